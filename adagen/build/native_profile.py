"""The shipped cost profile that fits this machine."""

from __future__ import annotations

from adagen.build.processor import processor_family
from adagen.build.registers import widest_register
from adagen.build.toolchain import Toolchain, find_toolchain
from adagen.schedule.profile import NATIVE, shipped_for


def native_profile(toolchain: Toolchain) -> str:
    """Return the name of the shipped profile that fits this machine.

    It was measured on the processor that is the most alike, with registers as wide as those that
    the compiler takes.

    Args:
        toolchain: the compiler and its options.

    Raises:
        EnvironmentFault: the compiler cannot be run, or refuses its options.
    """
    return shipped_for(widest_register(toolchain), processor_family())


def profile_named(name: str) -> str:
    """Return the name of a profile, or its file; of "native", that of the one that fits.

    Sources and commands name the profile that it stands for, so that they are made again anywhere.

    Raises:
        EnvironmentFault: there is no compiler to ask for its registers.
    """
    return native_profile(find_toolchain()) if name == NATIVE else name
