"""The package's command line in a process of its own."""

import subprocess
import sys

from .errors import BifdiagError, InputError


def command(*arguments: str) -> str:
    """Runs the package's command line in a separate process; returns its output.

    Raises
    ------
    InputError
        If its exit status is 2; carries its message.
    BifdiagError
        If its exit status is 1.
    """
    line = [sys.executable, "-m", "bifdiag", *arguments]
    with subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8") as process:
        try:
            printed, told = process.communicate()
        except BaseException:
            process.terminate()
            raise
    message = told.partition("\n\nFor more information")[0].strip().removeprefix("error: ")
    if process.returncode == 2:
        raise InputError(message)
    if process.returncode != 0:
        raise BifdiagError(message)
    return printed
