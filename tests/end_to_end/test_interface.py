"""The C functions of emitted files, called from a program that links two of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from adagen.states import States, random_states
from tests.emitted import QUICK, ROUNDING, Builder, Solver, forward_error, truth_of
from tests.end_to_end.test_library import filled
from tests.golden.examples import EXAMPLES, FOLDER

STEMS = ("arm7_p2", "mobile_p1")
BY_STEM = {example.stem: example for example in EXAMPLES}
REFUSED = (
    "MPI is not initialised: call MPI_Init first",
    "channel takes auto, window or message, not pigeon",
    "the time limit must be more than 0 s",
    "this solver is for exactly 2 processes, the communicator has 1",
)
Facts = dict[tuple[str, str, int], list[list[str]]]


def source(stem: str) -> str:
    return (FOLDER / stem / f"{stem}.cpp").read_text()


@pytest.fixture(scope="module")
def program(builder: Builder) -> Solver:
    objects = [str(builder.object_file(source(stem), stem)) for stem in STEMS]
    text = Path(__file__).with_name("program.cpp").read_text()
    includes = [f"-I{FOLDER / stem}" for stem in STEMS]
    executable = builder.compile(text, "program", (*QUICK, *includes, *objects))
    return Solver(executable, 2, builder.toolchain)


@pytest.fixture(scope="module")
def states() -> dict[str, States]:
    return {stem: random_states(BY_STEM[stem].model(), 3, seed=12) for stem in STEMS}


@pytest.fixture(scope="module", params=["window", "message"])
def facts(
    request: pytest.FixtureRequest,
    program: Solver,
    states: dict[str, States],
    tmp_path_factory: pytest.TempPathFactory,
) -> Facts:
    """What the program printed: (solver, what, rank) to the words of its lines."""
    folder = tmp_path_factory.mktemp("states")
    for stem, some in states.items():
        np.savetxt(folder / stem, [np.concatenate(row) for row in some.each], fmt="%.17g")
    # A window needs somebody to share it with, so that the lonely solver would refuse it.
    channel = "auto" if request.param == "window" else "message"
    done = program.run(channel, *(folder / stem for stem in STEMS))
    assert (done.status, done.stderr) == (0, "")
    lines = sorted(done.stdout.splitlines(), key=lambda line: line.split()[:3])
    refused = [line for line in lines if line.startswith("refuses")]
    assert sorted(refused) == [f"refuses 1: {why}" for why in REFUSED for _ in (0, 1)]
    found: Facts = {}
    for line in lines:
        words = line.split(maxsplit=3)
        if words[0] in STEMS:
            found.setdefault((words[0], words[1], int(words[2])), []).append(words[3].split())
    return found


def test_the_joints_tell_their_places(facts: Facts) -> None:
    for stem in STEMS:
        model = BY_STEM[stem].model()
        for k, joint in enumerate(model.joints):
            places = [model.q_start[k], joint.kind.nq, model.v_start[k], joint.kind.nv]
            assert facts[stem, "joint", k] == [[joint.name, *map(str, places)]]
        assert (stem, "joint", len(model.joints)) not in facts


def test_in_place_every_process_gets_its_own_joints(
    facts: Facts, states: dict[str, States]
) -> None:
    truth = truth_of(BY_STEM["arm7_p2"].model(), states["arm7_p2"])
    rows = [facts["arm7_p2", "place", rank] for rank in (0, 1)]
    merged = np.full(truth.shape, np.nan)
    for rank in (0, 1):
        for s, words in enumerate(rows[rank]):
            for k, word in enumerate(words):
                if word != "-":
                    assert np.isnan(merged[s, k])  # one process owns it
                    merged[s, k] = float(word)
    assert forward_error(merged, truth) < ROUNDING["double"]
    truth = truth_of(BY_STEM["mobile_p1"].model(), states["mobile_p1"])
    for rank in (0, 1):
        found = np.array(facts["mobile_p1", "place", rank], dtype=float)
        assert forward_error(found, truth) < ROUNDING["double"]


def test_at_the_root_process_0_gets_all(facts: Facts, states: dict[str, States]) -> None:
    for stem, ranks in (("arm7_p2", [0]), ("mobile_p1", [0, 1])):
        truth = truth_of(BY_STEM[stem].model(), states[stem])
        for rank in ranks:
            found = np.array(facts[stem, "root", rank], dtype=float)
            assert forward_error(found, truth) < ROUNDING["double"]
    assert ("arm7_p2", "root", 1) not in facts


def test_a_failure_is_told_in_words_writes_nothing_and_passes(facts: Facts) -> None:
    for stem in STEMS:
        last = BY_STEM[stem].model().joints[-1].name
        says = f'joint "{last}": its q, v or tau is not a finite number'
        assert " ".join(facts[stem, "failure", 0][0]) == says
        assert set(facts[stem, "spoilt", 0][0]) == {"-"}
        assert facts[stem, "after", 0][0] == facts[stem, "root", 0][0]


def test_what_one_process_cannot_open_no_process_waits_for(builder: Builder) -> None:
    """A communicator that is none ends no program; who was late is named in later calls, too."""
    part = str(builder.object_file(source("arm7_p2"), "arm7_p2"))
    flags = (*QUICK, f"-I{FOLDER / 'arm7_p2'}", part)
    done = Solver(builder.compile(filled("opening.cpp", "arm7_p2"), "opening", flags), 2,
                  builder.toolchain).run(timeout=60)  # fmt: skip
    assert (done.status, done.stderr) == (0, "")
    other = "process {} of the communicator cannot open it, and says why"
    told = {
        "null": ["the communicator is MPI_COMM_NULL"] * 2,
        "between": ["the communicator is an intercommunicator"] * 2,
        "channels": ["processes name different channels"] * 2,
        "word": ["channel takes auto, window or message, not pigeon", other.format(0)],
        "limit": [other.format(1), "the time limit must be more than 0 s"],
        "after": ["MPI is finalised already: open solvers before MPI_Finalize"] * 2,
    }
    lines = done.stdout.splitlines()
    for what, why in told.items():
        assert [f"{what} {k} 1: {why[k]}" for k in (0, 1)] == sorted(
            line for line in lines if line.startswith(f"{what} ")
        )
    assert lines.count("joint 1") == 2
    assert lines.count("late 1: process 1 did not answer within the time limit") == 2
