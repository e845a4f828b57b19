"""The schedule of a request, and its number of processes if that is left open."""

from __future__ import annotations

from dataclasses import dataclass, replace

from adagen.library.request import Request
from adagen.library.scheduling import KNOWN, given_schedule, schedule_of, searched
from adagen.model import Model
from adagen.plan import as_gathered
from adagen.run import cores
from adagen.schedule import CostProfile, Schedule, load_profile
from adagen.search import choose_processes, predicted_time
from adagen.search.base_gathering import alone_schedule
from adagen.search.process_count import margin

MOST_CORES = 16
"""Processes that are considered at most where their number is left open."""


@dataclass(frozen=True)
class Chosen:
    """A schedule, and the alternatives to it.

    Attributes:
        schedule: which process computes what.
        request: the request, with the number of processes and, of a schedule in a file, the shape.
        compared: processes and what is predicted of them, us, by their number; empty where it was
            not left open.
        unpaid: what is predicted of the processes that were asked for and of one alone, us, where
            these do not pay; else None. One does everything then, if the schedule was searched for
            the least time.
        profile: the name of the cost profile that predicts it.
    """

    schedule: Schedule
    request: Request
    compared: tuple[tuple[int, float], ...] = ()
    unpaid: tuple[float, float] | None = None
    profile: str = ""

    @property
    def unpaid_in_words(self) -> str:
        """What is to be said of processes that do not pay; empty where they do."""
        if self.unpaid is None:
            return ""
        many, one = self.unpaid
        idle = ", which does everything" if self.request.may_leave_idle else ""
        return (
            f"{self.request.procs} processes do not pay: {many:.2f} us predicted, {one:.2f} us on "
            f"one ({self.profile} profile){idle}"
        )


def choose(model: Model, request: Request, *, left_open: bool = False) -> Chosen:
    """Return the schedule for a request.

    Args:
        model: the robot.
        request: the request.
        left_open: whether as many processes are taken as pay, whatever the request says: as a
            schedule in a file has, all cores of a batch, one of any other solver that is certified
            by a schedule that is searched, or of an embedded one.

    Raises:
        InputError: the profile or the schedule file is refused.
        UsageError: there is no such profile or schedule.
    """
    certified = request.certify and not request.batch and request.schedule in KNOWN
    alone = request.target == "embedded" or certified
    if left_open and alone:
        request, left_open = replace(request, procs=1), False
    if request.schedule not in KNOWN:
        found = given_schedule(model, request)
        if request.shape == "auto":
            request = replace(request, shape=found.shape)
        if left_open and not request.batch:
            request = replace(request, procs=found.processes)
    if request.batch:  # each process solves states by the schedule of one
        request = replace(request, procs=cores()) if left_open else request
        return Chosen(schedule_of(model, request), request)
    if request.schedule not in KNOWN:
        return Chosen(schedule_of(model, request), request)
    profile = load_profile(request.profile)
    return (_as_pay if left_open else _as_asked)(model, request, profile)


def _as_pay(model: Model, request: Request, profile: CostProfile) -> Chosen:
    found = choose_processes(
        model,
        profile,
        request.form,
        min(cores(), MOST_CORES),
        lambda processes: searched(model, replace(request, procs=processes)),
        request.priced_shape,
        request.scalar,
        reproducible=request.reproducible,
    )
    compared = tuple(sorted((each.processes, each.time) for each in found))
    request = replace(request, procs=found[0].processes)
    return Chosen(as_gathered(model, found[0].schedule), request, compared, None, profile.name)


def _as_asked(model: Model, request: Request, profile: CostProfile) -> Chosen:
    own = searched(model, request)
    chosen = Chosen(as_gathered(model, own), request, profile=profile.name)
    if request.procs == 1 or profile.steps is None:
        return chosen
    alone = searched(model, replace(request, procs=1))
    many, one = (
        predicted_time(
            model,
            each,
            profile,
            request.form,
            request.priced_shape,
            request.scalar,
            reproducible=request.reproducible,
            certify=request.certify,
        )
        for each in (own, alone)
    )
    if many <= (1 - margin(profile)) * one:
        return chosen
    if request.may_leave_idle:
        whole = alone_schedule(model, request.procs, profile)
        found = replace(
            own, root=whole.root, meeting=whole.meeting, gathered=None, parts=alone.parts
        )
        loads = (one, *(request.procs - 1) * (0.0,))
        chosen = replace(chosen, schedule=replace(found, makespan=one, loads=loads))
    return replace(chosen, unpaid=(many, one))
