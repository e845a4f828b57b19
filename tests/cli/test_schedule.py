"""Scheduling through the command line."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from adagen.cli import main
from tests.cli.robots import Said, write_arm


class TestSchedule:
    def test_for_people(self, arm: Path, said: Said) -> None:
        assert main(["schedule", str(arm), "--procs", "2"]) == 0
        stdout, stderr = said()
        assert all(f"j{j}" in stdout for j in range(3))
        assert re.search(r"0\.\d+ us predicted \(default profile", stdout)
        assert "2 processes do not pay: " in stderr and stderr.count("warning:") == 1

    def test_long_chains_are_named_by_their_ends(self, tmp_path: Path, said: Said) -> None:
        path = write_arm(tmp_path / "chain.urdf", 40)
        assert main(["schedule", str(path), "--procs", "2", "--schedule", "balanced"]) == 0
        listed = re.findall(r"^  (.*) \.\. (.*) \((\d+) joints\)$", said()[0], re.MULTILINE)
        assert len(listed) == 2 and sum(int(count) for _, _, count in listed) == 40

    def test_the_program_as_json(self, arm: Path, said: Said) -> None:
        words = ["schedule", str(arm), "--procs", "2", "--schedule", "balanced"]
        assert main([*words, "--program"]) == 0
        told = json.loads(said()[0])
        assert told["robot"] == "arm" and told["meeting"] == "joined"
        owned = [name for process in told["processes"] for name in process["owns"]]
        assert sorted(owned) == ["j0", "j1", "j2"]
        sent = [
            operation["message"]
            for process in told["processes"]
            for operation in process["operations"]
            if operation["does"] == "send"
        ]
        assert sorted(sent) == list(range(len(told["messages"])))

    def test_as_json_and_back(self, arm: Path, tmp_path: Path, said: Said) -> None:
        assert main(["schedule", str(arm), "--procs", "2", "--json"]) == 0
        text = said()[0]
        told = json.loads(text)
        assert told["verdict"] == "optimal"
        (tmp_path / "s.json").write_text(text)
        words = ["schedule", str(arm), "--procs", "2", "--json"]
        assert main([*words, "--schedule", str(tmp_path / "s.json")]) == 0
        again = json.loads(said()[0])
        assert again["root"] == told["root"]
        assert again["makespan"] == told["makespan"]

    def test_a_schedule_for_other_processes_is_refused(
        self, arm: Path, tmp_path: Path, said: Said
    ) -> None:
        assert main(["schedule", str(arm), "--procs", "2", "--json"]) == 0
        (tmp_path / "s.json").write_text(said()[0])
        words = ["schedule", str(arm), "--procs", "1", "--schedule", str(tmp_path / "s.json")]
        assert main(words) == 1
        assert "is for 2 processes, not 1" in said()[1]

    @pytest.mark.parametrize("name", ["auto", "balanced", "sequential", "middle-out"])
    def test_by_name(self, name: str, arm: Path, said: Said) -> None:
        words = ["schedule", str(arm), "--procs", "2", "--schedule", name, "--json"]
        assert main(words) == 0
        told = json.loads(said()[0])
        assert told["strategy"] == ("exact" if name == "auto" else name)
        assert len(told["loads"]) == 2

    def test_drawn(self, arm: Path, tmp_path: Path) -> None:
        assert main(["schedule", str(arm), "--procs", "2", "--svg", str(tmp_path / "t.svg")]) == 0
        assert ET.fromstring((tmp_path / "t.svg").read_text()).tag.endswith("svg")

    @pytest.mark.parametrize("words", [["--profile", "none"], ["--schedule", "none"]])
    def test_a_file_that_is_not_there_is_told(
        self, words: list[str], arm: Path, said: Said
    ) -> None:
        assert main(["schedule", str(arm), "--procs", "2", *words]) == 2
        stderr = said()[1]
        assert "error: " in stderr and "none" in stderr and stderr.count("\n") == 1
