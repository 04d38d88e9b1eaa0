"""The straightened diagram."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from . import lines

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..atlas import Atlas

SIZE = 11.0
"""Of letters in pixels."""


def straight(
    atlas: "Atlas", ax: "Axes", *, regions: bool, labels: bool, events: "bool | str", **line: Any
) -> dict[str, Any]:
    """Draws the plane in the places of the command's picture, in the unit square; returns what was drawn."""
    from matplotlib.path import Path

    drawing = atlas._inner.straightened(lines.is_dark(ax)).drawing()
    for region, outlines, colors in (
        zip(atlas.regions, drawing["regions"], drawing["grounds"], strict=True) if regions else ()
    ):
        path = Path.make_compound_path(*(Path(lines.closed(outline), closed=True) for outline in outlines))
        lines.ground(ax, path, colors, region.id)
    for level in drawing["levels"]:
        ax.plot(level[:, 0], level[:, 1], color="0.6", linewidth=0.3, gid="level")
    ids = atlas.curves.ids
    for (_, _, width, parts), points in zip(drawing["strokes"], drawing["points"], strict=True):
        for own, pattern in parts if len(points) > 1 else ():
            for style in lines.styles(pattern, width):
                ax.plot(points[:, 0], points[:, 1], gid=ids[own], **(style | line))
    for name, event, at in zip(atlas.events.ids, atlas.events, drawing["events"], strict=True) if events else ():
        if at is not None:
            lines.event(ax, event.kind, at, name, drawing, named=events == "ids")
    for label in drawing["labels"][0] if labels else ():
        lines.label(ax, (*label[:2], SIZE, *label[3:]), atlas.regions[label[0]].id, drawing)
    _axes(ax, drawing)
    return drawing


def _axes(ax: "Axes", drawing: dict[str, Any]) -> None:
    """The numbers that are meant: l below, h on the left at l = 0, on the right at the last l."""
    left, right = drawing["energies"]
    ax.set(xlim=(0, 1), ylim=(0, 1), xlabel="$l$", ylabel="$h$ at $l = 0$")
    # Round numbers stand as close as small letters allow.
    ax.tick_params(labelsize="x-small")
    ax.set_xticks(*_split(drawing["momenta"]))
    ax.set_yticks(*_split(left))
    other = ax.secondary_yaxis("right")
    other.tick_params(labelsize="x-small")
    other.set_yticks(*_split(right))
    other.set_ylabel(f"$h$ at $l = {drawing['l_end']:.3g}$")


def _split(ticks: list[tuple[float, str]]) -> Iterator[list[Any]]:
    places, texts = zip(*ticks, strict=True) if ticks else ((), ())
    yield list(places)
    yield list(texts)
