"""The number of processes that pays, by the predicted times of schedules."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from adagen.emit.shapes import predict
from adagen.model import Model
from adagen.plan import make_plan
from adagen.plan.certificate import certified
from adagen.schedule import CostProfile, Schedule, step_costs

_PATIENCE = 3  # numbers of processes in a row that bring nothing, after which the search ends:
# a limit of effort, since each of them is a search


@dataclass(frozen=True)
class Candidate:
    """A number of processes, its schedule and its predicted time in microseconds."""

    processes: int
    schedule: Schedule
    time: float


def predicted_time(
    model: Model,
    schedule: Schedule,
    profile: CostProfile,
    form: str,
    shape: str = "auto",
    scalar: str = "double",
    *,
    reproducible: bool = False,
    certify: bool = False,
) -> float:
    """Return the predicted time of a schedule, microseconds.

    By its plan where the profile prices steps, else by Eq. (11).

    Args:
        model: the robot.
        schedule: of its joints.
        profile: the costs.
        form: of the algorithm.
        shape: of the code.
        scalar: "double" or "float".
        reproducible: whether answers are the same on every number of processes.
        certify: whether errors are bounded, too.
    """
    if profile.steps is None:
        return schedule.makespan
    plan = make_plan(model, schedule, form=form, scalar=scalar, reproducible=reproducible)
    plan = certified(plan) if certify else plan
    return predict(plan, profile, shape).makespan


def margin(profile: CostProfile) -> float:
    """Return the share of the time that more processes must save to be preferred.

    It is the error of the machine's predicted times, as calibration found it: what is predicted to
    save less is not known to save anything, and takes more cores.
    """
    return step_costs(profile)["process.margin"]


def choose_processes(
    model: Model,
    profile: CostProfile,
    form: str,
    most: int,
    schedule: Callable[[int], Schedule],
    shape: str = "auto",
    scalar: str = "double",
    *,
    reproducible: bool = False,
) -> list[Candidate]:
    """Return candidates for 1 process and more, the best one first.

    Args:
        model: the robot.
        profile: the costs.
        form: of the algorithm.
        most: processes to consider at most, such as the number of cores.
        schedule: finds a schedule for a number of processes.
        shape: of the code.
        scalar: "double" or "float".
        reproducible: whether answers are the same on every number of processes.
    """

    def candidate(processes: int) -> Candidate:
        found = schedule(processes)
        time = predicted_time(model, found, profile, form, shape, scalar, reproducible=reproducible)
        return Candidate(processes, found, time)

    best = candidate(1)
    seen = [best]
    for processes in range(2, most + 1):
        seen.append(candidate(processes))
        if seen[-1].time < (1 - margin(profile)) * best.time:
            best = seen[-1]
        elif processes - best.processes >= _PATIENCE:
            break
    return [best, *(candidate for candidate in seen if candidate is not best)]
