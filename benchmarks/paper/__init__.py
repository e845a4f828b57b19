"""The tables and figures of Yamane and Nakamura's paper, each by one command.

See docs/records/paper.md.
"""
