"""From an MJCF to a Model, as MuJoCo's own compiler settles it."""

from adagen.mjcf.reader import is_mjcf, read_mjcf

__all__ = ["is_mjcf", "read_mjcf"]
