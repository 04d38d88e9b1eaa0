"""Bifurcation diagrams."""

from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ..errors import InputError
from ..exact import span
from ..optional import needed
from . import lines
from .axes import Array, Size, axes, line_style, pyplot
from .straight import straight

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from ..atlas import Atlas

Window = tuple[tuple[float, float], tuple[float, float]]
"""Ranges of h and l."""

CHORD = 2000
"""A chord of a curve is off by the width of the picture divided by this."""

ROOM = 1.2
"""The letters of matplotlib are wider than those of the command's picture, and need more room."""

COLUMN = 3
"""Insets above each other."""


def diagram(
    atlas: "Atlas",
    ax: "Axes | None" = None,
    *,
    figsize: Size | None = None,
    view: "Literal['plane', 'straight', 'auto']" = "plane",
    h: tuple[float, float] | None = None,
    l: tuple[float, float] | None = None,
    regions: bool = True,
    labels: bool = True,
    events: "bool | Literal['ids']" = True,
    insets: bool | None = None,
    legend: bool | None = None,
    **line: Any,
) -> "Axes":
    """The bifurcation diagram as the command draws it: the same colours, lines, marks, names, insets and legend, but for
    the dots at the samples.

    Each type of component, by U and P, has one tint, the same in every diagram; a region of several components has
    stripes, of two shades where these are alike. A colour is a branch of relative equilibria. Curves are solid where the
    steady rotation is stable (thin if only without friction), dashed where it is unstable, dotted where that is open.
    Curves and outlines are computed for the ranges that are drawn, and are as fine as these need. Colours are light on a
    dark ground, as of the style ``"dark_background"``.

    Parameters
    ----------
    atlas : Atlas
        The atlas.
    ax : Axes, optional
        Where; None makes a new figure.
    figsize : pair of float, optional
        Width and height of a new figure in inches.
    view : {"plane", "straight", "auto"}
        ``"plane"``: h to the right, l upwards. ``"straight"``: the plane straightened so that every region can be seen: l
        to the right, h upwards from the level lowest curve, each region as high as its label needs; the places are those
        of the command's picture, in the unit square, and `Atlas.straightened` gives those of other points. ``"auto"``:
        straight where the command's plane would need more than two insets, or be too high.
    h, l : pair of float, optional
        Ranges of the axes of the plane; by default those of the picture of the command line.
    regions, labels : bool
        Whether regions are coloured, and named.
    events : bool or "ids"
        Whether cusps (diamonds), pitchforks (triangles) and crossings (rings) are marked, or also named.
    insets, legend : bool, optional
        Whether what is small is magnified beside the plane, as in the command's picture, and whether a legend stands below
        the figure, or below axes that are given; by default both on a new figure, unless ranges are given, else neither.
    **line
        Whatever ``Axes.plot`` knows, for the curves.

    Returns
    -------
    Axes
        The main one; those of insets follow it in ``ax.figure.axes``.

    Raises
    ------
    InputError
        If a range is none, the view is unknown, ranges are given for the straightened plane, or insets on given axes.
    RangeError
        If the plane cannot be straightened.
    ImportError
        Without matplotlib, which ``bifdiag[plot]`` brings.
    """
    if view not in ("plane", "straight", "auto"):
        raise InputError(f'view = {view!r}: the views are "plane", "straight" and "auto"')
    if h is not None or l is not None:
        if view == "straight":
            raise InputError("h and l are ranges of the plane; the straightened plane is drawn as a whole")
        view = "plane"
    if insets and ax is not None:
        raise InputError(
            "insets are axes of their own; leave out ax, or draw a magnified part with h and l on further axes"
        )
    if events not in (True, False, "ids"):
        raise InputError(f'events = {events!r}: give True, False, or "ids" to name them')
    line = line_style(line)
    is_new, has_ranges = ax is None, h is not None or l is not None
    shown: dict[str, Any] = {"regions": regions, "labels": labels, "events": events}
    if view == "straight" or (view == "auto" and atlas._inner.view() == "straight"):
        ax = axes(ax, figsize)
        drawn = straight(atlas, ax, **shown, **line)
    else:
        window = atlas._view()["main"]
        ranges = span(h or window["h"], "h"), span(l or window["l"], "l")
        windows: list[Window] = [ranges]
        if insets or (insets is None and is_new and not has_ranges):
            found = atlas._inner.picture(False, None)["windows"]
            windows += [(tuple(inset[0]), tuple(inset[1])) for inset in found[1:]]
        panels = _panels(ax, figsize, len(windows))
        if is_new:
            # The labels need the sizes that the layout gives the axes.
            for panel, place in zip(panels, windows, strict=True):
                panel.set(xlim=place[0], ylim=place[1], xlabel="$h$", ylabel="$l$")
            figure: Any = panels[0].figure
            figure.draw_without_rendering()
        described = [_panel(atlas, panel, place, **shown, **line) for panel, place in zip(panels, windows, strict=True)]
        ax, drawn = panels[0], described[0]
        _frames(panels, windows, drawn["ink"])
        if len(windows) > 1:
            drawn |= {"legend": atlas._inner.picture(lines.is_dark(ax), None)["legend"]}
    if is_new and not has_ranges:
        ax.set_title(drawn["title"], loc="left", fontsize="medium")
    if legend or (legend is None and is_new and not has_ranges):
        lines.legend(ax, drawn, of_figure=is_new)
    return ax


def _panels(ax: "Axes | None", figsize: Size | None, count: int) -> "list[Axes]":
    """The axes that are given, or those of a new figure: the main one and beside it insets in columns."""
    if count == 1:
        return [axes(ax, figsize)]
    plt = pyplot()
    rows, columns = min(count - 1, COLUMN), -(-(count - 1) // COLUMN)
    width, height = plt.rcParams["figure.figsize"]
    figure = plt.figure(layout="constrained", figsize=figsize or (width * (1 + 0.5 * columns), height * max(1, rows / 2)))
    grid = figure.add_gridspec(rows, 2 + columns)
    places = [grid[number % rows, 2 + number // rows] for number in range(count - 1)]
    return [figure.add_subplot(grid[:, :2]), *(figure.add_subplot(place) for place in places)]


def _panel(
    atlas: "Atlas", ax: "Axes", ranges: Window, *, regions: bool, labels: bool, events: "bool | str", **line: Any
) -> dict[str, Any]:
    """Draws a part of the plane; returns what was drawn."""
    h, l = ranges
    ax.set(xlim=h, ylim=l, xlabel="$h$", ylabel="$l$")
    drawn, scale = described(atlas, ax, ranges)
    for region, outlines, colors in (
        zip(atlas.regions, atlas.outlines(h, l), drawn["grounds"], strict=True) if regions else ()
    ):
        lines.ground(ax, _path(outlines), colors, region.id)
    ids = atlas.curves.ids
    for curve, (low, high), width, parts in drawn["strokes"]:
        seen = max(low, l[0]), min(high, l[1])
        if seen[0] < seen[1]:
            points = atlas.polyline(ids[curve], seen, tolerance=(h[1] - h[0]) / CHORD)
            for own, pattern in parts:
                for style in lines.styles(pattern, width):
                    ax.plot(points[:, 0], points[:, 1], gid=ids[own], **(style | line))
    for name, event in zip(atlas.events.ids, atlas.events, strict=True) if events else ():
        if h[0] <= event.h <= h[1] and l[0] <= event.l <= l[1]:
            lines.event(ax, event.kind, (event.h, event.l), name, drawn, named=events == "ids")
    for label in drawn["labels"][0] if labels else ():
        lines.label(ax, label, atlas.regions[label[0]].id, drawn, scale)
    return drawn


def described(atlas: "Atlas", ax: "Axes", ranges: Window) -> tuple[dict[str, Any], float]:
    """What the command would draw in these axes, and how much larger its letters are here."""
    scale: float = needed("matplotlib", "plot").rcParams["font.size"] / 10
    pixels = np.asarray(ax.get_window_extent().size) / ax.figure.dpi * 72 / lines.POINT / scale / ROOM
    return atlas._inner.picture(lines.is_dark(ax), (ranges, np.maximum(pixels, 1.0).tolist())), scale


def _frames(panels: "Sequence[Axes]", windows: "Sequence[Window]", ink: str) -> None:
    """Frames what the insets show, with their letters."""
    from matplotlib.patches import Rectangle

    (h, l), main = windows[0], panels[0]
    for number, (panel, ((h0, h1), (l0, l1))) in enumerate(zip(panels[1:], windows[1:], strict=True)):
        letter = chr(ord("a") + number)
        panel.set_title(f"({letter})", loc="left", fontsize="small")
        panel.tick_params(labelsize="x-small")
        if h[0] <= h0 and h1 <= h[1] and l[0] <= l0 and l1 <= l[1]:
            frame: dict[str, Any] = {
                "facecolor": "none",
                "edgecolor": ink,
                "linewidth": 0.7,
                "zorder": 3,
                "gid": f"frame-{letter}",
            }
            main.add_patch(Rectangle((h0, l0), h1 - h0, l1 - l0, **frame))
            main.annotate(letter, (h0, l1), ha="right", va="bottom", fontsize="x-small", color=ink, gid=f"frame-{letter}")


def _path(found: "Sequence[Array]") -> Any:
    """Outlines as one path in which holes run the other way round."""
    from matplotlib.path import Path

    outlines = [outline for outline in found if len(outline) > 3]
    paths = [Path(outline, closed=True) for outline in outlines]
    turned = []
    for outline in outlines:
        holes = sum(path.contains_point(outline[0]) for path in paths if path.vertices is not outline)
        x, y = outline.T
        rising = np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]) > 0
        turned.append(Path(outline if rising == (holes % 2 == 0) else outline[::-1], closed=True))
    return Path.make_compound_path(*turned) if turned else Path(np.empty((0, 2)))
