"""Predicted time of a batch that process 0 distributes (templates/include/adagen/handout.hpp)."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, field

from adagen.schedule.costs import ChannelCosts

PIECE = 1 << 16
"""Bytes of a piece at most, about."""


@dataclass(frozen=True)
class Batch:
    """A batch of states.

    Attributes:
        states: how many.
        state: microseconds that a process takes for one.
        given: numbers of a state, configuration, velocity and torques.
        answered: numbers of its accelerations.
        lanes: what pieces are multiples of but for the last, states that the widest registers hold.
    """

    states: int
    state: float
    given: int
    answered: int
    lanes: int = 8


@dataclass(frozen=True)
class Helper:
    """A process that receives pieces of a batch from process 0.

    Attributes:
        costs: of messages between the two.
        far: whether it is on another host: all such messages share the link of process 0's host.
    """

    costs: ChannelCosts
    far: bool


@dataclass(frozen=True)
class Handout:
    """The predicted distribution of a batch; microseconds.

    Attributes:
        makespan: from its begin until process 0 has all answers.
        computing: the least by what all processes compute together.
        link: for how long the link of process 0's host is busy, in the busier direction.
        handing: for how long process 0 puts messages together and takes them apart.
    """

    makespan: float
    computing: float
    link: float
    handing: float

    @property
    def limit(self) -> str:
        """What takes most of the time: computing, the link, process 0, or latency."""
        bounds = {
            "computing": self.computing,
            "the link of process 0's host": self.link,
            "process 0, which hands out": self.handing,
        }
        most = max(bounds, key=lambda name: bounds[name])
        return most if bounds[most] > 0.5 * self.makespan else "latency, and the batch's end"


@dataclass
class _Play:
    batch: Batch
    helpers: Sequence[Helper]
    clock: float = 0.0  # of process 0
    handing: float = 0.0
    out: float = 0.0  # when the link is free again: to the others
    back: float = 0.0  # and from them
    link: list[float] = field(default_factory=lambda: [0.0, 0.0])
    taken: int = 0

    def __post_init__(self) -> None:
        self.answers: list[deque[tuple[float, float]]] = [deque() for _ in self.helpers]
        self.free = [0.0] * len(self.helpers)

    def play(self) -> Handout:
        batch = self.batch
        while self.taken < batch.states:
            for k in range(len(self.helpers)):
                while self.answers[k] and self.answers[k][0][0] <= self.clock:
                    self._work(self.answers[k].popleft()[1])
                while len(self.answers[k]) < 2 and self.taken < batch.states:
                    self._give(k)
            self.clock += self._piece() * batch.state
        rest = sorted(answer for own in self.answers for answer in own)
        for arrived, work in rest:
            self.clock = max(self.clock, arrived)
            self._work(work)
        processes = 1 + len(self.helpers)
        computing = batch.states * batch.state / processes
        return Handout(self.clock, computing, max(self.link), self.handing)

    def _work(self, time: float) -> None:
        self.clock += time
        self.handing += time

    def _piece(self) -> int:
        """Take the next piece; return its states, as handout.hpp counts them."""
        batch, left = self.batch, self.batch.states - self.taken
        most = max(1, PIECE // (batch.given * 8 * batch.lanes)) * batch.lanes
        share = left // (4 * (1 + len(self.helpers))) // batch.lanes * batch.lanes
        count = min(left, max(batch.lanes, min(share, most)))
        self.taken += count
        return count

    def _give(self, k: int) -> None:
        """Send a piece to a helper, and compute when its answer arrives."""
        helper, batch, count = self.helpers[k], self.batch, self._piece()
        costs = helper.costs
        there, back = (count * n * costs.number for n in (batch.given, batch.answered))
        self._work(costs.send + there / 2)
        sent = self.clock
        if helper.far:
            sent = self.out = max(sent, self.out) + there
            self.link[0] += there
        begin = max(sent + costs.latency, self.free[k])
        done = begin + there / 2 + count * batch.state + costs.send + back / 2
        self.free[k] = done
        if helper.far:
            done = self.back = max(done, self.back) + back
            self.link[1] += back
        self.answers[k].append((done + costs.latency, back / 2))


def handed_out(batch: Batch, helpers: Sequence[Helper]) -> Handout:
    """Return the predicted distribution of a batch by process 0, which also solves states.

    Args:
        batch: the states.
        helpers: the other processes.
    """
    return _Play(batch, helpers).play()
