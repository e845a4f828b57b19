"""``--tune``: the fastest shape, function length and compiler, by trial."""

from __future__ import annotations

from typing import TYPE_CHECKING

from adagen.cli.console import Stages, note, progress

if TYPE_CHECKING:
    from adagen.library import Request
    from adagen.plan import Plan
    from adagen.run.tune import Candidate


def fastest(plan: Plan, request: Request, stages: Stages) -> Candidate:
    """Return how a plan is emitted fastest on this machine, and say on stderr what was tried.

    Raises:
        UsageError: the plan cannot be emitted in the shape asked for.
        EnvironmentFault: nothing could be built and run.
    """
    from adagen.library.tuning import tuned
    from adagen.run.tune import table

    with stages.stage("tune"):
        trials = tuned(plan, request, progress)
    played = trials[0].source == "stretches"
    how = " (more processes than cores: from measured stretches of computing)" if played else ""
    note(f"candidates, ns per evaluation with state and result in place{how}:")
    for line in table(trials).splitlines():
        note(line)
    return trials[0].candidate
