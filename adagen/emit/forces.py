"""Passive joint torques, prescribed motions and outer forces, as C++ lines.

In emitted code, a joint with a known acceleration has no degree of freedom (``Held``). So has, at a
cut, a joint with a rotor: the rotor's inertia then stands for the joint.
"""

from __future__ import annotations

from collections.abc import Sequence

from adagen.emit.names import quoted
from adagen.emit.symbols import Symbols
from adagen.plan import Plan
from adagen.plan.robot import PlanJoint


def has_effects(plan: Plan) -> bool:
    """Whether headers for prescribed joints, rotors or outer forces are needed."""
    return bool(plan.wrenches) or any(
        joint.prescribed or joint.rotor_inertia for joint in plan.joints
    )


def joined_type(symbols: Symbols, j: int) -> str:
    """The C++ type of a joint's freedoms where chains are joined."""
    joint = symbols.plan.joints[j]
    return "Held" if joint.prescribed or joint.rotor_inertia else symbols.type_of(j)


def body_type(symbols: Symbols, j: int) -> str:
    """The C++ type of a joint's factors of an articulated body."""
    joint = symbols.plan.joints[j]
    if joint.prescribed:
        return "Articulated<Held>"
    return f"{'Geared' if joint.rotor_inertia else 'Articulated'}<{symbols.type_of(j)}>"


def freedoms_type(symbols: Symbols, j: int) -> str:
    """The C++ type of a number for each degree of freedom and right-hand side."""
    return f"std::array<std::array<Real, kColumns>, kFree<{symbols.type_of(j)}>>"


def passive_torques(symbols: Symbols, j: int, tau: str) -> list[str]:
    """The lines that subtract damping, friction and a spring from a joint's torque."""
    joint, number = symbols.plan.joints[j], symbols.printer.number
    lines = []
    for k in range(symbols.kind(j).nv):
        qd = _rate(symbols, joint, k)
        terms = []
        if joint.damping:
            terms.append(f"{number(joint.damping)} * ({qd})")
        if joint.friction:
            slope = f"({qd}) / {number(joint.friction_speed)}"
            terms.append(f"{number(joint.friction)} * std::tanh({slope})")
        if joint.stiffness:
            terms.append(f"{number(joint.stiffness)} * ({_stretch(symbols, joint)})")
        if terms:
            lines.append(f"{tau}[{k}][0] -= {' + '.join(terms)};")
    return lines


def _rate(symbols: Symbols, joint: PlanJoint, k: int) -> str:
    if joint.mimic is None:
        return f"w.v[{joint.v + k}]"
    source, multiplier, _ = joint.mimic
    return symbols.printer.linear([(multiplier, f"w.v[{symbols.plan.joints[source].v}]")])


def _stretch(symbols: Symbols, joint: PlanJoint) -> str:
    if joint.mimic is None:
        return symbols.printer.linear([(1.0, f"w.q[{joint.q}]")], -joint.rest)
    source, multiplier, offset = joint.mimic
    q = symbols.plan.joints[source].q
    return symbols.printer.linear([(multiplier, f"w.q[{q}]")], offset - joint.rest)


def prescribe(symbols: Symbols, j: int, c: str, *, turned: bool = False) -> list[str]:
    """The lines that add S qdd to c where qdd is prescribed; ``turned``: see ``joins.assembly``."""
    joint = symbols.plan.joints[j]
    if not joint.prescribed:
        return []
    if turned:
        return [f"{c} += prescribed_across(w, {j});"]
    return [
        f"require_finite(w, w.tau + {joint.v}, {symbols.kind(j).nv}, {j});",
        f"prescribe<{symbols.type_of(j)}>(w.tau + {joint.v}, {c});",
    ]


def given_acceleration(symbols: Symbols, j: int) -> list[str]:
    """The lines that name a prescribed acceleration qdd."""
    return [
        f"{freedoms_type(symbols, j)} qdd;",
        f"load_torque(w, {j}, {symbols.plan.joints[j].v}, qdd);  // the prescribed acceleration",
    ]


def pushes(symbols: Symbols, link: int, line: str) -> list[str]:
    """The lines that apply the outer forces on a link; ``line`` is a format for each."""
    plan = symbols.plan
    return [
        line.format(f"outer_force(w, {k}, {plan.entry_of_wrench(k)}, {link - 1})")
        for k, wrench in enumerate(plan.wrenches)
        if wrench.link == link
    ]


def push_calls(symbols: Symbols, links: Sequence[int]) -> list[str]:
    """The calls of shape kernels that apply the outer forces on some links."""
    return [
        f"push<{k}>(w);  // on link {quoted(wrench.name)}"
        for k, wrench in enumerate(symbols.plan.wrenches)
        if wrench.link in links
    ]


def pushed_entries(symbols: Symbols, links: set[int]) -> list[int]:
    """The entries of tau that hold the outer forces on some links."""
    plan = symbols.plan
    return [
        plan.entry_of_wrench(k) + i
        for k, wrench in enumerate(plan.wrenches)
        if wrench.link in links
        for i in range(6)
    ]


def constants(symbols: Symbols, j: int) -> str:
    """The passive constants of a joint in the model's table; empty where it has none."""
    joint, number = symbols.plan.joints[j], symbols.printer.number
    numbers = (joint.damping, joint.friction, joint.friction_speed, joint.stiffness, joint.rest)
    if not (joint.damping or joint.friction or joint.stiffness):
        numbers = (0.0, 0.0, 1.0, 0.0, 0.0)
    if not (any(numbers[k] for k in (0, 1, 3)) or joint.rotor_inertia or joint.prescribed):
        return ""
    values = ", ".join(number(x) for x in (*numbers, joint.rotor_inertia))
    return f", {{{values}, {'true' if joint.prescribed else 'false'}}}"
