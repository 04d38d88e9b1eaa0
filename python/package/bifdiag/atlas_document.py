"""What an atlas says, in lists and as a document: written, read back and checked."""

import json
import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeAlias, TypeVar

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


class AtlasDocument:
    """Lists of what an atlas says, and all of it in the form of the command line's ``atlas.json``; `Atlas` is one."""

    body: "Body"
    accuracy: str
    _inner: _core.Atlas
    _certified: bool
    _ranges: tuple[Span, Span] | None
    _drawing: bool
    _loaded: str | None

    def __init__(self, body: "Body", accuracy: Literal["exact", "fast"] = "exact", *, certificate: bool = False) -> None:
        self.body = body
        self.accuracy = accuracy
        self._certified = bool(certificate)
        self._ranges, self._drawing, self._loaded = None, True, None
        self._inner = body._inner.atlas(accuracy, self._certified)

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
    def _of_text(cls: type[AnyAtlas], text: str) -> AnyAtlas:
        """The atlas of a document that is known to be one."""
        document = json.loads(text)
        atlas = cls(body_of(document["body"]), document["accuracy"], certificate="certificate" in document)
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
    def certificate(self) -> Document | None:
        """What an independent program needs to check the atlas; None without ``certificate=True``.

        `bifdiag.verify` checks it.
        """
        certificate: Document | None = self._document.get("certificate")
        return certificate

    @property
    def complete(self) -> bool:
        """Whether `regions` covers the whole half-plane l > 0 and nothing is undecided."""
        return bool(self._traced["summary"]["complete"])

    def to_json(self) -> str:
        """The text of the ``atlas.json`` that the command line writes, byte for byte."""
        return self._text

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes `to_json` to a file."""
        Path(path).write_text(self._text, encoding="utf-8", newline="\n")


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
