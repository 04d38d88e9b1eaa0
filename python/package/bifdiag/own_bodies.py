"""The user's own bodies for a scan: out of arrays and tables, and back into rows."""

import csv
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from . import exact
from .arrays import POLICIES
from .errors import InputError
from .given import Given

COLUMNS = ("A1", "A2", "A3", "r1", "r2", "r3")
"""The columns of a table of bodies."""

Floats = npt.NDArray[np.float64]


class OwnBodies:
    """A and r of each body, and which of them can be scanned."""

    def __init__(self, given: Any, invalid: str) -> None:
        if invalid not in POLICIES:
            raise InputError(f'invalid = {invalid!r}: "mark" marks a body that lacks a number, "raise" refuses it')
        self.numbers, self._masked = _numbers(given)
        self.valid: npt.NDArray[np.bool_] = np.asarray(np.isfinite(self.numbers).all(axis=1))
        self._first = None if self.valid.all() else int(np.flatnonzero(~self.valid)[0])
        if invalid == "raise":
            self.require('leave it out, or give invalid="mark"')
        if not self.valid.any():
            self.require("no other body has six finite numbers either")

    def require(self, hint: str) -> None:
        """Refuses bodies that cannot be scanned, naming the first."""
        if self._first is not None:
            raise InputError(f"bodies[{self._first}]: {self._why(self._first)}; {hint}")

    def write(self, path: Path) -> None:
        """Those that can be scanned, as a table for the command line."""
        with path.open("w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([COLUMNS, *([*map(repr, row)] for row in self.numbers[self.valid].tolist())])

    def spread(self, columns: dict[str, npt.NDArray[Any]]) -> dict[str, npt.NDArray[Any]]:
        """The columns with a row for every body; of one that was not scanned the numbers are NaN, and bools masked."""
        if self._first is None:
            return columns
        out = {name: _spread(column, self.valid) for name, column in columns.items()}
        out |= {name: self.numbers[:, place] for place, name in enumerate(COLUMNS)}
        out["index"] = np.arange(len(self.valid))
        wrong = ~self.valid
        # Without a failed body no row has an error, and the column is of floats.
        out["error"] = out["error"].astype(object)
        out["error"][self.valid] = [value if isinstance(value, str) else None for value in out["error"][self.valid]]
        out["error"][wrong] = [self._why(row) for row in np.flatnonzero(wrong).tolist()]
        out["status"][wrong] = "invalid"
        return out

    def _why(self, row: int) -> str:
        column = int(np.flatnonzero(~np.isfinite(self.numbers[row]))[0])
        if self._masked[row, column]:
            return f"{COLUMNS[column]} is masked"
        return f"{COLUMNS[column]} = {self.numbers[row, column]} is no finite number"


def _spread(column: npt.NDArray[Any], valid: npt.NDArray[np.bool_]) -> npt.NDArray[Any]:
    if column.dtype == bool:
        flags = np.ma.MaskedArray(np.zeros(len(valid), dtype=bool), mask=~valid)
        flags[valid] = column
        return flags
    out = np.full(len(valid), None if column.dtype == object else np.nan, dtype=object if column.dtype == object else float)
    out[valid] = column
    return out


def _floats(values: Any) -> tuple[Floats, npt.NDArray[np.bool_]]:
    """Numbers, with NaN where one is missing, and which are masked."""
    masked = np.ma.getmaskarray(values) if isinstance(values, np.ma.MaskedArray) else None
    plain: Any = values if masked is None else np.ma.getdata(values)
    # Nullable columns of pandas.
    if getattr(getattr(plain, "dtype", None), "na_value", None) is not None:
        plain = plain.to_numpy(dtype=np.float64, na_value=np.nan)
    numbers: Floats = np.array(plain, dtype=np.float64)
    if masked is None:
        return numbers, np.zeros(numbers.shape, dtype=bool)
    numbers[masked] = np.nan
    return numbers, masked


def _has_columns(bodies: Any) -> bool:
    """A frame, a table of Arrow, a Dataset of xarray, a dict."""
    return isinstance(bodies, Mapping) or hasattr(bodies, "columns")


def _require_columns(bodies: Any) -> None:
    """Each of the packages of tables has an error of its own for a column that is not there."""
    # Of a table of Arrow, `columns` are arrays.
    names = getattr(bodies, "column_names", getattr(bodies, "columns", None))
    known = getattr(bodies, "dtype", np.dtype(float)).names or (bodies if names is None else names)
    missing = [name for name in COLUMNS if name not in known]
    if missing:
        raise InputError(f"bodies has no column {missing[0]}; give a table with the columns {', '.join(COLUMNS)}")


def labels(bodies: Any) -> Any:
    """The index of pandas that bodies have: that of a frame, or of the one dimension of a Dataset; else None."""
    if isinstance(bodies, Mapping):
        indices = list(getattr(bodies, "indexes", {}).values())
        return indices[0] if len(indices) == 1 else None
    return getattr(bodies, "index", None) if hasattr(bodies, "columns") else None


def _numbers(bodies: Any) -> tuple[Floats, npt.NDArray[np.bool_]]:
    """A and r of each body, and which are masked: (n, 6)."""
    if not hasattr(bodies, "dtype") and not _has_columns(bodies):
        bodies = list(bodies)
        if bodies and all(isinstance(one, Given) for one in bodies):
            for one in bodies:
                one._exactly()
            bodies = [[float(exact.value(text)) for text in (*one.A, *one.r)] for one in bodies]
    try:
        if _has_columns(bodies) or getattr(bodies, "dtype", np.dtype(float)).names:
            _require_columns(bodies)
            columns = [_floats(bodies[name]) for name in COLUMNS]
            numbers = np.stack([column for column, _ in columns], axis=-1)
            masked = np.stack([mask for _, mask in columns], axis=-1)
        else:
            pair = len(bodies) == 2 and all(np.ndim(part) == 2 and np.shape(part)[1] == 3 for part in bodies)
            if pair and len(bodies[0]) != len(bodies[1]):
                raise InputError(
                    f"bodies: {len(bodies[0])} moments A and {len(bodies[1])} centres r; one of each is needed"
                )
            parts = [_floats(part) for part in bodies] if pair else [_floats(bodies)]
            numbers = np.concatenate([part for part, _ in parts], axis=-1)
            masked = np.concatenate([mask for _, mask in parts], axis=-1)
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"bodies: {error}; give a table with the columns {', '.join(COLUMNS)}, or rows of six") from error
    if numbers.ndim != 2 or numbers.shape[1] != 6 or not len(numbers):
        raise InputError(f"bodies has the shape {numbers.shape}; rows of A1, A2, A3, r1, r2, r3 are needed")
    # Without the sign of 0, which is none of the body's.
    return numbers + 0.0, masked
