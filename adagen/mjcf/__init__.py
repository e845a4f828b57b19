"""From an MJCF to a Model, as MuJoCo's own compiler settles it."""

from adagen.mjcf.reader import is_mjcf, read_mjcf, whole_bytes

__all__ = ["is_mjcf", "read_mjcf", "whole_bytes"]
