"""The package's command line in a process of its own."""

import re
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
    message = spoken(told)
    if process.returncode == 2:
        raise InputError(message)
    if process.returncode != 0:
        raise BifdiagError(message)
    return printed


def spoken(told: str) -> str:
    """A message of the command line with the names of arguments in place of options."""
    message = re.split("\n\n(?:Usage|For more information)", told, maxsplit=1)[0].strip().removeprefix("error: ")
    message = message.replace("leave out --keep", "give overwrite=True").replace(", or give --format", "")
    # An option with an example of its value, also of a list, then one with what stands for its value, then the name alone.
    message = re.sub(r"--([a-z][a-z-]*) (-?\d[\w.]*)(?![\w=:]|,\d)", lambda found: f"{_name(found[1])}={found[2]}", message)
    message = re.sub(r"--([a-z][a-z-]*) ([\w.]+=[\w.:,-]+)", lambda found: f'{_name(found[1])}="{found[2]}"', message)
    message = re.sub(
        r"--([a-z][a-z-]*)=(-?\d[\d.]*(?:,-?\d[\d.]*)+)", lambda found: f"{_name(found[1])}=[{found[2]}]", message
    )
    message = re.sub(r"'--([a-z][a-z-]*)(?: <[^>]*>)?'", lambda found: f"'{_name(found[1])}'", message)
    return re.sub(r"(?<![\w-])--([a-z][a-z-]*)", lambda found: _name(found[1]), message)


def _name(option: str) -> str:
    """The argument for an option."""
    return option.replace("-", "_")
