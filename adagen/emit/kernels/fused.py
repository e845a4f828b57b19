"""Runs of joints through massless links, joined as one, in shape `kernels`: as C++ lines.

They are in their links' own axes (adagen/kernels/fused.hpp), where S keeps all its digits.
"""

from __future__ import annotations

from adagen.emit.joints.fused import felt, fused, joined, named, released, rows_of
from adagen.emit.joints.joins import store
from adagen.emit.symbols import Symbols
from adagen.plan.steps import Disassemble, FusedJoin


def assembly(symbols: Symbols, join: FusedJoin) -> list[str]:
    """Eq. (3)-(7) of the run in its coordinates."""
    lines = [named(symbols, join)]
    for j, first, count in rows_of(symbols, join):
        lines += [
            "{",
            f"  extend<{symbols.type_of(j)}, {first}>(i.run, own_transform(w, {j}));",
            f"  std::array<std::array<Real, kColumns>, {count}> tau;",
            f"  load_torque(w, {j}, {symbols.plan.joints[j].v}, tau);",
            f"  place<{first}>(tau, i.joined.tau);",
            "}",
        ]
    lines += fused(symbols, join)
    if join.a_bias is None:
        return lines + joined(symbols, join, "kGround")
    lines.append(f"i.run.BX = for_expressed(w, {parent(symbols, join)}, i.run.BX);")
    return lines + joined(symbols, join, symbols.bias(join.a_bias))


def disassembly(symbols: Symbols, join: FusedJoin, end: Disassemble) -> list[str]:
    """Eq. (8)-(10) of the run: accelerations of its joints, and forces on its ends."""
    lines = released(symbols, join, end)
    if symbols.refine:
        lines.append(f"w.refinement.f[{join.joint}].col(w.refinement.side) = f;")
    for j, first, count in rows_of(symbols, join):
        lines.append(f"{store(symbols, j, f'part<{first}, {count}>(release.qdd())')}  // Eq. (9)")
    on_a = f"to_expressed(w, {parent(symbols, join)}, i.run.X.transposed_times(f))"
    return lines + felt(symbols, end, on_a)


def parent(symbols: Symbols, join: FusedJoin) -> int:
    """Return the link before a run."""
    return symbols.plan.joints[join.run[0]].parent
