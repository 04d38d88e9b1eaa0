"""Atlases: every region of the (h, l) half-plane of one body."""

import json
import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core, exact, pictures
from .errors import InputError
from .exact import Number
from .explorer import Explorer
from .records import Classification, Curve, Document, Event, Region, StabilityChange

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .body import Body

FORBIDDEN, CRITICAL, UNDECIDED = -1, -2, -3
"""What `Atlas.region` gives where there is no region."""

SCHEMA_VERSION = "2"


class Atlas:
    """Every region of the (h, l) half-plane of one body, with its topology; made by `Body.atlas`.

    Attributes
    ----------
    body : Body
        The body.
    accuracy : str
        ``"exact"`` or ``"fast"``.
    """

    body: "Body"
    accuracy: str
    _inner: _core.Atlas

    def __init__(self, body: "Body", accuracy: str = "exact") -> None:
        self.body = body
        self.accuracy = accuracy
        self._inner = body._inner.atlas(accuracy)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> "Atlas":
        """The atlas of a file.

        Parameters
        ----------
        path : path
            An ``atlas.json`` of the command line or of `to_json`.

        Returns
        -------
        Atlas
            Its `to_json` gives the bytes of the file.

        Raises
        ------
        InputError
            If the file is no atlas of this version, or says something else than this version of the program.
        """
        text = Path(path).read_text(encoding="utf-8")
        try:
            document = json.loads(text)
            version = document["schema_version"]
        except (ValueError, KeyError, TypeError) as error:
            raise InputError(f"{path} is no atlas: {error}") from error
        return cls._of_document(document, version, text, str(path))

    @classmethod
    def _of_document(cls, document: Document, version: str, text: str, name: str) -> "Atlas":
        from .body import Body

        if version != _core.SCHEMA_VERSION:
            told = document.get("body", {})
            command = f"bifdiag --A {','.join(told.get('A', []))} --r={','.join(told.get('r', []))} --json > {name}"
            raise InputError(
                f"{name} is an atlas of version {version}, and version {_core.SCHEMA_VERSION} is needed; make it anew "
                f"with: {command}"
            )
        body = Body._of_document(document["body"])
        atlas = cls(body, document["accuracy"])
        if document.get("window") is None and document.get("certificate") is None and atlas.to_json() != text:
            raise InputError(f"{name} does not say what this version of bifdiag computes for {body}; make it anew")
        atlas.__dict__["_text"] = text
        return atlas

    @cached_property
    def _text(self) -> str:
        return self._inner.to_json()

    @cached_property
    def _document(self) -> Document:
        document: Document = json.loads(self._text)
        return document

    @property
    def document(self) -> Document:
        """Everything that `to_json` tells, as a dict; not to be changed."""
        return self._document

    def _outlines(self, region: str) -> tuple[npt.NDArray[np.float64], ...]:
        found = next(document for document in self._document["regions"] if document["id"] == region)
        return tuple(np.array(outline, dtype=float).reshape(-1, 2) for outline in found["polygon"])

    @cached_property
    def regions(self) -> tuple[Region, ...]:
        """The regions, in the order of their ids: ``atlas.regions[4].id == "R5"``."""
        return tuple(Region.of(document, self._outlines) for document in json.loads(self._inner.regions()))

    @cached_property
    def events(self) -> tuple[Event, ...]:
        """Points where curves meet, by rising l."""
        return tuple(Event.of(document) for document in json.loads(self._inner.events()))

    @cached_property
    def curves(self) -> tuple[Curve, ...]:
        """Critical curves and pole lines, with their points."""
        return tuple(Curve.of(document) for document in self._document["curves"])

    @cached_property
    def stability_changes(self) -> tuple[StabilityChange, ...]:
        """Points of curves at which the stability of the relative equilibria changes."""
        return tuple(StabilityChange.of(document) for document in self._document["stability_changes"])

    @property
    def complete(self) -> bool:
        """Whether `regions` covers the whole half-plane l > 0."""
        return bool(self._document["summary"]["complete"])

    def to_json(self) -> str:
        """The text of the ``atlas.json`` that the command line writes, byte for byte."""
        return self._text

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes `to_json` to a file."""
        Path(path).write_text(self._text, encoding="utf-8", newline="\n")

    def region(self, h: Any, l: Any, *, threads: int | None = None) -> Any:
        """Numbers of the regions of points.

        Parameters
        ----------
        h, l : number, or array of them
            Energies and vertical angular momenta, of shapes that broadcast. The floats of an array mean what scalars mean:
            their shortest decimals. Arrays of Fraction or str are taken exactly.
        threads : int, optional
            None: one; 0: as many as there are cores. The result does not depend on it.

        Returns
        -------
        int, or array of int
            Indices into `regions`; −1 forbidden, −2 on a curve, −3 undecided (only with the accuracy ``"fast"``).

        Raises
        ------
        InputError
            If something is no finite number, or the shapes do not broadcast.
        RangeError
            If a point cannot be answered.

        Examples
        --------
        >>> import bifdiag
        >>> atlas = bifdiag.Body.preset("paper").atlas()
        >>> atlas.region([0, 3.8], 3.25)
        array([-1,  4])
        >>> atlas.regions[4]
        Region R5: S2+T2 at ...
        """
        energies, momenta = exact.doubles(h, "h"), exact.doubles(l, "l")
        if energies is None or momenta is None:
            return self._exact_places(h, l)
        try:
            energies, momenta = np.broadcast_arrays(energies, momenta)
        except ValueError as error:
            raise InputError(f"h and l do not broadcast: {error}") from error
        flat_h, flat_l = (np.ascontiguousarray(values).reshape(-1) for values in (energies, momenta))
        places = self._inner.places(flat_h, flat_l, exact.threads(threads)).reshape(energies.shape)
        return places if places.ndim else int(places)

    def _exact_places(self, h: Any, l: Any) -> Any:
        """One point after the other, from the texts of its numbers."""

        def place(h: Any, l: Any) -> int:
            return self._inner.place(exact.text(h, "h"), exact.text(l, "l"))

        try:
            energies, momenta = np.broadcast_arrays(np.asarray(h, dtype=object), np.asarray(l, dtype=object))
        except ValueError as error:
            raise InputError(f"h and l do not broadcast: {error}") from error
        found = [place(*point) for point in zip(energies.flat, momenta.flat, strict=True)]
        return np.array(found, dtype=np.int64).reshape(energies.shape) if energies.ndim else found[0]

    def classify(self, h: Number, l: Number) -> Classification:
        """The type of U, E and P at one point, as `Body.classify` gives it, sooner for many points."""
        return Classification.of(json.loads(self._inner.classify(exact.text(h, "h"), exact.text(l, "l"))))

    def plot(self, ax: "Axes | None" = None, **options: Any) -> "Axes":
        """Draws the bifurcation diagram with matplotlib; see `bifdiag.pictures.diagram` for the options."""
        return pictures.diagram(self, ax, **options)

    def svg(self) -> str:
        """The picture of the command line, as SVG."""
        return self._inner.svg()

    def explore(self, h: Number | None = None, l: Number | None = None, *, height: int = 720) -> Explorer:
        """The explorer's page with this body, in a cell of a notebook or at its ``url`` in a browser on this machine.

        Parameters
        ----------
        h, l : number, optional
            A point to begin with; both or none.
        height : int
            Height of the cell in pixels.

        Raises
        ------
        BifdiagError
            If the package was built without the page.
        """
        state = f"A={','.join(self.body.A)}&r={','.join(self.body.r)}"
        if h is not None or l is not None:
            state += f"&h={exact.text(h, 'h')}&l={exact.text(l, 'l')}"
        return Explorer(state, height)

    def _repr_svg_(self) -> str:
        return self.svg()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Atlas) and (self is other or self.to_json() == other.to_json())

    def __hash__(self) -> int:
        return hash((self.body, self.accuracy))

    def __reduce__(self) -> tuple[type["Atlas"], tuple["Body", str]]:
        return Atlas, (self.body, self.accuracy)

    def __repr__(self) -> str:
        lines = [f"Atlas of {self.body}: {len(self.regions)} regions, {len(self.events)} events"]
        lines += [f"  {region.id}: {region.signature or len(region.components)}" for region in self.regions]
        lines.append("  [regions, events, curves, stability_changes; region(h, l), classify(h, l), plot(), to_json()]")
        return "\n".join(lines)
