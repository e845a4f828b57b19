"""From a URDF file to a Model: strict, with one line for every refusal."""

from adagen.urdf.expansion import expanded_bytes
from adagen.urdf.reader import Reading, check_reduced, read_robot
from adagen.urdf.source import model_stem

__all__ = ["Reading", "check_reduced", "expanded_bytes", "model_stem", "read_robot"]
