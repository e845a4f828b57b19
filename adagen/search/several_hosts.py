"""Predictions for several hosts: one evaluation shared by them, and batches distributed to them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import accumulate

from adagen.cost import state_time, timeline
from adagen.cost.handout import Batch, Handout, Helper, handed_out
from adagen.emit import program_of
from adagen.emit.shapes import priced_program
from adagen.model import Model
from adagen.plan import make_plan
from adagen.schedule import CostProfile, Host, step_costs
from adagen.schedule.caches import solved_in_lanes
from adagen.schedule.costs import StepCosts
from adagen.schedule.fat_tree import Network, between_hosts
from adagen.search.best import best_schedule
from adagen.search.process_count import Candidate, choose_processes, margin

MOST_SHARING = 16
"""Processes that one evaluation is shared by at most."""

FULL = 8
"""States that pieces of a batch are multiples of: they fill the widest registers there are."""

STATES = 1 << 17
"""States of the batches that are played through."""


@dataclass(frozen=True)
class Shared:
    """One evaluation, shared by so many hosts; predicted microseconds.

    Attributes:
        hosts: how many.
        processes: how many in all, one on each.
        working: processes that have something to do under the schedule that is best there.
        time: of an evaluation.
    """

    hosts: int
    processes: int
    working: int
    time: float


@dataclass(frozen=True)
class HandedOut:
    """Batches distributed by process 0 to so many hosts; predicted.

    Attributes:
        hosts: how many.
        processes: how many in all.
        handout: how a batch goes.
        rate: states per microsecond.
        in_place: the same where every process has its own states.
    """

    hosts: int
    processes: int
    handout: Handout
    rate: float
    in_place: float


@dataclass(frozen=True)
class Across:
    """Predictions for several hosts.

    Attributes:
        alone: the best of one host.
        shared: one evaluation on two hosts and more.
        batches: batches on one host and more.
        state: predicted microseconds of one state of a batch on one process.
        profile: by which it is predicted.
        margin: the share that must be saved to be preferred.
    """

    alone: Candidate
    shared: tuple[Shared, ...]
    batches: tuple[HandedOut, ...]
    state: float
    profile: str
    margin: float

    @property
    def best_shared(self) -> Shared | None:
        """The shared evaluation that pays; None where one host does as well."""
        meeting = [one for one in self.shared if one.working > 1]
        best = min(meeting, key=lambda one: one.time, default=None)
        pays = best is not None and best.time < (1 - self.margin) * self.alone.time
        return best if pays else None

    @property
    def best_batches(self) -> HandedOut:
        """The fewest hosts that hand out about as many states as any number of them."""
        most = max(one.rate for one in self.batches)
        return next(one for one in self.batches if one.rate >= (1 - self.margin) * most)


def across_hosts(
    model: Model, hosts: Sequence[Host], profile: CostProfile, network: Network | None = None
) -> Across:
    """Return the predictions for a robot on several hosts.

    One evaluation is searched with every message at the price of the network, so that the
    processes meet as seldom as pays there; then it is played through with messages of one host at
    their own. Batches are played through piece by piece.

    Args:
        model: the robot.
        hosts: in the order in which they are filled.
        profile: the costs.
        network: what messages cost between hosts, by their numbers; what the profile says of them
            if not given.

    Raises:
        ValueError: the profile has no such costs, and they are not given.
    """
    network = network or network_of(profile)
    costs = profile.measured

    def searched(processes: int, by: CostProfile = profile) -> Candidate:
        schedule = best_schedule(model, processes, by)
        return Candidate(processes, schedule, schedule.makespan)

    most = min(max(host.slots for host in hosts), MOST_SHARING)
    alone, *_ = choose_processes(model, profile, "segment", most, lambda p: searched(p).schedule)
    shared = []
    for count in _counts(min(len(hosts), MOST_SHARING))[1:]:
        farthest = network(0, count - 1)
        far = replace(profile, steps=replace(costs, window=farthest, message=farthest))
        shared.append(_shared(model, hosts[:count], searched(count, far), profile, network))
    state = batch_state_time(model, profile)
    batches = batches_on(model, hosts, state, costs, network)
    return Across(alone, tuple(shared), batches, state, profile.name, margin(profile))


def network_of(profile: CostProfile) -> Network:
    """Return the costs of messages between any two hosts in a profile.

    Raises:
        ValueError: it says nothing.
    """
    costs = None if profile.steps is None else profile.steps.network
    if costs is None:
        raise ValueError(f"the profile {profile.name} has no costs of messages between hosts")
    return lambda _a, _b: costs


def _counts(hosts: int) -> list[int]:
    """Return 1, 2, 4, ... and the number of hosts."""
    found = [1 << k for k in range(hosts.bit_length())]
    return sorted({*found, hosts})


def _shared(
    model: Model,
    hosts: Sequence[Host],
    found: Candidate,
    profile: CostProfile,
    network: Network,
) -> Shared:
    plan = make_plan(model, found.schedule)
    links = between_hosts(placed(hosts, found.processes), network)
    time = timeline(priced_program(plan, profile=profile), profile, links).makespan
    working = sum(bool(process.owns) for process in plan.processes)
    return Shared(len(hosts), found.processes, working, time)


def placed(hosts: Sequence[Host], processes: int) -> list[int]:
    """Return the host of each process: equal parts, one after the other, no more than slots."""
    left = [host.slots for host in hosts]
    taken = [0] * len(hosts)
    for _ in range(processes):
        k = min((k for k in range(len(hosts)) if left[k] > 0), key=lambda k: taken[k])
        taken[k] += 1
        left[k] -= 1
    ends = list(accumulate(taken))
    return [next(k for k, end in enumerate(ends) if p < end) for p in range(processes)]


def batch_state_time(model: Model, profile: CostProfile) -> float:
    """Return the predicted time of a process for one state of a batch, microseconds.

    Long chains are solved state by state, their lanes are for parts.
    """
    in_parts = not solved_in_lanes(len(model.joints), step_costs(profile))
    plan = make_plan(model, best_schedule(model, 1, profile, in_parts=in_parts))
    return state_time(program_of(plan, batch=True, profile=profile), profile)


def batches_on(
    model: Model,
    hosts: Sequence[Host],
    state: float,
    costs: StepCosts,
    network: Network,
) -> tuple[HandedOut, ...]:
    """Return how batches go that process 0 hands out, on 1, 2, 4, ... of the hosts and on all.

    Args:
        model: the robot.
        hosts: in the order in which they are filled.
        state: microseconds of a state on one process.
        costs: of messages in a host.
        network: of messages between hosts.
    """
    batch = Batch(STATES, state, model.nq + model.nv + model.ntau, model.nv, FULL)
    return tuple(_batches(batch, hosts[:count], costs, network) for count in _counts(len(hosts)))


def _batches(batch: Batch, hosts: Sequence[Host], costs: StepCosts, network: Network) -> HandedOut:
    helpers = [Helper(costs.message, far=False)] * (hosts[0].slots - 1)
    for k, host in enumerate(hosts[1:], 1):
        helpers += [Helper(network(0, k), far=True)] * host.slots
    found = handed_out(batch, helpers)
    processes = 1 + len(helpers)
    return HandedOut(
        len(hosts), processes, found, batch.states / found.makespan, processes / batch.state
    )
