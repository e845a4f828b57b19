"""Random robots and mechanisms that are hard to solve, and what emitted solvers make of them."""
