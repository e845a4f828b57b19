"""The page of a report: the template with its style, its script and the data."""

from __future__ import annotations

import json
from html import escape
from typing import Any

from adagen.emit.templates import environment, verbatim
from adagen.errors import printable
from adagen.version import __version__

_STYLE = "report/style.css"
_PARTS = ("skeleton", "timeline", "chart", "accuracy", "page")
_SCRIPTS = tuple(f"report/{part}.js" for part in _PARTS)


def page(document: dict[str, Any]) -> str:
    """Return a report as one HTML page that needs no other file.

    Args:
        document: of ``adagen.report.document``.
    """
    robot, program = document["robot"]["name"], document["program"]["title"]
    return (
        environment()
        .get_template("report/page.html.j2")
        .render(
            title=escape(printable(f"{robot}: {program}")),
            version=escape(__version__),
            style=verbatim(_STYLE),
            script="\n".join(map(verbatim, _SCRIPTS)),
            data=_embedded(document),
        )
    )


def _embedded(document: dict[str, Any]) -> str:
    """Return JSON that cannot end the element it stands in: names are hostile data."""
    text = json.dumps(document, allow_nan=False, ensure_ascii=True, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")
