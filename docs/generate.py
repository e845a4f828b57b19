"""What MkDocs generates into pages of the reference: helps of commands, and parts of sources.

A page says where, in comments on lines of their own:

    <!-- help: VERB -->           all options of `adagen VERB` (of `adagen MODEL`: MODEL)
    <!-- program help -->         options of an emitted program
    <!-- source: PATH -->         a file of this repository
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
_FOREIGN_WORKER = "https://unpkg.com/iframe-worker/shim"
_WITHOUT_MORE = ("info", "verify", "calibrate", "stability", "completion", "env")


def on_page_markdown(markdown: str, **_: Any) -> str:
    """Put generated text where a page asks for it (called by MkDocs for each page)."""
    for pattern, text in _GENERATED.items():
        markdown = re.sub(rf"^<!-- {pattern} -->$", text, markdown, flags=re.MULTILINE)
    return markdown


def on_post_page(output: str, page: Any, **_: Any) -> str:
    """Let a page's search ask this site, and no other, for what it needs (called by MkDocs)."""
    here = "../" * page.url.count("/")
    return output.replace(_FOREIGN_WORKER, f"{here}assets/file_worker.js")


def on_post_template(output_content: str, **_: Any) -> str:
    """The same for the page that is shown where there is none (called by MkDocs)."""
    return output_content.replace(_FOREIGN_WORKER, "/assets/file_worker.js")


def _help(match: re.Match[str]) -> str:
    verb = match[1]
    option = "--help" if verb in _WITHOUT_MORE else "--help-all"
    command = [sys.executable, "-m", "adagen", *([] if verb == "MODEL" else [verb]), option]
    environment = {**os.environ, "COLUMNS": "80", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
    return f"```text\n{done.stdout.strip()}\n```"


def _program_help(_: re.Match[str]) -> str:
    source = (ROOT / "templates" / "include" / "adagen" / "options.hpp").read_text(encoding="utf-8")
    (literals,) = re.findall(r"kUsageText =\n(.*?);\n", source, flags=re.DOTALL)
    text = "".join(re.findall(r'^ *"(.*)"$', literals, flags=re.MULTILINE))
    return "```text\n" + text.replace("\\n", "\n").strip("\n") + "\n```"


def _source(match: re.Match[str]) -> str:
    language = {".h": "c", ".toml": "toml"}[Path(match[1]).suffix]
    return f"```{language}\n{(ROOT / match[1]).read_text(encoding='utf-8').strip()}\n```"


_GENERATED: dict[str, Callable[[re.Match[str]], str]] = {
    r"help: ([A-Za-z]+)": _help,
    r"program help": _program_help,
    r"source: (\S+)": _source,
}
