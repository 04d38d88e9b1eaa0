"""Maps of the chaotic share."""

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ..optional import needed
from . import lines
from .axes import Array, Size, axes
from .diagram import described

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..atlas import Atlas
    from ..chaos import ChaosMap

SQUARES = 12
"""Squares along a side of a cell, as a multiple of the numbers of components that there are."""

UNKNOWN = 2.0
"""What stands where a share is not known, above all shares."""

MOST = 4096
"""Squares along a side of the picture."""


def chaos(
    found: "ChaosMap",
    ax: "Axes | None" = None,
    *,
    figsize: Size | None = None,
    curves: bool = True,
    labels: bool = True,
    colorbar: bool = True,
    **image: Any,
) -> "Axes":
    """The chaotic share over the (h, l) plane, with the curves and the names of the regions.

    Of several components each cell shows one above the other, the first lowest. A cell through which a curve goes shows on
    each side the share of that region. Grey: not measured.

    Parameters
    ----------
    found : ChaosMap
        The map.
    ax : Axes, optional
        Where; None makes a new figure.
    figsize : pair of float, optional
        Width and height of a new figure in inches.
    curves, labels, colorbar : bool
        Whether curves are drawn, regions named, colours explained.
    **image
        Whatever ``Axes.imshow`` knows.

    Returns
    -------
    Axes

    Raises
    ------
    ImportError
        Without matplotlib, which ``bifdiag[plot]`` brings.
    """
    ax = axes(ax, figsize)
    atlas = found.body.atlas()
    (h, l), values = found.window, squares(found, atlas)
    colors = needed("matplotlib", "plot").colormaps[image.pop("cmap", "magma_r")].with_extremes(over="0.75")
    style: dict[str, Any] = {"vmin": 0.0, "vmax": 1.0, "interpolation": "nearest", "zorder": 0} | image
    drawn = ax.imshow(values.T, extent=(*h, *l), origin="lower", aspect="auto", cmap=colors, **style)
    if curves:
        for curve in atlas.curves:
            low, high = max(curve.l_range[0], l[0]), min(curve.l_range[1], l[1])
            if curve.stability and low < high:
                points = atlas.polyline(curve.id, (low, high), tolerance=(h[1] - h[0]) / 2000)
                ax.plot(points[:, 0], points[:, 1], color="black", linewidth=0.8, gid=curve.id)
    ax.set(xlim=h, ylim=l, xlabel="$h$", ylabel="$l$")
    if labels:
        plane, scale = described(atlas, ax, (h, l))
        for region, _, *where in plane["labels"][0]:
            name = atlas.regions[region].id
            lines.label(ax, (region, [name], *where), name, {"ink": "black", "paper": "white"}, scale)
    if colorbar:
        ax.figure.colorbar(drawn, ax=ax, label="chaotic share of the component")
    return ax


def squares(found: "ChaosMap", atlas: "Atlas") -> Array:
    """The share at each square of the picture; `UNKNOWN` where none is known, NaN where nothing moves."""
    n, m = found.shape
    side = max(1, min(SQUARES, MOST // max(n, m)))
    out = np.full((n * side, m * side), np.nan)
    first = np.lexsort((found.component, found.region, found.j, found.i))
    cells = np.stack([found.i[first], found.j[first]], axis=1)
    begins = np.flatnonzero(np.r_[True, (np.diff(cells, axis=0) != 0).any(axis=1)]) if len(cells) else np.array([], int)
    (h0, h1), (l0, l1) = found.window
    middles = (np.arange(side) + 0.5) / side
    for begin, end in zip(begins, np.r_[begins[1:], len(first)], strict=True):
        rows = first[begin:end]
        i, j = cells[begin]
        here = out[i * side : (i + 1) * side, j * side : (j + 1) * side]
        if (found.part[rows] >= 1).all():
            here[:] = _layers(found, rows, side)
            continue
        energies, momenta = h0 + (h1 - h0) * (i + middles) / n, l0 + (l1 - l0) * (j + middles) / m
        places: npt.NDArray[np.int64] = np.asarray(atlas.region(energies[:, None], momenta))
        here[:] = np.where(places >= 0, UNKNOWN, np.nan)
        for region in np.unique(found.region[rows]):
            layers = np.broadcast_to(_layers(found, rows[found.region[rows] == region], side), here.shape)
            here[places == region] = layers[places == region]
    return out


def _layers(found: "ChaosMap", rows: npt.NDArray[np.intp], side: int) -> Array:
    """The components of a region one above the other along l, in a cell of so many squares."""
    known = np.where(np.isnan(found.fraction[rows]), UNKNOWN, found.fraction[rows])
    layers: Array = known[np.arange(side) * len(rows) // side]
    return layers
