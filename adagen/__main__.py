"""``python -m adagen``."""

import sys

from adagen.cli import main

if __name__ == "__main__":
    sys.exit(main())
