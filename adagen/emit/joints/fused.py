"""Assembly and disassembly of a run of joints as one, as C++ lines."""

from __future__ import annotations

from adagen.emit.forces import passive_torques
from adagen.emit.joints.joins import bias_updates, block_updates, coupling_torques, store
from adagen.emit.joints.kinematics import configuration, velocity
from adagen.emit.symbols import Symbols
from adagen.plan.fused_frame import run_length
from adagen.plan.steps import Coupling, Disassemble, FusedJoin


def freedoms(symbols: Symbols, join: FusedJoin) -> int:
    """Return the degrees of freedom of a run."""
    return sum(symbols.kind(j).nv for j in join.run)


def type_of(symbols: Symbols, join: FusedJoin) -> str:
    """Return the C++ type of a run as a joint."""
    return f"Fused<{freedoms(symbols, join)}>"


def rows_of(symbols: Symbols, join: FusedJoin) -> list[tuple[int, int, int]]:
    """Each joint of the run, its first row among those of the run, and their number."""
    rows, first = [], 0
    for j in join.run:
        rows.append((j, first, symbols.kind(j).nv))
        first += symbols.kind(j).nv
    return rows


def assembly(symbols: Symbols, join: FusedJoin) -> list[str]:
    """Eq. (3)-(7) of the run: its motions, then as for any joint in its coordinates."""
    lines = [named(symbols, join)]
    for j, first, count in rows_of(symbols, join):
        joint, memory = symbols.plan.joints[j], symbols.memory(j)
        slaved = [] if joint.mimic is None else [configuration(symbols, j)[1]]
        lines += [
            "{",
            *(f"  {line}" for line in slaved),
            f"  extend<{symbols.type_of(j)}, {first}>(i.run, {memory}.X);",
            f"  i.run.c += velocity_product<{symbols.type_of(j)}>"
            f"({memory}.v, {velocity(symbols, j)});",
            f"  std::array<std::array<Real, kColumns>, {count}> tau;",
            f"  load_torque(w, {j}, {joint.v}, tau);",
            *(f"  {line}" for line in coupling_torques(symbols, j, "tau")),
            *(f"  {line}" for line in passive_torques(symbols, j, "tau")),
            f"  place<{first}>(tau, i.joined.tau);",
            "}",
        ]
    b_a = "w.ground" if join.a_bias is None else symbols.bias(join.a_bias)
    return [
        *lines,
        *fused(symbols, join),
        *joined(symbols, join, b_a, keeps_sum=bool(symbols.refine)),
    ]


def named(symbols: Symbols, join: FusedJoin) -> str:
    """The line that names the run's memory."""
    others = ", ".join(symbols.quoted_joint(j) for j in join.run[:-1])
    return f"auto& i = {symbols.memory(join.joint)};  // one joint with {others}"


def fused(symbols: Symbols, join: FusedJoin) -> list[str]:
    """The lines that compute the coordinates of the run, and its distance from gimbal lock."""
    joints = [symbols.plan.joints[j] for j in join.run]
    length = run_length(joints, symbols.plan.links[join.joint + 1])
    return [
        f"if (!fuse(i.run, Real({1.0 / length!r}))) fail(w, kGimbalLock, {join.joint});",
        f"if (i.run.lock < kNearLock) w.near_lock = {join.joint + 1};",
    ]


def joined(symbols: Symbols, join: FusedJoin, b_a: str, *, keeps_sum: bool = False) -> list[str]:
    """Eq. (3)-(7) in the coordinates of the run.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        join: the run.
        b_a: the bias of chain A.
        keeps_sum: whether Phi_A + Phi_B is kept, for other biases.
    """
    lines, phi_a = [], "kZero"
    if join.a is not None:
        lines.append(f"const Mat6 X_Phi_A = i.run.BX * {symbols.block(join.a)};")
        lines.append("const Mat6 Phi_A = X_Phi_A * i.run.BX.transpose();")
        phi_a = "Phi_A"
    lines += [
        f"const Mat6 X_Phi_B = i.run.B * {symbols.block(join.b)};",
        "const Mat6 Phi_B = X_Phi_B * i.run.B.transpose();",
    ]
    if keeps_sum:
        n = freedoms(symbols, join)
        lines.append(f"i.P = ({phi_a} + Phi_B).topLeftCorner<{n}, {n}>();")
    return [
        *lines,
        f"if (!join(i.joined, {phi_a}, Phi_B, i.run.BX * {b_a}, "
        f"i.run.B * {symbols.bias(join.b_bias)}, i.run.c))",
        f"  fail(w, kFactorization, {join.joint});",
        *(couple(symbols, coupling) for coupling in join.couplings),
        *block_updates(symbols, join),
        *bias_updates(symbols, join),
    ]


def couple(symbols: Symbols, coupling: Coupling) -> str:
    """The line of the coupling between a handle and the run."""
    transposed = ".transpose()" if coupling.transposed else ""
    frame = "BX" if coupling.side == "A" else "B"
    phi = f"i.run.{frame} * {symbols.block(coupling.source)}{transposed}"
    return f"couple(i.joined, {phi}, i.at_{symbols.links[coupling.handle]});"


def reassembly(symbols: Symbols, join: FusedJoin) -> list[str]:
    """The same for other biases, and the missing torques of its joints."""
    lines = []
    for j, first, count in rows_of(symbols, join):
        lines += [
            "{",
            f"  std::array<std::array<Real, kColumns>, {count}> tau;",
            f"  load_torque(w, {j}, {symbols.plan.joints[j].v}, tau);",
            f"  place<{first}>(tau, i.joined.tau);",
            "}",
        ]
    b_a = "w.ground" if join.a_bias is None else symbols.bias(join.a_bias)
    b_b = f"i.run.B * {symbols.bias(join.b_bias)}"
    return [
        *lines,
        f"rejoin(i.joined, i.P, i.run.BX * {b_a}, {b_b});",
        *bias_updates(symbols, join),
    ]


def released(symbols: Symbols, join: FusedJoin, end: Disassemble) -> list[str]:
    """Eq. (8) of the run, and Eq. (10), its force on the last link, where that is needed."""
    lines = [
        f"auto& i = {symbols.memory(join.joint)};",
        f"Release<{type_of(symbols, join)}> release(i.joined);",
    ]
    for coupling, force in zip(join.couplings, end.forces, strict=True):
        handle = symbols.links[coupling.handle]
        lines.append(f"release.feel_{coupling.side}(i.at_{handle}, {symbols.force(force)});")
    if end.updates or symbols.refine:
        lines.append("const Columns6 f = i.run.B.transpose() * release.force();  // Eq. (8), (10)")
    else:
        lines.append("release.force();  // Eq. (8)")
    return lines


def disassembly(symbols: Symbols, join: FusedJoin, end: Disassemble) -> list[str]:
    """Eq. (8)-(10) of the run: accelerations of its joints, and forces on its ends."""
    lines = released(symbols, join, end)
    if symbols.refine:
        lines.append(f"w.refinement.f[{join.joint}] = f;")
    for j, first, count in rows_of(symbols, join):
        qdd = f"part<{first}, {count}>(release.qdd())"
        if symbols.plan.slaved:
            lines.append(f"{symbols.memory(j)}.qdd = {qdd};  // Eq. (9)")
        else:
            lines.append(f"{store(symbols, j, qdd)}  // Eq. (9)")
    return lines + felt(symbols, end, "i.run.X.transposed_times(f)")


def felt(symbols: Symbols, end: Disassemble, on_a: str) -> list[str]:
    """The lines that apply the run's force to its ends.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        end: of the run.
        on_a: the opposite of the force on its first link.
    """
    lines = []
    for update in end.updates:
        change = f"- {on_a}" if update.side == "A" else "+ f"
        acting = "Columns6::Zero()" if update.source is None else symbols.force(update.source)
        lines.append(f"{symbols.force(update.target)} = {acting} {change};")
    return lines
