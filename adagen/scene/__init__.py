"""Scenes: a scene file, and the reduced robot for it."""

from adagen.scene.apply import Reduction, apply_scene
from adagen.scene.read import read_scene
from adagen.scene.types import Scene

__all__ = ["Reduction", "Scene", "apply_scene", "read_scene"]
