"""Code shape `kernels`: a plan's steps as loops over runs of joints. See values.py."""

from adagen.emit.kernels.values import values, why_not, why_not_weighed

__all__ = ["values", "why_not", "why_not_weighed"]
