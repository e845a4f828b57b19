"""How wide registers are."""

from __future__ import annotations

import os
import platform

import pytest

from adagen.build import find_toolchain
from adagen.build.registers import widest_register
from adagen.errors import EnvironmentFault
from adagen.schedule import load_profile
from adagen.schedule.profile import shipped_for


@pytest.mark.skipif(platform.machine() not in {"x86_64", "AMD64"}, reason="options of x86-64")
@pytest.mark.parametrize(
    ("option", "width"),
    [("-march=x86-64-v4", 64), ("-march=x86-64-v3", 32), ("-march=x86-64-v2", 16)],
)
def test_the_widest_registers_are_those_that_are_built_for(option: str, width: int) -> None:
    assert widest_register(find_toolchain({**os.environ, "CXXFLAGS": option})) == width
    name = shipped_for(width)
    assert load_profile(name).measured["process.register"] == (64 if width == 64 else 32)


def test_options_that_the_compiler_refuses_are_said() -> None:
    with pytest.raises(EnvironmentFault, match=r"refuses its options: .*no-such-option"):
        widest_register(find_toolchain({**os.environ, "CXXFLAGS": "--no-such-option"}))
