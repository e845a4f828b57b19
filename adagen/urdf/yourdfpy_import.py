"""Import of yourdfpy without the libraries for meshes, which take longer than to read a robot."""

from __future__ import annotations

import builtins
import functools
import importlib
import importlib.util
import sys
from types import ModuleType
from typing import Any


@functools.cache
def urdf_class() -> Any:
    """Return yourdfpy's class ``URDF``, which reads descriptions that name no mesh.

    What is imported for it has names of its own: whoever imports yourdfpy or trimesh gets all of
    them. Where a release of them has changed its parts, this takes yourdfpy as it is.
    """
    if "yourdfpy" not in sys.modules:
        try:
            return _without_meshes()
        except (ImportError, AttributeError):
            pass
    from yourdfpy import URDF

    return URDF


def _without_meshes() -> Any:
    trimesh = _parts_of("trimesh", _Trimesh)
    trimesh.transformations = importlib.import_module(f"{trimesh.__name__}.transformations")
    yourdfpy = _parts_of("yourdfpy", ModuleType)
    spec = importlib.util.find_spec(f"{yourdfpy.__name__}.urdf")
    if spec is None or spec.loader is None:
        raise ImportError("yourdfpy has no part urdf")

    def imported(name: str, *rest: Any, **more: Any) -> Any:
        if name.partition(".")[0] == "trimesh":
            return trimesh
        return builtins.__import__(name, *rest, **more)

    module = importlib.util.module_from_spec(spec)
    module.__dict__["__builtins__"] = {**vars(builtins), "__import__": imported}
    spec.loader.exec_module(module)
    return module.URDF


def _parts_of(name: str, kind: type[ModuleType]) -> Any:
    """Return a package under another name, from which parts are imported without the whole."""
    spec = importlib.util.find_spec(name)
    if spec is None or spec.submodule_search_locations is None:
        raise ImportError(f"{name} is no package")
    package = kind(f"_adagen_{name}")
    package.__path__ = list(spec.submodule_search_locations)
    sys.modules[package.__name__] = package
    return package


class _Trimesh(ModuleType):
    """Stands for trimesh: any name that yourdfpy's signatures mention is there."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return Any
