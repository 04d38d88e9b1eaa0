"""Atlases: every region of the (h, l) half-plane of one body."""

from typing import Any

from .atlas_document import Source
from .atlas_drawing import AtlasDrawing
from .behaviour import counted, sections
from .point_answers import PointAnswers


class Atlas(PointAnswers, AtlasDrawing):
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

    def _identity(self) -> tuple[Any, ...]:
        source = self._source
        return self.body, self.accuracy, source.certified, source.ranges, source.drawing

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Atlas) and self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def __reduce__(self) -> tuple[Any, ...]:
        return _of, (self._source,)

    def __repr__(self) -> str:
        found = f"{counted(len(self.regions), 'region')}, {counted(len(self.events), 'event')}"
        lines = [f"Atlas of {self.body}: {found}"]
        lines += [f"  {region.id}: {region.signature or sections(region.components)}" for region in self.regions]
        lists = "regions, events, curves, stability_changes, verdict_changes"
        lines.append(f"  [{lists}; region(h, l), classify(h, l), plot(), to_json()]")
        return "\n".join(lines)


def _of(source: Source) -> Atlas:
    atlas = Atlas.__new__(Atlas)
    atlas._take(source)
    return atlas
