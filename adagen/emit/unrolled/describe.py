"""What a step does, in a line of comment."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from adagen.emit.words import Words
from adagen.plan.steps import Step


def describe_step(words: Words, step: Step, row: Callable[[int], Sequence[int]]) -> str:
    """Return what a step does and to which joints or links, in one line of ASCII.

    Args:
        words: the plan's names.
        step: the step.
        row: the joints that are treated as one with a joint.
    """
    link, joint = getattr(step, "link", None), getattr(step, "joint", None)
    if link is not None:
        links = [j + 1 for j in row(link - 1)]
        names = ", ".join(f"{k} {words.quoted_link(k)}" for k in links)
        return f"link{'s' * (len(links) > 1)} {names}: {step.about}"
    if joint is None:
        return step.about
    joints = row(joint)
    names = ", ".join(f"{j} {words.quoted_joint(j)}" for j in joints)
    if len(joints) == 1:
        return f"joint {names}: {step.about}"
    return f"joints {names}: {getattr(step, 'about_row', step.about)}"
