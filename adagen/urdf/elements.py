"""Elements and attributes, looked up so that misspelt ones are not taken for missing."""

from __future__ import annotations

from collections.abc import Collection

from lxml import etree

from adagen.urdf.notes import Notes, line_of
from adagen.urdf.numbers import numbers

Element = etree._Element


def children(parent: Element, known: Collection[str], where: str, notes: Notes) -> list[Element]:
    """Return the child elements with a known name, in order.

    Raises:
        InputError: a child has a known name in other letter case or in an XML namespace.
    """
    found: list[Element] = []
    for child in parent:
        if not isinstance(child.tag, str):
            continue
        name = etree.QName(child)
        if name.namespace is None and name.localname in known:
            found.append(child)
            continue
        local = name.localname.lower()
        if local in known:
            problem = (
                f"write <{local}>"
                if name.namespace is None
                else f'it is in the XML namespace "{name.namespace}": remove the namespace'
            )
            raise notes.error(
                f"{where}: unknown element <{name.localname}>: {problem}", line_of(child)
            )
    return found


def only(found: list[Element], name: str, where: str, notes: Notes) -> Element | None:
    """Return the one element called ``name`` among ``found``, None if there is none.

    Raises:
        InputError: there are several.
    """
    named = [element for element in found if element.tag == name]
    if len(named) > 1:
        raise notes.error(f"{where} has {len(named)} <{name}>: keep one", line_of(named[1]))
    return named[0] if named else None


def attribute(element: Element, key: str, where: str, notes: Notes) -> str:
    """Return an attribute that must be there and not be empty."""
    value = element.get(key)
    if value is None or not value.strip():
        how = "is empty" if value is not None else "is missing"
        hint = _misspelt(element, (key,))
        raise notes.error(f'{where}: {key}="..." of <{element.tag}> {how}{hint}', line_of(element))
    return value


def vector(
    element: Element, key: str, count: int, where: str, notes: Notes
) -> tuple[float, ...] | None:
    """Return the ``count`` numbers of an attribute, None where it is absent.

    Raises:
        InputError: the numbers are no numbers of a URDF, too many or too few.
    """
    text = element.get(key)
    if text is None:
        return None
    try:
        return numbers(text, count)
    except ValueError as fault:
        raise notes.error(f"{where}: {key} of <{element.tag}> {fault}", line_of(element)) from None


def scalar(element: Element, key: str, where: str, notes: Notes) -> float | None:
    """Return the number of an attribute, None where it is absent."""
    values = vector(element, key, 1, where, notes)
    return None if values is None else values[0]


def check_attributes(element: Element, known: Collection[str], where: str, notes: Notes) -> None:
    """Refuse attributes that nobody reads where a slip would change the robot silently."""
    for key in map(str, element.attrib):
        if key not in known and not key.startswith("{"):
            raise notes.error(
                f'{where}: <{element.tag}> has an unknown attribute "{key}": '
                f"known are {', '.join(known)}",
                line_of(element),
            )


def _misspelt(element: Element, keys: tuple[str, ...]) -> str:
    for key in map(str, element.attrib):
        if key.lower() in keys:
            return f' (found "{key}": names are in small letters)'
    return ""
