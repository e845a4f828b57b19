"""The paper's search: Eq. (11), the A* of the Appendix, III-D, and an exact branch and bound.

Form `ada` is scheduled by it, and the tables of the paper come from it.
"""

from adagen.paper.search import find_schedule

__all__ = ["find_schedule"]
