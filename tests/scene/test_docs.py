"""docs/reference/scenes.md shows every key that a scene can have, and only such."""

from __future__ import annotations

import re
from pathlib import Path

from adagen.scene import read_scene
from adagen.scene.read import KEYS
from adagen.scene.types import EFFECTS, OUTPUTS

ROOT = Path(__file__).resolve().parents[2]


def test_the_documented_scene_is_read_and_complete(tmp_path: Path) -> None:
    text = (ROOT / "docs" / "reference" / "scenes.md").read_text()
    (example,) = re.findall(r"```toml\n(.*?)```", text, flags=re.DOTALL)
    path = tmp_path / "scene.toml"
    path.write_text(example)
    scene = read_scene(path)
    keys = {*KEYS, *OUTPUTS} - {"outputs"}
    assert {key for key in keys if getattr(scene, key) not in (None, (), {}, 0.0)} == keys
    assert set(scene.joints["knee"].effects) == set(EFFECTS)
    assert scene.joints["hip"].prescribed


def test_the_example_scenes_are_read() -> None:
    scenes = sorted((ROOT / "generated_examples" / "models").glob("*.toml"))
    assert [read_scene(path).source.file for path in scenes] == [str(path) for path in scenes]
    assert len(scenes) == 4
