"""Step costs for tests: every coefficient another number, so that none can stand for another."""

from __future__ import annotations

from adagen.cost import Timeline, timeline
from adagen.plan import Plan
from adagen.program import lower
from adagen.schedule.costs import ASSUMED, NAMES, ChannelCosts, StepCosts
from adagen.schedule.profile import CostProfile

WINDOW = ChannelCosts(0.01, 0.07, 0.002)
MESSAGE = ChannelCosts(0.1, 0.3, 0.004)


def step_costs(cores: tuple[float, ...] = (), **changes: float) -> StepCosts:
    """Return coefficients around 0.05 us; ``group__key=...`` changes one."""
    table = {name: 0.03 + 0.001 * k for k, name in enumerate(NAMES)}
    table["slaved.column"] = 0.1
    for name in ("process.cache", "process.register", "unrolled.ahead", "unrolled.urgent"):
        table[name] = ASSUMED[name]
    table.update({name.replace("__", "."): value for name, value in changes.items()})
    return StepCosts(table, WINDOW, MESSAGE, cores)


def step_profile(cores: tuple[float, ...] = (), **changes: float) -> CostProfile:
    """Return a profile with these step costs."""
    return CostProfile("steps", 0.05, 0.05, -0.01, 0.25, steps=step_costs(cores, **changes))


def step_by_step(plan: Plan, profile: CostProfile) -> Timeline:
    """Return the timeline of a plan whose steps are operations by themselves, as trees price it."""
    return timeline(lower(plan, "joints"), profile)
