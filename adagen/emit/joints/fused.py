"""Assembly and disassembly of a run of joints as one, as C++ lines."""

from __future__ import annotations

from adagen.emit.effects import passive_torques
from adagen.emit.joints.joins import bias_updates, block_updates, coupling_torques, store
from adagen.emit.joints.kinematics import configuration, velocity
from adagen.emit.words import Words
from adagen.plan.steps import Coupling, Disassemble, FusedJoin


def freedoms(words: Words, join: FusedJoin) -> int:
    """Return the degrees of freedom of a run."""
    return sum(words.kind(j).nv for j in join.run)


def type_of(words: Words, join: FusedJoin) -> str:
    """Return the C++ type that stands for a run as a joint."""
    return f"Fused<{freedoms(words, join)}>"


def rows_of(words: Words, join: FusedJoin) -> list[tuple[int, int, int]]:
    """Each joint of the run, its first row among those of the run, and their number."""
    rows, first = [], 0
    for j in join.run:
        rows.append((j, first, words.kind(j).nv))
        first += words.kind(j).nv
    return rows


def assembly(words: Words, join: FusedJoin) -> list[str]:
    """Eq. (3)-(7) of the run: its motions, then as for any joint in its coordinates."""
    lines = [named(words, join)]
    for j, first, count in rows_of(words, join):
        joint, memory = words.plan.joints[j], words.memory(j)
        slaved = [] if joint.mimic is None else [configuration(words, j)[1]]
        lines += [
            "{",
            *(f"  {line}" for line in slaved),
            f"  extend<{words.type_of(j)}, {first}>(i.run, {memory}.X);",
            f"  i.run.c += velocity_product<{words.type_of(j)}>({memory}.v, {velocity(words, j)});",
            f"  std::array<std::array<Real, kColumns>, {count}> tau;",
            f"  load_torque(w, {j}, {joint.v}, tau);",
            *(f"  {line}" for line in coupling_torques(words, j, "tau")),
            *(f"  {line}" for line in passive_torques(words, j, "tau")),
            f"  place<{first}>(tau, i.joined.tau);",
            "}",
        ]
    b_a = "w.ground" if join.a_bias is None else words.bias(join.a_bias)
    return [*lines, *fused(join), *joined(words, join, b_a, keeps_sum=bool(words.refine))]


def named(words: Words, join: FusedJoin) -> str:
    """The line that names the run's memory."""
    others = ", ".join(words.quoted_joint(j) for j in join.run[:-1])
    return f"auto& i = {words.memory(join.joint)};  // one joint with {others}"


def fused(join: FusedJoin) -> list[str]:
    """The lines that find the coordinates of the run, and how near they are to gimbal lock."""
    return [
        f"if (!fuse(i.run)) fail(w, kGimbalLock, {join.joint});",
        f"if (i.run.lock < kNearLock) w.near_lock = {join.joint + 1};",
    ]


def joined(words: Words, join: FusedJoin, b_a: str, *, keeps_sum: bool = False) -> list[str]:
    """Eq. (3)-(7) in the coordinates of the run.

    Args:
        words: the plan's names.
        join: the run.
        b_a: the bias of chain A.
        keeps_sum: whether Phi_A + Phi_B is kept, for other biases.
    """
    lines, phi_a = [], "kZero"
    if join.a is not None:
        lines.append(f"const Mat6 X_Phi_A = i.run.BX * {words.block(join.a)};")
        lines.append("const Mat6 Phi_A = X_Phi_A * i.run.BX.transpose();")
        phi_a = "Phi_A"
    lines += [
        f"const Mat6 X_Phi_B = i.run.B * {words.block(join.b)};",
        "const Mat6 Phi_B = X_Phi_B * i.run.B.transpose();",
    ]
    if keeps_sum:
        n = freedoms(words, join)
        lines.append(f"i.P = ({phi_a} + Phi_B).topLeftCorner<{n}, {n}>();")
    return [
        *lines,
        f"if (!join(i.joined, {phi_a}, Phi_B, i.run.BX * {b_a}, "
        f"i.run.B * {words.bias(join.b_bias)}, i.run.c))",
        f"  fail(w, kFactorization, {join.joint});",
        *(couple(words, coupling) for coupling in join.couplings),
        *block_updates(words, join),
        *bias_updates(words, join),
    ]


def couple(words: Words, coupling: Coupling) -> str:
    """The line that finds how a handle feels the run."""
    transposed = ".transpose()" if coupling.transposed else ""
    frame = "BX" if coupling.side == "A" else "B"
    phi = f"i.run.{frame} * {words.block(coupling.source)}{transposed}"
    return f"couple(i.joined, {phi}, i.at_{words.links[coupling.handle]});"


def reassembly(words: Words, join: FusedJoin) -> list[str]:
    """The same for other biases, and the torques that the forces of its joints lack."""
    lines = []
    for j, first, count in rows_of(words, join):
        lines += [
            "{",
            f"  std::array<std::array<Real, kColumns>, {count}> tau;",
            f"  load_torque(w, {j}, {words.plan.joints[j].v}, tau);",
            f"  place<{first}>(tau, i.joined.tau);",
            "}",
        ]
    b_a = "w.ground" if join.a_bias is None else words.bias(join.a_bias)
    b_b = f"i.run.B * {words.bias(join.b_bias)}"
    return [*lines, f"rejoin(i.joined, i.P, i.run.BX * {b_a}, {b_b});", *bias_updates(words, join)]


def released(words: Words, join: FusedJoin, end: Disassemble) -> list[str]:
    """Eq. (8) of the run, and Eq. (10), its force on the last link, where that is asked for."""
    lines = [
        f"auto& i = {words.memory(join.joint)};",
        f"Release<{type_of(words, join)}> release(i.joined);",
    ]
    for coupling, force in zip(join.couplings, end.forces, strict=True):
        handle = words.links[coupling.handle]
        lines.append(f"release.feel_{coupling.side}(i.at_{handle}, {words.force(force)});")
    if end.updates or words.refine:
        lines.append("const Columns6 f = i.run.B.transpose() * release.force();  // Eq. (8), (10)")
    else:
        lines.append("release.force();  // Eq. (8)")
    return lines


def disassembly(words: Words, join: FusedJoin, end: Disassemble) -> list[str]:
    """Eq. (8)-(10) of the run: the accelerations of its joints, and what its ends get to feel."""
    lines = released(words, join, end)
    if words.refine:
        lines.append(f"w.refinement.f[{join.joint}] = f;")
    for j, first, count in rows_of(words, join):
        qdd = f"part<{first}, {count}>(release.qdd())"
        if words.plan.slaved:
            lines.append(f"{words.memory(j)}.qdd = {qdd};  // Eq. (9)")
        else:
            lines.append(f"{store(words, j, qdd)}  // Eq. (9)")
    return lines + felt(words, end, "i.run.X.transposed_times(f)")


def felt(words: Words, end: Disassemble, on_a: str) -> list[str]:
    """The lines by which the ends of a run feel its force.

    Args:
        words: the plan's names.
        end: of the run.
        on_a: the opposite of the force on its first link.
    """
    lines = []
    for update in end.updates:
        change = f"- {on_a}" if update.side == "A" else "+ f"
        acting = "Columns6::Zero()" if update.source is None else words.force(update.source)
        lines.append(f"{words.force(update.target)} = {acting} {change};")
    return lines
