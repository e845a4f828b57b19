"""The program of a plan: its operations in order. See adagen/program/types.py."""

from adagen.program.check import ProgramError, check
from adagen.program.lower import lower
from adagen.program.serialise import program_to_json
from adagen.program.types import Block, Links, Method, Operation, ProcessProgram, Program

__all__ = [
    "Block",
    "Links",
    "Method",
    "Operation",
    "ProcessProgram",
    "Program",
    "ProgramError",
    "check",
    "lower",
    "program_to_json",
]
