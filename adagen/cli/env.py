"""``adagen env``: the toolchain in use; emitted Makefiles call it."""

from __future__ import annotations

import json
import os
import shlex
import textwrap
from collections.abc import Sequence

from adagen.build import cache_folder, find_toolchain
from adagen.cli.parser import Parser, make_parser, parse

_EPILOG = """examples:
  adagen env                         what would be used
  $(adagen env --mpicxx) -O3 ...     for use in a Makefile or script

MPICXX, MPIEXEC, EIGEN and CXX choose another compiler wrapper, launcher, Eigen
or compiler; CXXFLAGS is appended to the options.

profile is the shipped one that was measured on a processor like this one, with
registers of the same width: --profile native takes it. adagen calibrate
measures this machine's costs."""


def command_parser() -> Parser:
    """Return the parser of ``adagen env``."""
    parser = make_parser("adagen env", "Print the toolchain that would be used.", _EPILOG)
    parser.usage = "adagen env [option]"
    which = parser.add_mutually_exclusive_group()
    for option, help_text in (
        ("--cxx", "only the compiler for one process"),
        ("--mpicxx", "only the compiler wrapper"),
        ("--mpiexec", "only the launcher"),
        ("--eigen", "only the folder with Eigen's headers"),
        ("--flags", "only the compiler options"),
        ("--variables", "only the variables to set, as NAME=VALUE words"),
        ("--json", "everything as JSON"),
    ):
        which.add_argument(
            option, dest="which", action="store_const", const=option[2:], help=help_text
        )
    return parser


def run(argv: Sequence[str]) -> int:
    """Carry out ``adagen env`` with the arguments after the verb; return the exit status."""
    options = parse(command_parser(), argv)
    toolchain = find_toolchain(os.environ)
    lines = {
        "cxx": shlex.join(toolchain.cxx),
        "mpicxx": shlex.join(toolchain.mpicxx),
        "mpiexec": shlex.join(toolchain.mpiexec),
        "eigen": shlex.quote(str(toolchain.eigen)),
        "flags": shlex.join(toolchain.flags),
        "variables": " ".join(shlex.quote(f"{n}={v}") for n, v in toolchain.environment),
    }
    if options.which not in (None, "json"):
        print(lines[options.which])
        return 0

    from adagen.build.native_profile import native_profile
    from adagen.build.registers import widest_register

    register, profile = widest_register(toolchain), native_profile(toolchain)
    if options.which == "json":
        report: dict[str, object] = {
            "cxx": list(toolchain.cxx),
            "mpicxx": list(toolchain.mpicxx),
            "mpiexec": list(toolchain.mpiexec),
            "eigen": str(toolchain.eigen),
            "flags": list(toolchain.flags),
            "variables": dict(toolchain.environment),
            "wheel": toolchain.wheel,
            "cache": str(cache_folder()),
            "register_bytes": register,
            "profile": profile,
        }
        print(json.dumps(report, indent=2))
        return 0
    lines["cache"] = str(cache_folder())
    alike = f"this processor with registers of {register} bytes"
    lines["profile"] = f"{profile}, the shipped one for {alike}"
    for name, line in lines.items():
        words = textwrap.wrap(line, 70, break_long_words=False, break_on_hyphens=False)
        print(f"{name:10}" + f"\n{'':10}".join(words))
    return 0
