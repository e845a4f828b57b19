"""Which processor this is."""

from __future__ import annotations

from pathlib import Path

import pytest

from adagen.build.processor import processor_family, processor_name, told

EPYC = """processor\t: 0
vendor_id\t: AuthenticAMD
cpu family\t: 25
model\t\t: 17
model name\t: AMD EPYC
"""
ARM = "processor\t: 0\nBogoMIPS\t: 50.00\nCPU implementer\t: 0x41\n"


@pytest.mark.parametrize(
    ("text", "found"), [(EPYC, ("AuthenticAMD", 25)), (ARM, None), ("", None), (None, None)]
)
def test_linux_tells_maker_and_family(
    text: str | None, found: tuple[str, int] | None, tmp_path: Path
) -> None:
    file = tmp_path / "cpuinfo"
    if text is not None:
        file.write_text(text)
    assert processor_family(file) == found
    assert told("model name", file) == (["AMD EPYC"] if text == EPYC else [])
    assert processor_name()
