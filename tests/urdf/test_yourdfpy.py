"""yourdfpy is imported without the libraries for meshes, and reads the same."""

from __future__ import annotations

import io
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from adagen.urdf import yourdfpy_check
from tests.conftest import ROOT

ARM = ROOT / "generated_examples" / "models" / "arm7.urdf"


def imported(code: str) -> set[str]:
    """Return which packages Python has imported after some code."""
    show = "import sys; print(*{name.partition('.')[0] for name in sys.modules})"
    done = subprocess.run(
        [sys.executable, "-c", f"{code}; {show}"], capture_output=True, text=True, cwd=ROOT
    )
    assert (done.returncode, done.stderr) == (0, "")
    return set(done.stdout.split())


def test_a_robot_is_read_without_libraries_for_meshes() -> None:
    names = imported(f"import adagen; adagen.read({str(ARM)!r})")
    assert "_adagen_yourdfpy" in names
    assert not {"scipy", "trimesh", "yourdfpy", "networkx"} & names


def test_others_get_all_of_trimesh_and_yourdfpy() -> None:
    code = f"import adagen; adagen.read({str(ARM)!r}); import trimesh, yourdfpy; "
    names = imported(code + "yourdfpy.URDF.load; trimesh.Trimesh; trimesh.transformations")
    assert {"trimesh", "yourdfpy"} <= names


@pytest.fixture
def _anew() -> Iterator[None]:
    yourdfpy_check.urdf_class.cache_clear()
    yield
    yourdfpy_check.urdf_class.cache_clear()


@pytest.mark.usefixtures("_anew")
@pytest.mark.parametrize("fault", [ImportError, AttributeError])
def test_another_release_is_taken_whole(
    monkeypatch: pytest.MonkeyPatch, fault: type[Exception]
) -> None:
    import yourdfpy

    def missing(*_: Any) -> Any:
        raise fault

    monkeypatch.delitem(sys.modules, "yourdfpy")
    monkeypatch.setattr(yourdfpy_check, "_parts_of", missing)
    assert yourdfpy_check.urdf_class().__name__ == yourdfpy.URDF.__name__
    assert yourdfpy_check.urdf_class().__module__ == "yourdfpy.urdf"


@pytest.mark.parametrize("path", sorted(ARM.parent.glob("*.urdf")), ids=lambda path: path.stem)
def test_both_read_the_same(path: Path) -> None:
    import yourdfpy

    alone, whole = (
        kind.load(
            io.BytesIO(path.read_bytes()),
            build_scene_graph=False,
            build_collision_scene_graph=False,
            load_meshes=False,
            load_collision_meshes=False,
        ).robot
        for kind in (yourdfpy_check._without_meshes(), yourdfpy.URDF)
    )
    assert [plain(link.inertial) for link in alone.links] == [
        plain(link.inertial) for link in whole.links
    ]
    assert [plain(joint) for joint in alone.joints] == [plain(joint) for joint in whole.joints]


def plain(thing: Any) -> Any:
    """Return an object's numbers and names, to be compared."""
    if isinstance(thing, np.ndarray):
        return thing.tolist()
    if hasattr(thing, "__dict__"):
        return {name: plain(value) for name, value in vars(thing).items()}
    return thing
