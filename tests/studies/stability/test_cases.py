"""The failing cases: weak methods fail as expected, the shipped ones keep their digits."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from adagen.cli import main
from adagen.model import Model
from adagen.plan import make_plan
from adagen.reference import exact_forward_dynamics
from adagen.states import States, write_states
from adagen.studies.stability import CASES, Case, robots, run_case
from adagen.studies.stability.draw import draw_map
from adagen.studies.stability.maps import Map, condition
from adagen.studies.stability.methods import METHODS, Trial, digits
from adagen.studies.stability.motion import energy_growth
from adagen.studies.stability.textbook_methods import articulated, composite, true_acceleration
from tests.emitted import Builder
from tests.schedules import random_schedule
from tests.slow import spread


@pytest.mark.parametrize("case", spread(CASES, 6), ids=lambda case: f"{case.number}")
def test_every_case_is_as_it_must_be(case: Case) -> None:
    outcome = run_case(case, quick=True)
    assert [finding for finding in outcome.findings if not finding.good] == []
    assert outcome.findings
    assert any(finding.weak for finding in outcome.findings)


@pytest.mark.slow
def test_a_thousand_links() -> None:
    assert run_case(CASES[0]).good


@pytest.mark.parametrize(
    "model", [robots.rods(6), robots.spherical_rods(3), robots.far_away(4, 10.0), robots.coil(5)]
)
def test_the_weak_methods_are_right_where_nothing_is_wrong(model: Model) -> None:
    """They fail in the cases because of what they are, not because they are wrong."""
    trial = Trial(model)
    truth = exact_forward_dynamics(trial.model, *trial.state).value
    assert np.array_equal(true_acceleration(trial.model, *trial.state), truth)
    assert trial.error(composite(trial.model, *trial.state)) < 1e-11
    for world in (False, True):
        assert trial.error(articulated(trial.model, *trial.state, world=world)) < 1e-11
    assert trial.error(articulated(trial.model, *trial.state, scalar=np.float32)) < 1e-2


def test_a_mass_ratio_costs_form_ada_its_digits_and_form_segment_none() -> None:
    kept = {
        name: [
            digits(Trial(robots.with_mass(20, 10, mass)).outcome(METHODS[name])[0])
            for mass in (1.0, 1e-4, 1e-8)
        ]
        for name in ("form ada", "form segment")
    }
    assert kept["form ada"][0] > kept["form ada"][1] + 2 > kept["form ada"][2] + 4
    assert min(kept["form segment"]) > 14


def test_the_limit_of_the_step_is_where_theory_has_it() -> None:
    limit = 6.68e-5
    assert energy_growth(1.05 * limit, 400, False) > 1e6
    assert energy_growth(0.95 * limit, 400, False) < 1.01
    assert energy_growth(1e-1, 20, True) < 1.01


@pytest.mark.slow
def test_float_raises_beside_the_light_link(builder: Builder, tmp_path: Path) -> None:
    """Case 3 in the emitted solver: an error that names the joint, no NaN."""
    model = robots.with_mass(30, 15, 1e-8)
    schedule = random_schedule(model, 1, np.random.default_rng(0))
    solver = builder.solver(make_plan(model, schedule, form="ada", scalar="float"))
    q, v, tau = robots.state(model)
    given, result = tmp_path / "states.json", tmp_path / "result.json"
    write_states(States(q[None], v[None], tau[None]), model, given)
    done = solver.run("--states", given, "--result", result)
    assert done.status == 1
    assert 'joint "j' in done.stderr
    assert not result.exists()


@pytest.mark.slow
def test_a_map_tells_where_methods_end_and_is_drawn(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("matplotlib")
    words = ["stability", "--map", str(tmp_path), "--family", "distance", "--json"]
    assert main(words) == 0
    (data,) = json.loads(capsys.readouterr().out)
    assert data == json.loads((tmp_path / "stability_distance.json").read_text())
    kept = dict(zip(data["methods"], data.pop("digits"), strict=True))
    assert kept["articulated bodies, world frame"][-1] < 6 < 14 < kept["form segment"][-1]
    assert len(data["conditions"]) == len(data["values"])
    assert data["conditions"] == pytest.approx([data["conditions"][0]] * 4)
    text = (tmp_path / "stability_distance.svg").read_text()
    assert "base from the origin (m)" in text
    draw_map(Map(**data), tmp_path / "again.svg")
    assert text == (tmp_path / "again.svg").read_text()
    assert "cond(H) eps" in (tmp_path / "stability_condition.svg").read_text()
    behind = json.loads((tmp_path / "stability_condition.json").read_text())["distance"]
    assert behind["conditions"] == data["conditions"]
    drawn = dict(zip(data["methods"], data["errors"], strict=True))
    assert behind["errors"].items() <= drawn.items() and len(behind["errors"]) == 6


def test_a_failure_is_no_number_in_the_data() -> None:
    found = Map("f", "x", (1.0,), ("a",), ((np.inf,),), (1.0,)).listed()
    assert (found["errors"], found["digits"]) == ([[None]], ((0.0,),))


@pytest.mark.parametrize("links", [10, 30, 60])
def test_the_condition_of_stretched_planar_chains(links: int) -> None:
    """cond(H) = 4 N^4."""
    assert condition(robots.planar(links, 1.0), np.zeros(links)) == pytest.approx(
        4 * links**4, rel=0.1
    )


def test_the_condition_beyond_doubles_and_of_a_singular_inertia() -> None:
    model = robots.dill(3)
    assert condition(model, np.zeros(model.nq)) > 1e14
    leaf = robots.massless_leaf(3)
    with pytest.raises(FloatingPointError, match="singular"):
        condition(leaf, np.zeros(leaf.nq))


def test_the_command_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["stability", "--quick", "--case", "7", "--json"]) == 0
    (found,) = json.loads(capsys.readouterr().out)
    assert (found["case"], found["ok"]) == (7, True)
    assert any(finding["weak"] for finding in found["findings"])
    assert main(["stability", "--case", "11"]) == 0
    assert "link5" in capsys.readouterr().out
    assert main(["stability", "--case", f"{len(CASES) + 1}"]) == 2
    assert main(["stability", "--family", "light"]) == 2
    assert main(["stability", "--map", "x", "--family", "none"]) == 2
