"""``python -m amrmetrics REFERENCE ESTIMATE``: see `amrmetrics.command`."""

import sys

from amrmetrics.command import main

if __name__ == "__main__":
    sys.exit(main())
