"""Pictures with matplotlib; the user's style sheets apply."""

from collections.abc import Callable
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

VERDICTS = {"regular": "#0072b2", "chaotic": "#d55e00", "open": "#aab4bd"}
"""Colours of orbits by their verdict."""

CELLS = np.array([160, 120])
"""Cells along h and l in which room for the names of regions is sought."""

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
    """The bifurcation diagram: regions as coloured patches, curves, names where they find room.

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
    ax.set(xlim=h, ylim=l, xlabel="$h$", ylabel="$l$")
    if labels:
        _name(atlas, ax, h, l)
    return ax


def _name(atlas: "Atlas", ax: "Axes", h: tuple[float, float], l: tuple[float, float]) -> None:
    """Writes ids and signatures of the regions, or ids alone, deepest inside each region, where they fit."""
    from matplotlib.font_manager import FontProperties

    columns, rows = CELLS
    energies = h[0] + (np.arange(columns) + 0.5) / columns * (h[1] - h[0])
    momenta = l[0] + (np.arange(rows) + 0.5) / rows * (l[1] - l[0])
    found = atlas.region(energies[:, None], momenta)
    points = np.asarray(ax.get_window_extent().size) / ax.figure.dpi * 72
    size = FontProperties(size="small").get_size_in_points()
    for number, region in enumerate(atlas.regions):
        names = [region.id] if region.signature is None else [f"{region.id}\n{pretty(region.signature)}", region.id]
        for name in names:
            lines = name.splitlines()
            extent = size * np.array([0.65 * max(map(len, lines)), 1.3 * len(lines)])
            cell = _deepest(found == number, np.ceil(extent / points * CELLS / 2).astype(int))
            if cell is not None:
                at = (energies[cell[0]], momenta[cell[1]])
                ax.annotate(name, at, ha="center", va="center", fontsize="small", clip_on=True)
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
    """``S2+T2`` as S²+T², ``M3`` as M²₃ (genus 3)."""
    below = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
    names = {"S2": "S²", "T2": "T²"}
    return "+".join(names.get(name, f"M²{name[1:].translate(below)}") for name in signature.split("+"))


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
        The name of a column, ``"verdict"``, or a value for each point; by default the orbit.
    **points
        Whatever ``Axes.scatter`` knows.

    Returns
    -------
    array of two Axes
    """
    import matplotlib.pyplot as plt
    from matplotlib.colors import ListedColormap

    if projection not in ("torus", "sphere"):
        from .errors import InputError

        raise InputError(f'projection = {projection!r}: the projections are "torus" and "sphere"')
    if ax is None:
        ax = plt.subplots(1, 2, layout="constrained", figsize=(9, 4.5), sharex=True, sharey=True)[1]
    panels = np.atleast_1d(np.asarray(ax, dtype=object)).reshape(-1)
    style: dict[str, Any] = {"s": 1.0, "linewidths": 0, "cmap": "turbo"}
    if isinstance(color, str) and color == "verdict":
        values = np.array([list(VERDICTS).index(verdict) for verdict in found.verdict])[found.orbit]
        style["cmap"] = ListedColormap(list(VERDICTS.values()))
        style |= {"vmin": 0, "vmax": len(VERDICTS) - 1}
    else:
        values = getattr(found, color) if isinstance(color, str) else found.orbit if color is None else np.asarray(color)
        style |= {"vmin": np.nanmin(values), "vmax": np.nanmax(values)}
    style |= points
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
    if isinstance(color, str) and color == "verdict":
        for name, tone in VERDICTS.items():
            panels[-1].scatter([], [], c=tone, s=12, label=name)
        panels[-1].legend(loc="upper right", fontsize="small")
    return panels


def _disc(found: "Section") -> tuple[Array, Array]:
    """Lambert's map of equal areas about +r̂: the disc of radius 2 is the whole sphere."""
    radius = 2 * np.sin(found.theta / 2)
    return radius * np.cos(found.psi), radius * np.sin(found.psi)


def sphere(given: "Body", h: float, l: float, ax: Any = None, **surface: Any) -> Any:
    """The accessible region U on the Poisson sphere: γ with l²/(2J) − ⟨γ, r⟩ ≤ h.

    Parameters
    ----------
    given : Body
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
    ax = _space(ax)
    gamma = _directions()
    moments, center = _numbers(given)
    potential = l * l / 2 / (gamma**2 @ moments) - gamma @ center
    accessible = potential <= h
    colours = np.where(accessible[..., None], [0.35, 0.6, 0.9, 1.0], [0.92, 0.92, 0.92, 0.6])
    style = {"rcount": POINTS, "ccount": POINTS, "linewidth": 0, "antialiased": False, "shade": True} | surface
    ax.plot_surface(*np.moveaxis(gamma, -1, 0), facecolors=colours, **style)
    ax.set_box_aspect((1, 1, 1))
    ax.set(xlabel="γ₁", ylabel="γ₂", zlabel="γ₃")
    return ax


def body(given: "Body", ax: Any = None, **surface: Any) -> Any:
    """A body: its ellipsoid of inertia ⟨x, A x⟩ = 1 about the fixed point, its principal axes and its centre of mass.

    Parameters
    ----------
    given : Body
        The body.
    ax : Axes3D, optional
        Where; None makes a new figure.
    **surface
        Whatever ``Axes3D.plot_surface`` knows.

    Returns
    -------
    Axes3D
        Lengths are those of the ellipsoid; of r only the direction is drawn.
    """
    ax = _space(ax)
    moments, center = _numbers(given)
    half = moments**-0.5
    style = {"color": (0.35, 0.6, 0.9, 0.35), "linewidth": 0, "rcount": 60, "ccount": 60} | surface
    ax.plot_surface(*np.moveaxis(_directions() * half, -1, 0), **style)
    for axis in np.eye(3):
        x, y, z = np.outer(axis * half * 1.25, [-1, 1])
        ax.plot(x, y, z, color="0.5", linewidth=1)
        ax.text(*(axis * half * 1.35), f"$A_{1 + int(np.argmax(axis))}$", ha="center", va="center")
    length = float(np.linalg.norm(center))
    if length > 0:
        ax.plot(*np.outer(center / length * half.min(), [0, 1]), "o-", color="C3", markevery=[1], label="centre of mass")
    ax.set(xlabel="$x_1$", ylabel="$x_2$", zlabel="$x_3$", aspect="equal")
    return ax


def plane(
    body_at: Callable[[float, float], "Body | None"],
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    ax: "Axes | None" = None,
    *,
    value: Callable[["Atlas"], float | str] = lambda atlas: len(atlas.regions),
    **mesh: Any,
) -> "Axes":
    """A map of bodies: something of the atlas of each body of a plane, by default the number of its regions.

    Parameters
    ----------
    body_at : function of two floats
        The body at a place; None where there is none.
    x, y : array (n,), array (m,)
        The places.
    ax : Axes, optional
        Where; None makes a new figure.
    value : function of an Atlas
        What the colour tells: a number, or a text such as a list of signatures.
    **mesh
        Whatever ``Axes.pcolormesh`` knows.

    Returns
    -------
    Axes
        With a colour bar; places without a body, and bodies whose atlas cannot be computed, are left blank.

    Examples
    --------
    >>> import bifdiag, bifdiag.pictures
    >>> ax = bifdiag.pictures.plane(lambda x, y: bifdiag.Body([1, x, y], [1, 0, 0]), [0.5, 1.5], [0.7, 1.3])
    >>> ax.collections[0].get_array().tolist()
    [[6.0, 5.0], [5.0, 4.0]]
    """
    from .errors import RangeError

    ax = _axes(ax)
    across, up = np.asarray(x, dtype=float), np.asarray(y, dtype=float)

    def found(place: float, height: float) -> float | str | None:
        try:
            given = body_at(place, height)
            return None if given is None else value(given.atlas())
        except RangeError:
            return None

    values = [[found(float(place), float(height)) for place in across] for height in up]
    texts = sorted({cell for row in values for cell in row if isinstance(cell, str)})
    numbers = [[np.nan if v is None else texts.index(v) if isinstance(v, str) else v for v in row] for row in values]
    style: dict[str, Any] = {"cmap": "viridis"} | mesh
    image = ax.pcolormesh(across, up, np.array(numbers, dtype=float), **style)
    bar = ax.figure.colorbar(image, ax=ax)
    if texts:
        bar.set_ticks(range(len(texts)), labels=texts)
    return ax


def _space(ax: Any) -> Any:
    """Axes of three dimensions."""
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    return plt.figure(layout="constrained").add_subplot(projection="3d")


def _directions() -> Array:
    """Unit vectors over a grid of angles."""
    polar, azimuth = np.meshgrid(np.linspace(0, np.pi, POINTS), np.linspace(0, 2 * np.pi, 2 * POINTS), indexing="ij")
    return np.stack([np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)], axis=-1)


def _numbers(given: "Body") -> tuple[Array, Array]:
    """A and r as doubles."""
    from .exact import value

    moments, center = (np.array([float(value(text)) for text in texts]) for texts in (given.A, given.r))
    return moments, center
