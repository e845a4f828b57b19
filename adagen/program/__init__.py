"""The program of a plan: what runs, operation by operation. See adagen/program/types.py."""

from adagen.program.lower import lower
from adagen.program.types import Block, Links, Method, Operation, ProcessProgram, Program

__all__ = [
    "Block",
    "Links",
    "Method",
    "Operation",
    "ProcessProgram",
    "Program",
    "lower",
]
