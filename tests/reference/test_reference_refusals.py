"""What the reference refuses to answer."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from adagen.errors import InputError
from adagen.model import REVOLUTE, SPHERICAL, Inertia
from adagen.reference import (
    bias,
    forward_dynamics,
)
from tests.links import with_inertia
from tests.models import (
    Part,
    assemble,
    human_figure,
    rod,
    serial_chain,
    vector,
)

Array = NDArray[np.float64]
G = 9.81


class TestRefusals:
    def test_a_massless_leaf(self) -> None:
        model = with_inertia(serial_chain(3), 3, Inertia.zero())
        with pytest.raises(InputError, match="'j002'"):
            forward_dynamics(model, np.ones(3), np.ones(3), np.ones(3))

    def test_a_motion_that_only_rounding_resists(self) -> None:
        """Two joints on one axis: the inertia is singular but its computed pivot is not 0."""
        tip = vector(0.3, 0.1, 0.0)
        axis = vector(0.36, 0.48, 0.8)
        model = assemble(
            "coaxial",
            [
                Part("first", None, REVOLUTE, Inertia.zero(), axis=axis),
                Part("second", "first", REVOLUTE, rod(1.0, tip), axis=axis),
            ],
        )
        for seed in range(20):
            q = np.random.default_rng(seed).normal(size=2)
            with pytest.raises(InputError, match="'second'"):
                forward_dynamics(model, q, np.ones(2), np.ones(2))

    @pytest.mark.parametrize("bad", [np.nan, np.inf])
    def test_numbers_that_are_not_finite(self, bad: float) -> None:
        model, values = human_figure(), np.ones(41)
        q = np.ones(model.nq)
        values = np.ones(model.nv)
        values[-1] = bad
        for state in ((q, values, np.ones(40)), (q, np.ones(40), values)):
            with pytest.raises(InputError, match="'right_wrist'"):
                forward_dynamics(model, *state)
        q[0] = bad
        with pytest.raises(InputError, match="'__base__': q holds"):
            forward_dynamics(model, q, np.ones(40), np.ones(40))

    def test_a_zero_quaternion(self) -> None:
        model = serial_chain(2, kind=SPHERICAL)
        q = vector(0, 0, 0, 1, 0, 0, 0, 0)
        with pytest.raises(InputError, match="'j001': the quaternion is zero"):
            forward_dynamics(model, q, np.zeros(6), np.zeros(6))

    def test_a_wrong_shape_is_the_callers_mistake(self) -> None:
        with pytest.raises(ValueError, match="shape"):
            bias(serial_chain(3), np.zeros(3), np.zeros(4))
