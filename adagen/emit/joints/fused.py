"""Assembly and disassembly of a run of joints as one, as C++ lines."""

from __future__ import annotations

from collections.abc import Iterable

from adagen.emit.forces import passive_torques
from adagen.emit.joints.joins import bias_updates, block_updates, coupling_torques, released, store
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


def assembly(symbols: Symbols, join: FusedJoin, *, turned: bool = False) -> list[str]:
    """Eq. (3)-(7) of the run: its motions, then as for any joint in its coordinates.

    With ``turned`` in shape kernels, where the links before and beyond the run are in axes of the
    base or in their own (adagen/kernels/fused.hpp).
    """
    others = ", ".join(symbols.quoted_joint(j) for j in join.run[:-1])
    lines = [f"auto& i = {symbols.memory(join.joint)};  // one joint with {others}"]
    for j, first, count in rows_of(symbols, join):
        kind, memory = symbols.type_of(j), symbols.memory(j)
        if turned:
            moved = [f"extend<{kind}, {first}>(i.run, own_transform(w, {j}));"]
            acting = []
        else:
            slaved = symbols.plan.joints[j].mimic is not None
            product = f"velocity_product<{kind}>({memory}.v, {velocity(symbols, j)})"
            moved = [
                *configuration(symbols, j)[1:] * slaved,
                f"extend<{kind}, {first}>(i.run, {memory}.X);",
                f"i.run.c += {product};",
            ]
            acting = [*coupling_torques(symbols, j, "tau"), *passive_torques(symbols, j, "tau")]
        lines += _driven(symbols, j, first, count, moved, acting)
    joints = [symbols.plan.joints[j] for j in join.run]
    length = run_length(joints, symbols.plan.links[join.joint + 1])
    lines += [
        f"if (!fuse(i.run, Real({1.0 / length!r}))) fail(w, kGimbalLock, {join.joint});",
        f"if (i.run.lock < kNearLock) w.near_lock = {join.joint + 1};",
    ]
    if turned and join.a_bias is not None:
        lines.append(f"i.run.BX = for_expressed(w, {joints[0].parent}, i.run.BX);")
    ground = "kGround" if turned else "w.ground"
    b_a = ground if join.a_bias is None else symbols.bias(join.a_bias)
    return lines + _joined(symbols, join, b_a, keeps_sum=bool(symbols.refine) and not turned)


def _driven(
    symbols: Symbols,
    j: int,
    first: int,
    count: int,
    moved: Iterable[str] = (),
    acting: Iterable[str] = (),
) -> list[str]:
    """The torques of a joint in its rows of a run, behind lines on its motion.

    What else acts on it adds to them.
    """
    lines = [
        *moved,
        f"std::array<std::array<Real, kColumns>, {count}> tau;",
        f"load_torque(w, {j}, {symbols.plan.joints[j].v}, tau);",
        *acting,
        f"place<{first}>(tau, i.joined.tau);",
    ]
    return ["{", *(f"  {line}" for line in lines), "}"]


def _joined(symbols: Symbols, join: FusedJoin, b_a: str, *, keeps_sum: bool) -> list[str]:
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
        *(_couple(symbols, coupling) for coupling in join.couplings),
        *block_updates(symbols, join),
        *bias_updates(symbols, join),
    ]


def _couple(symbols: Symbols, coupling: Coupling) -> str:
    """The line of the coupling between a handle and the run."""
    transposed = ".transpose()" if coupling.transposed else ""
    frame = "BX" if coupling.side == "A" else "B"
    phi = f"i.run.{frame} * {symbols.block(coupling.source)}{transposed}"
    return f"couple(i.joined, {phi}, i.at_{symbols.links[coupling.handle]});"


def reassembly(symbols: Symbols, join: FusedJoin) -> list[str]:
    """The same for other biases, and the missing torques of its joints."""
    lines = []
    for row in rows_of(symbols, join):
        lines += _driven(symbols, *row)
    b_a = "w.ground" if join.a_bias is None else symbols.bias(join.a_bias)
    b_b = f"i.run.B * {symbols.bias(join.b_bias)}"
    return [
        *lines,
        f"rejoin(i.joined, i.P, i.run.BX * {b_a}, {b_b});",
        *bias_updates(symbols, join),
    ]


def disassembly(
    symbols: Symbols, join: FusedJoin, end: Disassemble, *, turned: bool = False
) -> list[str]:
    """Eq. (8)-(10) of the run: accelerations of its joints, and forces on its ends.

    With ``turned``, as of ``assembly``.
    """
    lines = released(symbols, type_of(symbols, join), join, end)
    if end.updates or symbols.refine:
        lines.append("const Columns6 f = i.run.B.transpose() * release.force();  // Eq. (8), (10)")
    else:
        lines.append("release.force();  // Eq. (8)")
    if symbols.refine:
        side = ".col(w.refinement.side)" * turned
        lines.append(f"w.refinement.f[{join.joint}]{side} = f;")
    for j, first, count in rows_of(symbols, join):
        qdd = f"part<{first}, {count}>(release.qdd())"
        if symbols.plan.slaved and not turned:
            lines.append(f"{symbols.memory(j)}.qdd = {qdd};  // Eq. (9)")
        else:
            lines.append(f"{store(symbols, j, qdd)}  // Eq. (9)")
    on_a = "i.run.X.transposed_times(f)"
    if turned:
        on_a = f"to_expressed(w, {symbols.plan.joints[join.run[0]].parent}, {on_a})"
    for update in end.updates:
        change = f"- {on_a}" if update.side == "A" else "+ f"
        acting = "Columns6::Zero()" if update.source is None else symbols.force(update.source)
        lines.append(f"{symbols.force(update.target)} = {acting} {change};")
    return lines
