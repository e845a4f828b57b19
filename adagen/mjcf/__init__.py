"""From an MJCF file to a Model, by MuJoCo's own compiler."""

from adagen.mjcf.reader import is_mjcf, read_mjcf, whole_bytes

__all__ = ["is_mjcf", "read_mjcf", "whole_bytes"]
