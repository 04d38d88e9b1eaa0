"""Types of many points as a table."""

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import exact
from .arrays import INVALID, Points
from .collection import Regions
from .optional import needed
from .records import Component, Region
from .tables import Table, arrow_of, frame_of, marked

if TYPE_CHECKING:
    import pandas
    import pyarrow
    import xarray

STATUS = {-1: "forbidden", -2: "critical", -3: "undecided", INVALID: "invalid"}
"""Codes that are no indices of regions, in words."""

ANSWERS = ("status", "code", "region", "signature", "margin", "error_bound", "nearest")
"""Columns of every table beside h and l."""


class Classifications:
    """The types of many points: arrays of one shape, that of h and l broadcast; made by `Atlas.classify`.

    Attributes
    ----------
    h, l : array of float
        The points, rounded to floats; NaN where they are invalid.
    code : array of int
        The codes of `Atlas.region`: an index into `Atlas.regions`, −1 forbidden, −2 on a curve, −3 undecided, −4 invalid.
    region : array of object
        Id of the region, such as ``"R5"``; None where the point lies in none.
    margin : array of float
        Distance in h from the nearest curve; NaN where the point is invalid.
    error_bound : array of float
        Bound on the error of ``margin``.
    nearest : array of object
        Id of the nearest curve; None where the point is invalid.
    components : tuple of tuples of Component
        The table of the codes: ``found.components[code]`` are the components of U, E and P in the region of that index.
    signatures : tuple of str or None
        Likewise the signatures.
    """

    def __init__(self, columns: dict[str, npt.NDArray[Any]], table: tuple[Any, Any, Any], form: tuple[Any, Any]) -> None:
        self._columns = columns
        self._ids, self.signatures, self.components = table
        self._index, self._template = form

    h: npt.NDArray[np.float64]
    l: npt.NDArray[np.float64]
    code: npt.NDArray[np.int64]
    margin: npt.NDArray[np.float64]
    error_bound: npt.NDArray[np.float64]
    nearest: npt.NDArray[np.object_]
    signatures: tuple[str | None, ...]
    components: tuple[tuple[Component, ...], ...]

    @classmethod
    def _of(cls, given: Points, found: dict[str, Any], regions: Regions[Region]) -> "Classifications":
        curves = np.array([*found["curves"], None], dtype=object)
        rounded = [
            np.array([_rounded(text) for text in numbers]) if isinstance(numbers, list) else numbers
            for numbers in (given.h, given.l)
        ]
        columns = {
            "h": given.spread(rounded[0].astype(float), np.nan),
            "l": given.spread(rounded[1].astype(float), np.nan),
            "code": given.spread(found["place"], INVALID),
            "margin": given.spread(found["margin"], np.nan),
            "error_bound": given.spread(found["error"], np.nan),
            "nearest": given.spread(curves[found["nearest"]], None),
        }
        table = tuple(tuple(getattr(region, name) for region in regions) for name in ("id", "signature", "components"))
        return cls(columns, table, (given.index, given.template))  # type: ignore[arg-type]

    # Type checkers know the columns by name, so that they find typing errors.
    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> npt.NDArray[Any]:
            columns: dict[str, npt.NDArray[Any]] = self.__dict__.get("_columns", {})
            if name not in columns:
                raise AttributeError(f"Classifications has no column {name!r}; it has {', '.join(columns)}")
            return columns[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._columns]

    def _told(self, regular: tuple[Any, ...], others: dict[int, Any]) -> npt.NDArray[np.object_]:
        """A word for each code."""
        words = np.array([*regular, *(others.get(code) for code in range(INVALID, 0))], dtype=object)
        return words[self.code]

    @property
    def status(self) -> npt.NDArray[np.object_]:
        """``"regular"``, ``"forbidden"``, ``"critical"``, ``"undecided"`` or ``"invalid"`` for each point."""
        return self._told(("regular",) * len(self._ids), STATUS)

    @property
    def signature(self) -> npt.NDArray[np.object_]:
        """The signature of each point; None where it lies in no region, and without weight."""
        return self._told(self.signatures, {})

    @property
    def region(self) -> npt.NDArray[np.object_]:
        """The id of the region of each point, such as ``"R5"``; None where it lies in no region."""
        return self._told(self._ids, {})

    @property
    def shape(self) -> tuple[int, ...]:
        """That of h and l broadcast."""
        return self.code.shape

    def flat(self) -> dict[str, npt.NDArray[Any]]:
        """The columns of the table, a row for each point."""
        return {name: getattr(self, name).reshape(-1) for name in ("h", "l", *ANSWERS)}

    def to_pandas(self) -> "pandas.DataFrame":
        """A DataFrame with a row for each point, with the index of h or l if these were of pandas."""
        index = self._index if self._index is not None and self.code.size == len(self._index) else None
        return frame_of(self.flat(), index)

    def to_arrow(self) -> "pyarrow.Table":
        """An Arrow table with a row for each point."""
        return arrow_of(self.flat())

    def to_xarray(self) -> "xarray.Dataset":
        """A Dataset with the dimensions and coordinates of h and l if these were of xarray; else ``dim_0``, ``dim_1``, …"""
        xr = needed("xarray", "tables")
        dims = self._template.dims if self._template is not None else tuple(f"dim_{k}" for k in range(len(self.shape)))
        coords = self._template.coords if self._template is not None else {}
        data: xarray.Dataset = xr.Dataset({name: (dims, getattr(self, name)) for name in ANSWERS}, coords=coords)
        return marked(data.assign({name: (dims, self._columns[name]) for name in ("h", "l") if name not in data.coords}))

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """The table as a stream of Arrow, for polars, duckdb and their like."""
        stream: object = self.to_arrow().__arrow_c_stream__(requested_schema)
        return stream

    def _repr_html_(self) -> str:
        return Table(self.flat(), "{}")._repr_html_()

    def __reduce__(self) -> tuple[Any, ...]:
        table = (self._ids, self.signatures, self.components)
        return Classifications, (self._columns, table, (self._index, self._template))

    def __repr__(self) -> str:
        names, counts = np.unique(self.status.astype(str), return_counts=True)
        told = ", ".join(f"{count} {name}" for name, count in zip(names, counts, strict=True)) or "no points"
        return f"Classifications {self.shape}: {told} [code, region, status, signature, components, margin, nearest]"


def _rounded(text: str) -> float:
    return float(exact.value(text))
