"""The straightened diagram."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from . import lines
from .axes import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..atlas import Atlas

SIZE = 11.0
"""Of letters in pixels."""

LETTER = 0.6
"""Width of a letter by its size."""


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
    for region, text, _, (x, y), tip in drawing["labels"][0] if labels else ():
        half = max(map(len, text)) * LETTER * SIZE * lines.POINT / 2 / _points(ax)[0]
        at = min(max(x, half), max(half, 1 - half)), y
        lines.label(ax, (region, text, SIZE, at, tip), atlas.regions[region].id, drawing)
    _axes(ax, drawing)
    return drawing


def _points(ax: "Axes") -> Array:
    """Width and height of axes in points."""
    return np.asarray(ax.get_window_extent().size) / ax.figure.dpi * 72


def _axes(ax: "Axes", drawing: dict[str, Any]) -> None:
    """The numbers that are meant: l below, h on the left at l = 0, on the right at the last l."""
    ax.set(xlim=(0, 1), ylim=(0, 1), xlabel="$l$", ylabel="$h$ at $l = 0$")
    other = ax.secondary_yaxis("right")
    other.set_ylabel(f"$h$ at $l = {drawing['l_end']:.3g}$")
    width, height = _points(ax)
    left, right = drawing["energies"]
    for axes in (ax, other):
        axes.tick_params(labelsize="x-small")
    size = float(ax.xaxis.get_ticklabels()[0].get_fontsize())
    ax.set_xticks(*_apart(drawing["momenta"], lambda text: (len(text) + 1) * LETTER * size / width))
    ax.set_yticks(*_apart(left, lambda _: size / height))
    other.set_yticks(*_apart(right, lambda _: size / height))


def _apart(ticks: list[tuple[float, str]], room: Callable[[str], float]) -> tuple[list[float], list[str]]:
    """The roundest numbers, which come first, and of the others those that leave room for them."""
    kept: list[tuple[float, str]] = []
    for place, text in ticks:
        if all(abs(place - other) >= (room(text) + room(beside)) / 2 for other, beside in kept):
            kept.append((place, text))
    return [place for place, _ in kept], [text for _, text in kept]
