"""One page about a robot and the program that solves it; it needs no network."""

from adagen.report.document import Measured, Scene, document
from adagen.report.page import page

__all__ = ["Measured", "Scene", "document", "page"]
