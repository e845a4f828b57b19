"""Imports between the packages of the compiler go one way."""

from __future__ import annotations

import ast
from graphlib import TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1] / "adagen"


def imported(file: Path) -> set[str]:
    """Return the packages of adagen that a file imports as it is loaded."""
    found = set()
    for node in ast.parse(file.read_text(encoding="utf-8")).body:  # not those inside of functions
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("adagen."):
            found.add(node.module.split(".")[1])
    return found


def test_packages_have_an_order() -> None:
    packages: dict[str, set[str]] = {}
    for file in ROOT.rglob("*.py"):
        name = file.relative_to(ROOT).parts[0].removesuffix(".py")
        if name not in ("__init__", "__main__"):
            packages.setdefault(name, set()).update(imported(file) - {name})
    order = list(TopologicalSorter(packages).static_order())  # raises where there is a circle
    assert order.index("plan") < order.index("executor") < order.index("program")
    assert order.index("program") < order.index("cost") < order.index("emit")
    assert order.index("schedule") < order.index("paper") < order.index("search")
    assert order.index("emit") < order.index("search") < order.index("library") < order.index("cli")
    assert order.index("search") < order.index("studies")
    assert order.index("studies") < order.index("report") < order.index("cli")
    assert order.index("urdf") < order.index("mjcf") < order.index("library")


def modules_of() -> dict[str, Path]:
    """Return the file of each module; that of a package is its __init__.py."""
    found = {}
    for file in ROOT.rglob("*.py"):
        parts = file.relative_to(ROOT.parent).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = file
    return found


def test_modules_have_an_order() -> None:
    """Those of all imports: for types alone and inside of functions, too."""
    files = modules_of()
    modules: dict[str, set[str]] = {}
    for module, file in files.items():
        own: set[str] = set()
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                own.update(alias.name for alias in node.names)
            elif isinstance(node, ast.ImportFrom):
                assert node.module and not node.level, f"{file}:{node.lineno} is relative"
                whole = (f"{node.module}.{alias.name}" for alias in node.names)
                own.update(name if name in files else node.module for name in whole)
        modules[module] = own & files.keys()
    order = list(TopologicalSorter(modules).static_order())  # raises where there is a circle
    first, last = (f"adagen.executor.{name}" for name in ("process_memory", "machine"))
    assert order.index(first) < order.index("adagen.executor.state") < order.index(last)
    assert order.index("adagen.library.solver") < order.index("adagen.library.compiled")


def test_nothing_below_the_command_line_knows_its_options() -> None:
    """Requests are dataclasses there; argparse and its namespaces stay in cli."""
    for file in ROOT.rglob("*.py"):
        if file.relative_to(ROOT).parts[0] in ("cli", "__main__.py"):
            continue
        names = {
            name
            for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
            for name in (
                [alias.name for alias in node.names]
                if isinstance(node, ast.Import)
                else [node.module]
                if isinstance(node, ast.ImportFrom)
                else []
            )
        }
        assert "argparse" not in names, file
        assert not any(name and name.startswith("adagen.cli") for name in names), file
