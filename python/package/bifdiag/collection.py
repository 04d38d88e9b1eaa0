"""Lists of records that know their ids and are tables, too."""

import html
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any, ClassVar, Generic, SupportsIndex, TypeVar, overload

import numpy as np
import numpy.typing as npt

from .behaviour import all_apart, counted, sections
from .errors import InputError
from .optional import needed
from .tables import arrow_of, frame_of, marked

if TYPE_CHECKING:
    import pandas
    import pyarrow
    import xarray
    from typing_extensions import Self

Item = TypeVar("Item", covariant=True)


class Collection(Generic[Item]):
    """A list of records that does not change: ``regions[4]``, ``regions["R5"]``, ``regions[1:3]``; and a table.

    The table has a row for each record; `to_pandas`, `to_arrow`, `to_xarray` and, through the PyCapsule interface,
    ``polars.DataFrame(regions)`` hand it on. Its columns are numbers, bools and texts; lists of names are lists in Arrow
    and polars, elsewhere one text with spaces between them.
    """

    COLUMNS: ClassVar[dict[str, Callable[[Any], Any]]] = {}
    LISTS: ClassVar[dict[str, Callable[[Any], Any]]] = {}
    """Those of the columns that are lists of names."""

    # Records are made when they are first looked at.
    def __init__(self, sources: Iterable[Any], make: Callable[[Any], Item], ids: tuple[str, ...] | None = None) -> None:
        self._sources = list(sources)
        self._make = make
        self._ids = ids
        self._made: dict[int, Item] = {}

    @classmethod
    def _of(cls, items: Iterable[Item], ids: tuple[str, ...] | None = None) -> "Self":
        return cls(items, _same, ids)

    @overload
    def __getitem__(self, key: "SupportsIndex | str") -> Item: ...
    @overload
    def __getitem__(self, key: slice) -> "Self": ...
    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            ids = self.ids
            if key in ids:
                return self._item(ids.index(key))
            listed = f"the ids are {', '.join(ids)}" if ids else "these records have no ids; take them by place"
            raise InputError(f"there is no {key!r}; {listed if len(self) else 'the list is empty'}")
        if isinstance(key, slice):
            return type(self)(self._sources[key], self._make, None if self._ids is None else self._ids[key])
        try:
            return self._item(range(len(self))[key])
        except IndexError:
            raise IndexError(f"there is no record {key} of {len(self)}, from 0 on") from None

    def _item(self, place: int) -> Item:
        if place not in self._made:
            self._made[place] = self._make(self._sources[place])
        return self._made[place]

    def __len__(self) -> int:
        return len(self._sources)

    def __iter__(self) -> Iterator[Item]:
        return map(self._item, range(len(self)))

    def __reversed__(self) -> Iterator[Item]:
        return map(self._item, reversed(range(len(self))))

    def __contains__(self, key: object) -> bool:
        """Whether there is such a record, or one of this id."""
        return key in self.ids if isinstance(key, str) else key in tuple(self)

    def __eq__(self, other: object) -> bool:
        return tuple(self) == tuple(other) if isinstance(other, (Collection, tuple)) else NotImplemented

    def __hash__(self) -> int:
        return hash(tuple(self))

    @property
    def ids(self) -> tuple[str, ...]:
        """The ids of the records."""
        if self._ids is not None:
            return self._ids
        return tuple(getattr(item, "id") for item in self if hasattr(item, "id"))  # noqa: B009

    def flat(self) -> dict[str, npt.NDArray[Any]]:
        """The columns of the table."""
        ids = {} if self._ids is None else {"id": _column(list(self._ids))}
        return ids | {name: _column([value(item) for item in self]) for name, value in self.COLUMNS.items()}

    def to_pandas(self) -> "pandas.DataFrame":
        """A DataFrame; ``bifdiag[tables]`` installs pandas."""
        return frame_of(self.flat())

    def to_arrow(self) -> "pyarrow.Table":
        """An Arrow table, in which lists of names are lists; ``bifdiag[tables]`` installs pyarrow."""
        return arrow_of(self.flat() | {name: _texts([value(item) for item in self]) for name, value in self.LISTS.items()})

    def to_xarray(self) -> "xarray.Dataset":
        """A Dataset over ``row``; ``bifdiag[tables]`` installs xarray.

        Files of ``to_netcdf`` have no missing texts: there None is an empty text, as the attribute ``missing`` of the
        variable says.
        """
        columns = {name: ("row", column) for name, column in self.flat().items()}
        return marked(needed("xarray", "tables").Dataset(columns))

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """The table as a stream of Arrow, for polars, duckdb and their like."""
        stream: object = self.to_arrow().__arrow_c_stream__(requested_schema)
        return stream

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self)._of, (tuple(self), self._ids)

    def __repr__(self) -> str:
        return "\n".join([f"{len(self)} {type(self).__name__.lower()}", *(f"  {item!r}" for item in self)])

    def _repr_html_(self) -> str:
        columns = self.flat()
        heads = "".join(f"<th>{name}</th>" for name in columns)
        rows = "".join(
            "<tr>" + "".join(f"<td>{_cell(column[row])}</td>" for column in columns.values()) + "</tr>"
            for row in range(len(self))
        )
        return f"<table><tr>{heads}</tr>{rows}</table>"


class Regions(Collection[Item]):
    """The regions of an atlas."""

    COLUMNS: ClassVar[dict[str, Callable[[Any], Any]]] = {
        "id": lambda region: region.id,
        "signature": lambda region: region.signature,
        "h": lambda region: region.sample.h,
        "l": lambda region: region.sample.l,
        "margin": lambda region: region.sample.margin.h,
        "accessible": lambda region: "+".join(part.accessible_region for part in region.components),
        "energy_surface": lambda region: "+".join(part.energy_surface for part in region.components),
        "bounded": lambda region: region.bounded,
        "l_from": lambda region: region.l_range[0],
        "l_to": lambda region: region.l_range[1],
        "h_width": lambda region: region.h_width,
        "boundary": lambda region: " ".join(region.boundary),
        "neighbours": lambda region: " ".join(_neighbours(region)),
    }
    LISTS: ClassVar[dict[str, Callable[[Any], Any]]] = {
        "boundary": lambda region: region.boundary,
        "neighbours": lambda region: _neighbours(region),
    }

    def __repr__(self) -> str:
        return "\n".join([counted(len(self), "region"), *map(_line, self)])


def _places(points: Iterable[Any]) -> tuple[list[str], list[str]]:
    """The energies and the momenta of points, as texts that differ where they do."""
    return all_apart([point.h for point in points]), all_apart([point.l for point in points])


def _neighbours(region: Any) -> list[str]:
    return [beside.region or "forbidden" for beside in region.neighbours]


def _line(region: Any) -> str:
    near = f"({region.sample.h:.6g}, {region.sample.l:.6g})"
    return f"  {region.id}: {region.signature or sections(region.components)} near (h, l) = {near}"


class Events(Collection[Item]):
    """The events of an atlas, ``atlas.events["E1"]``: their ids are those of the command."""

    COLUMNS: ClassVar[dict[str, Callable[[Any], Any]]] = {
        "kind": lambda event: event.kind,
        "h": lambda event: event.h,
        "l": lambda event: event.l,
        "h_error": lambda event: event.h_error,
        "l_error": lambda event: event.l_error,
        "curves": lambda event: " ".join(event.curves),
    }
    LISTS: ClassVar[dict[str, Callable[[Any], Any]]] = {"curves": lambda event: event.curves}

    def __repr__(self) -> str:
        def line(name: str, event: Any, h: str, l: str) -> str:
            return f"  {name}: {event.kind} at (h, l) = ({h}, {l}), curves {', '.join(event.curves)}"

        return "\n".join([counted(len(self), "event"), *map(line, self.ids, self, *_places(self))])


class Curves(Collection[Item]):
    """The curves of an atlas."""

    COLUMNS: ClassVar[dict[str, Callable[[Any], Any]]] = {
        "id": lambda curve: curve.id,
        "kind": lambda curve: curve.kind,
        "index": lambda curve: curve.index,
        "multiplicity": lambda curve: curve.multiplicity,
        "l_from": lambda curve: curve.l_range[0],
        "l_to": lambda curve: curve.l_range[1],
        "stability": lambda curve: " ".join(_runs(part.stability for part in curve.stability)),
        "verdict": lambda curve: " ".join(_runs(part.nonlinear.verdict for part in curve.stability)),
        "branch": lambda curve: curve.branch,
        "branch_name": lambda curve: curve.branch_name,
        "coincides_with": lambda curve: " ".join(curve.coincides_with),
    }
    LISTS: ClassVar[dict[str, Callable[[Any], Any]]] = {
        "stability": lambda curve: _runs(part.stability for part in curve.stability),
        "verdict": lambda curve: _runs(part.nonlinear.verdict for part in curve.stability),
        "coincides_with": lambda curve: curve.coincides_with,
    }

    def __repr__(self) -> str:
        def line(curve: Any) -> str:
            low, high = all_apart(curve.l_range)
            stability = ", ".join(_runs(part.stability for part in curve.stability))
            return f"  {curve.id}: {curve.kind}, l from {low} to {high}" + (stability and f", {stability}")

        return "\n".join([counted(len(self), "curve"), *map(line, self)])


class Changes(Collection[Item]):
    """Points of curves at which stability changes."""

    COLUMNS: ClassVar[dict[str, Callable[[Any], Any]]] = {
        "kind": lambda change: change.kind,
        "h": lambda change: change.h,
        "l": lambda change: change.l,
        "curve": lambda change: change.curve,
        "error_bound": lambda change: change.error_bound,
    }

    def __repr__(self) -> str:
        def line(change: Any, h: str, l: str) -> str:
            return f"  {change.kind} at (h, l) = ({h}, {l}), curve {change.curve}"

        return "\n".join([counted(len(self), "change"), *map(line, self, *_places(self))])


def _texts(lists: list[Any]) -> npt.NDArray[np.object_]:
    """A column of lists of texts."""
    column = np.empty(len(lists), dtype=object)
    column[:] = [list(names) for names in lists]
    return column


def _same(item: Item) -> Item:  # type: ignore[misc]
    return item


def _runs(words: Iterable[str]) -> list[str]:
    """Words, each once where it is repeated."""
    told: list[str] = []
    for word in words:
        if told[-1:] != [word]:
            told.append(word)
    return told


def _column(values: list[Any]) -> npt.NDArray[Any]:
    """Texts and what may be missing as objects; numbers as numbers, with NaN where there is none."""
    if any(isinstance(value, str) for value in values) or not values:
        return np.array(values, dtype=object)
    return np.array([np.nan if value is None else value for value in values])


def _cell(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else html.escape("" if value is None else str(value))
