"""Values of the straight line of one process that each process needs, and who sends them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from adagen.executor.line import Line, Looked, Pair
from adagen.model.kinds import KINDS
from adagen.plan.steps import Articulate, HoldBack, LinkBias, Send, StartLink
from adagen.plan.types import Plan, Process


@dataclass(frozen=True)
class Sender:
    """The process that sends a number, and the core link that it belongs to."""

    process: int
    link: int


class NeededValues:
    """The values of the straight line that one process needs.

    Attributes:
        process: its number.
        missing: numbers that others tell it, ascending, and who does.
        sends: numbers that it tells others, by process, likewise.
    """

    def __init__(self, plan: Plan, line: Line, p: int, senders: Mapping[Pair, Sender]) -> None:
        self.plan, self.line, self.process = plan, line, p
        self.own: Process = plan.processes[p]
        self.sends: dict[int, dict[Pair, Sender]] = {}
        alone = line.needs((pair for pair, sender in senders.items() if sender.process == p), ())
        self._others = {
            pair: sender
            for pair, sender in senders.items()
            if sender.process != p and pair not in alone
        }
        exchange = any(plan.steps_of(Send))
        for pair, entry in line.torques() if exchange else ():
            readers = _readers(plan, entry)
            if pair not in self._others and all(reader.process != p for reader in readers):
                self._others[pair] = readers[0]
        self._found = line.needs(self._results(), self._others)
        least = (looked.least for looked in self._looked(self._found))
        self._found |= line.needs(least, self._others)
        known = sorted(self._found & self._others.keys())
        self.missing = {pair: self._others[pair] for pair in known}

    def _results(self) -> list[Pair]:
        found = [pair for j in self.own.owns for pair in self.line.results.get(j, [])]
        found += [pair for own in (self.outputs, self.forces) for x in own.values() for pair in x]
        if self.plan.closed:  # answers need not depend on how far loops are open
            found += [looked.pivot for looked in self.line.checks if looked.joint in self._blamed]
        return found + self.certificate

    @property
    def outputs(self) -> Mapping[int, list[Pair]]:
        """The numbers of the scene's outputs, at the only process that has work in such plans."""
        return self.line.outputs if self.own.steps else {}

    @cached_property
    def forces(self) -> dict[int, list[Pair]]:
        """Forces of loops and couplings that this process gives, by their first entries."""
        own = self.plan.force_entries(self.own)
        return {k: x for k, x in self.line.forces.items() if k in own}

    @cached_property
    def _blamed(self) -> set[int]:
        """Joints, loops and couplings that its steps treat, as checks number them."""
        joints = {*self.own.owns, *self.own.shares}
        joints.update(step.joint for step in self.own.steps_of(Articulate, HoldBack))
        first = len(self.plan.joints)
        loops = (max(loop.links) - 1 for loop in self.plan.loops)
        near = [*loops, *(coupling.terms[0][0] for coupling in self.plan.couplings)]
        return joints | {k for k, j in enumerate(near, start=first) if j in joints}

    @property
    def certificate(self) -> list[Pair]:
        """What bounds the error of the answer, at the only process that has work in such plans."""
        return self.line.certificate if self.own.steps else []

    def _looked(self, found: set[Pair]) -> list[Looked]:
        nodes = self.line.nodes
        return [
            looked
            for looked in self.line.checks
            if looked.pivot in found
            or (nodes[looked.pivot[0]].op == "constant" and looked.joint in self._blamed)
        ]

    def all_of_it(self) -> tuple[set[Pair], list[Looked]]:
        """Return all values that it computes or receives, and the checks among them."""
        sent = self.line.needs((pair for own in self.sends.values() for pair in own), ())
        looked = self._looked(self._found | sent)
        more = self.line.needs((each.least for each in looked if each.pivot in sent), ())
        return self._found | sent | more, looked


def _readers(plan: Plan, entry: int) -> list[Sender]:
    """Return the processes that read an entry of tau, and for which link."""
    for j, joint in enumerate(plan.joints):
        if joint.v <= entry < joint.v + KINDS[joint.kind].nv:
            return [
                Sender(p, j + 1)
                for p, process in enumerate(plan.processes)
                if j in process.owns or j in process.shares
            ]
    for k, wrench in enumerate(plan.wrenches):
        if plan.entry_of_wrench(k) <= entry < plan.entry_of_wrench(k) + 6:
            return [
                Sender(p, wrench.link)
                for p, process in enumerate(plan.processes)
                for step in process.steps_of(LinkBias, StartLink)
                if step.link == wrench.link
            ]
    raise AssertionError(f"nobody is given entry {entry} of tau")
