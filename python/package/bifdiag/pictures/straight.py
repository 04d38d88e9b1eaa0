"""The straightened diagram."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from .axes import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..atlas import Atlas

MARKERS = {"cusp": "D", "pitchfork": "^", "crossing": "o"}
"""Marks of events."""


def straight(
    atlas: "Atlas", ax: "Axes", *, regions: bool, labels: bool, styles: Any, tint: Any, ink: str, **line: Any
) -> "Axes":
    """Draws the plane in the places of the command's picture, in the unit square."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    drawing = atlas._straightened.drawing()
    for region, outlines in zip(atlas.regions, drawing["regions"], strict=True) if regions else ():
        path = Path.make_compound_path(*(Path(_closed(outline), closed=True) for outline in outlines))
        ax.add_patch(PathPatch(path, facecolor=tint(region.signature), edgecolor="none", zorder=0, gid=region.id))
    for level in drawing["levels"]:
        ax.plot(level[:, 0], level[:, 1], color="0.6", linewidth=0.3, gid="level")
    curves = list(atlas.curves)
    for number, stretch, points in drawing["curves"]:
        curve = curves[number]
        drawn: dict[str, Any] = {"linewidth": 1.0} | styles(curve, stretch, ink) | line
        ax.plot(points[:, 0], points[:, 1], gid=curve.id, **drawn)
    for event, at in zip(atlas.events, drawing["events"], strict=True):
        if at is not None:
            fill = "none" if event.kind == "crossing" else ink
            style: dict[str, Any] = {"markersize": 4, "color": ink, "markerfacecolor": fill, "gid": event.kind}
            ax.plot(*at, MARKERS[event.kind], **style)
    for region, lines, at, tip in drawing["labels"] if labels else ():
        arrow: dict[str, Any] = {} if tip is None else {"arrowprops": {"arrowstyle": "->", "linewidth": 0.7, "color": ink}}
        text = "\n".join(filter(None, lines))
        written: dict[str, Any] = {
            "ha": "center",
            "va": "center",
            "fontsize": "small",
            "color": ink,
            "gid": atlas.regions[region].id,
        }
        ax.annotate(text, at if tip is None else tip, at, **written, **arrow)
    _axes(ax, drawing)
    return ax


def _closed(outline: Array) -> Array:
    """The first point again at the end."""
    return np.concatenate([outline, outline[:1]])


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
