"""Columns of equal length: what sections, motions and other tables have in common."""

import html
import io
import json
import os
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar, overload

import numpy as np
import numpy.typing as npt

from . import exact, files
from .behaviour import counted
from .errors import InputError
from .optional import needed

if TYPE_CHECKING:
    import pandas
    import pyarrow
    import xarray
    from typing_extensions import Self


ROWS = 20
"""Rows that a notebook shows."""

AnyTable = TypeVar("AnyTable", bound="StoredTable")

MISSING = "None; an empty text in a file, which has no missing texts"
"""The attribute ``missing`` of a variable of texts some of which are missing."""


class Table:
    """Columns of equal length with a document that describes them; every column is an attribute.

    Attributes
    ----------
    meta : dict
        The document of the run: body, point, parameters and outcome.
    """

    meta: dict[str, Any]

    SELECTS: ClassVar[bool] = True
    """Whether some rows are such a table, too; False where what is said of all rows would be wrong of these."""

    def __init__(self, columns: dict[str, npt.NDArray[Any]], meta: str) -> None:
        self._columns = columns
        self._meta = meta
        self.meta = json.loads(meta)

    @overload
    def __getitem__(self, key: str) -> npt.NDArray[Any]: ...
    @overload
    def __getitem__(self, key: int) -> np.void: ...
    @overload
    def __getitem__(self, key: "slice | npt.NDArray[Any] | list[int] | list[bool]") -> "Self": ...
    def __getitem__(self, key: Any) -> Any:
        """A column by its name, a row by its place, and the rows of a slice, of bools or of places."""
        if isinstance(key, str):
            if key not in self._columns:
                raise KeyError(f"there is no column {key!r}; the columns are {', '.join(self._columns)}")
            return self._columns[key]
        if isinstance(key, list) and key and all(isinstance(name, str) for name in key):
            return np.asarray(self)[key]
        if not isinstance(key, slice):
            # What is masked is not known to be True.
            kept = np.ma.filled(key, False) if isinstance(key, np.ma.MaskedArray) else np.asarray(key)
            if kept.ndim == 0 and not -len(self) <= exact.whole(key, "row", -(2**53)) < len(self):
                raise IndexError(f"there is no row {key} of {len(self)}, from 0 on")
            key = kept.astype(bool if kept.dtype == bool else np.intp) if kept.size == 0 else kept
            if kept.ndim == 0 or not self.SELECTS:
                return np.asarray(self)[key]
        return self._selected(key) if self.SELECTS else np.asarray(self)[key]

    def _selected(self, kept: Any) -> "Self":
        return type(self)({name: column[kept] for name, column in self._columns.items()}, self._meta)

    @property
    def dtype(self) -> np.dtype[np.void]:
        """That of ``numpy.asarray`` of the table, a structured array."""
        return np.dtype([_field(name, column) for name, column in self._columns.items()])

    @property
    def size(self) -> int:
        """The number of rows."""
        return len(self)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        rows = np.empty(len(self), dtype=self.dtype)
        for name, column in self._columns.items():
            rows[name] = column.tolist() if isinstance(column, np.ma.MaskedArray) else column
        return rows if dtype is None else rows.astype(dtype)

    def __iter__(self) -> Iterator[np.void]:
        return iter(np.asarray(self))

    # Type checkers know the columns by name, so that they find typing errors.
    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> npt.NDArray[Any]:
            columns = self.__dict__.get("_columns", {})
            if name not in columns:
                raise AttributeError(f"{type(self).__name__} has no column {name!r}; it has {', '.join(columns)}")
            column: npt.NDArray[Any] = columns[name]
            return column

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._columns]

    def __len__(self) -> int:
        return len(next(iter(self._columns.values())))

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of the columns."""
        return tuple(self._columns)

    def _head(self, *beside: str) -> str:
        """What it is, how many rows it has and what can be asked of it: the first line of a repr."""
        return f"{type(self).__name__}: {counted(len(self), 'row')} [{', '.join((*self.columns, *beside, 'meta'))}]"

    def flat(self) -> dict[str, npt.NDArray[Any]]:
        """The columns, with vectors and complex numbers split: ``gamma_1``, ``gamma_2``, ``gamma_3``."""
        out: dict[str, npt.NDArray[Any]] = {}
        for name, column in self._columns.items():
            if column.ndim == 1:
                out[name] = column
            else:
                parts = "wxyz" if column.shape[1] == 4 else "123"
                split = zip(parts, column.T, strict=False)
                for part, values in split:
                    out |= _split(f"{name}_{part}", values)
        return out

    def to_pandas(self) -> "pandas.DataFrame":
        """A DataFrame with the columns of `flat`, and `meta` as its ``attrs``; ``bifdiag[tables]`` installs pandas."""
        frame: pandas.DataFrame = frame_of(self.flat())
        frame.attrs.update(self.meta)
        return frame

    def to_arrow(self) -> "pyarrow.Table":
        """An Arrow table with the columns of `flat`; ``bifdiag[tables]`` installs pyarrow."""
        return arrow_of(self.flat())

    def to_xarray(self) -> "xarray.Dataset":
        """A Dataset with the columns over ``row`` (and ``axis`` for vectors); ``bifdiag[tables]`` installs xarray.

        Complex numbers are two variables, ``eigenvalues_re`` and ``eigenvalues_im``, which every file can store. Files of
        ``to_netcdf`` have no missing texts: there None is an empty text, as the attribute ``missing`` of the variable says.
        """
        variables = {}
        for name, column in self._columns.items():
            second = {4: "component", 2: "pair"}.get(column.shape[-1], "axis") if column.ndim == 2 else "axis"
            for part, values in _split(name, column).items():
                variables[part] = (("row", second)[: column.ndim], _with_nan(values))
        return marked(needed("xarray", "tables").Dataset(variables, attrs={"meta": self._meta}))

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """The columns as a stream of Arrow, for polars, duckdb and their like; ``bifdiag[tables]`` brings pyarrow."""
        stream: object = self.to_arrow().__arrow_c_stream__(requested_schema)
        return stream

    def _repr_html_(self) -> str:
        few = self.flat() if len(self) <= ROWS else {name: column[:ROWS] for name, column in self.flat().items()}
        heads = "".join(f"<th>{name}</th>" for name in few)
        rows = zip(*(column.tolist() for column in few.values()), strict=True)
        told = "".join("<tr>" + "".join(f"<td>{_cell(value)}</td>" for value in row) + "</tr>" for row in rows)
        more = f"<p>and {counted(len(self) - ROWS, 'more row')}</p>" if len(self) > ROWS else ""
        return f"<table><tr>{heads}</tr>{told}</table>{more}"

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other) or not isinstance(other, Table):
            return NotImplemented
        same = self.columns == other.columns and self._meta == other._meta
        return same and all(_equal(column, other._columns[name]) for name, column in self._columns.items())

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._columns, self._meta)


class StoredTable(Table):
    """A table that the command line writes as an archive, too."""

    NAMES: ClassVar[tuple[str, ...]] = ()
    """The columns of a file."""
    KIND: ClassVar[str]
    """What a file of them is, one of `files.SOURCES`."""

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes an archive .npz: where the command line writes this table too, the same bytes, but for a `Motion`."""
        with zipfile.ZipFile(path, "w", zipfile.ZIP_STORED, allowZip64=True) as archive:
            for name, column in [*self._columns.items(), ("meta", np.array(self._meta))]:
                buffer = io.BytesIO()
                np.lib.format.write_array(buffer, np.asarray(column), version=(1, 0), allow_pickle=False)
                entry = zipfile.ZipInfo(f"{name}.npy", (1980, 1, 1, 0, 0, 0))
                entry.create_system, entry.create_version, entry.extract_version = 3, 10, 10
                entry.external_attr = 0o100644 << 16
                archive.writestr(entry, buffer.getvalue())

    @classmethod
    def load(cls: type[AnyTable], path: str | os.PathLike[str]) -> AnyTable:
        """Reads an archive .npz written by `save` or by the command line.

        Raises
        ------
        InputError
            If the file is not such an archive; the message says what it is.
        OSError
            If the file cannot be read; FileNotFoundError if it is not there.
        """
        files.require(path, cls.KIND)
        try:
            with np.load(Path(path), allow_pickle=False) as archive:
                arrays = {name: archive[name] for name in archive.files}
        except (ValueError, zipfile.BadZipFile, TypeError) as error:
            raise InputError(f"{path} is no archive of arrays: {error}") from error
        arrays = cls._of_command(arrays)
        missing = [name for name in (*cls.NAMES, "meta") if name not in arrays]
        if missing:
            raise InputError(f"{path} is no {cls.KIND}: it has no array {missing[0]!r}")
        return cls(arrays, str(arrays.pop("meta")))

    @classmethod
    def _of_command(cls, arrays: dict[str, npt.NDArray[Any]]) -> dict[str, npt.NDArray[Any]]:
        """The arrays of a file as they are named here, where the command line names them otherwise."""
        return arrays


def _field(name: str, column: npt.NDArray[Any]) -> tuple[Any, ...]:
    if isinstance(column, np.ma.MaskedArray):
        return name, "O"
    return (name, column.dtype, column.shape[1:]) if column.ndim > 1 else (name, column.dtype)


def _cell(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else html.escape("" if value is None else str(value))


def _split(name: str, values: npt.NDArray[Any]) -> dict[str, npt.NDArray[Any]]:
    """A column, or the real and imaginary parts of one."""
    return {f"{name}_re": np.real(values), f"{name}_im": np.imag(values)} if values.dtype.kind == "c" else {name: values}


def _with_nan(column: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """A masked column of bools as 1, 0 and NaN, which every format can store."""
    return np.ma.filled(column.astype(np.float64), np.nan) if isinstance(column, np.ma.MaskedArray) else column


def marked(data: "xarray.Dataset") -> "xarray.Dataset":
    """The Dataset, in which each variable with missing texts says how a file has them."""
    for variable in data.data_vars.values():
        if variable.dtype == object and variable.isnull().any():
            variable.attrs["missing"] = MISSING
    return data


def frame_of(columns: dict[str, npt.NDArray[Any]], index: Any = None) -> "pandas.DataFrame":
    """A DataFrame; masked values are ``pandas.NA``."""
    pd = needed("pandas", "tables")

    def series(column: npt.NDArray[Any]) -> Any:
        if isinstance(column, np.ma.MaskedArray):
            return pd.arrays.BooleanArray(column.data.copy(), np.ma.getmaskarray(column).copy())
        return column

    frame: pandas.DataFrame = pd.DataFrame({name: series(column) for name, column in columns.items()}, index=index)
    return frame


def arrow_of(columns: dict[str, npt.NDArray[Any]]) -> "pyarrow.Table":
    """An Arrow table; masked values are null."""
    pa = needed("pyarrow", "tables")

    def array(column: npt.NDArray[Any]) -> Any:
        if column.dtype == object and len(column) and all(isinstance(value, list) for value in column):
            return pa.array(column.tolist(), pa.list_(pa.string()))
        if isinstance(column, np.ma.MaskedArray):
            return pa.array(column.data, mask=np.ma.getmaskarray(column))
        return pa.array(column.tolist() if column.dtype.kind in "OU" else np.ascontiguousarray(column))

    table: pyarrow.Table = pa.table({name: array(column) for name, column in columns.items()})
    return table


def _equal(one: npt.NDArray[Any], other: npt.NDArray[Any]) -> bool:
    masks = np.array_equal(np.ma.getmaskarray(one), np.ma.getmaskarray(other))
    floats = one.dtype.kind in "fc" and other.dtype.kind in "fc"
    return masks and np.array_equal(np.asarray(one), np.asarray(other), equal_nan=floats)
