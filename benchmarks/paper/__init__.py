"""The tables and figures of Yamane and Nakamura's paper, each by one command; see docs/paper.md."""
