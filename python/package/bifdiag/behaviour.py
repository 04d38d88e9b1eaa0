"""What records do beside holding their fields: how they are printed, and what was drawn of them."""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import fields
from typing import Any, TypeVar

import numpy as np

Document = dict[str, Any]

Made = TypeVar("Made")


class Classification:
    """How a classification is printed."""

    __slots__ = ()

    def __repr__(self: Any) -> str:
        region = f", region={self.region!r}" if self.region else ""
        signature = f", signature={self.signature!r}" if self.signature else ""
        candidates = f", candidates={[c.region or c.status for c in self.candidates]}" if self.candidates else ""
        return (
            f"Classification(h={self.h}, l={self.l}, status={self.status!r}{region}{signature}{candidates}, "
            f"margin={self.margin.h:.6g} to {self.margin.nearest})"
        )

    def _repr_html_(self: Any) -> str:
        rows = [("(h, l)", f"({self.h}, {self.l})"), ("status", self.status)]
        if self.components is None:
            rows.append(("candidates", ", ".join(found.region or found.status for found in self.candidates)))
        else:
            rows += [("region", self.region or "–"), _sections_row(self.components, "nothing")]
        return table([*rows, ("distance to the nearest curve", f"{self.margin.h:.6g} to {self.margin.nearest}")])


class Sample:
    """A point that unpacks as ``h, l``."""

    __slots__ = ()

    def __iter__(self: Any) -> Iterator[float]:
        return iter((self.h, self.l))


class Drawn:
    """What was drawn of a record: none of its fields, so that ``dataclasses.asdict`` has numbers and texts only."""

    __slots__ = ("_drawn",)

    def _with(self: Made, drawn: Any) -> Made:
        object.__setattr__(self, "_drawn", drawn)
        return self

    def __reduce__(self: Any) -> tuple[Any, ...]:
        return _restored, (
            type(self),
            tuple(getattr(self, field.name) for field in fields(self)),
            getattr(self, "_drawn", None),
        )


def _restored(kind: Any, values: tuple[Any, ...], drawn: Any) -> Any:
    return kind(*values)._with(drawn)


class Region(Drawn):
    """The drawing of a region, and how a region is printed."""

    __slots__ = ()

    @property
    def h_width(self: Any) -> float:
        """The largest extent in h at one l; ``inf`` if unbounded."""
        width: float = self._drawn[0](self.id)
        return width

    @property
    def polygon(self: Any) -> tuple[np.ndarray, ...]:
        """Closed outlines of points [h, l] within the body's default view; a hole is an outline of its own.

        They are fit for a picture of that view, ``atlas.document["drawing"]["view"]["everything"]``: their corners lie on
        the curves, and between corners they are off by a thousandth of its range of h. `Atlas.outlines` gives finer ones
        of a smaller window, `Atlas.region` decides points exactly. Of a file they lie within its window, if it has one,
        and there are none if it has no drawing.
        """
        outlines: tuple[np.ndarray, ...] = self._drawn[1](self.id)
        return outlines

    def __repr__(self: Any) -> str:
        names = ", ".join(["polygon", "h_width", *public(self)])
        shown = self.signature or sections(self.components)
        return f"Region {self.id}: {shown} near (h, l) = ({self.sample.h:.6g}, {self.sample.l:.6g}) [{names}]"

    def _repr_html_(self: Any) -> str:
        at = f"({self.sample.h:.6g}, {self.sample.l:.6g})"
        return table([("region", self.id), _sections_row(self.components), ("sample (h, l), rounded", at)])


class Curve(Drawn):
    """The drawing of a curve, and how a curve is printed."""

    __slots__ = ()

    @property
    def points(self: Any) -> np.ndarray:
        """Points [h, l] by rising l, dense enough for a picture of the diagram.

        No chord between them leaves the curve by more than 1/800 of the size of the whole diagram, whose l reaches up to
        l₁, the largest of 1.6 times the l of the last event and 3√(A|r|) with the largest A, and its h up to l₁²/(2A) +
        2|r|, where without weight 1 stands for the length of r. An unbounded curve goes on beyond the last one.
        `Atlas.polyline` gives finer ones. Of a file without a drawing there are none, and of one with a window none
        of a curve that has no l in common with it.
        """
        drawn = getattr(self, "_drawn", None)
        return np.array(drawn["polyline"] if drawn else [], dtype=float).reshape(-1, 2)

    def __repr__(self: Any) -> str:
        names = ", ".join([*public(self), "points"])
        return f"Curve {self.id}: {self.kind}, {len(self.points)} points [{names}]"


def public(record: Any) -> list[str]:
    """Names of the fields of a record."""
    return [field.name for field in fields(record) if field.name[0] != "_"]


def sections(components: Any, empty: str = "not decided") -> str:
    """The sections of components in words, or without sections the parts of U; ``empty`` if there are no components."""
    return " + ".join(component.section or component.accessible_region for component in components) or empty


def _sections_row(components: Any, empty: str = "not decided") -> tuple[str, str]:
    """The same with its heading: without weight there is no section."""
    of_accessible_region = any(component.section is None for component in components)
    return "U" if of_accessible_region else "sections", sections(components, empty)


def infinite(value: float | None) -> float:
    """Null in a document is an infinite end."""
    return math.inf if value is None else value


def span(ends: list[float | None]) -> tuple[float, float]:
    """A range, of which an end may be infinite."""
    low, high = ends
    return -math.inf if low is None else low, infinite(high)


def maybe(make: Callable[[Any], Made], value: Any) -> Made | None:
    """What a function makes of a value; None of None."""
    return None if value is None else make(value)


def all_apart(numbers: Iterable[float]) -> list[str]:
    """Numbers with six digits, or with as many more as needed to tell apart all that differ."""
    numbers = list(numbers)
    texts = ([f"{number:.{digits}g}" for number in numbers] for digits in range(6, 18))
    return next(told for told in texts if len({*told}) == len({*numbers}))


def counted(count: int, one: str, several: str | None = None) -> str:
    """A number with the word for one of them or for several."""
    return f"{count} {one if count == 1 else several or one + 's'}"


def table(rows: list[tuple[str, str]]) -> str:
    """Names and values for a notebook."""
    cells = "".join(f"<tr><th style='text-align:left'>{name}</th><td>{value}</td></tr>" for name, value in rows)
    return f"<table>{cells}</table>"
