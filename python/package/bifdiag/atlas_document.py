"""What an atlas says, in lists and as a document: written, read back and checked."""

import json
import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from . import _core, files
from .behaviour import Document, infinite
from .collection import Changes, Curves, Events, Regions
from .errors import InputError
from .given import body_of
from .records import Curve, Event, Region, StabilityChange, VerdictChange

if TYPE_CHECKING:
    from .body import Body

AnyAtlas = TypeVar("AnyAtlas", bound="AtlasDocument")

Span: TypeAlias = tuple[float, float]
"""The ends of a range."""


class Source:
    """The document of an atlas, made when it is needed.

    The regions of an atlas ask this, and not the atlas: two objects that keep each other are freed by the garbage collector
    only, while all other threads wait.
    """

    def __init__(self, body: "Body", accuracy: Literal["exact", "fast"], certified: bool) -> None:
        self.body, self.accuracy, self.certified = body, accuracy, certified
        self.inner: _core.Atlas = body._inner.atlas(accuracy, certified)
        self.ranges: tuple[Span, Span] | None = None
        self.drawing = True
        self.loaded: str | None = None

    @classmethod
    def of_text(cls, text: str) -> "Source":
        """That of a document that is known to be one."""
        document = json.loads(text)
        source = cls(body_of(document["body"]), document["accuracy"], "certificate" in document)
        window = document.get("window")
        source.ranges = None if window is None else (tuple(window["h"]), tuple(window["l"]))
        source.drawing, source.loaded = "drawing" in document, text
        return source

    def __reduce__(self) -> tuple[Any, ...]:
        if self.loaded is not None:
            return Source.of_text, (self.loaded,)
        return Source, (self.body, self.accuracy, self.certified)

    def written(self) -> str:
        """The text as this version of the program makes it."""
        return self.inner.to_json(self.ranges, self.drawing, True)

    @cached_property
    def text(self) -> str:
        """The text of the file, or of the atlas that was made."""
        return self.written() if self.loaded is None else self.loaded

    @cached_property
    def document(self) -> Document:
        """What the text says."""
        document: Document = json.loads(self.text)
        return document

    @cached_property
    def traced(self) -> Document:
        """The document; if it has still to be made without `verdict_changes`, which take longer than the rest."""
        if self.certified or self.loaded is not None:
            return self.document
        document: Document = json.loads(self.inner.to_json(self.ranges, self.drawing, False))
        return document

    def outlines(self, region: str) -> tuple[npt.NDArray[np.float64], ...]:
        """Those of a region."""
        drawn = self.traced.get("drawing", {"regions": {}})["regions"].get(region, {"polygon": []})
        return tuple(np.array(outline, dtype=float).reshape(-1, 2) for outline in drawn["polygon"])

    @cached_property
    def widths(self) -> dict[str, float]:
        """The largest extent of each region in h."""
        return {f"R{number}": infinite(width) for number, width in enumerate(self.inner.h_widths(), 1)}

    def width(self, region: str) -> float:
        """That of one region."""
        return self.widths[region]


class AtlasDocument:
    """Lists of what an atlas says, and all of it in the form of the command line's ``atlas.json``; `Atlas` is one."""

    body: "Body"
    accuracy: str
    _inner: _core.Atlas
    _source: Source

    def __init__(self, body: "Body", accuracy: Literal["exact", "fast"] = "exact", *, certificate: bool = False) -> None:
        self._take(Source(body, accuracy, bool(certificate)))

    def _take(self, source: Source) -> None:
        self.body, self.accuracy, self._inner, self._source = source.body, source.accuracy, source.inner, source

    @classmethod
    def load(cls: type[AnyAtlas], path: str | os.PathLike[str]) -> AnyAtlas:
        """The atlas of a file.

        Parameters
        ----------
        path : path
            An ``atlas.json`` of the command line or of `save`.

        Returns
        -------
        Atlas
            Its `to_json` gives the bytes of the file. If the file was made for a window, `document`, `stability_changes`,
            `verdict_changes` and `Region.polygon` are restricted to it, `Curve.stability` is empty for curves that have no
            l in common with it, and `complete` is False; `regions` and `events` are those of the whole half-plane. If it
            was made with ``--no-drawing``, every `Region.polygon` and `Curve.points` is empty.

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
        if _substance(json.loads(atlas._source.written())) != _substance(json.loads(text)):
            raise InputError(f"{name} does not say what this version of bifdiag computes for {atlas.body}; make it anew")
        return atlas

    @classmethod
    def _of_text(cls: type[AnyAtlas], text: str) -> AnyAtlas:
        """The atlas of a document that is known to be one."""
        atlas = cls.__new__(cls)
        atlas._take(Source.of_text(text))
        return atlas

    @property
    def document(self) -> Document:
        """The contents of `to_json` as a dict; do not modify it."""
        return self._source.document

    @cached_property
    def regions(self) -> Regions[Region]:
        """The regions, in the order of their ids: ``atlas.regions["R5"]`` is ``atlas.regions[4]``; also a table."""
        drawn = self._source.width, self._source.outlines
        return Regions(self._inner.regions(), lambda text: Region._of(json.loads(text), drawn))

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
        traced = self._source.traced
        drawn = traced.get("drawing", {"curves": {}})["curves"]
        return Curves(traced["curves"], lambda document: Curve._of(document, drawn.get(document["id"])))

    @cached_property
    def stability_changes(self) -> Changes[StabilityChange]:
        """Points of curves at which the linear type of the relative equilibria changes; of a file's window those in it."""
        return Changes(self._source.traced["stability_changes"], StabilityChange._of)

    @cached_property
    def verdict_changes(self) -> Changes[VerdictChange] | None:
        """Isolated points of curves at which a hypothesis of Arnold's theorem fails, by increasing l.

        Curves where a further integral decides have none; of a file's window those in it. None where not all of them are
        known, and with `accuracy="fast"`.
        """
        found = self._source.document.get("verdict_changes")
        return None if found is None else Changes(found, VerdictChange._of)

    @property
    def certificate(self) -> Document | None:
        """What an independent program needs to check the atlas; None without ``certificate=True``.

        `bifdiag.verify` checks it.
        """
        certificate: Document | None = self._source.document.get("certificate")
        return certificate

    @property
    def complete(self) -> bool:
        """Whether `regions` covers the whole half-plane l > 0 and nothing is undecided; False of a file with a window."""
        return bool(self._source.traced["summary"]["complete"])

    def to_json(self) -> str:
        """The text of the ``atlas.json`` that the command line writes, byte for byte."""
        return self._source.text

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes `to_json` to a file."""
        Path(path).write_text(self._source.text, encoding="utf-8", newline="\n")


def verify(atlas: str | os.PathLike[str] | Document | AtlasDocument) -> int:
    """Checks an atlas with a certificate by independent code, like ``bifdiag verify``.

    Parameters
    ----------
    atlas : path, dict or Atlas
        A file, a document, or an atlas made with ``certificate=True``.

    Returns
    -------
    int
        The number of regions, all of which were confirmed.

    Raises
    ------
    VerifyError
        Names the first item that is wrong or could not be confirmed; also raised if there is no certificate. For a
        file every byte counts.
    InputError
        If it is not an atlas; the message says what it is.
    OSError
        If the file cannot be read.

    Examples
    --------
    >>> import bifdiag
    >>> atlas = bifdiag.Body.preset("paper").atlas(certificate=True)
    >>> bifdiag.verify(atlas)
    9
    """
    if isinstance(atlas, dict):
        try:
            text = json.dumps(atlas)
        except (TypeError, ValueError) as error:
            raise InputError(f"the document is no JSON: {error}") from error
        return _core.verify(text, "the document", False)
    if isinstance(atlas, AtlasDocument):
        return _core.verify(atlas.to_json(), "the atlas", True)
    files.require(atlas, "atlas")
    return _core.verify(Path(atlas).read_text(encoding="utf-8"), os.fspath(atlas), True)


def _substance(document: Document) -> Document:
    """A document without the version that wrote it, and the checksum over that."""
    certificate = document.get("certificate")
    sealed = None if certificate is None else certificate | {"checksum": None}
    return document | {"version": None, "certificate": sealed}
