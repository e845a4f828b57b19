"""Messages to process 0 about the bound of the answer's error, in shape kernels.

See templates/include/adagen/kernels/shared_bound.hpp.
"""

from __future__ import annotations

from collections.abc import Iterable

from adagen.emit.kernels.messages import exchanged
from adagen.emit.processes import describe_message
from adagen.emit.symbols import Symbols
from adagen.plan.certificate import beyond_held, spread
from adagen.plan.steps import Certify, Step
from adagen.plan.types import CERTIFICATE, Process
from adagen.program import Operation


def tells(symbols: Symbols, operation: Operation) -> bool:
    """Return whether a message contains a process's part of the error bound."""
    return exchanged(symbols, operation)[1].sweep == CERTIFICATE


def told(symbols: Symbols, process: Process, operation: Operation) -> list[str]:
    """Return the lines that send a process's part to process 0."""
    number, message = exchanged(symbols, operation)
    (joints,) = (step.joints for step in process.steps_of(Certify))
    lines = [
        f"{{  // to process {message.target}: {describe_message(symbols, message)}",
        f"  Number* to = channel.outgoing({number}, w.status);",
        "  to = tell_sums(to, w);",
    ]
    for link in message.weighed:
        numbers = _spread(symbols, joints, link)
        lines.append(f"  to = tell_link(to, w, {link}, {numbers});")
    return [*lines, f"  channel.send({number}, w.status);", "}"]


def beyond(symbols: Symbols, steps: Iterable[Step], link: int) -> str:
    """Return the energy bounds of everything beyond a held link for rotation and translation."""
    return _spread(symbols, beyond_held(symbols.plan, steps), link)


def _spread(symbols: Symbols, joints: Iterable[int], link: int) -> str:
    """Energy bounds of limbs at a link for rotation and translation."""
    number, limbs = symbols.printer.number, spread(symbols.plan, joints, link)
    terms = [number(limbs.turning)]
    terms += [f"{number(scale)} * w.q[{k}] * w.q[{k}]" for k, scale in limbs.along]
    return f"{' + '.join(terms)}, {number(limbs.sliding)}"


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
