"""``--tune``: the fastest shape, function length and compiler, found by trying."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from adagen.cli.console import Stages, note, progress

if TYPE_CHECKING:
    from adagen.plan import Plan
    from adagen.run.tune import Candidate


def tuned(plan: Plan, options: argparse.Namespace, stages: Stages) -> Candidate:
    """Return how a plan is emitted fastest on this machine, and say on stderr what was tried.

    Raises:
        UsageError: the plan cannot be emitted in the shape asked for.
        EnvironmentFault: nothing could be built and run.
    """
    from adagen.build import find_toolchain
    from adagen.emit import emit, stem_of
    from adagen.emit.refine import checked_steps
    from adagen.emit.shapes import SHAPES, chosen_shape, offered, stepwise
    from adagen.run.tune import candidates, compilers, table, tune
    from adagen.schedule import load_profile

    if options.shape == "auto":
        shapes = [name for name, shape in SHAPES.items() if shape.why_not(plan) is None]
        shapes = list(offered(plan)) if plan.reproducible else shapes
    else:
        shapes = [chosen_shape(plan, options.shape)]
    if checked_steps(options.refine):
        shapes = [stepwise(plan)] if options.shape == "auto" else shapes
    stem = stem_of(plan)

    def text_of(candidate: Candidate) -> str:
        files = emit(
            plan,
            shape=candidate.shape,
            refine=options.refine,
            chunk=candidate.chunk,
            profile=load_profile(options.profile),
        )
        return files[f"{stem}.cpp"]

    with stages.stage("tune"):
        trials = tune(
            candidates(shapes, compilers()),
            text_of,
            stem,
            plan.launched,
            find_toolchain(),
            progress,
        )
    played = trials[0].source == "stretches"
    how = " (more processes than cores: from measured stretches of computing)" if played else ""
    note(f"candidates, ns per evaluation with state and result in place{how}:")
    for line in table(trials).splitlines():
        note(line)
    return trials[0].candidate
