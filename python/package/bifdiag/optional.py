"""Packages that are needed for some things only."""

import importlib
from typing import Any


def needed(module: str, extra: str) -> Any:
    """A module of a package that one of this package's extras brings.

    Raises
    ------
    ImportError
        If it is not installed: the message names the extra.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = module.partition(".")[0]
        raise ImportError(f"this needs {package}: pip install 'bifdiag[{extra}]', or {package} alone ({error})") from error
