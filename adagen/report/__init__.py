"""One HTML page about a robot and its solver, without network access."""

from adagen.report.accuracy import Accuracy, accuracy_of
from adagen.report.document import Measured, Scene, document
from adagen.report.page import page

__all__ = ["Accuracy", "Measured", "Scene", "accuracy_of", "document", "page"]
