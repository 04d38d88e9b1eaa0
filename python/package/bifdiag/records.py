"""What the documents of the program hold, as records: read-only, comparable, picklable, with all their fields printed."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np

Document = dict[str, Any]


def sections(components: "tuple[Component, ...] | None") -> str:
    """The sections of components in words; where there are none, the parts of U."""
    if components is None:
        return "not decided"
    return " + ".join(component.section or component.accessible_region for component in components) or "nothing"


@dataclass(frozen=True, slots=True)
class Component:
    """One connected component of the accessible region U, with the energy surface and the section over it.

    Attributes
    ----------
    boundary_circles : int
        Number k of circles that bound it.
    poles : tuple of str or None
        Which of r̂ (``"+"``) and −r̂ (``"-"``) it contains; None when r = 0.
    accessible_region : str
        Its name: ``"S2"`` the sphere, ``"D2"`` a disc, ``"S2-2D2"`` an annulus, ``"S2-3D2"`` the sphere without 3 discs, …
    energy_surface : str
        The component of the three-dimensional E above it: ``"RP3"`` (k = 0), ``"S3"`` (1), ``"S1xS2"`` (2),
        ``"(S1xS2)#(S1xS2)"`` (3), ``"#3(S1xS2)"`` (4), …
    section : str or None
        The component of the Poincaré section P above it, by its genus: ``"S2"``, ``"T2"``, ``"M2"``, ``"M3"``, …; None when
        r = 0.
    genus : int or None
        The genus k + n − 1 of `section`, with n poles inside; None when r = 0.
    """

    boundary_circles: int
    poles: tuple[str, ...] | None
    accessible_region: str
    energy_surface: str
    section: str | None
    genus: int | None

    @classmethod
    def _of(cls, document: Document) -> "Component":
        poles = document["poles"]
        return cls(
            document["boundary_circles"],
            None if poles is None else tuple(poles),
            document["accessible_region"],
            document["energy_surface"],
            document["section"],
            document["genus"],
        )

    @classmethod
    def _all_of(cls, documents: list[Document] | None) -> "tuple[Component, ...] | None":
        return None if documents is None else tuple(cls._of(document) for document in documents)


@dataclass(frozen=True, slots=True)
class Margin:
    """The distance in h to the nearest curve at the same l.

    Attributes
    ----------
    h : float
        The distance, in units of energy.
    nearest : str
        Id of that curve.
    error_bound : float
        Bound on the error of `h`.
    """

    h: float
    nearest: str
    error_bound: float

    @classmethod
    def _of(cls, document: Document) -> "Margin":
        return cls(document["h"], document["nearest"], document["error_bound"])


@dataclass(frozen=True, slots=True)
class Candidate:
    """A region that meets at a point on a curve, or to which a point may belong that is not decided.

    Attributes
    ----------
    region : str or None
        Its id; None for the forbidden region.
    status : str
        ``"regular"`` or ``"forbidden"``.
    components : tuple of Component
        The components of U there.
    """

    region: str | None
    status: str
    components: tuple[Component, ...]

    @classmethod
    def _of(cls, document: Any) -> "Candidate":
        return cls(document["region"], document["status"], Component._all_of(document["components"]) or ())


@dataclass(frozen=True, slots=True, repr=False)
class Classification:
    """What is known of a point (h, l).

    Attributes
    ----------
    h, l : str
        The point, as it was given.
    status : str
        ``"regular"``; ``"forbidden"`` (h below the minimum); ``"critical"`` (on a curve, by exact equality);
        ``"undecided"`` (only with the accuracy ``"fast"``).
    region : str or None
        Id of the region in the body's atlas; None unless regular.
    signature : str or None
        The names of the sections of `components` joined by ``+``, in their order; None unless regular, and when r = 0.
    components : tuple of Component or None
        The components of U; none where it is forbidden; None on a curve, or where nothing is decided.
    candidates : tuple of Candidate
        The regions that meet on a curve, or those that are possible.
    margin : Margin
        The distance to the nearest curve.
    note : str or None
        Why something is None.
    """

    h: str
    l: str
    status: str
    region: str | None
    signature: str | None
    components: tuple[Component, ...] | None
    candidates: tuple[Candidate, ...]
    margin: Margin
    note: str | None

    @classmethod
    def _of(cls, document: Document) -> "Classification":
        return cls(
            document["h"],
            document["l"],
            document["status"],
            document.get("region"),
            document.get("signature"),
            Component._all_of(document["components"]),
            tuple(Candidate._of(candidate) for candidate in document.get("candidates", ())),
            Margin._of(document["margin"]),
            document.get("note"),
        )

    def __repr__(self) -> str:
        region = f", region={self.region!r}" if self.region else ""
        signature = f", signature={self.signature!r}" if self.signature else ""
        candidates = f", candidates={[c.region or c.status for c in self.candidates]}" if self.candidates else ""
        return (
            f"Classification(h={self.h}, l={self.l}, status={self.status!r}{region}{signature}{candidates}, "
            f"margin={self.margin.h:.6g} to {self.margin.nearest})"
        )

    def _repr_html_(self) -> str:
        rows = [("status", self.status), ("region", self.region or "–"), ("sections", sections(self.components))]
        rows.append(("distance to the nearest curve", f"{self.margin.h:.6g} to {self.margin.nearest}"))
        return table([("(h, l)", f"({self.h}, {self.l})"), *rows])


@dataclass(frozen=True, slots=True)
class Sample:
    """A well-placed point inside a region.

    Attributes
    ----------
    h, l : float
        The point.
    margin : Margin
        Its distance to the boundary.
    """

    h: float
    l: float
    margin: Margin

    def __iter__(self) -> Iterator[float]:
        return iter((self.h, self.l))


@dataclass(frozen=True, slots=True)
class Neighbour:
    """A region on the other side of a curve.

    Attributes
    ----------
    region : str or None
        Its id; None for the forbidden region.
    curve : str
        Id of the curve that is crossed.
    """

    region: str | None
    curve: str


@dataclass(frozen=True, slots=True, repr=False)
class Region:
    """A connected region of the (h, l) half-plane, on which the topology is constant.

    Attributes
    ----------
    id : str
        ``"R1"``, ``"R2"``, … by the first appearance as l, then h rise.
    signature : str or None
        The names of the sections of `components` joined by ``+``, in their order, such as ``"S2+T2"``; None when r = 0.
    components : tuple of Component
        The components of U.
    sample : Sample
        A point inside.
    bounded : bool
        Whether it is bounded in the (h, l) plane.
    l_range : tuple of float
        Its range of l; ``inf`` if it has no end.
    h_width : float
        Its largest extent in h at one l; ``inf`` if unbounded.
    boundary : tuple of str
        Ids of the curves on the boundary.
    neighbours : tuple of Neighbour
        The regions next to it.
    clipped : bool
        Whether a window cuts it.
    """

    id: str
    signature: str | None
    components: tuple[Component, ...]
    sample: Sample
    bounded: bool
    l_range: tuple[float, float]
    h_width: float
    boundary: tuple[str, ...]
    neighbours: tuple[Neighbour, ...]
    clipped: bool
    _outlines: Callable[[str], tuple[np.ndarray, ...]] = field(compare=False)

    @classmethod
    def _of(cls, document: Document, h_width: float | None, outlines: Callable[[str], tuple[np.ndarray, ...]]) -> "Region":
        sample = document["sample"]
        return cls(
            document["id"],
            document["signature"],
            Component._all_of(document["components"]) or (),
            Sample(sample["h"], sample["l"], Margin._of(sample["margin"])),
            document["bounded"],
            span(document["l_range"]),
            infinite(h_width),
            tuple(document["boundary"]),
            tuple(Neighbour(next_to["region"], next_to["curve"]) for next_to in document["neighbours"]),
            document.get("clipped", False),
            outlines,
        )

    @property
    def polygon(self) -> tuple[np.ndarray, ...]:
        """Closed outlines of points [h, l] within the body's default view; a hole is an outline of its own.

        They are fit for a picture of that view, ``atlas.document["drawing"]["view"]["everything"]``: their corners lie on
        the curves, and between corners they are off by a thousandth of its range of h. `Atlas.outlines` gives finer ones
        of a smaller window, `Atlas.region` decides points exactly.
        """
        return self._outlines(self.id)

    def __repr__(self) -> str:
        names = ", ".join(["polygon", *(field.name for field in fields(self) if field.name[0] != "_")])
        told = self.signature or sections(self.components)
        return f"Region {self.id}: {told} at (h, l) = ({self.sample.h:.6g}, {self.sample.l:.6g}) [{names}]"

    def _repr_html_(self) -> str:
        at = f"({self.sample.h:.6g}, {self.sample.l:.6g})"
        return table([("region", self.id), ("sections", sections(self.components)), ("a point (h, l) inside", at)])


@dataclass(frozen=True, slots=True)
class Event:
    """A point where curves meet.

    Attributes
    ----------
    kind : str
        ``"cusp"``: two curves meet and vanish. ``"pitchfork"``: a symmetric pair leaves a curve. ``"crossing"``: two curves
        cross. Others may follow.
    l, h : float
        The point, rounded.
    curves : tuple of str
        Ids of the curves that meet; at a pitchfork the curve before, after, and the pair.
    l_error, h_error : float
        Bounds on the errors of `l` and `h`.
    l_enclosure, h_enclosure : tuple of two str, or None
        Exact decimals between which `l` and `h` are proved to lie; of an atlas with certificate only.

    Notes
    -----
    The coordinates of an event are algebraic numbers, which in general no decimal and no fraction is. So ``(event.h,
    event.l)`` is a point beside it: `Body.classify` there gives one of the regions that meet, not ``"critical"``. What
    meets at the event is told by `curves`, and by the `Region.boundary` that name them.
    """

    kind: str
    l: float
    h: float
    curves: tuple[str, ...]
    l_error: float
    h_error: float
    l_enclosure: tuple[str, str] | None
    h_enclosure: tuple[str, str] | None

    @classmethod
    def _of(cls, document: Document) -> "Event":
        curves = tuple(document["curves"])
        errors = document["l_error"], document["h_error"]
        l_ends, h_ends = (document.get("enclosure", {}).get(name) for name in ("l", "h"))
        proved = None if l_ends is None else tuple(l_ends), None if h_ends is None else tuple(h_ends)
        return cls(document["kind"], document["l"], document["h"], curves, *errors, *proved)


@dataclass(frozen=True, slots=True)
class StabilityChange:
    """A point of a curve at which the stability of its relative equilibria changes.

    Attributes
    ----------
    kind : str
        ``"zero"``: a pair of eigenvalues goes through zero, at a cusp or pitchfork. ``"hamiltonian-hopf"``: two imaginary
        pairs of opposite sign of energy meet and leave the axis. ``"real-collision"``: two real pairs meet and become a
        complex quadruple. Others may follow.
    l, h : float
        The point.
    curve : str
        Id of the curve.
    error_bound : float
        Bound on the errors of `l` and `h`.
    """

    kind: str
    l: float
    h: float
    curve: str
    error_bound: float

    @classmethod
    def _of(cls, document: Document) -> "StabilityChange":
        return cls(document["kind"], document["l"], document["h"], document["curve"], document["error_bound"])


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Curve:
    """A curve of critical values, or a pole line; l is monotone along it.

    Attributes
    ----------
    id : str
        Its id, unique in the atlas.
    kind : str
        ``"generic"`` equilibria; ``"pair"`` of two that are mirror images; ``"circle"`` and ``"sphere"`` of them;
        ``"axis"``, rotation about the one axis that carries r; ``"pole-plus"`` and ``"pole-minus"``, where r̂ and −r̂
        enter U.
    branch : str
        Curves that continue each other through cusps and pitchforks share it.
    index : int or None
        Morse index of U_l along it; None for a pole line.
    multiplicity : int
        2 for a symmetric pair.
    coincides_with : tuple of str
        Curves with the same (h, l).
    l_range : tuple of float
        Range of l.
    stability : tuple of (float, float, str)
        Stretches of l and the linear type there, in the words of `Body.critical`.
    points : array (n, 2)
        Points [h, l] by rising l; between them the curve is off by a thousandth of the ranges of the events. An unbounded
        curve goes on beyond the last one. `Atlas.polyline` gives finer ones.
    """

    id: str
    kind: str
    branch: str
    index: int | None
    multiplicity: int
    coincides_with: tuple[str, ...]
    l_range: tuple[float, float]
    stability: tuple[tuple[float, float, str], ...]
    points: np.ndarray

    @classmethod
    def _of(cls, document: Document, points: Document | None) -> "Curve":
        return cls(
            document["id"],
            document["kind"],
            document["branch"],
            document["index"],
            document["multiplicity"],
            tuple(document["coincides_with"]),
            span(document["l_range"]),
            tuple((part["l_from"], infinite(part["l_to"]), part["stability"]) for part in document["stability"]),
            np.array(points["polyline"] if points else [], dtype=float).reshape(-1, 2),
        )

    def __repr__(self) -> str:
        names = ", ".join(field.name for field in fields(self))
        return f"Curve {self.id}: {self.kind}, {len(self.points)} points [{names}]"


def infinite(value: float | None) -> float:
    """Null in a document is an infinite end."""
    return math.inf if value is None else value


def span(ends: list[float | None]) -> tuple[float, float]:
    """A range whose lower end is finite."""
    return infinite(ends[0]), infinite(ends[1])


def table(rows: list[tuple[str, str]]) -> str:
    """Names and values for a notebook."""
    cells = "".join(f"<tr><th style='text-align:left'>{name}</th><td>{value}</td></tr>" for name, value in rows)
    return f"<table>{cells}</table>"
