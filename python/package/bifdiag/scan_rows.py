"""The rows of a scan."""

from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from .behaviour import counted
from .errors import InputError
from .tables import Table

if TYPE_CHECKING:
    import pandas
    import xarray


class Scan(Table):
    """The rows of a scan, one for each body, as arrays; the page "Files" describes the columns.

    Of a DataFrame or Dataset of bodies `to_pandas` and `to_xarray` have the index, so that
    ``frame[["name"]].join(scan.to_pandas())`` brings the answers beside its own columns.

    Attributes
    ----------
    status : array (n,) of str
        ``"classified"``, ``"undecided"``, ``"failed"``, or ``"invalid"`` where a number of the body is missing; ``error``
        says why. Counts are NaN where there is no answer, and of an invalid body bools are masked.
    meta : dict
        The summary of the scan; ``invalid``: the places of own bodies that could not be scanned.
    """

    A1: npt.NDArray[np.float64]
    A2: npt.NDArray[np.float64]
    A3: npt.NDArray[np.float64]
    r1: npt.NDArray[np.float64]
    r2: npt.NDArray[np.float64]
    r3: npt.NDArray[np.float64]
    status: npt.NDArray[np.object_]
    regions: npt.NDArray[Any]
    critical_points: npt.NDArray[Any]

    def __init__(self, columns: dict[str, npt.NDArray[Any]], meta: str, labels: Any = None) -> None:
        super().__init__(columns, meta)
        self._labels = labels

    def _selected(self, kept: Any) -> "Scan":
        return Scan({name: column[kept] for name, column in self._columns.items()}, self._meta, self._labels)

    def counts(self, name: Literal["signatures", "types"] = "signatures") -> dict[str, npt.NDArray[np.int64]]:
        """How many regions of each body have a signature, or show a type of component: an array for each that occurs.

        ``pandas.DataFrame(scan.counts())`` has a column for each.
        """
        if name not in ("signatures", "types"):
            raise InputError(f'name = {name!r}: the columns with counts are "signatures" and "types"')
        found: list[dict[str, int]] = []
        for told in self[name].tolist():
            parts = [word.rpartition(":") for word in str(told or "").split()]
            found.append({word: int(count) for word, _, count in parts})
        every = sorted({word for one in found for word in one})
        return {word: np.array([one.get(word, 0) for one in found], dtype=np.int64) for word in every}

    def to_pandas(self) -> "pandas.DataFrame":
        """A DataFrame, with the index of that of the bodies if there was one; ``bifdiag[tables]`` installs pandas."""
        frame = super().to_pandas()
        return frame if self._labels is None else frame.set_index(self._labels.take(self["index"]))

    def to_xarray(self) -> "xarray.Dataset":
        """A Dataset over ``row``, with the index of the bodies as a coordinate; ``bifdiag[tables]`` installs xarray."""
        data = super().to_xarray()
        if self._labels is None or self._labels.nlevels > 1:
            return data
        return data.assign_coords({str(self._labels.name or "label"): ("row", self._labels.take(self["index"]).to_numpy())})

    def __reduce__(self) -> tuple[Any, ...]:
        return Scan, (self._columns, self._meta, self._labels)

    def __repr__(self) -> str:
        return f"Scan of {counted(len(self), 'body', 'bodies')} [{', '.join(self.columns)}, meta]"


def column(values: tuple[str, ...]) -> npt.NDArray[Any]:
    """A column of a table of texts: whole numbers, floats, bools or texts."""
    for kind in (np.int64, np.float64):
        try:
            told = [value or "nan" for value in values] if kind is np.float64 else values
            return np.array(told, dtype=object).astype(kind)
        except ValueError:
            continue
    if set(values) <= {"true", "false"}:
        return np.array([value == "true" for value in values])
    return np.array([value or None for value in values], dtype=object)
