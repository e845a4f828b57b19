"""Along which axes rows of loops are, and what is known of forces at points."""

from __future__ import annotations

import numpy as np

from adagen.executor.arm_lanes import CouplingColumn
from adagen.executor.frames import Dense, Rotation, Transform
from adagen.graph import Graph
from adagen.graph.evaluate import Evaluation
from adagen.plan.weld_points import with_points
from tests.executor.test_split_rods import ankles


def test_rows_of_a_weld_are_along_the_axes_of_what_hangs_on_a_ball() -> None:
    model = ankles()
    names = [link.name for link in model.links]
    for loop in with_points(model):
        assert (loop.kind, names[loop.link2][:4]) == ("weld", "rest")
        assert np.array_equal(loop.rotation2, np.eye(3))
        assert not np.any(loop.translation2)
        turn = np.array(loop.rotation1)
        assert np.abs(turn @ turn.T - np.eye(3)).max() < 1e-15


def test_a_force_at_a_point_is_passed_by_that() -> None:
    """Its moment about the near link's origin, by its place there."""
    graph, rng = Graph(), np.random.default_rng(1)
    turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    origin, point, force = rng.normal(size=(3, 3))
    known = [[graph.constant(x) for x in row] for row in (*turn, origin)]
    entries = np.array(known, dtype=object)
    x = Transform(Rotation((Dense(entries[:3]),)), entries[3])
    p, f, m = ([graph.input(f"{n}[{k}]") for k in range(3)] for n in "pfm")
    passed = CouplingColumn(
        (0,), np.array([*m, *f], dtype=object), np.array(p, dtype=object)
    ).passed(x)
    assert passed.point is not None
    given = {f"{n}[{k}]": v[k] for n, v in (("p", point), ("f", force)) for k in range(3)}
    found = Evaluation(graph, given.__getitem__).of([*passed.point, *passed.column])
    there, pushed = origin + turn @ point, turn @ force
    np.testing.assert_allclose(found, [*there, *np.cross(there, pushed), *pushed], atol=1e-14)
