"""Long runs that one process sweeps in parts, one in each SIMD lane (adagen/plan/parts.py)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from itertools import groupby
from typing import TypeVar

from adagen.plan import steps as do
from adagen.plan.parts import pairs_of, strips_of
from adagen.plan.robot import PlanJoint
from adagen.plan.steps import Step
from adagen.program.runs import Run

_AtLink = TypeVar("_AtLink", do.Load, do.AccelerateRoot)
_OfJoint = TypeVar("_OfJoint", do.Articulate, do.Accelerate)


def parts_joined(run: Run, lanes: int, steps: Sequence[Step]) -> list[Run]:
    """Return the parts of a run if each is joined by the first joint of its strip; else nothing.

    Args:
        run: a long run, outwards.
        lanes: SIMD lanes, and parts.
        steps: of the process; they join the parts level by level.
    """
    strips = strips_of(range(run.first, run.last + 1), lanes)
    wanted = [strips[far].start for _, far in pairs_of(len(strips))]
    joins = [step.joint for step in steps if isinstance(step, do.Join) and step.joint in wanted]
    return [Run(strip.start + 1, strip.stop - 1) for strip in strips] if joins == wanted else []


class PartedRuns:
    """The runs of a process that are swept in parts, and their steps."""

    def __init__(self) -> None:
        self.runs: dict[Run, list[Run]] = {}
        self._roots: dict[int, do.InvertRoot] = {}  # by link: the first link of a part

    def __contains__(self, unit: object) -> bool:
        """Whether a unit of a sweep is a part."""
        return any(unit in parts for parts in self.runs.values())

    def of_joints(
        self, by_joint: Mapping[int, _OfJoint], joints: Callable[[Run], range]
    ) -> Iterator[tuple[Run, list[_OfJoint]]]:
        """Yield each run with the steps of its parts, whose joints are in the order of a sweep."""
        for run, parts in self.runs.items():
            yield run, [by_joint[j] for part in parts for j in joints(part)]

    def keep_roots(self, steps: Sequence[do.InvertRoot]) -> list[do.InvertRoot]:
        """Keep the steps at the first links of parts until mobilities are carried; return others.

        A part's first link has the number of its first joint.
        """
        first = {part.first for parts in self.runs.values() for part in parts}
        self._roots |= {step.link: step for step in steps if step.link in first}
        return [step for step in steps if step.link not in first]

    def propagated(
        self, steps: list[do.Propagate]
    ) -> tuple[list[tuple[Run, list[do.InvertRoot | do.Propagate]]], list[do.Propagate]]:
        """Return each run with its steps and those at the roots of its parts, and other steps."""
        found: list[tuple[Run, list[do.InvertRoot | do.Propagate]]] = []
        for run, parts in self.runs.items():
            joints = {j for part in parts for j in part.joints()}
            own = [step for step in steps if step.joint in joints]
            steps = [step for step in steps if step.joint not in joints]
            if own:
                found.append((run, [*(self._roots[part.first] for part in parts), *own]))
        return found, steps

    def joined(
        self, steps: Sequence[do.Join | do.Disassemble], joints: Sequence[PlanJoint]
    ) -> Iterator[tuple[Run | None, list[do.Join | do.Disassemble]]]:
        """Yield successive joins of the parts of one run together; None for others."""
        between: dict[int, Run] = {}
        for parted, parts in self.runs.items():
            on_ground = joints[parted.first].parent == 0  # then the first part is held by it
            between.update((part.first - 1, parted) for part in parts[not on_ground :])
        for run, group in groupby(steps, lambda step: between.get(step.joint)):
            yield run, list(group)

    def at_links(
        self, steps: Sequence[_AtLink], ends: Callable[[Run], Set[int]]
    ) -> tuple[list[tuple[Run, list[_AtLink]]], list[_AtLink]]:
        """Return each run with the steps at ends of its parts, and the other steps."""
        found: list[tuple[Run, list[_AtLink]]] = []
        for run, parts in self.runs.items():
            links = {link for part in parts for link in ends(part)}
            own = [step for step in steps if step.link in links]
            steps = [step for step in steps if step.link not in links]
            if own:
                found.append((run, own))
        return found, list(steps)
