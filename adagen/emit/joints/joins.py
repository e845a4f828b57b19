"""Assembly and disassembly of a joint as C++ lines, in the paper's symbols: Eq. (3)-(10)."""

from __future__ import annotations

from adagen.emit import forces
from adagen.emit.joints.kinematics import configuration, velocity
from adagen.emit.symbols import Symbols
from adagen.plan.digits import least_mobility
from adagen.plan.steps import Coupling, Disassemble, FusedJoin, Join


def parts(symbols: Symbols, join: Join, end: Disassemble) -> str:
    """One line about the two parts and the whole of a join."""
    first = join.run[0] if isinstance(join, FusedJoin) else join.joint
    parent = symbols.plan.joints[first].parent
    below = {update.side: update.target.joint for update in end.updates}

    def part(side: str, link: int) -> str:
        if side in below:
            return f"the chain of {symbols.quoted_joint(below[side])}"
        return (
            f"the ground {symbols.quoted_link(0)}"
            if link == 0
            else f"link {symbols.quoted_link(link)}"
        )

    handles = ", ".join(symbols.quoted_link(c.handle) for c in join.couplings) or "no link"
    return f"A: {part('A', parent)}; B: {part('B', join.joint + 1)}; C feels the joint at {handles}"


def assembly(symbols: Symbols, join: Join, *, turned: bool = False) -> list[str]:
    """Eq. (3)-(7): V_i and beta_i, then the couplings with C's handles.

    With ``turned``, blocks at the child link are not in the joint's frame either: i.Y leads there.
    """
    own = "i.Y * " if turned else ""
    j = join.joint
    rotor = symbols.plan.joints[j].rotor_inertia
    tau = "i.tau" if rotor else "i.joined.tau"
    lines = [f"auto& i = {symbols.memory(j)};", *torques(symbols, j, tau, turned=turned)]
    if join.a is None:
        phi_a = "kZero"
    else:
        lines.append(f"const Mat6 X_Phi_A = i.X * {symbols.block(join.a)};")
        lines.append("const Mat6 Phi_A = from_right(X_Phi_A, i.X);")
        phi_a = "Phi_A"
    if turned:
        lines.append(f"const Mat6 Phi_B = from_right(i.Y * {symbols.block(join.b)}, i.Y);")
    phi_b = "Phi_B" if turned else symbols.block(join.b)
    ground = "kGround" if turned else "w.ground"
    b_a = ground if join.a_bias is None else symbols.bias(join.a_bias)
    given = forces.prescribe(symbols, j, "c", turned=turned)
    c = "Columns6 c" if given or rotor else "const Columns6 c"
    if join.velocity_product:
        lines += velocity_product(symbols, j, c)
    else:
        lines.append(f"{c} = Columns6::Zero();")
    lines += given
    if rotor:
        kind, size = symbols.type_of(j), symbols.printer.number(rotor)
        lines.append(f"drive<{kind}>(i.tau, {size}, c);")
        phi_b = f"with_rotor<{kind}>({phi_b}, {size})"
    lines += _digits(symbols, join, phi_a, phi_b)
    lines.append(
        f"if (!join(i.joined, {phi_a}, {phi_b}, i.X * {b_a}, {own}{symbols.bias(join.b_bias)}, c))"
    )
    lines.append(f"  fail(w, kFactorization, {j});")
    lines.extend(_couple(symbols, join, coupling, turned) for coupling in join.couplings)
    lines.extend(block_updates(symbols, join))
    lines.extend(bias_updates(symbols, join))
    return lines


def _digits(symbols: Symbols, join: Join, phi_a: str, phi_b: str) -> list[str]:
    """The guard against a loss of all digits."""
    least = least_mobility(symbols.plan, join)
    if not least:
        return []
    numbers = symbols.printer.numbers(least)
    kind = symbols.type_of(join.joint)
    return [
        f"constexpr std::array<Real, 6> least{{{numbers}}};",
        f"if (!keeps_digits<{kind}>({phi_a}, {phi_b}, least))",
        f"  fail(w, kGrowth, {join.joint});",
    ]


def velocity_product(symbols: Symbols, j: int, target: str) -> list[str]:
    """The lines that set c = v x S qd; next to the ground v is S qd itself, and c zero."""
    joint = symbols.plan.joints[j]
    if joint.parent == 0:
        return [f"{target} = Columns6::Zero();"]
    product = f"velocity_product<{symbols.type_of(j)}>(i.v, {velocity(symbols, j)})"
    slaved = [] if joint.mimic is None else [configuration(symbols, j)[1]]
    return [*slaved, f"{target} = {product};"]


def store(symbols: Symbols, j: int, qdd: str) -> str:
    """The line that outputs a joint's acceleration, or stores it until coupling is solved."""
    if symbols.columns > 1:
        return f"i.qdd = {qdd};"
    return f"store_acceleration(w, {j}, {symbols.plan.joints[j].v}, {qdd});"


def torques(symbols: Symbols, j: int, tau: str, *, turned: bool = False) -> list[str]:
    """The lines that set a joint's torques; none where its acceleration is prescribed."""
    joint = symbols.plan.joints[j]
    if joint.prescribed:
        return []
    load = f"load_torque(w, {j}, {joint.v}, {tau});"
    if turned:  # what passive effects take, it knows
        return [load]
    return [
        load,
        *coupling_torques(symbols, j, tau),
        *forces.passive_torques(symbols, j, tau),
    ]


def coupling_torques(symbols: Symbols, j: int, tau: str) -> list[str]:
    """The unit coupling torques of slaved joints and their sources."""
    lines: list[str] = []
    if symbols.columns == 1:
        return lines
    for column, (slaved, source, multiplier) in enumerate(symbols.plan.following, start=1):
        if j == slaved:
            lines.append(f"{tau}[0][{column}] = 1;")
        if j == source:
            lines.append(f"{tau}[0][{column}] = {symbols.printer.number(-multiplier)};")
    return lines


def _couple(symbols: Symbols, join: Join, coupling: Coupling, turned: bool) -> str:
    source = symbols.block(coupling.source)
    if coupling.side == "A":
        if coupling.source == join.a:
            phi = "X_Phi_A"
        elif coupling.transposed:
            phi = f"times_transposed(i.X, {source})"
        else:
            phi = f"i.X * {source}"
    elif turned:
        phi = f"times_transposed(i.Y, {source})" if coupling.transposed else f"i.Y * {source}"
    else:
        phi = f"{source}.transpose()" if coupling.transposed else source
    return f"couple(i.joined, {phi}, i.at_{symbols.links[coupling.handle]});"


def block_updates(symbols: Symbols, join: Join) -> list[str]:
    """Eq. (3)-(5): the blocks of C that change."""
    sides = {coupling.handle: coupling.side for coupling in join.couplings}
    lines = []
    for block in join.blocks:
        row, column = symbols.links[block.target.row], symbols.links[block.target.column]
        product = f"product(i.at_{row}, i.at_{column})"
        if block.across:
            text, equation = product, 5
        else:
            assert block.source is not None  # handles of one side that feel one joint
            text = f"{symbols.block(block.source)} - {product}"
            equation = 3 if sides[block.target.row] == "A" else 4
        lines.append(f"i.{symbols.block_member(block.target)} = {text};  // Eq. ({equation})")
    return lines


def bias_updates(symbols: Symbols, join: Join) -> list[str]:
    """Eq. (6), (7): the biases of C."""
    lines = []
    for bias in join.biases:
        handle = symbols.links[bias.target.handle]
        sign, equation = ("-", 6) if bias.side == "A" else ("+", 7)
        lines.append(
            f"i.b_{handle} = {symbols.bias(bias.source)} {sign} "
            f"bias_change(i.joined, i.at_{handle});  // Eq. ({equation})"
        )
    return lines


def released(symbols: Symbols, kind: str, join: Join, end: Disassemble) -> list[str]:
    """The lines that release a join of a C++ type and tell it the forces on C's handles."""
    lines = [f"auto& i = {symbols.memory(join.joint)};", f"Release<{kind}> release(i.joined);"]
    for coupling, force in zip(join.couplings, end.forces, strict=True):
        handle = symbols.links[coupling.handle]
        lines.append(f"release.feel_{coupling.side}(i.at_{handle}, {symbols.force(force)});")
    return lines


def disassembly(
    symbols: Symbols, join: Join, end: Disassemble, *, turned: bool = False
) -> list[str]:
    """Eq. (8)-(10): the joint's acceleration and force, and the forces on the two parts.

    With ``turned``, the child link's part is not in the joint's frame: see ``assembly``.
    """
    j = join.joint
    lines = released(symbols, forces.joined_type(symbols, j), join, end)
    joint = symbols.plan.joints[j]
    if symbols.refine and turned:
        lines.append("const Columns6 f = release.force();  // Eq. (8), (10)")
        lines.append(f"w.refinement.f[{j}].col(w.refinement.side) = f;")
    elif symbols.refine:
        kept = f"w.refinement.f[{j}] = release.force();"
        lines.append(f"const Columns6& f = {kept}" if end.updates else kept)
    elif end.updates or joint.rotor_inertia:
        lines.append("const Columns6 f = release.force();  // Eq. (8), (10)")
    else:
        lines.append("release.force();  // Eq. (8)")
    if joint.prescribed:
        lines += [*forces.given_acceleration(symbols, j), store(symbols, j, "qdd")]
    elif joint.rotor_inertia:
        size = symbols.printer.number(joint.rotor_inertia)
        lines.append(
            store(symbols, j, f"rotor_acceleration<{symbols.type_of(j)}>(i.tau, {size}, f)")
        )
    else:
        lines.append(f"{store(symbols, j, 'release.qdd()')}  // Eq. (9)")
    for update in end.updates:
        if update.side == "A":
            change = "i.X.transposed_times(f)"
        else:
            change = "i.Y.transposed_times(f)" if turned else "f"
        if update.source is None:
            text = f"-{change}" if update.side == "A" else change
        else:
            sign = "-" if update.side == "A" else "+"
            text = f"{symbols.force(update.source)} {sign} {change}"
        lines.append(f"{symbols.force(update.target)} = {text};")
    return lines
