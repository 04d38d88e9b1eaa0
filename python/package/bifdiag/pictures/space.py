"""Bodies, and U on the Poisson sphere, in three dimensions."""

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import exact
from ..errors import InputError
from ..exact import Number
from .axes import Array, Size, line_style, space

if TYPE_CHECKING:
    from ..body import Body
    from ..motion import Motion

TICKS = (-1, 0, 1)
"""More numbers on the axes of a sphere would overlap."""

ABOVE = 1.01
"""Marks stand a little above the sphere."""

MARKS = [("o", "minimum"), ("s", "saddle"), ("^", "maximum")]
"""Marks of relative equilibria by their index."""

SMOOTH = 8
"""Pieces of the path of a motion between two times."""

POINTS = 200
"""Points of the sphere's picture along each side."""


def sphere(
    given: "Body", h: Number, l: Number, ax: Any = None, *, figsize: Size | None = None, legend: bool = True, **surface: Any
) -> Any:
    """The accessible region U on the Poisson sphere: γ with l²/(2⟨γ, A γ⟩) − ⟨γ, r⟩ ≤ h, blue.

    Marks are the isolated, nondegenerate relative equilibria at this l by their index, also those outside U; ±r̂ have
    their names.

    Parameters
    ----------
    given : Body
        The body.
    h, l : number
        The point.
    ax : Axes3D, optional
        Where; None makes a new figure.
    figsize : pair of float, optional
        Width and height of a new figure in inches.
    legend : bool
        Whether the marks are explained.
    **surface
        Whatever ``Axes3D.plot_surface`` knows.

    Returns
    -------
    Axes3D

    Raises
    ------
    InputError
        If the point is forbidden: U is empty.
    ImportError
        Without matplotlib, which ``bifdiag[plot]`` brings.
    """
    found = given.critical(l)
    if given.classify(h, l).status == "forbidden":
        raise InputError(f"(h, l) = ({h}, {l}) is forbidden: the lowest energy at l = {l} is {found.h.min():.16g}")
    energy, momentum = (float(exact.value(exact.text(number, name))) for number, name in ((h, "h"), (l, "l")))
    ax = space(ax, figsize)
    gamma = _directions()
    moments, center = given.moments, given.com
    potential = momentum**2 / 2 / (gamma**2 @ moments) - given.weight * gamma @ center
    accessible = potential <= energy
    colours = np.where(accessible[..., None], [0.35, 0.6, 0.9, 1.0], [0.92, 0.92, 0.92, 0.6])
    style = {"rcount": POINTS, "ccount": POINTS, "linewidth": 0, "antialiased": False, "shade": True} | surface
    drawn = ax.plot_surface(*np.moveaxis(gamma, -1, 0), facecolors=colours, **style)
    # Each mark is a collection of its own and the sphere is sorted by its middle, so that it hides what lies behind.
    drawn.set_sort_zpos(0.0)
    for index, (mark, name) in enumerate(MARKS):
        rows = found[(found["index"] == index) & (found.multiplicity == "1")]
        for place, at in enumerate(rows.gamma * ABOVE):
            told = {} if place else {"label": f"{name} of U(γ)"}
            ax.scatter(*at[:, None], marker=mark, color="C3", s=24, depthshade=False, gid=name, **told)
    length = float(np.linalg.norm(center))
    for side, name in ((1, r"$+\hat{r}$"), (-1, r"$-\hat{r}$")) if length > 0 else ():
        pole = center / length * side * 1.1
        ax.scatter(*pole[:, None], marker=name, color="black", s=160, linewidths=0.3, depthshade=False, gid=name)
    if legend and ax.get_legend_handles_labels()[0]:
        ax.legend(loc="upper left", fontsize="small")
    ax.set_box_aspect((1, 1, 1))
    ax.set(xlabel="γ₁", ylabel="γ₂", zlabel="γ₃", xticks=TICKS, yticks=TICKS, zticks=TICKS)
    return ax


def body(given: "Body", ax: Any = None, *, figsize: Size | None = None, **surface: Any) -> Any:
    """A body: its ellipsoid of inertia ⟨x, A x⟩ = 1 about the fixed point, its principal axes and its centre of mass.

    Parameters
    ----------
    given : Body
        The body.
    ax : Axes3D, optional
        Where; None makes a new figure.
    figsize : pair of float, optional
        Width and height of a new figure in inches.
    **surface
        Whatever ``Axes3D.plot_surface`` knows.

    Returns
    -------
    Axes3D
        Lengths are those of the ellipsoid; of r only the direction is drawn.
    """
    ax = space(ax, figsize)
    moments, center = given.moments, given.com
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
    ax.locator_params(nbins=4)
    return ax


def _directions() -> Array:
    """Unit vectors over a grid of angles."""
    polar, azimuth = np.meshgrid(np.linspace(0, np.pi, POINTS), np.linspace(0, 2 * np.pi, 2 * POINTS), indexing="ij")
    return np.stack([np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)], axis=-1)


def motion(given: "Motion", ax: Any = None, *, figsize: Size | None = None, **line: Any) -> Any:
    """The path of the centre of mass in space, on the unit sphere about the fixed point, with up as the third axis.

    Parameters
    ----------
    given : Motion
        The motion.
    ax : Axes3D, optional
        Where; None makes a new figure.
    figsize : pair of float, optional
        Width and height of a new figure in inches.
    **line
        Whatever ``Axes3D.plot`` knows.

    Returns
    -------
    Axes3D
        Without weight the path is that of the body's third axis. The dot is the first time. Between times through which the
        body turns by less than a radian the path is curved as its velocities say, else the line is straight.
    """
    ax = space(ax, figsize)
    center = given.center
    length = float(np.linalg.norm(center))
    pointer = center / length if length > 0 else np.array([0.0, 0.0, 1.0])
    style = {"linewidth": 1.0} | line_style(line)
    for part in given._parts():
        x, y, z = _path(part, pointer).T
        (drawn,) = ax.plot(x, y, z, **style)
        ax.plot(x[:1], y[:1], z[:1], "o", color=drawn.get_color())
    ax.plot([0, 0], [0, 0], [-1, 1], color="0.6", linewidth=0.8)
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1), xlabel="$x$", ylabel="$y$", zlabel="up")
    ax.set(xticks=TICKS, yticks=TICKS, zticks=TICKS)
    ax.set_box_aspect((1, 1, 1))
    return ax


def _path(given: "Motion", pointer: Array) -> Array:
    """The path of a direction of the body, with up as the third axis; between times through cubic arcs."""
    axes = given.axes()
    # Space is turned about its first axis, so that the third one points up.
    turned = np.array([1.0, -1.0, -1.0])
    at = (axes @ pointer) * turned
    velocity = np.einsum("kij,kj->ki", axes, np.cross(given.omega, pointer)) * turned
    steps = np.diff(given.time)[:, None]
    if len(at) < 2 or (np.linalg.norm(given.omega, axis=1)[:-1] * steps[:, 0]).max() > 1:
        rough: Array = at
        return rough
    s = (np.arange(SMOOTH) / SMOOTH)[:, None, None]
    arcs = (1 + 2 * s) * (1 - s) ** 2 * at[:-1] + s**2 * (3 - 2 * s) * at[1:]
    arcs = arcs + steps * (s * (1 - s) ** 2 * velocity[:-1] - s**2 * (1 - s) * velocity[1:])
    path = np.concatenate([arcs.transpose(1, 0, 2).reshape(-1, 3), at[-1:]])
    smooth: Array = path / np.linalg.norm(path, axis=1, keepdims=True)
    return smooth
