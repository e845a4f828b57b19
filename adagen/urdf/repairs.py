"""Repairs, before parsing, of harmless slips in real files that other URDF readers accept.

None of them can change the dynamics. Each gets one warning; a strict reader refuses the file.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from lxml import etree

from adagen.urdf.notes import Notes, line_of, quoted

# Possessive: hundreds of comments without a declaration behind them cost no more than their length.
_BEFORE = re.compile(
    r"(?P<before>(?>\s+|<!--.*?-->)*+)(?P<declaration><\?xml\s[^>]{0,200}?\?>)", re.DOTALL
)
_VERSION = re.compile(r"(\bversion\s*=\s*[\"'])([^\"']{0,40})([\"'])")
_ENCODING = re.compile(r"\bencoding\s*=\s*[\"'](?!(?:utf-?8|us-ascii|ascii)[\"'])", re.I)
_UNDECLARED = re.compile(r"^Namespace prefix (\S{1,100}) (?:for \S+ )?on \S+ is not defined")
_ROOT = re.compile(r"<[A-Za-z_][\w.:-]*")
_MOST_PREFIXES = 32

UNDECLARED = "undeclared:"
"""What the namespaces that stand for undeclared prefixes begin with."""


def mended_declaration(text: str, notes: Notes) -> str:
    """Return the text with its XML declaration at the start and of a version that exists.

    Lines stay where they are.

    Raises:
        InputError: the reader is strict.
    """
    match = _BEFORE.match(text)
    if match is None:
        return text
    before, declaration = match["before"], match["declaration"]
    line = before.count("\n") + 1
    if before and not _ENCODING.search(declaration):  # another encoding would have been missed
        notes.slip(
            "the XML declaration does not stand at the start of the file", "read as if it did", line
        )
        blank = "".join(c if c == "\n" else " " for c in declaration)
        return before + blank + text[match.end() :]
    version = _VERSION.search(declaration)
    if version is not None and not re.fullmatch(r"1\.\d+", version[2]):
        notes.slip(f'there is no XML version "{version[2]}"', "read as 1.0", line)
        return before + _VERSION.sub(r"\g<1>1.0\g<3>", declaration, count=1) + text[match.end() :]
    return text


def with_prefixes_declared(
    text: str, parse: Callable[[str], etree._Element], start: int, notes: Notes
) -> etree._Element:
    """Return what a text is parsed to, namespace prefixes that nobody declared being declared.

    What has such a prefix is then in a namespace of its own, and so no part of a URDF.

    Args:
        text: an XML document.
        parse: from text to its root element; raises ``etree.XMLSyntaxError``.
        start: where the root element begins in the text.
        notes: takes one warning for all prefixes.

    Raises:
        InputError: the reader is strict.
        etree.XMLSyntaxError: the text is no XML for another reason.
    """
    prefixes: list[str] = []
    line = None
    while True:
        try:
            root = parse(text)
        except etree.XMLSyntaxError as fault:
            found = _UNDECLARED.match(fault.msg or "")
            name = _ROOT.match(text, start)
            if found is None or name is None or len(prefixes) == _MOST_PREFIXES:
                raise
            line = line or fault.lineno
            prefixes.append(found[1])
            declared = f' xmlns:{found[1]}="{UNDECLARED}{found[1]}"'
            text = text[: name.end()] + declared + text[name.end() :]
            continue
        if prefixes:
            many = len(prefixes) > 1
            notes.slip(
                f"namespace {'prefixes' if many else 'prefix'} {quoted(prefixes)} "
                f"{'are' if many else 'is'} not declared",
                "what has one is left out" if many else "what has it is left out",
                line,
            )
        return root


def without_default_namespace(root: etree._Element, notes: Notes) -> None:
    """Take elements out of the namespace that a root element sets as the default, in place.

    Files for old releases of Drake have one; other readers of URDF know no namespaces.

    Raises:
        InputError: the reader is strict.
    """
    namespace = root.nsmap.get(None)
    if namespace is None or root.prefix is not None:
        return
    notes.slip(
        f'the default XML namespace is "{namespace}", a URDF is in none',
        "read as if it was",
        line_of(root),
    )
    for element in root.iter(f"{{{namespace}}}*"):
        if element.prefix is None:
            element.tag = etree.QName(element).localname
