"""Runs of joints through massless links, joined as one, in shape `kernels`: as C++ lines.

They are in their links' own axes (adagen/kernels/fused.hpp), where S keeps all its digits.
"""

from __future__ import annotations

from adagen.emit.joints.fused import couple, released, rows_of
from adagen.emit.joints.joins import bias_updates, block_updates, store
from adagen.emit.words import Words
from adagen.plan.steps import Disassemble, FusedJoin


def assembly(words: Words, join: FusedJoin) -> list[str]:
    """Eq. (3)-(7) of the run in its coordinates."""
    others = ", ".join(words.quoted_joint(j) for j in join.run[:-1])
    lines = [f"auto& i = {words.memory(join.joint)};  // one joint with {others}"]
    for j, first, count in rows_of(words, join):
        lines += [
            "{",
            f"  extend<{words.type_of(j)}, {first}>(i.run, own_transform(w, {j}));",
            f"  std::array<std::array<Real, kColumns>, {count}> tau;",
            f"  load_torque(w, {j}, {words.plan.joints[j].v}, tau);",
            f"  place<{first}>(tau, i.joined.tau);",
            "}",
        ]
    lines += [
        f"if (!fuse(i.run)) fail(w, kGimbalLock, {join.joint});",
        f"if (i.run.lock < kNearLock) w.near_lock = {join.joint + 1};",
    ]
    near = parent(words, join)
    phi_a, b_a = "kZero", "kGround"
    if join.a is not None:
        assert join.a_bias is not None
        lines.append(f"i.run.BX = for_expressed(w, {near}, i.run.BX);")
        lines.append(f"const Mat6 X_Phi_A = i.run.BX * {words.block(join.a)};")
        lines.append("const Mat6 Phi_A = X_Phi_A * i.run.BX.transpose();")
        phi_a, b_a = "Phi_A", words.bias(join.a_bias)
    return [
        *lines,
        f"const Mat6 X_Phi_B = i.run.B * {words.block(join.b)};",
        "const Mat6 Phi_B = X_Phi_B * i.run.B.transpose();",
        f"if (!join(i.joined, {phi_a}, Phi_B, i.run.BX * {b_a}, "
        f"i.run.B * {words.bias(join.b_bias)}, i.run.c))",
        f"  fail(w, kFactorization, {join.joint});",
        *(couple(words, coupling) for coupling in join.couplings),
        *block_updates(words, join),
        *bias_updates(words, join),
    ]


def disassembly(words: Words, join: FusedJoin, end: Disassemble) -> list[str]:
    """Eq. (8)-(10) of the run: the accelerations of its joints, and what its ends get to feel."""
    lines = released(words, join, end)
    if words.refine:
        lines.append(f"w.refinement.f[{join.joint}].col(w.refinement.side) = f;")
    for j, first, count in rows_of(words, join):
        lines.append(f"{store(words, j, f'part<{first}, {count}>(release.qdd())')}  // Eq. (9)")
    near = parent(words, join)
    for update in end.updates:
        sign, change = "+", "f"
        if update.side == "A":
            sign, change = "-", f"to_expressed(w, {near}, i.run.X.transposed_times(f))"
        acting = "Columns6::Zero()" if update.source is None else words.force(update.source)
        lines.append(f"{words.force(update.target)} = {acting} {sign} {change};")
    return lines


def parent(words: Words, join: FusedJoin) -> int:
    """Return the link that a run begins at."""
    return words.plan.joints[join.run[0]].parent
