"""Messages to process 0 about the bound of the answer's error, in shape kernels.

See templates/include/adagen/kernels/shared_bound.hpp.
"""

from __future__ import annotations

from adagen.emit.kernels.limb_spread import LimbSpread
from adagen.emit.kernels.messages import exchanged
from adagen.emit.messages import describe_message, send_lines
from adagen.emit.symbols import Symbols
from adagen.plan.limb_spread import spread
from adagen.plan.messages import CERTIFICATE
from adagen.plan.steps import Certify
from adagen.plan.types import Process
from adagen.program import Operation


def tells(symbols: Symbols, operation: Operation) -> bool:
    """Return whether a message contains a process's part of the error bound."""
    return exchanged(symbols, operation)[1].sweep == CERTIFICATE


def told(
    symbols: Symbols, limb_spread: LimbSpread, process: Process, operation: Operation
) -> list[str]:
    """Return the lines that send a process's part to process 0."""
    number, message = exchanged(symbols, operation)
    (joints,) = (step.joints for step in process.steps_of(Certify))
    lines = ["  to = tell_sums(to, w);"]
    for link in message.weighed:
        limbs, call = spread(symbols.plan, joints, link), f"to = tell_link(to, w, {link}, {{}});"
        lines += [f"  {line}" for line in limb_spread.lines(limbs, link, call.format)]
    return send_lines(symbols, number, lines)


def heard(symbols: Symbols, operation: Operation) -> list[str]:
    """Return the lines that store another process's part."""
    number, message = exchanged(symbols, operation)
    call = f"channel.receive({number}, w.status)"
    about = f"  // from process {message.source}: {describe_message(symbols, message)}"
    return [f"w.heard[{_place(symbols, message.source)}] = {call};{about}"]


def sums(step: Certify) -> list[str]:
    """Return the lines that add other processes' sums of error and answer."""
    return [f"hear_sums(w, w.heard[{k}]);" for k in range(len(step.hears))]


def at_links(symbols: Symbols, operation: Operation) -> list[str]:
    """Return the lines that add residuals of another process's limbs.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        operation: takes the inertias of these limbs, and knows what is first at a link.
    """
    _, message = exchanged(symbols, operation)
    shares = [m for m in symbols.plan.messages if m.sweep == CERTIFICATE]
    place = _place(symbols, message.source)
    return [
        f"hear_link<{'true' if first else 'false'}>"
        f"(w, {link}, w.heard[{place}] + kSums + {shares[place].weighed.index(link)} * kAtLink);"
        for link, first in zip(message.inertias, operation.first, strict=True)
    ]


def _place(symbols: Symbols, source: int) -> int:
    """The index of a process's stored part."""
    return [m.source for m in symbols.plan.messages if m.sweep == CERTIFICATE].index(source)
