"""Options of code generation that cannot be combined, for any robot."""

from __future__ import annotations

from adagen.errors import UsageError
from adagen.plan.types import THREADS

FORM_ADA_ALONE = "it is for form ada: add --form ada, or take shape kernels or unrolled"
"""Why shape joints does not take form segment."""


def check_form(form: str, shape: str) -> None:
    """Refuse a shape that does not take a form, for any robot.

    Raises:
        UsageError: it does not.
    """
    if shape == "joints" and form != "ada":
        raise UsageError(f"shape joints cannot be emitted: {FORM_ADA_ALONE}")


def check_batch(shape: str, refine: int, channel: str) -> None:
    """Refuse options that batches do not support.

    Raises:
        UsageError: the shape, refinement or channel cannot be had for batches.
    """
    if channel == THREADS:
        raise UsageError(
            "batches are not shared out to threads: open a solver for one process in each of yours"
        )
    if refine:
        raise UsageError("batches are not refined; leave out --batch or --refine")
    if shape not in ("auto", "kernels", "unrolled"):
        raise UsageError(f"batches are emitted in shapes kernels and unrolled, not {shape}")


def check_certified(form: str, refine: int) -> None:
    """Refuse options that certified solvers do not support, for any robot.

    Raises:
        UsageError: the form or refinement has no certificates.
    """
    if form != "segment":
        raise UsageError(
            f"form {form} has no factors to certify answers with: leave out --certify or "
            f"--form {form}"
        )
    if refine:
        raise UsageError(
            "refined answers come with an estimate of their own: leave out --certify or --refine"
        )


def check_reproducible(form: str, refine: int, shape: str) -> None:
    """Refuse options that reproducible solvers do not support, for any robot.

    Raises:
        UsageError: the form, refinement or shape has other digits on each number of
            processes, or by each compiler.
    """
    if form != "segment":
        raise UsageError(
            f"form {form} joins in an order that depends on the number of processes, and so do "
            f"its last digits: leave out --reproducible or --form {form}"
        )
    if refine:
        raise UsageError(
            "answers are refined in loops, which are not reproducible: leave out --reproducible "
            "or --refine"
        )
    if shape not in ("auto", "unrolled"):
        raise UsageError(
            f"shape {shape} rounds differently for each number of lanes: only straight lines are "
            f"reproducible; leave out --reproducible or --shape {shape}"
        )
