"""Times at which a motion is wanted."""

from typing import Any

import numpy as np
import numpy.typing as npt

from . import exact
from .errors import InputError

SAMPLES = 201
"""Times if only the last one is said."""


def times(t: Any) -> npt.NDArray[np.float64]:
    """Times that rise; of a number so many from 0 to it.

    Raises
    ------
    InputError
        If they are none, do not rise, or are not finite.
    """
    exact.unmasked(t, "t")
    try:
        found: npt.NDArray[np.float64] = np.asarray(t, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InputError(f"t = {t!r}: {error}") from error
    if found.ndim == 0 and np.isfinite(found):
        end = float(found)
        found = spread(min(end, 0.0), max(end, 0.0), SAMPLES if end else 1)
    if found.ndim != 1 or not len(found) or not np.isfinite(found).all():
        raise InputError("t: finite times are needed, one or more")
    if (np.diff(found) < 0).any():
        place = int(np.argmax(np.diff(found) < 0)) + 1
        raise InputError(f"t[{place}] = {found[place]} is before t[{place - 1}]; sort the times, equal ones are allowed")
    return found


def spread(first: float, last: float, count: int) -> npt.NDArray[np.float64]:
    """Equidistant times, to the last bit those of the command line."""
    if count == 1:
        return np.array([first])
    places = np.arange(count, dtype=np.float64)
    return ((count - 1 - places) * first + places * last) / (count - 1)


def span(found: npt.NDArray[np.float64]) -> tuple[float, float, int] | None:
    """First, last and number of times that `spread` gives; None of others."""
    first, last, count = float(found[0]), float(found[-1]), len(found)
    return (first, last, count) if np.array_equal(found, spread(first, last, count)) else None
