"""The steps inside a segment as C++ lines: articulated bodies inwards, mobility outwards."""

from __future__ import annotations

from adagen.emit import forces
from adagen.emit.joints.joins import store, torques, velocity_product
from adagen.emit.symbols import Symbols
from adagen.plan import steps as do
from adagen.plan.order import ends_of
from adagen.plan.steps import Spread


def of_link(symbols: Symbols, j: int, link: int) -> str:
    """A link's part of the memory, as named in a joint's function (``i`` is its own)."""
    return "i" if link == j + 1 else symbols.link_memory(link)


def articulate(symbols: Symbols, step: do.Articulate) -> list[str]:
    """I^A and p^A of the far link, through the joint, onto the near link."""
    j = step.joint
    joint = symbols.plan.joints[j]
    near, far = ends_of(symbols.plan.joints, step.joint, step.reversed)
    own, beyond = of_link(symbols, step.joint, near), of_link(symbols, step.joint, far)
    sigma = "-1" if step.reversed else "1"
    inertia, force = f"{beyond}.IA", f"{beyond}.pA"
    lines = [
        f"auto& i = {symbols.memory(j)};",
        *torques(symbols, j, "i.body.tau"),
        *velocity_product(symbols, j, "i.body.c"),
        *forces.prescribe(symbols, j, "i.body.c"),
    ]
    if joint.rotor_inertia:
        lines.append(f"i.body.J = {symbols.printer.number(joint.rotor_inertia)};")
    if step.reversed:
        lines += [
            "i.body.c = -i.body.c;",
            f"const Inertia IA = in_child(i.X, {inertia});",
            f"const Columns6 pA = wrench_in_child(i.X, {force});",
        ]
        inertia, force = "IA", "pA"
    call = f"hand_on(w, {j}, i.body, {sigma}, {inertia}, {force})"
    if near == 0:
        return [*lines, f"{call};"]
    add = "add(" if step.reversed else "add_in_parent(i.X, "
    return [*lines, f"{add}{call}, {own}.IA, {own}.pA);"]


def propagate(symbols: Symbols, step: do.Propagate) -> list[str]:
    """Omega and Psi of the far link from the near link's."""
    lines = [f"auto& i = {symbols.memory(step.joint)};"]
    target = symbols.block(step.block)
    if step.near is None:
        lines.append("Mat6 Omega = kZero;")
    elif step.reversed:
        lines.append(f"Mat6 Omega = {symbols.block(step.near)};")
    else:
        lines.append(f"Mat6 Omega = from_right(i.X * {symbols.block(step.near)}, i.X);")
    lines.append("carry(i.body, Omega);")
    lines.append(f"{target} = {'congruent_in_parent(i.X, Omega)' if step.reversed else 'Omega'};")
    near = "w.ground" if step.near_bias is None else symbols.bias(step.near_bias)
    lines += far_acceleration(step, near, symbols.bias(step.bias))
    for number, spread in enumerate(step.spreads):
        lines += _spread(symbols, step, spread, f"Psi_{number}")
    return lines


def _spread(symbols: Symbols, step: do.Propagate, spread: Spread, name: str) -> list[str]:
    source = symbols.block(spread.source)
    if step.reversed:
        start = f"{source}.transpose()" if spread.source_transposed else source
    elif spread.source_transposed:
        start = f"times_transposed(i.X, {source})"
    else:
        start = f"i.X * {source}"
    end = f"motion_in_parent(i.X, {name})" if step.reversed else name
    transposed = ".transpose()" if spread.target_transposed else ""
    return [
        f"Mat6 {name} = {start};  // with link {symbols.quoted_link(spread.handle)}",
        f"share(i.body, {name});",
        f"{symbols.block(spread.target)} = {end}{transposed};",
    ]


def far_acceleration(step: do.Propagate | do.Accelerate, near: str, target: str) -> list[str]:
    """The far link's acceleration from the near link's."""
    if step.reversed:
        moved = "accelerate(i.body, a);"
        return [f"Columns6 a = {near};", moved, f"{target} = motion_in_parent(i.X, a);"]
    return [f"{target} = i.X * {near};", f"accelerate(i.body, {target});"]


def deliver(symbols: Symbols, step: do.Deliver) -> list[str]:
    """The load on the far link, through the joint, onto the near link."""
    near, far = ends_of(symbols.plan.joints, step.joint, step.reversed)
    load = f"{of_link(symbols, step.joint, far)}.load"
    lines = [
        f"auto& i = {symbols.memory(step.joint)};",
        f"Columns6 load = {f'wrench_in_child(i.X, {load})' if step.reversed else load};",
        "deliver(i.body, load);",
    ]
    if near > 0:
        passed = "load" if step.reversed else "i.X.transposed_times(load)"
        lines.append(f"{of_link(symbols, step.joint, near)}.load += {passed};")
    return lines


def accelerate(symbols: Symbols, step: do.Accelerate) -> list[str]:
    """Qdd of the joint and the acceleration of its far link."""
    near, far = ends_of(symbols.plan.joints, step.joint, step.reversed)
    start = "w.ground" if near == 0 else f"{of_link(symbols, step.joint, near)}.a"
    lines = [f"auto& i = {symbols.memory(step.joint)};"]
    target = f"{of_link(symbols, step.joint, far)}.a"
    if symbols.plan.joints[step.joint].prescribed:
        lines += far_acceleration(step, start, target)
        given = forces.given_acceleration(symbols, step.joint)
        return [*lines, *given, store(symbols, step.joint, "qdd")]
    moved = f"accelerate(i.body, {'a' if step.reversed else target})"
    if step.reversed:
        lines += [f"Columns6 a = {start};", store(symbols, step.joint, f"negated({moved})")]
        lines.append(f"{target} = motion_in_parent(i.X, a);")
    else:
        lines += [f"{target} = i.X * {start};", store(symbols, step.joint, moved)]
    return [*lines, *_force(symbols, step, far)] if symbols.refine else lines


def _force(symbols: Symbols, step: do.Accelerate, far: int) -> list[str]:
    """The joint's force on its child link, to be refined."""
    beyond = of_link(symbols, step.joint, far)
    load = f" - {beyond}.load" if far in symbols.loaded else ""
    force = f"effort({beyond}.IA, {beyond}.a, {beyond}.pA){load}"
    return [
        f"Columns6& f = w.refinement.f[{step.joint}];",
        f"f = {f'-wrench_in_child(i.X, {force})' if step.reversed else force};",
        f"along<{symbols.type_of(step.joint)}>(i.body.tau, f);",
    ]


def free_base(symbols: Symbols, step: do.FreeBase) -> list[str]:
    """The torque of a floating joint on the ground, straight onto its link."""
    j = step.joint
    return [
        f"auto& i = {symbols.memory(j)};",
        "std::array<std::array<Real, kColumns>, 6> tau;",
        *torques(symbols, j, "tau"),
        "for (std::size_t k = 0; k < 6; ++k)",
        "  for (int c = 0; c < kColumns; ++c)",
        "    i.pA(Floating::Free::row[k], c) -= tau[k][static_cast<std::size_t>(c)];",
    ]


def free_acceleration(symbols: Symbols, step: do.FreeAcceleration) -> list[str]:
    """Qdd of a floating joint on the ground, from the acceleration of its link."""
    j = step.joint
    return [
        f"auto& i = {symbols.memory(j)};",
        "const Columns6 a = i.a - i.X * w.ground;",
        "std::array<std::array<Real, kColumns>, 6> qdd;",
        "for (std::size_t k = 0; k < 6; ++k)",
        "  for (int c = 0; c < kColumns; ++c)",
        "    qdd[k][static_cast<std::size_t>(c)] = a(Floating::Free::row[k], c);",
        store(symbols, j, "qdd"),
        *_free_force(symbols, j),
    ]


def _free_force(symbols: Symbols, j: int) -> list[str]:
    """The torque of a floating joint on the ground, which is its whole force."""
    if not symbols.refine:
        return []
    return [
        "std::array<std::array<Real, kColumns>, 6> tau;",
        *torques(symbols, j, "tau"),
        f"along<Floating>(tau, w.refinement.f[{j}]);",
    ]
