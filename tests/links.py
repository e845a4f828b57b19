"""Robots with other bodies as links."""

from __future__ import annotations

from dataclasses import replace

from adagen.model import Inertia, Model


def with_inertia(model: Model, number: int, inertia: Inertia) -> Model:
    """Return the model with another inertia of a link."""
    links = list(model.links)
    links[number] = replace(links[number], inertia=inertia)
    return replace(model, links=tuple(links))


def with_light_link(model: Model, number: int, ratio: float) -> Model:
    """Return the model with a link that is lighter by a factor, in mass and inertia."""
    heavy = model.links[number].inertia
    return with_inertia(model, number, Inertia(heavy.mass * ratio, heavy.com, heavy.tensor * ratio))
