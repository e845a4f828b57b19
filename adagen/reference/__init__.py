"""Independent answers: they share no arithmetic with the emitted algorithm."""

from adagen.reference.certified import (
    Certified,
    exact_forward_dynamics,
    exact_inverse_dynamics,
)
from adagen.reference.double import (
    bias,
    energy_norm_error,
    forward_dynamics,
    inverse_dynamics,
    joint_space_inertia,
    kinetic_energy,
    momentum,
    potential_energy,
    residual,
)

__all__ = [
    "Certified",
    "bias",
    "energy_norm_error",
    "exact_forward_dynamics",
    "exact_inverse_dynamics",
    "forward_dynamics",
    "inverse_dynamics",
    "joint_space_inertia",
    "kinetic_energy",
    "momentum",
    "potential_energy",
    "residual",
]
