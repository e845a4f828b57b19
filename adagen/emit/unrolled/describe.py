"""A step as a one-line comment."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from adagen.emit.symbols import Symbols
from adagen.plan.steps import Step


def describe_step(symbols: Symbols, step: Step, row: Callable[[int], Sequence[int]]) -> str:
    """Return a step with its joints or links, in one line of ASCII.

    Args:
        symbols: the C++ names of the plan's joints, links and buffers.
        step: the step.
        row: the joints that are treated as one with a joint.
    """
    link, joint = getattr(step, "link", None), getattr(step, "joint", None)
    if link is not None:
        links = [j + 1 for j in row(link - 1)]
        names = ", ".join(f"{k} {symbols.quoted_link(k)}" for k in links)
        return f"link{'s' * (len(links) > 1)} {names}: {step.about}"
    if joint is None:
        return step.about
    joints = row(joint)
    names = ", ".join(f"{j} {symbols.quoted_joint(j)}" for j in joints)
    if len(joints) == 1:
        return f"joint {names}: {step.about}"
    return f"joints {names}: {getattr(step, 'about_row', step.about)}"
