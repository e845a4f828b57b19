"""Energy bounds of long limbs that move as one body: emitted loops find those of the executor."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from adagen.executor import certificate, shared_bound
from adagen.executor.allowance import Allowance
from adagen.executor.run import lines_of
from adagen.executor.shared_bound import Heard
from adagen.executor.solve import Run
from adagen.graph import Expression
from adagen.model import Model
from adagen.plan import Plan
from adagen.plan.limb_spread import Spread
from adagen.states import random_states, write_states
from benchmarks.stability.bounds import certified_plan, plan_elsewhere
from tests.emitted import Builder, Solver, kernels_of
from tests.models import random_tree, serial_chain, star
from tests.slow import all_but

_CALL = re.compile(
    r"^( *)((?:to = tell_link|weigh_held|weigh_shown)\S*\(.*, turning, sliding\);)", re.M
)
_TELL = r'\1std::fprintf(stderr, "told %.17g %.17g\\n", double(turning), double(sliding));\n\1\2'
CASES: dict[str, tuple[Callable[[], Model], Callable[[Model], Plan], int]] = {
    "chain": (lambda: serial_chain(44), plan_elsewhere, 2),
    "tree": (
        lambda: random_tree(np.random.default_rng(7), 45, floating=True),
        plan_elsewhere,
        1,
    ),
    "limbs in lanes": (lambda: star(6, 11), partial(certified_plan, processes=3), 2),
}


@pytest.mark.parametrize("name", all_but(CASES, "tree", "chain"))
def test_loops_find_what_the_executor_finds(
    name: str, builder: Builder, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot, planned, count = CASES[name]
    model, told = robot(), list[tuple[Allowance, list[Expression]]]()
    plan, states = planned(model), random_states(model, 1, seed=3)
    honest = shared_bound.spread_of

    def kept(
        found: Allowance, limbs: Spread, link: int, shares: Sequence[Heard] = ()
    ) -> list[Expression]:
        own = honest(found, limbs, link, shares)
        if limbs.distances or limbs.hears:
            told.append((found, own))
        return own

    for module in (certificate, shared_bound):
        monkeypatch.setattr(module, "spread_of", kept)
    lines_of.cache_clear()
    (state,) = states.each
    run = Run(plan, dict(zip(("q", "v", "tau"), state, strict=True)))
    lines_of.cache_clear()
    known = [
        run.of(p, own)
        for p, machine in enumerate(run.machines)
        for found, own in told
        if machine is found.state
    ]
    assert len(known) == count
    source, calls = _CALL.subn(_TELL, kernels_of(plan))
    assert calls >= count
    path = builder.compile("#include <cstdio>\n" + source, f"{model.name}_p{len(plan.processes)}")
    given = tmp_path / "states.json"
    write_states(states, model, given)
    solver = Solver(path, 1, builder.toolchain)  # of threads
    done = solver.run("--states", given, "--result", tmp_path / "result.json")
    assert done.status == 0
    seen = [
        np.array(line.split()[1:], float) for line in done.stderr.splitlines() if "told" in line
    ]
    assert seen
    for one in seen:
        assert any(one == pytest.approx(own, rel=1e-9) for own in known)
    for own in known:
        assert any(one == pytest.approx(own, rel=1e-9) for one in seen)
