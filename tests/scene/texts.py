"""Scenes for tests, written as they would be in a file."""

from __future__ import annotations

from pathlib import Path

from adagen.model import Model
from adagen.scene import Reduction, Scene, apply_scene, read_scene


def scene_of(folder: Path, text: str) -> Scene:
    """Return the scene that a file with this text holds."""
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return read_scene(path)


def reduced(model: Model, folder: Path, text: str) -> Reduction:
    """Return what a scene makes of a robot."""
    return apply_scene(model, scene_of(folder, text))
