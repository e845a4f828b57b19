"""Finds the templates and renders them."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from adagen.errors import EnvironmentFault


@cache
def templates_folder() -> Path:
    """Return the folder of the templates: in the installed package, or beside it in a checkout."""
    package = Path(__file__).resolve().parents[1]
    for folder in (package / "templates", package.parent / "templates"):
        if (folder / "solver.cpp.j2").is_file():
            return folder
    raise EnvironmentFault("the templates are missing from this installation; install adagen again")


@cache
def environment() -> Environment:
    """Return the one Jinja environment: undefined names are errors, blocks leave no blank lines."""
    env = Environment(
        loader=FileSystemLoader(templates_folder()),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,  # noqa: S701 (C++, not HTML; names are quoted by adagen.emit.names)
    )
    env.globals["verbatim"] = verbatim
    return env


def verbatim(name: str) -> str:
    """Return a C++ part without template syntax, unchanged."""
    return template(name).rstrip("\n")


def template(name: str) -> str:
    """Return a template that is emitted unchanged."""
    return (templates_folder() / name).read_text(encoding="utf-8")


def render(name: str, **values: object) -> str:
    """Return a rendered template."""
    return environment().get_template(name).render(**values)
