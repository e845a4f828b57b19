"""From text to the root element <robot> of a well-formed XML document without a DTD."""

from __future__ import annotations

import re

from lxml import etree

from adagen.urdf.notes import Notes, line_of
from adagen.urdf.repairs import (
    UNDECLARED,
    mended_declaration,
    with_prefixes_declared,
    without_default_namespace,
)

_PROLOG = re.compile(r"(?:\s+|<!--.*?-->|<\?.*?\?>)*", re.DOTALL)
_FOREIGN = {
    "sdf": "this is SDF, not URDF: convert it first",
    "gazebo": "this is SDF, not URDF: convert it first",
    "mujoco": "this is MJCF, not URDF: let its name end in .xml to have it read as such",
    "mujocoinclude": "this is a part of an MJCF: give the file that includes it",
    "html": "this is a web page, perhaps a failed download",
    "svg": "this is a drawing",
    "collada": "this is a mesh",
}


def parse(text: str, notes: Notes) -> etree._Element:
    """Return the root element <robot>, comments and processing instructions left out.

    Entities other than the five of XML are never expanded: a DTD is refused before parsing. Slips
    that change nothing are put right (repairs.py).

    Raises:
        InputError: no well-formed XML, or another kind of document.
    """
    start = check_prolog(text, notes)
    text = mended_declaration(text, notes)
    parser = etree.XMLParser(
        encoding="utf-8",  # the text is decoded already: overrides what the file declares
        recover=False,
        resolve_entities=False,
        load_dtd=False,
        no_network=True,
        huge_tree=False,
        remove_comments=True,
        remove_pis=True,
    )
    try:
        root = with_prefixes_declared(
            text, lambda each: etree.fromstring(each.encode("utf-8"), parser), start, notes
        )
    except etree.XMLSyntaxError as fault:
        line = fault.lineno or None
        reason = " ".join((fault.msg or "syntax error").split())
        reason = re.sub(r", line \d+, column \d+$", "", reason)
        raise notes.error(f"XML is not well formed: {reason}", line) from None
    except UnicodeEncodeError:
        raise notes.error("XML is not well formed: lone surrogate: save it as UTF-8") from None
    _check_root(root, notes)
    return root


def check_prolog(text: str, notes: Notes) -> int:
    """Return where the root element begins; refuse a DTD, which can only stand before it.

    Raises:
        InputError: there is a DTD, or no XML.
    """
    match = _PROLOG.match(text)
    start = match.end() if match else 0
    line = text.count("\n", 0, start) + 1
    head = text[start : start + 200].lower()
    if head.startswith("<!doctype html"):
        raise notes.error("the root element <html> is not <robot>: " + _FOREIGN["html"], line)
    if head.startswith("<!doctype"):
        raise notes.error(
            "a DTD and its entities are not allowed in a URDF: remove <!DOCTYPE ...>", line
        )
    if not head.startswith("<"):
        raise notes.error("not XML: the file does not start with <: give a URDF file", line)
    return start


def _check_root(root: etree._Element, notes: Notes) -> None:
    name = etree.QName(root)
    line = line_of(root)
    if name.localname != "robot":
        hint = _FOREIGN.get(name.localname.lower(), "give a URDF file")
        raise notes.error(f"the root element <{name.localname}> is not <robot>: {hint}", line)
    if name.namespace is not None and root.prefix is not None:
        raise notes.error(
            f'<robot> is in the XML namespace "{name.namespace}", a URDF is in none: '
            f'remove the prefix "{root.prefix}:"',
            line,
        )
    without_default_namespace(root, notes)
    for element in root.iter():
        tag = element.tag
        if isinstance(tag, str) and "xacro" in tag and is_xacro(tag):
            raise notes.error(
                f"<xacro:{tag.replace('}', ':').rpartition(':')[2]}> is not expanded: run xacro "
                "on the file and give its output, or let its name end in .xacro",
                line_of(element),
            )
    _warn_xacro_attributes(root, notes)


def _warn_xacro_attributes(root: etree._Element, notes: Notes) -> None:
    """Attributes of xacro on elements of URDF do nothing, to whoever reads the file."""
    for element in root.iter():
        for key in map(str, element.attrib):
            if is_xacro(key) and UNDECLARED not in key:
                name = etree.QName(key).localname
                notes.slip(f'a leftover attribute "xacro:{name}"', "left out", line_of(element))
                return


def is_xacro(tag: str) -> bool:
    """Tell whether a tag, as lxml spells it, belongs to xacro (its namespace declared or not)."""
    space, _, _ = tag.rpartition("}")
    return tag.startswith("xacro:") or "xacro" in space
