"""Pictures with matplotlib; the user's style sheets apply."""

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .atlas import Atlas
    from .body import Body
    from .records import Region
    from .section import Section

Array = npt.NDArray[np.float64]

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

POINTS = 200
"""Points of the sphere's picture along each side."""


def _axes(ax: "Axes | None") -> "Axes":
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    return plt.subplots(layout="constrained")[1]


def diagram(
    atlas: "Atlas",
    ax: "Axes | None" = None,
    *,
    h: tuple[float, float] | None = None,
    l: tuple[float, float] | None = None,
    regions: bool = True,
    labels: bool = True,
    **line: Any,
) -> "Axes":
    """The bifurcation diagram: regions as coloured patches, curves, ids at the samples.

    Parameters
    ----------
    atlas : Atlas
        The atlas.
    ax : Axes, optional
        Where; None makes a new figure.
    h, l : pair of float, optional
        Ranges of the axes; by default those of the picture of the command line.
    regions, labels : bool
        Whether regions are coloured, and named. Colours end where `Region.polygon` does.
    **line
        Whatever ``Axes.plot`` knows, for the curves.

    Returns
    -------
    Axes
    """
    ax = _axes(ax)
    window = atlas.document["view"]["main"]
    h, l = h or tuple(window["h"]), l or tuple(window["l"])
    for region in atlas.regions if regions else ():
        ax.add_patch(_patch(region))
    for curve in atlas.curves:
        pole = curve.kind.startswith("pole")
        style = {"color": "0.4" if pole else "k", "linestyle": ":" if pole else "-", "linewidth": 1.0} | line
        ax.plot(curve.points[:, 0], curve.points[:, 1], gid=curve.id, **style)
    for region in atlas.regions if labels else ():
        at = region.sample
        if h[0] <= at.h <= h[1] and l[0] <= at.l <= l[1]:
            text = region.id if region.signature is None else f"{region.id}\n{pretty(region.signature)}"
            ax.annotate(text, (at.h, at.l), ha="center", va="center", fontsize="small")
    ax.set(xlim=h, ylim=l, xlabel="$h$", ylabel="$l$")
    return ax


def _patch(region: "Region") -> Any:
    """The outlines of a region; those inside an odd number of others are holes, and turn the other way."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    outlines = [outline for outline in region.polygon if len(outline) > 3]
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
    """``S2+T2`` as S²+T²."""
    powers = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
    names = {"S2": "S²", "T2": "T²"}
    return "+".join(names.get(name, f"M²{name[1:].translate(powers)}") for name in signature.split("+"))


def section(
    found: "Section", ax: Any = None, projection: str = "torus", *, color: Any = None, **points: Any
) -> npt.NDArray[np.object_]:
    """The points of a section, one panel for each sheet.

    Parameters
    ----------
    found : Section
        The section.
    ax : pair of Axes, optional
        Where; None makes a new figure.
    projection : {"torus", "sphere"}
        The angles (θ, ψ) of the PP-torus, or γ on the Poisson sphere seen from +r̂ and −r̂ in equal areas.
    color : str or array (n,), optional
        The name of a column, or a value for each point; by default the orbit.
    **points
        Whatever ``Axes.scatter`` knows.

    Returns
    -------
    array of two Axes
    """
    import matplotlib.pyplot as plt

    if projection not in ("torus", "sphere"):
        from .errors import InputError

        raise InputError(f'projection = {projection!r}: the projections are "torus" and "sphere"')
    if ax is None:
        ax = plt.subplots(1, 2, layout="constrained", figsize=(9, 4.5), sharex=True, sharey=True)[1]
    panels = np.atleast_1d(np.asarray(ax, dtype=object)).reshape(-1)
    values = getattr(found, color) if isinstance(color, str) else found.orbit if color is None else np.asarray(color)
    style = {"s": 1.0, "linewidths": 0, "vmin": np.nanmin(values), "vmax": np.nanmax(values)}
    style |= {"cmap": "turbo"} | points
    x, y = (found.psi, found.theta) if projection == "torus" else _disc(found)
    for panel, sheet in zip(panels[[0, -1]], (1, -1), strict=True):
        here = found.sheet == sheet
        panel.scatter(x[here], y[here], c=values[here], rasterized=True, **style)
        panel.set_title(f"{'T' if projection == 'torus' else 'S'}{'⁺' if sheet > 0 else '⁻'}")
        if projection == "torus":
            panel.set(xlim=(0, 2 * np.pi), ylim=(np.pi, 0), xlabel="ψ", ylabel="θ")
        else:
            panel.set_aspect("equal")
            panel.axis("off")
    return panels


def _disc(found: "Section") -> tuple[Array, Array]:
    """Lambert's map of equal areas about +r̂: the disc of radius 2 is the whole sphere."""
    radius = 2 * np.sin(found.theta / 2)
    return radius * np.cos(found.psi), radius * np.sin(found.psi)


def sphere(body: "Body", h: float, l: float, ax: Any = None, **surface: Any) -> Any:
    """The accessible region U on the Poisson sphere: γ with l²/(2J) − ⟨γ, r⟩ ≤ h.

    Parameters
    ----------
    body : Body
        The body.
    h, l : float
        The point.
    ax : Axes3D, optional
        Where; None makes a new figure.
    **surface
        Whatever ``Axes3D.plot_surface`` knows.

    Returns
    -------
    Axes3D
    """
    import matplotlib.pyplot as plt

    from .exact import value

    if ax is None:
        ax = plt.figure(layout="constrained").add_subplot(projection="3d")
    polar, azimuth = np.meshgrid(np.linspace(0, np.pi, POINTS), np.linspace(0, 2 * np.pi, 2 * POINTS), indexing="ij")
    gamma = np.stack([np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)], axis=-1)
    moments, center = (np.array([float(value(text)) for text in texts]) for texts in (body.A, body.r))
    potential = l * l / 2 / (gamma**2 @ moments) - gamma @ center
    accessible = potential <= h
    colours = np.where(accessible[..., None], [0.35, 0.6, 0.9, 1.0], [0.92, 0.92, 0.92, 0.6])
    style = {"rcount": POINTS, "ccount": POINTS, "linewidth": 0, "antialiased": False, "shade": True} | surface
    ax.plot_surface(*np.moveaxis(gamma, -1, 0), facecolors=colours, **style)
    ax.set_box_aspect((1, 1, 1))
    ax.set(xlabel="γ₁", ylabel="γ₂", zlabel="γ₃")
    return ax
