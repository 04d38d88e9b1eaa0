"""Atlases: every region of the (h, l) half-plane of one body."""

import json
import os
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _core, exact, files, pictures
from .behaviour import Document, infinite, sections
from .collection import Changes, Curves, Events, Regions
from .errors import InputError
from .exact import Number
from .explorer import Explorer
from .point_answers import PointAnswers
from .records import Curve, Event, Region, StabilityChange, VerdictChange

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .body import Body


Span: TypeAlias = tuple[float, float]
"""The ends of a range."""


class Atlas(PointAnswers):
    """Every region of the (h, l) half-plane of one body, with its topology; made by `Body.atlas`.

    An atlas covers l ≥ 0; everything depends only on l², so the sign of l does not matter.

    Attributes
    ----------
    body : Body
        The body.
    accuracy : str
        ``"exact"`` or ``"fast"``.

    Notes
    -----
    Two atlases are equal if they agree in the numbers of the body, the accuracy, and the requested contents of their
    documents: certificate, window, outlines. Equal atlases have equal hashes, and the same regions.
    """

    body: "Body"
    accuracy: str
    _inner: _core.Atlas
    _certified: bool
    _ranges: tuple[Span, Span] | None
    _drawing: bool
    _loaded: str | None
    # Makes the body of a document. The module of bodies, which makes atlases, sets it.
    _body_of: ClassVar[Callable[[Document], "Body"]]

    def __init__(self, body: "Body", accuracy: Literal["exact", "fast"] = "exact", *, certificate: bool = False) -> None:
        self.body = body
        self.accuracy = accuracy
        self._certified = bool(certificate)
        self._ranges, self._drawing, self._loaded = None, True, None
        self._inner = body._inner.atlas(accuracy, self._certified)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> "Atlas":
        """The atlas of a file.

        Parameters
        ----------
        path : path
            An ``atlas.json`` of the command line or of `save`.

        Returns
        -------
        Atlas
            Its `to_json` gives the bytes of the file. If the file was made for a window, only `document`, `to_json` and
            `Region.polygon` are restricted to it; `regions` are those of the whole half-plane.

        Raises
        ------
        InputError
            If the file is no atlas of this version of the documents, or says something else of its body than this version
            of the program; the message says what the file is, or what makes it anew.
        OSError
            If the file cannot be read; FileNotFoundError if it is not there.
        """
        files.require(path, "atlas")
        text, name = Path(path).read_text(encoding="utf-8"), os.fspath(path)
        _core.readable(text, name)
        atlas = cls._of_text(text)
        if _substance(json.loads(atlas._written())) != _substance(json.loads(text)):
            raise InputError(f"{name} does not say what this version of bifdiag computes for {atlas.body}; make it anew")
        return atlas

    @classmethod
    def _of_text(cls, text: str) -> "Atlas":
        """The atlas of a document that is known to be one."""
        document = json.loads(text)
        atlas = cls(cls._body_of(document["body"]), document["accuracy"], certificate="certificate" in document)
        window = document.get("window")
        atlas._ranges = None if window is None else (tuple(window["h"]), tuple(window["l"]))
        atlas._drawing = "drawing" in document
        atlas._loaded = text
        return atlas

    def _written(self) -> str:
        return self._inner.to_json(self._ranges, self._drawing, True)

    @cached_property
    def _text(self) -> str:
        return self._written() if self._loaded is None else self._loaded

    @cached_property
    def _document(self) -> Document:
        document: Document = json.loads(self._text)
        return document

    @property
    def document(self) -> Document:
        """The contents of `to_json` as a dict; do not modify it."""
        return self._document

    @cached_property
    def _traced(self) -> Document:
        """The document; if it has still to be made without `verdict_changes`, which take longer than the rest."""
        if self._certified or self._loaded is not None:
            return self._document
        document: Document = json.loads(self._inner.to_json(self._ranges, self._drawing, False))
        return document

    def _view(self) -> Document:
        """Where the diagram is seen, also of a file without a drawing."""
        whole = self._traced if self._drawing else json.loads(self._inner.to_json(self._ranges, True, False))
        view: Document = whole["drawing"]["view"]
        return view

    def _outlines(self, region: str) -> tuple[npt.NDArray[np.float64], ...]:
        drawn = self._traced.get("drawing", {"regions": {}})["regions"].get(region, {"polygon": []})
        return tuple(np.array(outline, dtype=float).reshape(-1, 2) for outline in drawn["polygon"])

    @cached_property
    def regions(self) -> Regions[Region]:
        """The regions, in the order of their ids: ``atlas.regions["R5"]`` is ``atlas.regions[4]``; also a table."""
        drawn = self._width, self._outlines
        return Regions(self._inner.regions(), lambda text: Region._of(json.loads(text), drawn))

    @cached_property
    def _widths(self) -> dict[str, float]:
        return {region.id: infinite(width) for region, width in zip(self.regions, self._inner.h_widths(), strict=True)}

    def _width(self, region: str) -> float:
        return self._widths[region]

    @cached_property
    def events(self) -> Events[Event]:
        """Cusps, pitchforks, crossings by increasing l: ``atlas.events["E1"]``; also a table. `Event` explains them."""
        found = json.loads(self._inner.events())
        return Events(found, Event._of, tuple(f"E{number}" for number in range(1, len(found) + 1)))

    @cached_property
    def curves(self) -> Curves[Curve]:
        """Critical curves and pole lines, ``atlas.curves["G1.2"]``, with their points; also a table.

        `polyline` gives finer points.
        """
        drawn = self._traced.get("drawing", {"curves": {}})["curves"]
        return Curves(self._traced["curves"], lambda document: Curve._of(document, drawn.get(document["id"])))

    @cached_property
    def stability_changes(self) -> Changes[StabilityChange]:
        """Points of curves at which the linear type of the relative equilibria changes."""
        return Changes(self._traced["stability_changes"], StabilityChange._of)

    @cached_property
    def verdict_changes(self) -> Changes[VerdictChange] | None:
        """Isolated points of curves at which a hypothesis of Arnold's theorem fails, by increasing l.

        None where not all of them are known, and with `accuracy="fast"`.
        """
        found = self._document.get("verdict_changes")
        return None if found is None else Changes(found, VerdictChange._of)

    @property
    def complete(self) -> bool:
        """Whether `regions` covers the whole half-plane l > 0 and nothing is undecided."""
        return bool(self._traced["summary"]["complete"])

    @property
    def certificate(self) -> Document | None:
        """What an independent program needs to check the atlas; None without ``certificate=True``.

        `bifdiag.verify` checks it.
        """
        certificate: Document | None = self._document.get("certificate")
        return certificate

    def polyline(self, curve: str, l: Span, *, tolerance: float = 1e-6) -> npt.NDArray[np.float64]:
        """Points of a curve to a given tolerance.

        Parameters
        ----------
        curve : str
            The id of a curve, such as ``"G1.2"`` or ``"P+"``.
        l : (float, float)
            A range of l.
        tolerance : float
            Largest deviation in h of the straight line between neighbours, up to rounding.

        Returns
        -------
        array (n, 2)
            Points [h, l] by increasing l, over the part of the range on which the curve exists; possibly none.

        Raises
        ------
        InputError
            If there is no such curve, or the range is invalid.

        Examples
        --------
        >>> import bifdiag
        >>> atlas = bifdiag.Body.preset("paper").atlas()
        >>> points = atlas.polyline("G1.2", (2.1, 2.2), tolerance=1e-9)
        >>> len(points) > 100, points[[0, -1], 1].tolist()
        (True, [2.1, 2.2])
        """
        if curve not in {known.id for known in self.curves}:
            raise InputError(f"curve = {curve!r}: the curves are {', '.join(known.id for known in self.curves)}")
        finest = exact.real(tolerance, "tolerance")
        if finest <= 0:
            raise InputError(f"tolerance = {tolerance}: a positive number is needed")
        points = self._inner.polyline(curve, exact.span(l, "l"), finest)
        return np.empty((0, 2)) if points is None else points

    def outlines(self, h: Span, l: Span) -> tuple[tuple[npt.NDArray[np.float64], ...], ...]:
        """The regions as polygons within a window, at the resolution of a picture.

        Parameters
        ----------
        h, l : (float, float)
            The window.

        Returns
        -------
        tuple of tuples of arrays (n, 2)
            For each of `regions` its closed outlines of points [h, l]; holes are separate outlines. Corners lie on the
            curves; between them an outline deviates by at most a thousandth of the range of h, except where a curve would
            need more than 256 chords between two events.

        Raises
        ------
        InputError
            If a range is invalid.
        """
        found = self._inner.outlines([exact.span(h, "h"), exact.span(l, "l")])
        return tuple(tuple(outlines) for outlines in found)

    def to_json(self) -> str:
        """The text of the ``atlas.json`` that the command line writes, byte for byte."""
        return self._text

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes `to_json` to a file."""
        Path(path).write_text(self._text, encoding="utf-8", newline="\n")

    def plot(
        self,
        ax: "Axes | None" = None,
        *,
        figsize: Span | None = None,
        view: Literal["plane", "straight", "auto"] = "plane",
        h: Span | None = None,
        l: Span | None = None,
        regions: bool = True,
        labels: bool = True,
        events: bool | Literal["ids"] = True,
        insets: bool | None = None,
        legend: bool | None = None,
        **line: Any,
    ) -> "Axes":
        """Draws the bifurcation diagram with matplotlib; `bifdiag.pictures.diagram` explains the options."""
        shown: Any = {"regions": regions, "labels": labels, "events": events, "insets": insets, "legend": legend}
        return pictures.diagram(self, ax, figsize=figsize, view=view, h=h, l=l, **shown, **line)

    @cached_property
    def _straightened(self) -> _core.Straightened:
        return self._inner.straightened(False)

    def straightened(self, h: npt.ArrayLike, l: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Where points (h, l) lie in ``plot(view="straight")``, whose axes are the unit square.

        Parameters
        ----------
        h, l : array of float
            They are broadcast.

        Returns
        -------
        array (..., 2)
            NaN where there is no motion, and beyond the last l that is shown.

        Raises
        ------
        RangeError
            If the plane cannot be straightened.
        """
        first, second = np.broadcast_arrays(np.asarray(h, dtype=np.float64), np.asarray(l, dtype=np.float64))
        flat = [np.ascontiguousarray(array).reshape(-1) for array in (first, second)]
        return self._straightened.positions(*flat).reshape(*first.shape, 2)

    def svg(self) -> str:
        """The command line's picture as SVG."""
        return self._inner.svg()

    def explore(self, h: Number | None = None, l: Number | None = None, *, height: int = 720) -> Explorer:
        """The explorer's page with this body, in a cell of a notebook or at its ``url`` in a browser on this machine.

        Parameters
        ----------
        h, l : number, optional
            The initial point; both or neither.
        height : int
            Height of the cell in pixels.

        Raises
        ------
        InputError
            If one of h and l is missing or not a number.
        BifdiagError
            If the package was built without the page.

        Notes
        -----
        The page is served to this machine only, at ``127.0.0.1``, until the process ends. A notebook on another machine
        can show it if the port in ``url`` is forwarded: ``ssh -L PORT:127.0.0.1:PORT``.
        """
        if (h is None) != (l is None):
            raise InputError("give both h and l, or none of them")
        state = f"A={','.join(self.body.A)}&r={','.join(self.body.r)}"
        if h is not None or l is not None:
            state += f"&h={exact.text(h, 'h')}&l={exact.text(l, 'l')}"
        return Explorer(state, height)

    def _repr_svg_(self) -> str:
        return self.svg()

    def _repr_html_(self) -> str:
        regions = f"<details><summary>{len(self.regions)} regions</summary>{self.regions._repr_html_()}</details>"
        return f"<div>{self.svg()}{regions}</div>"

    def _identity(self) -> tuple[Any, ...]:
        return self.body, self.accuracy, self._certified, self._ranges, self._drawing

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Atlas) and self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def __reduce__(self) -> tuple[Any, ...]:
        if self._loaded is not None:
            return Atlas._of_text, (self._loaded,)
        return _made, (self.body, self.accuracy, self._certified)

    def __repr__(self) -> str:
        lines = [f"Atlas of {self.body}: {len(self.regions)} regions, {len(self.events)} events"]
        lines += [f"  {region.id}: {region.signature or sections(region.components)}" for region in self.regions]
        lists = "regions, events, curves, stability_changes, verdict_changes"
        lines.append(f"  [{lists}; region(h, l), classify(h, l), plot(), to_json()]")
        return "\n".join(lines)


def _made(body: "Body", accuracy: Literal["exact", "fast"], certificate: bool) -> Atlas:
    return Atlas(body, accuracy, certificate=certificate)


def _substance(document: Document) -> Document:
    """A document without the version that wrote it, and the checksum over that."""
    certificate = document.get("certificate")
    sealed = None if certificate is None else certificate | {"checksum": None}
    return document | {"version": None, "certificate": sealed}
