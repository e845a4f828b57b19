"""Form `ada`: a joint's memory, assembly and disassembly as C++ lines, in the paper's symbols."""

from __future__ import annotations

from collections import defaultdict

from adagen.emit.kinematics import configuration, kinematics_lines, velocity
from adagen.emit.words import Words
from adagen.plan.types import Coupling, Disassemble, Force, Join, LinkBias


def joint_rows(words: Words) -> list[dict[str, object]]:
    """Return what the template says of each joint."""
    plan = words.plan
    joins: dict[int, Join] = {}
    ends: dict[int, Disassemble] = {}
    for process in plan.processes:
        for step in process.steps:
            if isinstance(step, Join):
                joins[step.joint] = step
            elif isinstance(step, Disassemble):
                ends[step.joint] = step
    members = _members(words, joins, ends)
    return [
        {
            "id": f"j_{words.joints[j]}",
            "type": f"Joint_{words.joints[j]}",
            "word": words.joints[j],
            "quoted": words.quoted_joint(j),
            "kind": joint.kind,
            "parent_quoted": words.quoted_link(joint.parent),
            "child_quoted": words.quoted_link(j + 1),
            "members": members[j],
            "kinematics": kinematics_lines(words, j),
            "parts": _parts(words, joins[j], ends[j]),
            "assembly": _assembly(words, joins[j]),
            "disassembly": _disassembly(words, joins[j], ends[j]),
        }
        for j, joint in enumerate(plan.joints)
    ]


def _members(words: Words, joins: dict[int, Join], ends: dict[int, Disassemble]) -> list[list[str]]:
    """The memory of each joint: all that any process keeps with it."""
    plan = words.plan
    forces: dict[int, list[Force]] = defaultdict(list)
    for end in ends.values():
        for update in end.updates:
            forces[update.target.joint].append(update.target)
    bare = {step.link for p in plan.processes for step in p.steps if isinstance(step, LinkBias)}
    result = []
    for j in range(len(plan.joints)):
        kind = words.type_of(j)
        lines = [
            "Transform X;  // parent link's to child link's frame",
            f"Vec6 v;  // velocity of link {words.quoted_link(j + 1)}",
        ]
        if j + 1 in bare:
            lines.append(
                f"Columns6 b;  // bias acceleration of the bare link {words.quoted_link(j + 1)}"
            )
        lines.append(f"Joined<{kind}> joined;")
        for coupling in joins[j].couplings:
            lines.append(f"Coupled<{kind}> at_{words.links[coupling.handle]};")
        for block in joins[j].blocks:
            lines.append(f"Mat6 {words.block_member(block.target)};  // of the chain it completes")
        for bias in joins[j].biases:
            lines.append(f"Columns6 b_{words.links[bias.target.handle]};")
        for force in sorted(forces[j]):
            lines.append(f"Columns6 {words.force_member(force)};  // outer wrench on that chain")
        if plan.right_hand_sides > 1:
            lines.append(f"std::array<std::array<Real, kColumns>, kFree<{kind}>> qdd;")
        result.append(lines)
    return result


def _parts(words: Words, join: Join, end: Disassemble) -> str:
    """One line on the two parts and the whole that a join makes."""
    joint = words.plan.joints[join.joint]
    below = {update.side: update.target.joint for update in end.updates}

    def part(side: str, link: int) -> str:
        if side in below:
            return f"the chain of {words.quoted_joint(below[side])}"
        return (
            f"the ground {words.quoted_link(0)}" if link == 0 else f"link {words.quoted_link(link)}"
        )

    handles = ", ".join(words.quoted_link(c.handle) for c in join.couplings) or "no link"
    return (
        f"A: {part('A', joint.parent)}; B: {part('B', join.joint + 1)};"
        f" C feels the joint at {handles}"
    )


def _assembly(words: Words, join: Join) -> list[str]:
    plan, j = words.plan, join.joint
    joint, kind = plan.joints[j], words.type_of(j)
    lines = [
        f"auto& i = {words.memory(j)};",
        f"load_torque(w, {j}, {joint.v}, i.joined.tau);",
        *_coupling_torques(words, j),
    ]
    if join.a is None:
        phi_a = "kZero"
    else:
        lines.append(f"const Mat6 X_Phi_A = i.X * {words.block(join.a)};")
        lines.append("const Mat6 Phi_A = from_right(X_Phi_A, i.X);")
        phi_a = "Phi_A"
    b_a = "kGround" if join.a_bias is None else words.bias(join.a_bias)
    if join.velocity_product:
        if joint.mimic is not None:
            lines.append(configuration(words, j)[1])
        product = f"velocity_product<{kind}>(i.v, {velocity(words, j)})"
        lines.append(f"const Columns6 c = {product};")
    else:
        lines.append("const Columns6 c = Columns6::Zero();  // v x S qd, v being S qd itself")
    lines.append(
        f"if (!join(i.joined, {phi_a}, {words.block(join.b)}, i.X * {b_a}, "
        f"{words.bias(join.b_bias)}, c))"
    )
    lines.append(f"  fail(w, kFactorization, {j});")
    lines.extend(_couple(words, join, coupling) for coupling in join.couplings)
    lines.extend(_updates(words, join))
    return lines


def _coupling_torques(words: Words, j: int) -> list[str]:
    """The unit torques by which slaved joints and their sources are held in step."""
    plan, lines = words.plan, []
    for column, slaved in enumerate(plan.slaved, start=1):
        mimic = plan.joints[slaved].mimic
        assert mimic is not None  # that is what slaved means
        if j == slaved:
            lines.append(f"i.joined.tau[0][{column}] = 1;")
        if j == mimic[0]:
            lines.append(f"i.joined.tau[0][{column}] = {words.printer.number(-mimic[1])};")
    return lines


def _couple(words: Words, join: Join, coupling: Coupling) -> str:
    source = words.block(coupling.source)
    if coupling.side == "A":
        if coupling.source == join.a:
            phi = "X_Phi_A"
        elif coupling.transposed:
            phi = f"times_transposed(i.X, {source})"
        else:
            phi = f"i.X * {source}"
    else:
        phi = f"{source}.transpose()" if coupling.transposed else source
    return f"couple(i.joined, {phi}, i.at_{words.links[coupling.handle]});"


def _updates(words: Words, join: Join) -> list[str]:
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
    for bias in join.biases:
        handle = words.links[bias.target.handle]
        sign, equation = ("-", 6) if bias.side == "A" else ("+", 7)
        lines.append(
            f"i.b_{handle} = {words.bias(bias.source)} {sign} "
            f"bias_change(i.joined, i.at_{handle});  // Eq. ({equation})"
        )
    return lines


def _disassembly(words: Words, join: Join, end: Disassemble) -> list[str]:
    plan, j = words.plan, join.joint
    joint = plan.joints[j]
    lines = [f"auto& i = {words.memory(j)};", f"Release<{words.type_of(j)}> release(i.joined);"]
    for coupling, force in zip(join.couplings, end.forces, strict=True):
        handle = words.links[coupling.handle]
        lines.append(f"release.feel_{coupling.side}(i.at_{handle}, {words.force(force)});")
    if end.updates:
        lines.append("const Columns6 f = release.force();  // Eq. (8), (10)")
    else:
        lines.append("release.force();  // Eq. (8)")
    if plan.slaved:
        lines.append("i.qdd = release.qdd();  // Eq. (9)")
    else:
        lines.append(f"store_acceleration(w, {j}, {joint.v}, release.qdd());  // Eq. (9)")
    for update in end.updates:
        change = "i.X.transposed_times(f)" if update.side == "A" else "f"
        if update.source is None:
            text = f"-{change}" if update.side == "A" else change
        else:
            sign = "-" if update.side == "A" else "+"
            text = f"{words.force(update.source)} {sign} {change}"
        lines.append(f"{words.force(update.target)} = {text};")
    return lines
