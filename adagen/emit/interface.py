"""The C interface of an emitted file: sizes, indices of joints, reasons for failure, functions."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class FailureRow:
    """A reason why an evaluation fails.

    Attributes:
        name: what the header calls it, behind the solver's own prefix.
        value: as ``templates/include/adagen/status.hpp`` has it.
        what: in a few words, for the header.
    """

    name: str
    value: int
    what: str

    @property
    def word(self) -> str:
        """Its name in the source."""
        return "k" + "".join(part.capitalize() for part in self.name.split("_"))


FAILURES = (
    FailureRow("FINE", 0, "none"),
    FailureRow("NOT_FINITE", 1, "q, v or tau of a joint is not a finite number"),
    FailureRow("ZERO_QUATERNION", 2, "a joint's quaternion cannot be normalised"),
    FailureRow("FACTORIZATION", 3, "inertias beside a joint differ too much for the scalar"),
    FailureRow("OVERFLOW", 4, "a joint's acceleration is not a finite number"),
    FailureRow("NO_ANSWER", 5, "a process did not answer within the time limit"),
    FailureRow("ENDED", 6, "process 0 has ended the evaluations"),
    FailureRow("NOT_REFINED", 7, "refinement does not converge"),
    FailureRow("GIMBAL_LOCK", 8, "gimbal lock of joints that are joined as one"),
    FailureRow("GROWTH", 9, "a link beside a joint is too light for its neighbours"),
    FailureRow(
        "NOT_SET",
        16,
        "a value is not finite, a mass not positive, or the constant cannot be set",
    ),
    FailureRow("TOO_FEW_STEPS", 11, "refinement converges too slowly"),
    FailureRow("LOOP_OPEN", 12, "a loop or coupling is not closed in this configuration"),
    FailureRow("LOOP_TORN", 13, "the velocity violates a loop or coupling"),
    FailureRow("LOOP_SINGULAR", 14, "the rank of the loop constraints changes in this pose"),
    FailureRow("LOOP_FREE", 15, "the loops allow a motion of a joint that has no inertia"),
)
"""What a status may say, as the header names it."""
