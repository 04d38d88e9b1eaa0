"""Bifurcation diagrams."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from ..errors import InputError
from ..exact import span
from ..optional import needed
from .axes import Array, Size, axes, line_style
from .straight import straight

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..atlas import Atlas
    from ..records import Curve, Region

TINTS = {
    "S2": "#cfe2f3",
    "T2": "#dcedc8",
    "M2": "#ffecb3",
    "M3": "#f8cdbf",
    "M4": "#dfc2c2",
    "S2+S2": "#b9dfe8",
    "S2+T2": "#cbc5e8",
    "T2+T2": "#efc9e4",
    "M2+S2": "#ddd3b0",
    "M2+T2": "#bce5d3",
    "M3+S2": "#f2d19a",
    "S2+S2+T2": "#d2d2d2",
}
"""Grounds of the regions by their signature, in alphabetical order; others take one of these."""

STRETCHES = {"stable": "-", "unstable": (0, (5, 3)), "open": ":"}
"""Lines of stretches of curves by the verdict on their stability."""

THIN = 0.4
"""Width of a curve that is stable without friction only, relative to the others."""

POLES = {"pole-plus": (0, (9, 2.5, 1.8, 2.5)), "pole-minus": (0, (9, 2.5, 1.8, 2.5, 1.8, 2.5))}
"""Lines of the pole lines: dash and dot, dash and two dots."""

CHORD = 2000
"""A chord of a curve is off by the width of the picture divided by this."""


CELLS = np.array([160, 120])
"""Cells along h and l in which room for the names of regions is sought."""


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
    **line: Any,
) -> "Axes":
    """The bifurcation diagram: regions as coloured patches, curves, names where they find room.

    Curves are solid where the steady rotation is stable (thin if only without friction), dashed where it is unstable,
    dotted where that is open; the pole lines are grey, with one dot between dashes where r̂ enters U and two where −r̂
    does. Curves and outlines are computed for the ranges that are drawn, and are as fine as these need.

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
    **line
        Whatever ``Axes.plot`` knows, for the curves.

    Returns
    -------
    Axes

    Raises
    ------
    InputError
        If a range is none, the view is unknown, or ranges are given for the straightened plane.
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
    line = line_style(line)
    # The grounds of regions are pale whatever the style sheet says.
    ink = "black" if regions else needed("matplotlib", "plot").rcParams["text.color"]
    if view == "straight" or (view == "auto" and atlas._inner.view() == "straight"):
        shown = {"regions": regions, "labels": labels}
        return straight(atlas, axes(ax, figsize), styles=_style, tint=tint, ink=ink, **shown, **line)
    window = atlas._view()["main"]
    h, l = span(h or window["h"], "h"), span(l or window["l"], "l")
    ax = axes(ax, figsize)
    for region, outlines in zip(atlas.regions, atlas.outlines(h, l), strict=True) if regions else ():
        ax.add_patch(_patch(region, outlines))
    for curve in atlas.curves:
        for low, high, style in _stretches(curve, ink):
            seen = max(low, l[0]), min(high, l[1])
            if seen[0] < seen[1]:
                points = atlas.polyline(curve.id, seen, tolerance=(h[1] - h[0]) / CHORD)
                drawn: dict[str, Any] = {"linewidth": 1.0} | style | line
                ax.plot(points[:, 0], points[:, 1], gid=curve.id, **drawn)
    ax.set(xlim=h, ylim=l, xlabel="$h$", ylabel="$l$")
    if labels:
        name_regions(atlas, ax, h, l, ink)
    return ax


def _stretches(curve: "Curve", ink: str) -> Iterator[tuple[float, float, dict[str, Any]]]:
    """The ranges of l over which a curve is drawn in one style."""
    if curve.kind in POLES:
        yield *curve.l_range, _style(curve, None, ink)
    for number, part in enumerate(curve.stability):
        yield part.l_from, part.l_to, _style(curve, number, ink)


def _style(curve: "Curve", stretch: int | None, ink: str) -> dict[str, Any]:
    """How a stretch of stability of a curve is drawn; a pole line has none."""
    if stretch is None:
        return {"color": "0.4", "linestyle": POLES.get(curve.kind, "-")}
    part = curve.stability[stretch]
    style: dict[str, Any] = {"color": ink, "linestyle": STRETCHES[part.nonlinear.verdict]}
    if part.nonlinear.verdict == "stable" and part.friction.conserving_l != "survives":
        style["linewidth"] = THIN
    return style


def name_regions(
    atlas: "Atlas", ax: "Axes", h: tuple[float, float], l: tuple[float, float], ink: str, *, signatures: bool = True
) -> None:
    """Writes ids and signatures of the regions, or ids alone, deepest inside each region, where they fit."""
    from matplotlib.font_manager import FontProperties

    columns, rows = CELLS
    energies = h[0] + (np.arange(columns) + 0.5) / columns * (h[1] - h[0])
    momenta = l[0] + (np.arange(rows) + 0.5) / rows * (l[1] - l[0])
    found: Any = atlas.region(energies[:, None], momenta)
    points = np.asarray(ax.get_window_extent().size) / ax.figure.dpi * 72
    size = FontProperties(size="small").get_size_in_points()
    for number, region in enumerate(atlas.regions):
        full = [f"{region.id}\n{pretty(region.signature)}"] if signatures and region.signature is not None else []
        names = [*full, region.id]
        for name in names:
            lines = name.splitlines()
            extent = size * np.array([0.65 * max(map(len, lines)), 1.3 * len(lines)])
            cell = _deepest(found == number, np.ceil(extent / points * CELLS / 2).astype(int))
            if cell is not None:
                at = (energies[cell[0]], momenta[cell[1]])
                ax.annotate(name, at, ha="center", va="center", fontsize="small", color=ink, clip_on=True)
                break


def _deepest(inside: npt.NDArray[np.bool_], room: npt.NDArray[np.int_]) -> tuple[int, int] | None:
    """A cell with so many cells inside on each side, and as far from the edge as there is one; None if there is none."""

    def roomy(a: int, b: int) -> npt.NDArray[np.intp]:
        sums = np.pad(inside.astype(int).cumsum(0).cumsum(1), ((1, 0), (1, 0)))
        w, d = 2 * a + 1, 2 * b + 1
        if w > inside.shape[0] or d > inside.shape[1]:
            return np.empty((0, 2), dtype=np.intp)
        full = sums[w:, d:] - sums[:-w, d:] - sums[w:, :-d] + sums[:-w, :-d] == w * d
        cells: npt.NDArray[np.intp] = np.argwhere(full) + np.array([a, b])
        return cells

    best = None
    for more in range(max(inside.shape)):
        cells = roomy(int(room[0]) + more, int(room[1]) + more)
        if len(cells) == 0:
            break
        best = cells[np.argmin(((cells - cells.mean(axis=0)) ** 2).sum(axis=1))]
    return None if best is None else (int(best[0]), int(best[1]))


def _patch(region: "Region", found: tuple[Array, ...]) -> Any:
    """The outlines of a region; those inside an odd number of others are holes, and turn the other way."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    outlines = [outline for outline in found if len(outline) > 3]
    paths = [Path(outline, closed=True) for outline in outlines]
    turned = []
    for outline in outlines:
        holes = sum(path.contains_point(outline[0]) for path in paths if path.vertices is not outline)
        x, y = outline.T
        rising = np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]) > 0
        turned.append(Path(outline if rising == (holes % 2 == 0) else outline[::-1], closed=True))
    path = Path.make_compound_path(*turned) if turned else Path(np.empty((0, 2)))
    return PathPatch(path, facecolor=tint(region.signature), edgecolor="none", zorder=0, gid=region.id)


def tint(signature: str | None) -> str:
    """The ground of regions of this type."""
    name = "+".join(sorted((signature or "").split("+")))
    return TINTS.get(name) or list(TINTS.values())[sum(name.encode()) % len(TINTS)]


def pretty(signature: str) -> str:
    """``S2+T2`` as S²+T², ``M3`` as M²₃ (genus 3)."""
    below = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
    names = {"S2": "S²", "T2": "T²"}
    return "+".join(names.get(name, f"M²{name[1:].translate(below)}") for name in signature.split("+"))
