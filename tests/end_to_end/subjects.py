"""Built examples that are run."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from adagen.model import Model
from adagen.states import States, random_states, write_states
from tests.emitted import QUICK, Builder, Solver
from tests.golden.examples import EXAMPLES, FOLDER

BY_STEM = {example.stem: example for example in EXAMPLES}


@dataclass(frozen=True)
class Subject:
    """A built example, its robot, and a folder to work in."""

    model: Model
    solver: Solver
    folder: Path

    def states(self, count: int = 2) -> States:
        return random_states(self.model, count, seed=6)

    def refuses(self, states: States) -> str:
        """Solve states that must fail; return the one line that says why."""
        given, result = self.folder / "s.json", self.folder / "r.json"
        write_states(states, self.model, given)
        done = self.solver.run("--states", given, "--result", result)
        assert (done.status, done.stdout) == (1, "")
        assert not result.exists()
        (line,) = done.stderr.splitlines()
        assert line.startswith(f"{given}: error: ")
        assert "nan" not in line.lower().replace(str(given), "")
        return line.removeprefix(f"{given}: error: ")


def subject(stem: str, builder: Builder, folder: Path) -> Subject:
    example = BY_STEM[stem]
    source = (FOLDER / stem / f"{stem}.cpp").read_text()
    executable = builder.compile(source, stem, QUICK)
    return Subject(
        example.model(), Solver(executable, example.processes, builder.toolchain), folder
    )
