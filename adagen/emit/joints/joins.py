"""Assembly and disassembly of a joint as C++ lines, in the paper's symbols: Eq. (3)-(10)."""

from __future__ import annotations

from adagen.emit import effects
from adagen.emit.joints.kinematics import configuration, velocity
from adagen.emit.words import Words
from adagen.plan.digits import least_mobility
from adagen.plan.steps import Coupling, Disassemble, FusedJoin, Join


def parts(words: Words, join: Join, end: Disassemble) -> str:
    """One line on the two parts and the whole that a join makes."""
    first = join.run[0] if isinstance(join, FusedJoin) else join.joint
    parent = words.plan.joints[first].parent
    below = {update.side: update.target.joint for update in end.updates}

    def part(side: str, link: int) -> str:
        if side in below:
            return f"the chain of {words.quoted_joint(below[side])}"
        return (
            f"the ground {words.quoted_link(0)}" if link == 0 else f"link {words.quoted_link(link)}"
        )

    handles = ", ".join(words.quoted_link(c.handle) for c in join.couplings) or "no link"
    return f"A: {part('A', parent)}; B: {part('B', join.joint + 1)}; C feels the joint at {handles}"


def assembly(words: Words, join: Join, *, turned: bool = False) -> list[str]:
    """Eq. (3)-(7): V_i and beta_i, then what C's handles feel.

    With ``turned``, blocks at the child link are not in the joint's frame either: i.Y leads there.
    """
    own = "i.Y * " if turned else ""
    j = join.joint
    rotor = words.plan.joints[j].rotor_inertia
    tau = "i.tau" if rotor else "i.joined.tau"
    lines = [f"auto& i = {words.memory(j)};", *torques(words, j, tau, turned=turned)]
    if join.a is None:
        phi_a = "kZero"
    else:
        lines.append(f"const Mat6 X_Phi_A = i.X * {words.block(join.a)};")
        lines.append("const Mat6 Phi_A = from_right(X_Phi_A, i.X);")
        phi_a = "Phi_A"
    if turned:
        lines.append(f"const Mat6 Phi_B = from_right(i.Y * {words.block(join.b)}, i.Y);")
    phi_b = "Phi_B" if turned else words.block(join.b)
    ground = "kGround" if turned else "w.ground"
    b_a = ground if join.a_bias is None else words.bias(join.a_bias)
    given = effects.prescribe(words, j, "c", turned=turned)
    c = "Columns6 c" if given or rotor else "const Columns6 c"
    if join.velocity_product:
        lines += velocity_product(words, j, c)
    else:
        lines.append(f"{c} = Columns6::Zero();")
    lines += given
    if rotor:
        kind, size = words.type_of(j), words.printer.number(rotor)
        lines.append(f"drive<{kind}>(i.tau, {size}, c);")
        phi_b = f"with_rotor<{kind}>({phi_b}, {size})"
    lines += _digits(words, join, phi_a, phi_b)
    lines.append(
        f"if (!join(i.joined, {phi_a}, {phi_b}, i.X * {b_a}, {own}{words.bias(join.b_bias)}, c))"
    )
    lines.append(f"  fail(w, kFactorization, {j});")
    lines.extend(_couple(words, join, coupling, turned) for coupling in join.couplings)
    lines.extend(block_updates(words, join))
    lines.extend(bias_updates(words, join))
    return lines


def _digits(words: Words, join: Join, phi_a: str, phi_b: str) -> list[str]:
    """The guard against a loss of all digits."""
    least = least_mobility(words.plan, join)
    if not least:
        return []
    numbers = words.printer.numbers(least)
    kind = words.type_of(join.joint)
    return [
        f"constexpr std::array<Real, 6> least{{{numbers}}};",
        f"if (!keeps_digits<{kind}>({phi_a}, {phi_b}, least))",
        f"  fail(w, kGrowth, {join.joint});",
    ]


def velocity_product(words: Words, j: int, target: str) -> list[str]:
    """The lines that set c = v x S qd; next to the ground v is S qd itself, and c zero."""
    joint = words.plan.joints[j]
    if joint.parent == 0:
        return [f"{target} = Columns6::Zero();"]
    product = f"velocity_product<{words.type_of(j)}>(i.v, {velocity(words, j)})"
    slaved = [] if joint.mimic is None else [configuration(words, j)[1]]
    return [*slaved, f"{target} = {product};"]


def store(words: Words, j: int, qdd: str) -> str:
    """The line that gives a joint's acceleration away, or keeps it until coupling is solved."""
    if words.columns > 1:
        return f"i.qdd = {qdd};"
    return f"store_acceleration(w, {j}, {words.plan.joints[j].v}, {qdd});"


def torques(words: Words, j: int, tau: str, *, turned: bool = False) -> list[str]:
    """The lines that set a joint's torques at work; none where its acceleration is prescribed."""
    joint = words.plan.joints[j]
    if joint.prescribed:
        return []
    load = f"load_torque(w, {j}, {joint.v}, {tau});"
    if turned:  # what passive effects take, it knows
        return [load]
    return [
        load,
        *coupling_torques(words, j, tau),
        *effects.passive_torques(words, j, tau),
    ]


def coupling_torques(words: Words, j: int, tau: str) -> list[str]:
    """The unit torques by which slaved joints and their sources are held in step."""
    plan, lines = words.plan, []
    if words.columns == 1:
        return []
    for column, slaved in enumerate(plan.slaved, start=1):
        mimic = plan.joints[slaved].mimic
        assert mimic is not None  # that is what slaved means
        if j == slaved:
            lines.append(f"{tau}[0][{column}] = 1;")
        if j == mimic[0]:
            lines.append(f"{tau}[0][{column}] = {words.printer.number(-mimic[1])};")
    return lines


def _couple(words: Words, join: Join, coupling: Coupling, turned: bool) -> str:
    source = words.block(coupling.source)
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
    return f"couple(i.joined, {phi}, i.at_{words.links[coupling.handle]});"


def block_updates(words: Words, join: Join) -> list[str]:
    """Eq. (3)-(5): the blocks of C that change."""
    sides = {coupling.handle: coupling.side for coupling in join.couplings}
    lines = []
    for block in join.blocks:
        row, column = words.links[block.target.row], words.links[block.target.column]
        product = f"product(i.at_{row}, i.at_{column})"
        if block.across:
            text, equation = product, 5
        else:
            assert block.source is not None  # handles of one side that feel one joint
            text = f"{words.block(block.source)} - {product}"
            equation = 3 if sides[block.target.row] == "A" else 4
        lines.append(f"i.{words.block_member(block.target)} = {text};  // Eq. ({equation})")
    return lines


def bias_updates(words: Words, join: Join) -> list[str]:
    """Eq. (6), (7): the biases of C."""
    lines = []
    for bias in join.biases:
        handle = words.links[bias.target.handle]
        sign, equation = ("-", 6) if bias.side == "A" else ("+", 7)
        lines.append(
            f"i.b_{handle} = {words.bias(bias.source)} {sign} "
            f"bias_change(i.joined, i.at_{handle});  // Eq. ({equation})"
        )
    return lines


def disassembly(words: Words, join: Join, end: Disassemble, *, turned: bool = False) -> list[str]:
    """Eq. (8)-(10): the joint's acceleration and force, and what the two parts get to feel.

    With ``turned``, the child link's part is not in the joint's frame: see ``assembly``.
    """
    j = join.joint
    kind = effects.joined_type(words, j)
    lines = [f"auto& i = {words.memory(j)};", f"Release<{kind}> release(i.joined);"]
    for coupling, force in zip(join.couplings, end.forces, strict=True):
        handle = words.links[coupling.handle]
        lines.append(f"release.feel_{coupling.side}(i.at_{handle}, {words.force(force)});")
    joint = words.plan.joints[j]
    if words.refine and turned:
        lines.append("const Columns6 f = release.force();  // Eq. (8), (10)")
        lines.append(f"w.refinement.f[{j}].col(w.refinement.side) = f;")
    elif words.refine:
        kept = f"w.refinement.f[{j}] = release.force();"
        lines.append(f"const Columns6& f = {kept}" if end.updates else kept)
    elif end.updates or joint.rotor_inertia:
        lines.append("const Columns6 f = release.force();  // Eq. (8), (10)")
    else:
        lines.append("release.force();  // Eq. (8)")
    if joint.prescribed:
        lines += [*effects.given_acceleration(words, j), store(words, j, "qdd")]
    elif joint.rotor_inertia:
        size = words.printer.number(joint.rotor_inertia)
        lines.append(store(words, j, f"rotor_acceleration<{words.type_of(j)}>(i.tau, {size}, f)"))
    else:
        lines.append(f"{store(words, j, 'release.qdd()')}  // Eq. (9)")
    for update in end.updates:
        if update.side == "A":
            change = "i.X.transposed_times(f)"
        else:
            change = "i.Y.transposed_times(f)" if turned else "f"
        if update.source is None:
            text = f"-{change}" if update.side == "A" else change
        else:
            sign = "-" if update.side == "A" else "+"
            text = f"{words.force(update.source)} {sign} {change}"
        lines.append(f"{words.force(update.target)} = {text};")
    return lines
