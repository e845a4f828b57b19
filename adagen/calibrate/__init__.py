"""Measurement of a machine's costs of plan steps, by timing emitted programs."""

from adagen.calibrate.run import Calibration, Progress, calibrate, calibrate_network
from adagen.calibrate.write import profile_text

__all__ = ["Calibration", "Progress", "calibrate", "calibrate_network", "profile_text"]
