"""Pinocchio's dynamics with closed loops, called in Python: what it answers, not how fast."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from adagen.errors import EnvironmentFault
from adagen.model import Model, canonical
from adagen.studies.bench.peers.pinocchio_loops import constraint_lines

Array = NDArray[np.float64]
MU = 1e-4
"""Proximal parameter of lcaba, which needs one."""
Solve = Callable[[Array, Array, Array], Array]


def installed() -> bool:
    """Whether Pinocchio can be asked."""
    return find_spec("pinocchio") is not None


def solvers(model: Model, q: Array) -> dict[str, Solve]:
    """Return constraintDynamics and lcaba of a robot.

    Args:
        model: the robot.
        q: a configuration in which its loops are closed, shape (nq,).

    Raises:
        EnvironmentFault: Pinocchio has no such joints or loops.
    """
    import pinocchio as pin

    robot = canonical(model)
    lines, shift = constraint_lines(robot, q)
    built = _built(pin, robot)
    held = pin.StdVec_RigidConstraintModel()
    held.extend([_constraint(pin, built, line.split()) for line in lines])

    def state(algorithm: str) -> tuple[Any, Any]:
        data, at = built.createData(), pin.StdVec_RigidConstraintData()
        at.extend([one.createData() for one in held])
        if algorithm == "factors":
            pin.initConstraintDynamics(built, data, held, at)
        else:
            pin.computeJointMinimalOrdering(built, data, held)
        return data, at

    def factors(q: Array, v: Array, tau: Array) -> Array:
        data, at = state("factors")
        settings = pin.ProximalSettings(1e-14, shift, 10 if shift else 1)
        return _checked(pin.constraintDynamics(built, data, q, v, tau, held, at, settings))

    def articulated(q: Array, v: Array, tau: Array) -> Array:
        data, at = state("lcaba")
        settings = pin.ProximalSettings(1e-14, MU, 50)
        return _checked(pin.lcaba(built, data, q, v, tau, held, at, settings))

    return {"pinocchio constraintDynamics": factors, "pinocchio lcaba": articulated}


def _checked(found: Any) -> Array:
    result = np.array(found)
    if not np.isfinite(result).all():
        raise FloatingPointError("its answer is no number")
    return result


def _built(pin: Any, model: Model) -> Any:
    kinds = {
        "revolute": pin.JointModelRZ,
        "prismatic": pin.JointModelPZ,
        "spherical": pin.JointModelSpherical,
        "floating": pin.JointModelFreeFlyer,
    }
    built = pin.Model()
    built.gravity.linear = model.gravity
    for joint, link in zip(model.joints, model.links[1:], strict=True):
        if joint.kind.name not in kinds:
            raise EnvironmentFault(f'it is not asked for joints of kind "{joint.kind.name}"')
        place = pin.SE3(joint.rotation, joint.translation)
        number = built.addJoint(joint.parent, kinds[joint.kind.name](), place, joint.name)
        body = pin.Inertia(link.inertia.mass, link.inertia.com, link.inertia.tensor)
        built.appendBodyToJoint(number, body, pin.SE3.Identity())
    return built


def _constraint(pin: Any, built: Any, words: list[str]) -> Any:
    kind = pin.ContactType.CONTACT_6D if words[0] == "weld" else pin.ContactType.CONTACT_3D
    ends: list[Any] = []
    for own in (words[1:14], words[14:27]):
        numbers = np.array(own[1:], dtype=np.float64)
        ends += [int(own[0]), pin.SE3(numbers[:9].reshape(3, 3), numbers[9:])]
    return pin.RigidConstraintModel(kind, built, *ends, pin.ReferenceFrame.LOCAL)
