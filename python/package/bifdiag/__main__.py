"""The command line: ``bifdiag`` or ``python -m bifdiag``."""

import signal
import sys

from . import _core
from .explorer import PAGE


def main() -> int:
    """Runs the command line of this process; the exit status."""
    # The command answers interrupts itself.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    arguments = sys.argv[1:]
    if arguments[:1] == ["explore"] and PAGE.is_dir() and not any(word.startswith("--page") for word in arguments):
        arguments.insert(1, f"--page={PAGE}")
    return _core.run(["bifdiag", *arguments])


if __name__ == "__main__":
    sys.exit(main())
