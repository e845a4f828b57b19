"""The parts of SVG that the drawings need, with the same bytes for the same picture."""

from __future__ import annotations

from html import escape
from unicodedata import east_asian_width

from adagen.errors import printable

FONT = "sans-serif"
MARGIN = 24.0
"""Around a picture, pixels."""
SIZE = 11.0
"""Of text, pixels."""
INK, MUTED, RULE, PAPER = "#1a1a1a", "#5c5c5c", "#b8b8b8", "#ffffff"

# Okabe and Ito's colours, distinct for people of any colour vision. More processes than colours
# repeat them in lighter shades; the process number is written as well.
_COLOURS = (
    (0, 114, 178),
    (230, 159, 0),
    (0, 158, 115),
    (204, 121, 167),
    (86, 180, 233),
    (213, 94, 0),
    (240, 228, 66),
    (128, 128, 128),
)
_SHADES = (0.0, 0.4, 0.65)


def colour(process: int) -> tuple[str, str]:
    """Return the colour of a process, and the colour of text on it."""
    shade = _SHADES[process // len(_COLOURS) % len(_SHADES)]
    r, g, b = (round(c + (255 - c) * shade) for c in _COLOURS[process % len(_COLOURS)])
    dark = 0.299 * r + 0.587 * g + 0.114 * b < 120
    return f"#{r:02x}{g:02x}{b:02x}", PAPER if dark else INK


def text_width(text: str, size: float) -> float:
    """Return an estimate of the width of text in a sans-serif face, on the safe side."""
    wide = 0 if text.isascii() else sum(east_asian_width(c) in "WF" for c in text)
    return (1.05 * wide + 0.62 * (len(text) - wide)) * size


def shorten(text: str, width: float, size: float) -> str:
    """Return a name in printable characters, cut with an ellipsis so that it fits the width."""
    text = printable(text)
    if text_width(text, size) <= width:
        return text
    while text and text_width(text + "…", size) > width:
        text = text[:-1]
    return text + "…" if text else ""


class Canvas:
    """Collects shapes; coordinates are pixels, written with one decimal."""

    def __init__(self) -> None:
        self._shapes: list[str] = []

    def rect(
        self,
        x: float,
        y: float,
        width: float,
        height: float,
        fill: str,
        *,
        stroke: str = "none",
        note: str = "",
    ) -> None:
        """Draw a rectangle; ``note`` is shown under a pointer."""
        self._shapes.append(
            f'<rect x="{x:.1f}" y="{y:.1f}" width="{max(width, 0.0):.1f}" height="{height:.1f}" '
            f'fill="{fill}" stroke="{stroke}" stroke-width="0.5"{_close(note)}'
        )

    def circle(self, x: float, y: float, radius: float, fill: str) -> None:
        """Draw a disc."""
        self._shapes.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:.1f}" fill="{fill}"/>')

    def path(
        self, points: list[tuple[float, float]], stroke: str = RULE, *, dashed: bool = False
    ) -> None:
        """Draw straight lines through points."""
        line = " ".join(f"{'L' if i else 'M'}{x:.1f} {y:.1f}" for i, (x, y) in enumerate(points))
        dash = ' stroke-dasharray="2 2"' if dashed else ""
        self._shapes.append(f'<path d="{line}" fill="none" stroke="{stroke}"{dash}/>')

    def text(
        self,
        x: float,
        y: float,
        text: str,
        size: float,
        *,
        fill: str = INK,
        anchor: str = "start",
        bold: bool = False,
    ) -> None:
        """Draw text with its baseline at y."""
        weight = ' font-weight="bold"' if bold else ""
        self._shapes.append(
            f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size:.1f}" fill="{fill}" '
            f'text-anchor="{anchor}"{weight}>{escape(printable(text), quote=False)}</text>'
        )

    def document(self, width: float, height: float, title: str) -> str:
        """Return the whole picture on a white ground."""
        w, h = f"{width:.0f}", f"{height:.0f}"
        return "\n".join(
            [
                f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" '
                f'viewBox="0 0 {w} {h}" font-family="{FONT}" role="img">',
                f"<title>{escape(printable(title), quote=False)}</title>",
                f'<rect width="{w}" height="{h}" fill="{PAPER}"/>',
                *self._shapes,
                "</svg>\n",
            ]
        )


def _close(note: str) -> str:
    return f"><title>{escape(printable(note), quote=False)}</title></rect>" if note else "/>"


def time_axis(canvas: Canvas, end: float, start: float, scale: float, y: float) -> None:
    """Draw an axis of time from 0 to ``end`` microseconds, ``scale`` units of length each."""
    step = 1e-6
    while end / step > 10:
        step *= 2.5 if f"{step:e}".startswith("2") else 2
    digits = max(0, next(d for d in range(9) if abs(step - round(step, d)) < 1e-9 * step))
    canvas.path([(start, y), (start + end * scale, y)])
    for i in range(int(end / step + 1e-9) + 1):
        x = start + i * step * scale
        canvas.path([(x, y), (x, y + 4)])
        canvas.text(x, y + 15, f"{i * step:.{digits}f}", 10, fill=MUTED, anchor="middle")
    canvas.text(start + end * scale + 8, y + 15, "µs", 10, fill=MUTED)
