"""Budgets in words, and the Pareto front that they choose from."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from adagen.cli import main
from adagen.errors import InputError, UsageError
from adagen.studies.chart import Budget, Point, front, parse_budget


def point(
    label: str,
    time: float | None,
    error: float | None,
    team: str = "adagen",
    source: str | None = "clock",
) -> Point:
    return Point(
        label, team, "segment", "auto", "double", 1, 0, "auto", time, source, 1.0, error, error
    )


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("error<1e-10", Budget(1e-10)),
        (" error <= 2.5E-3 ", Budget(2.5e-3)),
        ("time<2us", Budget(None, 2000.0)),
        ("time < 800 ns", Budget(None, 800.0)),
        ("time<0.5µs", Budget(None, 500.0)),
        ("time<1ms", Budget(None, 1e6)),
        ("error<1e-10, time<2us", Budget(1e-10, 2000.0)),
        ("time<1s and error<1", Budget(1.0, 1e9)),
    ],
)
def test_a_budget_is_read(text: str, expected: Budget) -> None:
    assert parse_budget(text) == expected


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "expected error<NUMBER or time<NUMBER UNIT"),
        ("error>1", "expected error<NUMBER"),
        ("error<", "expected error<NUMBER"),
        ("error<-1", "expected error<NUMBER"),
        ("error<1e-10,", "expected error<NUMBER"),
        ("speed<1", "only error and time can be limited"),
        ("error<1e-3 us", "an error has no unit"),
        ("time<2", "a time needs a unit"),
        ("time<2 weeks", "a time needs a unit"),
        ("time<0us", "must be above 0"),
        ("error<1e999", "must be above 0"),
        ("error<1.2.3", "is not a number"),
        ("error<1, error<2", "limited twice"),
    ],
)
def test_what_is_no_budget_is_refused(text: str, says: str) -> None:
    with pytest.raises(UsageError, match=says):
        parse_budget(text)


class TestChoice:
    points = (
        point("slow and right", 900.0, 1e-15),
        point("fast and wrong", 100.0, 1e-4),
        point("between", 400.0, 1e-9),
        point("a textbook", 50.0, 1e-16, team="baseline"),
        point("not timed", None, 1e-16),
        point("from stretches", 50.0, 1e-16, source="stretches"),
        point("failed", 10.0, None),
    )

    @pytest.mark.parametrize(
        ("text", "label"),
        [
            ("error<1e-8", "between"),
            ("error<1", "fast and wrong"),
            ("time<500ns", "between"),
            ("time<1us", "slow and right"),
            ("error<1e-3, time<500ns", "fast and wrong"),
        ],
    )
    def test_the_budget_chooses(self, text: str, label: str) -> None:
        assert parse_budget(text).best(self.points).label == label

    def test_what_cannot_be_kept_says_what_comes_nearest(self) -> None:
        with pytest.raises(InputError, match=r'fastest is "fast and wrong" \(0\.1 us'):
            parse_budget("error<1e-10, time<200ns").best(self.points)
        with pytest.raises(InputError, match="nothing was both solved and timed"):
            parse_budget("error<1").best(self.points[3:])


maybe = st.none() | st.floats(1e-3, 1e3)


class TestFront:
    @given(st.lists(st.tuples(maybe, maybe), max_size=25))
    def test_nothing_on_it_is_beaten_and_all_else_is(
        self, pairs: list[tuple[float | None, float | None]]
    ) -> None:
        points = [point(str(k), *pair) for k, pair in enumerate(pairs)]
        known = {k for k, p in enumerate(points) if p.time_ns is not None and p.error is not None}

        def beaten(k: int) -> bool:
            mine = points[k].time_ns or 0.0, points[k].error or 0.0
            others = ((points[i].time_ns or 0.0, points[i].error or 0.0) for i in known)
            return any(o[0] <= mine[0] and o[1] <= mine[1] and o != mine for o in others)

        assert front(points) == {k for k in known if not beaten(k)}

    def test_an_infinite_error_is_not_on_it(self) -> None:
        assert front([point("a", 1.0, math.inf)]) == set()


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ([], "required: MODEL"),
        (["r.urdf", "--budget", "fast"], "argument --budget: budget 'fast'"),
        (["r.urdf", "--scalars", "quad"], "'quad' is none of double, float"),
        (["r.urdf", "--procs", "1,0"], "must be a whole number from 1 to 64, not '0'"),
        (["r.urdf", "--states", "3"], "must be a whole number from 20 to 10000, not '3'"),
        (["r.urdf", "--simulate", "1", "--budget", "error<1"], "exclude each other"),
    ],
)
def test_a_wrong_command_line_is_one_line_and_status_2(
    words: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["chart", *words]) == 2
    told = capsys.readouterr()
    assert told.out == "" and told.err.count("\n") == 1
    assert says in told.err
