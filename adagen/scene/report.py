"""What a scene removed and saved, as lines for people."""

from __future__ import annotations

from dataclasses import dataclass

from adagen.scene.apply import Reduction

_NAMED = 6


@dataclass(frozen=True)
class Simplification:
    """A simplification of a scene, and its errors where it does not hold.

    Attributes:
        holds: in words, what it takes for true.
        else_: in words, what else may be.
        states: random states that were looked at.
        median: of them, the difference of accelerations in joint space, relative to the whole.
        largest: likewise.
    """

    holds: str
    else_: str
    states: int
    median: float
    largest: float


@dataclass(frozen=True)
class Cost:
    """Cost of an evaluation: operations counted from its plan, and predicted time in us."""

    operations: int
    time: float


def removed(reduction: Reduction) -> list[str]:
    """Return lines on what was removed."""
    lines = []
    if reduction.locked:
        locked = [f'"{name}" at {_written(q)}' for name, q in reduction.locked.items()]
        lines.append(f"scene: {len(locked)} joints locked: {_listed(locked)}")
    if reduction.dropped:
        names = [f'"{name}"' for name in reduction.dropped]
        lines.append(
            f"scene: {len(names)} joints left out, as no requested result depends on them: "
            f"{_listed(names)}"
        )
    model = reduction.model
    if model.wanted:
        names = [f'"{model.joints[j].name}"' for j in model.wanted]
        lines.append(
            f"scene: accelerations of {len(names)} of {len(model.joints)} joints are computed: "
            f"{_listed(names)}"
        )
    if model.outputs:
        named = [f'{output.what} at "{output.name}"' for output in model.outputs]
        lines.append(f"scene: other outputs: {_listed(named)}")
    if model.at_rest:
        lines.append("scene: at rest, all velocities are zero")
    if not reduction.model.gravity.any():
        lines.append("scene: no gravity")
    return lines


def saved(reduction: Reduction, before: Cost | None, after: Cost) -> str:
    """Return a line about the remaining robot and the savings.

    Args:
        reduction: the reduction.
        before: what the whole robot takes on as many processes, if it can be solved.
        after: what is left takes.
    """
    full, model = reduction.full, reduction.model
    text = (
        f"scene: {len(model.joints)} of {len(full.joints)} joints and {model.nv} of {full.nv} "
        f"degrees of freedom left; {after.operations} operations, {after.time:.2f} us predicted"
    )
    if before is None:
        return f"{text}; the whole robot has no forward dynamics"
    share = 1.0 - after.operations / before.operations
    faster = 1.0 - after.time / before.time
    return (
        f"{text}; the whole robot: {before.operations} operations, {before.time:.2f} us: "
        f"{_change(share, 'fewer')} operations, {_change(faster, 'less')} time"
    )


def measured(before: float, after: float) -> str:
    """Return a line on measured times, microseconds, of the whole robot and of what is left."""
    change = _change(1.0 - after / before, "less")
    return f"scene: measured here: {after:.2f} us, the whole robot {before:.2f} us: {change} time"


def accurate(digits: float, whole: float | None) -> str:
    """Return a line on the digits that are predicted of what is left, and of the whole robot."""
    beside = "" if whole is None else f", of the whole robot {whole:.1f}"
    return f"scene: {digits:.1f} digits are predicted for what is left{beside}"


def differs(simplification: Simplification) -> str:
    """Return a line about the errors of a simplification where it does not hold."""
    return (
        f"scene: exact where {simplification.holds}; where {simplification.else_}, accelerations "
        f"differ by {simplification.median:.0%} (median of {simplification.states} random states; "
        f"at most {simplification.largest:.0%})"
    )


def _change(share: float, less: str) -> str:
    return f"{abs(share):.0%} {less if share >= 0 else 'more'}"


def _written(q: tuple[float, ...]) -> str:
    return f"{q[0]:g}" if len(q) == 1 else "[" + ", ".join(f"{x:g}" for x in q) + "]"


def _listed(items: list[str]) -> str:
    more = f" and {len(items) - _NAMED} more" if len(items) > _NAMED else ""
    return ", ".join(items[:_NAMED]) + more
