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
    others = ", ".join(words.quoted_joint(j) for j in join.run[:-1])
    lines = [f"auto& i = {words.memory(join.joint)};  // one joint with {others}"]
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
    lines.append(f"if (!fuse(i.run)) fail(w, kGimbalLock, {join.joint});")
    lines.append(f"if (i.run.lock < kNearLock) w.near_lock = {join.joint + 1};")
    phi_a = "kZero"
    if join.a is not None:
        lines.append(f"const Mat6 X_Phi_A = i.run.BX * {words.block(join.a)};")
        lines.append("const Mat6 Phi_A = X_Phi_A * i.run.BX.transpose();")
        phi_a = "Phi_A"
    b_a = "w.ground" if join.a_bias is None else words.bias(join.a_bias)
    lines += [
        f"const Mat6 X_Phi_B = i.run.B * {words.block(join.b)};",
        "const Mat6 Phi_B = X_Phi_B * i.run.B.transpose();",
    ]
    if words.refine:
        n = freedoms(words, join)
        lines.append(f"i.P = ({phi_a} + Phi_B).topLeftCorner<{n}, {n}>();")
    lines += [
        f"if (!join(i.joined, {phi_a}, Phi_B, i.run.BX * {b_a}, "
        f"i.run.B * {words.bias(join.b_bias)}, i.run.c))",
        f"  fail(w, kFactorization, {join.joint});",
        *(couple(words, coupling) for coupling in join.couplings),
        *block_updates(words, join),
        *bias_updates(words, join),
    ]
    return lines


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
    for update in end.updates:
        change = "i.run.X.transposed_times(f)" if update.side == "A" else "f"
        sign = "-" if update.side == "A" else "+"
        acting = "Columns6::Zero()" if update.source is None else words.force(update.source)
        lines.append(f"{words.force(update.target)} = {acting} {sign} {change};")
    return lines
