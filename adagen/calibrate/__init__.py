"""Measuring what a machine takes for the steps of a plan, by timing emitted programs."""

from adagen.calibrate.run import Calibration, Progress, calibrate, calibrate_network
from adagen.calibrate.write import profile_text

__all__ = ["Calibration", "Progress", "calibrate", "calibrate_network", "profile_text"]
