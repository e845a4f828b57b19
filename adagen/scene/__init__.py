"""No more model than the scene needs: a scene file, and what it makes of a robot."""

from adagen.scene.apply import Reduction, apply_scene
from adagen.scene.read import read_scene
from adagen.scene.types import Scene

__all__ = ["Reduction", "Scene", "apply_scene", "read_scene"]
