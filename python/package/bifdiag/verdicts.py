"""Verdicts on the stability of relative equilibria: computed with the rest of a row, or when they are first read."""

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from .errors import RangeError

VERDICTS = ("stable", "stable_by", "verdict")
"""Columns that are computed when they are first read."""

LATER = -1
"""In place of a verdict that was not asked for."""

Columns = dict[str, npt.NDArray[Any]]


def place(columns: Columns) -> int:
    """Where the verdicts stand."""
    return list(columns).index("stability") + 1


def worded(verdict: npt.NDArray[Any], why: npt.NDArray[Any], words: dict[str, Any]) -> Columns:
    """The verdicts in words, of their codes."""
    told = np.array(words["verdict"])[verdict]
    stable = np.ma.MaskedArray(told == "stable", mask=told == "open")
    return {"stable": stable, "stable_by": np.array(words["stable_by"])[why], "verdict": told}


def deferred(
    body: _core.Body,
    asked: Any,
    l_index: npt.NDArray[np.int64],
    words: dict[str, Any],
    codes: tuple[npt.NDArray[Any], ...],
    threads: int,
) -> Callable[[], Columns]:
    """Asks once more, with verdicts, for the momenta at which some are missing."""

    def complete() -> Columns:
        branch, verdict, why = codes
        missing = np.zeros(len(asked), dtype=bool)
        missing[l_index[verdict == LATER]] = True
        places = np.flatnonzero(missing)
        again = [asked[place] for place in places] if isinstance(asked, list) else asked[places]
        found = _core.critical(body, again, True, threads)
        rows = missing[l_index]
        ids = {number: name for number, (name, _) in enumerate(words["branches"])}
        theirs = {number: name for number, (name, _) in enumerate(found["words"]["branches"])}
        ours = [ids[number] for number in branch[rows].tolist()]
        if ours != [theirs[number] for number in found["branch"].tolist()]:
            raise RangeError("the verdicts do not belong to these rows; ask for fewer l at a time")
        verdict, why = verdict.copy(), why.copy()
        verdict[rows], why[rows] = found["verdict"], found["stable_by"]
        return worded(verdict, why, words)

    return complete
