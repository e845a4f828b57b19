"""Runs of joints through massless links, joined as one, in shape `kernels`: as C++ lines.

They are in their links' own axes (adagen/kernels/fused.hpp), where S keeps all its digits.
"""

from __future__ import annotations

from adagen.emit.joints.fused import felt, fused, joined, named, released, rows_of
from adagen.emit.joints.joins import store
from adagen.emit.words import Words
from adagen.plan.steps import Disassemble, FusedJoin


def assembly(words: Words, join: FusedJoin) -> list[str]:
    """Eq. (3)-(7) of the run in its coordinates."""
    lines = [named(words, join)]
    for j, first, count in rows_of(words, join):
        lines += [
            "{",
            f"  extend<{words.type_of(j)}, {first}>(i.run, own_transform(w, {j}));",
            f"  std::array<std::array<Real, kColumns>, {count}> tau;",
            f"  load_torque(w, {j}, {words.plan.joints[j].v}, tau);",
            f"  place<{first}>(tau, i.joined.tau);",
            "}",
        ]
    lines += fused(join)
    if join.a_bias is None:
        return lines + joined(words, join, "kGround")
    lines.append(f"i.run.BX = for_expressed(w, {parent(words, join)}, i.run.BX);")
    return lines + joined(words, join, words.bias(join.a_bias))


def disassembly(words: Words, join: FusedJoin, end: Disassemble) -> list[str]:
    """Eq. (8)-(10) of the run: the accelerations of its joints, and what its ends get to feel."""
    lines = released(words, join, end)
    if words.refine:
        lines.append(f"w.refinement.f[{join.joint}].col(w.refinement.side) = f;")
    for j, first, count in rows_of(words, join):
        lines.append(f"{store(words, j, f'part<{first}, {count}>(release.qdd())')}  // Eq. (9)")
    on_a = f"to_expressed(w, {parent(words, join)}, i.run.X.transposed_times(f))"
    return lines + felt(words, end, on_a)


def parent(words: Words, join: FusedJoin) -> int:
    """Return the link that a run begins at."""
    return words.plan.joints[join.run[0]].parent
