"""From a URDF file to a Model: strict, with one line for every refusal."""

from adagen.urdf.reader import Reading, read_robot

__all__ = ["Reading", "read_robot"]
