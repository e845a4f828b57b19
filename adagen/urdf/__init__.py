"""From a URDF file to a Model: strict, with one line for every refusal."""

from adagen.urdf.reader import Reading, check_reduced, read_robot

__all__ = ["Reading", "check_reduced", "read_robot"]
