"""Where forward dynamics loses its digits: failing cases, weak methods beside the shipped one."""

from adagen.studies.stability.cases import CASES, Case, Finding, Outcome, run_case

__all__ = ["CASES", "Case", "Finding", "Outcome", "run_case"]
