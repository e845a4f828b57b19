"""Numbers and small linear expressions as C++ text, with constants folded."""

from __future__ import annotations

from collections.abc import Iterable

_VANISHES = 2.0**-150  # half the smallest float


class Printer:
    """Prints numbers of one scalar type."""

    def __init__(self, scalar: str) -> None:
        self.suffix = "f" if scalar == "float" else ""

    def number(self, value: float) -> str:
        """Return a literal that reads back to the same double (or its nearest float)."""
        if self.suffix and abs(value) <= _VANISHES:  # compilers warn of such literals
            value = 0.0
        return repr(float(value) + 0.0) + self.suffix

    def numbers(self, values: Iterable[float]) -> str:
        """Return literals, comma-separated."""
        return ", ".join(self.number(value) for value in values)

    def linear(self, terms: Iterable[tuple[float, str]], constant: float = 0.0) -> str:
        """Return constant + sum of factor * variable, without zeros and factors of one."""
        text = self.number(constant) if constant != 0.0 else ""
        for factor, variable in terms:
            if factor == 0.0:
                continue
            size = variable if abs(factor) == 1.0 else f"{self.number(abs(factor))} * {variable}"
            if text:
                text += f" - {size}" if factor < 0.0 else f" + {size}"
            else:
                text = f"-{size}" if factor < 0.0 else size
        return text or self.number(0.0)
