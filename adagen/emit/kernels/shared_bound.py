"""What processes of shape kernels tell process 0 of the bound of an answer's error.

See templates/include/adagen/kernels/shared_bound.hpp.
"""

from __future__ import annotations

from collections.abc import Iterable

from adagen.emit.kernels.messages import exchanged
from adagen.emit.processes import describe_message
from adagen.emit.words import Words
from adagen.plan.certificate import beyond_held, spread
from adagen.plan.steps import Certify, Step
from adagen.plan.types import CERTIFICATE, Process
from adagen.program import Operation


def tells(words: Words, operation: Operation) -> bool:
    """Return whether a message tells what a process adds to the bound of the answer's error."""
    return exchanged(words, operation)[1].sweep == CERTIFICATE


def told(words: Words, process: Process, operation: Operation) -> list[str]:
    """Return the lines that tell process 0 of a process's share."""
    number, message = exchanged(words, operation)
    (joints,) = (step.joints for step in process.steps_of(Certify))
    lines = [
        f"{{  // to process {message.target}: {describe_message(words, message)}",
        f"  Number* to = channel.outgoing({number}, w.status);",
        "  to = tell_sums(to, w);",
    ]
    for link in message.weighed:
        numbers = _spread(words, joints, link)
        lines.append(f"  to = tell_link(to, w, {link}, {numbers});")
    return [*lines, f"  channel.send({number}, w.status);", "}"]


def beyond(words: Words, steps: Iterable[Step], link: int) -> str:
    """Return what all beyond a held link takes where it turns otherwise, and where it slides."""
    return _spread(words, beyond_held(words.plan, steps), link)


def _spread(words: Words, joints: Iterable[int], link: int) -> str:
    """What limbs at a link take where it turns otherwise, and where it slides."""
    number, limbs = words.printer.number, spread(words.plan, joints, link)
    terms = [number(limbs.turning)]
    terms += [f"{number(scale)} * w.q[{k}] * w.q[{k}]" for k, scale in limbs.along]
    return f"{' + '.join(terms)}, {number(limbs.sliding)}"


def heard(words: Words, operation: Operation) -> list[str]:
    """Return the lines that keep what another process has told."""
    number, message = exchanged(words, operation)
    call = f"channel.receive({number}, w.status)"
    about = f"  // from process {message.source}: {describe_message(words, message)}"
    return [f"w.heard[{_place(words, message.source)}] = {call};{about}"]


def sums(step: Certify) -> list[str]:
    """Return the lines that add what others have found of error and answer."""
    return [f"hear_sums(w, w.heard[{k}]);" for k in range(len(step.hears))]


def at_links(words: Words, operation: Operation) -> list[str]:
    """Return the lines that add what limbs of another process leave over.

    Args:
        words: the plan's names.
        operation: takes the inertias of these limbs, and knows what is first at a link.
    """
    _, message = exchanged(words, operation)
    shares = [m for m in words.plan.messages if m.sweep == CERTIFICATE]
    place = _place(words, message.source)
    return [
        f"hear_link<{'true' if first else 'false'}>"
        f"(w, {link}, w.heard[{place}] + kSums + {shares[place].weighed.index(link)} * kAtLink);"
        for link, first in zip(message.inertias, operation.first, strict=True)
    ]


def _place(words: Words, source: int) -> int:
    """Where what a process has told is kept."""
    return [m.source for m in words.plan.messages if m.sweep == CERTIFICATE].index(source)
