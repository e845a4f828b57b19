"""The fastest shape, function length and compiler of a request, by trial."""

from __future__ import annotations

from adagen.build import find_toolchain
from adagen.build.cache import Progress
from adagen.emit import emit, stem_of
from adagen.emit.shapes import SHAPES, chosen_shape, offered, stepwise
from adagen.library.request import Request
from adagen.plan import Plan
from adagen.run.tune import Candidate, Trial, candidates, compilers, tune
from adagen.schedule import load_profile


def tuned(plan: Plan, request: Request, progress: Progress) -> list[Trial]:
    """Return all timed variants of a plan, the fastest on this machine first.

    Args:
        plan: what each process computes.
        request: names a shape, or leaves all to be tried; and how answers are refined.
        progress: is told what is done.

    Raises:
        UsageError: the plan cannot be emitted in the shape asked for.
        EnvironmentFault: nothing could be built and run.
    """
    stem, profile = stem_of(plan), load_profile(request.profile)

    def text_of(candidate: Candidate) -> str:
        files = emit(
            plan,
            shape=candidate.shape,
            refine=request.refine,
            chunk=candidate.chunk,
            profile=profile,
        )
        return files[f"{stem}.cpp"]

    tried = candidates(_shapes(plan, request), compilers())
    return tune(tried, text_of, stem, plan.launched, find_toolchain(), progress)


def _shapes(plan: Plan, request: Request) -> list[str]:
    """The shapes to try."""
    if request.shape != "auto":
        return [chosen_shape(plan, request.shape)]
    if request.refinement:
        return [stepwise(plan)]
    if plan.reproducible:
        return list(offered(plan))
    return [name for name, shape in SHAPES.items() if shape.why_not(plan) is None]
