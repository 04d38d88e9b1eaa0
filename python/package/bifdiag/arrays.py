"""Arrays of points in, arrays of answers out, in whatever form they came."""

import re
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import exact
from .errors import InputError
from .optional import needed

INVALID = -4
"""The place of a point with a number that is missing, infinite or out of range."""

POLICIES = ("mark", "raise")
"""What becomes of such a point."""


@dataclass(frozen=True)
class Points:
    """Points (h, l), broadcast against each other.

    Attributes
    ----------
    h, l : array (n,) of float, or list of str
        The numbers of the valid points: doubles that mean their shortest decimals, or exact texts.
    valid : array of bool
        Which points they are, in the shape of the answer.
    dress : function
        An array of answers in the form of the input: of xarray, of pandas, of numpy, or a scalar.
    index : pandas.Index or None
        The labels, if the input was of pandas.
    template : xarray.DataArray or None
        Dimensions and coordinates, if the input was of xarray.
    """

    h: Any
    l: Any
    valid: npt.NDArray[np.bool_]
    dress: Callable[[npt.NDArray[Any], str], Any]
    index: Any = None
    template: Any = None

    def spread(self, answers: npt.NDArray[Any], fill: Any) -> npt.NDArray[Any]:
        """Answers for the valid points in the shape of the input."""
        if len(answers) == self.valid.size:
            return answers.reshape(self.valid.shape)
        out = np.full(self.valid.shape, fill, dtype=answers.dtype)
        out[self.valid] = answers
        return out

    @contextmanager
    def named(self) -> Iterator[None]:
        """Names the place of a text that the compiled part refuses."""
        try:
            yield
        except InputError as error:
            found = re.match("`(.*)` is not a number", str(error), re.DOTALL)
            for name, values in (("h", self.h), ("l", self.l)) if found else ():
                if self.valid.ndim and isinstance(values, list) and found and found[1] in values:
                    where = np.argwhere(self.valid)[values.index(found[1])].tolist()
                    raise InputError(f"{_place(name, where)}: {error}") from None
            raise


class Labels:
    """The labels of an array of l of pandas or xarray."""

    def __init__(self, index: Any, template: Any) -> None:
        self._index, self._template = index, template

    @classmethod
    def of(cls, given: Points) -> "Labels | None":
        """Those of what was given; None of plain arrays and of scalars."""
        if given.index is None and (given.template is None or not given.template.ndim):
            return None
        return cls(given.index, given.template)

    def columns(self, places: npt.NDArray[np.int64]) -> dict[str, Any]:
        """For each of some places in the flat array of l its labels, by their names."""
        if self._index is not None:
            taken = self._index.take(places)
            names = [name or "label" for name in taken.names]
            return {str(name): taken.get_level_values(level).to_numpy() for level, name in enumerate(names)}
        sizes = self._template.sizes
        where = dict(zip(sizes, np.unravel_index(places, tuple(sizes.values())), strict=True))
        out = {str(name): place for name, place in where.items()}
        for name, coordinate in self._template.coords.items():
            if coordinate.dims:
                out[str(name)] = coordinate.to_numpy()[tuple(where[dim] for dim in coordinate.dims)]
        return out

    def index(self, places: npt.NDArray[np.int64]) -> Any:
        """For each of some places its label, as an index of pandas."""
        if self._index is not None:
            return self._index.take(places)
        columns = self.columns(places)
        named = {str(name): columns[str(name)] for name in self._template.sizes}
        pd = needed("pandas", "tables")
        if len(named) == 1:
            ((name, values),) = named.items()
            return pd.Index(values, name=name)
        return pd.MultiIndex.from_arrays(list(named.values()), names=list(named))


def points(h: Any, l: Any, invalid: str) -> Points:
    """Points of what the caller gave.

    Raises
    ------
    InputError
        For what is no number, and shapes that do not broadcast; with ``invalid="raise"`` also for NaN, masked, infinite and
        out-of-range entries: the message names the first.
    """
    if invalid not in POLICIES:
        raise InputError(
            f'invalid = {invalid!r}: "mark" marks what is missing, infinite or out of range and answers the rest, '
            '"raise" refuses it'
        )
    h, l, dress, index, template = _undressed(h, l)
    (h_values, h_valid), (l_values, l_valid) = _numbers(h, "h"), _numbers(l, "l")
    try:
        valid = np.logical_and(h_valid, l_valid)
        h_values, l_values = np.broadcast_to(h_values, valid.shape), np.broadcast_to(l_values, valid.shape)
    except ValueError as error:
        raise InputError(f"h and l do not broadcast: {error}") from error
    if invalid == "raise" and not valid.all():
        where = tuple(int(place) for place in np.argwhere(~valid)[0])
        name, values = ("l", l_values) if np.broadcast_to(h_valid, valid.shape)[where] else ("h", h_values)
        given = h if name == "h" else l
        masked = isinstance(given, np.ma.MaskedArray) and np.broadcast_to(np.ma.getmaskarray(given), valid.shape)[where]
        told = "is masked" if masked else f"= {values[where]} is no finite number in range"
        raise InputError(f"{_place(name, where)} {told}" + ('; leave it out, or give invalid="mark"' if where else ""))
    whole = bool(valid.all())
    both = [
        (np.ascontiguousarray(values).reshape(-1) if whole else values[valid], name)
        for values, name in ((h_values, "h"), (l_values, "l"))
    ]
    if h_values.dtype == object or l_values.dtype == object:
        places = np.argwhere(valid).tolist()
        first, second = (
            [exact.text(value, _place(name, place)) for value, place in zip(values.tolist(), places, strict=True)]
            for values, name in both
        )
        return Points(first, second, valid, dress, index, template)
    return Points(both[0][0], both[1][0], valid, dress, index, template)


def _place(name: str, where: Sequence[int]) -> str:
    return f"{name}[{', '.join(map(str, where))}]" if len(where) else name


def _numbers(given: Any, name: str) -> tuple[npt.NDArray[Any], npt.NDArray[np.bool_]]:
    """Numbers as doubles, or as objects where doubles do not have them exactly; and which of them can be used."""
    mask = np.ma.getmaskarray(given) if isinstance(given, np.ma.MaskedArray) else None
    array = np.asarray(np.ma.getdata(given) if mask is not None else given)
    if array.dtype.kind in "OUT":
        values = array.astype(object)
        valid = np.array([not _missing(value, values.ndim > 0) for value in values.flat], dtype=bool).reshape(values.shape)
    else:
        found = exact.doubles(array, name, check=False)
        if found is None:
            values, valid = array.astype(object), np.ones(array.shape, dtype=bool)
        else:
            values, valid = found, exact.usable(found)
    return values, valid if mask is None else valid & ~mask


def _missing(value: Any, of_array: bool) -> bool:
    """None of an array, NA of pandas, and what is not finite."""
    if value is None or isinstance(value, str):
        return value is None and of_array
    if type(value).__name__ in ("NAType", "NaTType"):
        return True
    return bool(isinstance(value, float | np.floating) and not np.isfinite(value))


def _undressed(h: Any, l: Any) -> tuple[Any, Any, Callable[[npt.NDArray[Any], str], Any], Any, Any]:
    """Plain arrays of h and l, and how answers are given their form."""
    xr, pd = sys.modules.get("xarray"), sys.modules.get("pandas")
    if xr is not None and any(isinstance(value, xr.DataArray) for value in (h, l)):
        arrays = [value if isinstance(value, xr.DataArray) else _labelled(xr, value) for value in (h, l)]
        first, second = xr.broadcast(*arrays)
        first = first.assign_coords({name: other for name, other in second.coords.items() if name not in first.coords})
        return first.to_numpy(), second.to_numpy(), lambda out, name: first.copy(data=out).rename(name), None, first
    if pd is not None and any(isinstance(value, pd.DataFrame) for value in (h, l)):
        return _of_frames(pd, h, l)
    if pd is not None and any(isinstance(value, pd.Series) for value in (h, l)):
        if isinstance(h, pd.Series) and isinstance(l, pd.Series) and not h.index.equals(l.index):
            h, l = h.align(l)
        index = h.index if isinstance(h, pd.Series) else l.index
        h, l = (_unpacked(value) if isinstance(value, pd.Series) else value for value in (h, l))

        def series(out: npt.NDArray[Any], name: str) -> Any:
            return pd.Series(out, index=index, name=name) if out.shape == (len(index),) else out

        return h, l, series, index, None
    return h, l, lambda out, name: out if out.ndim else out.item(), None, None


def _of_frames(pd: Any, h: Any, l: Any) -> tuple[Any, Any, Callable[[npt.NDArray[Any], str], Any], Any, Any]:
    """The same of tables, of which answers have the index and the columns."""
    if isinstance(h, pd.DataFrame) and isinstance(l, pd.DataFrame):
        h, l = h.align(l)
    elif any(np.ndim(value) and not isinstance(value, pd.DataFrame) for value in (h, l)):
        raise InputError("one of h and l is a DataFrame, and the other an array or a Series; give two tables, or a number")
    table = h if isinstance(h, pd.DataFrame) else l
    index = pd.MultiIndex.from_product([table.index, table.columns])
    h, l = (_unpacked(value) if isinstance(value, pd.DataFrame) else value for value in (h, l))
    return h, l, lambda out, name: pd.DataFrame(out, index=table.index, columns=table.columns), index, None


def _labelled(xr: Any, value: Any) -> Any:
    """A scalar beside an array with dimensions."""
    if np.ndim(value):
        raise InputError(
            "one of h and l is an xarray.DataArray, and the other an array without dimensions; give both with theirs"
        )
    return xr.DataArray(value)


def _unpacked(given: Any) -> npt.NDArray[Any]:
    """The values of a Series or a table; of nullable ones with NaN for NA."""
    kinds = given.dtypes.tolist() if given.ndim > 1 else [given.dtype]
    if all(kind.kind in "fiu" for kind in kinds) and not all(isinstance(kind, np.dtype) for kind in kinds):
        found: npt.NDArray[Any] = given.to_numpy(dtype=np.float64, na_value=np.nan)
        return found
    return np.asarray(given.to_numpy())
