"""The command line: ``bifdiag`` or ``python -m bifdiag``."""

import signal
import sys

from . import _core


def main() -> int:
    """Runs the command line of this process; the exit status."""
    # The command answers interrupts itself.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _core.run(["bifdiag", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
