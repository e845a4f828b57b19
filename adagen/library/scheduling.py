"""The schedule of a request: searched, by name, or from a file."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import cast, get_args

from adagen.errors import InputError, UsageError
from adagen.library.request import Request
from adagen.model import Model
from adagen.plan import as_gathered
from adagen.plan.clusters import fold_of
from adagen.schedule import CostProfile, Schedule, Topology, load_profile, step_costs
from adagen.schedule.tree import Named
from adagen.search import named_schedule, schedule_from_json
from adagen.search.base_gathering import (
    alone_schedule,
    certified_schedule,
    reproducible_schedule,
)
from adagen.search.chain_parts import certifies
from adagen.search.objective import schedule_for

KNOWN = ("auto", *get_args(Named))
"""Schedules that are asked for by name."""


def schedule_of(model: Model, request: Request) -> Schedule:
    """Return the schedule of a robot for a request.

    Raises:
        InputError: the profile or the schedule file is refused.
        UsageError: there is no such profile or schedule.
    """
    if request.schedule not in KNOWN:
        found = given_schedule(model, request)
        if found.processes != request.sharing:
            raise InputError(
                f"this schedule is for {found.processes} processes, not {request.sharing}; "
                f"use --procs {found.processes}",
                request.schedule,
            )
        # Parts say how a process sweeps what is its own, which not all answers can be found by.
        if not request.may_part(len(model.joints), step_costs(load_profile(request.profile))) or (
            request.certify and found.parts and not certifies(found, model)
        ):
            found = replace(found, parts=0)
        return as_gathered(model, found)
    return as_gathered(model, searched(model, request))


def searched(model: Model, request: Request) -> Schedule:
    """Return the schedule that is searched, or the named one.

    Raises:
        InputError: the profile is refused, or the robot cannot be treated in this form.
        UsageError: there is no such profile.
    """
    profile = load_profile(request.profile)
    if request.schedule == "auto" and request.reproducible:
        if request.certify:  # a line that is shared tells no bound
            return alone_schedule(model, request.sharing, profile)
        return reproducible_schedule(model, request.sharing, profile, request.scalar)
    if request.schedule != "auto":
        return _named(model, request, profile.joins_only() if request.form == "ada" else profile)
    if request.certify and request.sharing > 1:
        whole = replace(request, parts="none")  # processes that have parts do not certify
        plain = _best(model, whole, profile) if request.may_gather else None
        asked = request.sharing, profile, request.scalar, request.shape
        in_parts = request.may_part(len(model.joints), step_costs(profile))
        return certified_schedule(model, *asked, plain, in_parts=in_parts)
    return _best(model, request, profile)


def _best(model: Model, request: Request, profile: CostProfile) -> Schedule:
    """The best schedule without certificates."""
    return schedule_for(
        request.objective,
        model,
        request.sharing,
        profile,
        request.form,
        request.scalar,
        tie=request.tie,
        strategy=request.strategy,
        split=request.split,
        improved=not request.naive,
        gather=request.may_gather,
        shape=request.priced_shape,
        in_parts=request.may_part(len(model.joints), step_costs(profile)),
        certify=request.certify,
        **({} if request.expansions is None else {"expansions": request.expansions}),
    )


def _named(model: Model, request: Request, profile: CostProfile) -> Schedule:
    """Return the named schedule.

    Raises:
        InputError: the robot has no joint at which anything could be joined.
    """
    seen = fold_of(model, request.form)
    if not len(seen.topology):
        raise InputError(
            f"form {request.form} treats all links of this robot as one, as their inertias cannot"
            f" be inverted: there is no order of joints for --schedule {request.schedule}; leave it"
            " out"
        )
    name = cast(Named, request.schedule)
    found = named_schedule(name, seen.topology, request.sharing, profile=profile)
    return seen.unfold(found, profile)


def given_schedule(model: Model, request: Request) -> Schedule:
    """Return the schedule in the given file.

    Raises:
        InputError: the file is refused.
        UsageError: there is no such file.
    """
    profile = load_profile(request.profile)
    if request.form == "ada":
        profile = profile.joins_only()
    try:
        text = Path(request.schedule).read_text(encoding="utf-8")
    except FileNotFoundError:
        raise UsageError(
            f"--schedule: '{request.schedule}' is neither a file nor one of {', '.join(KNOWN)}"
        ) from None
    except OSError as error:
        raise InputError(f"cannot read it: {error.strerror}", request.schedule) from None
    except ValueError:
        raise InputError("not UTF-8 text", request.schedule) from None
    return schedule_from_json(text, Topology.of(model), profile, request.schedule)
