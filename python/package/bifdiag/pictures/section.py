"""Poincaré sections."""

from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from ..errors import InputError
from ..optional import needed
from .axes import Array, Size, pyplot, refuse_size

if TYPE_CHECKING:
    from ..section import Section

VERDICTS = {"regular": "#0072b2", "chaotic": "#d55e00", "open": "#aab4bd"}
"""Colours of orbits by their verdict."""


def section(
    found: "Section",
    ax: Any = None,
    projection: "Literal['torus', 'sphere']" = "torus",
    *,
    figsize: Size | None = None,
    color: Any = None,
    sheet: "Literal[1, -1] | None" = None,
    **points: Any,
) -> npt.NDArray[np.object_]:
    """The points of a section, one panel for each sheet.

    Parameters
    ----------
    found : Section
        The section.
    ax : pair of Axes, optional
        Where, first T⁺, then T⁻; None makes a new figure. With `sheet` a single one.
    figsize : pair of float, optional
        Width and height of a new figure in inches.
    projection : {"torus", "sphere"}
        The angles (ϑ′, ψ′) of the PP-torus, or γ on the Poisson sphere seen from +r̂ in equal areas: r̂ is the centre, −r̂ the
        rim.
    color : str or array (n,), optional
        The name of a column, ``"verdict"``, or a value for each point; by default the orbit. Points without a value are
        grey.
    sheet : {1, -1}, optional
        Draw T⁺ or T⁻ alone; by default both.
    **points
        Whatever ``Axes.scatter`` knows.

    Returns
    -------
    array of Axes, two or with `sheet` one

    Raises
    ------
    InputError
        If the projection, the sheet or the colour is unknown, or the axes are not as many as the sheets.
    ImportError
        Without matplotlib, which ``bifdiag[plot]`` brings.
    """
    if projection not in ("torus", "sphere"):
        raise InputError(f'projection = {projection!r}: the projections are "torus" and "sphere"')
    if sheet not in (None, 1, -1):
        raise InputError(f"sheet = {sheet!r}: the sheets are 1 and -1")
    sheets = (1, -1) if sheet is None else (sheet,)
    values, style = _colors(found, color)
    if ax is not None:
        refuse_size(figsize)
    else:
        size = figsize or (4.5 * len(sheets), 4.5)
        ax = pyplot().subplots(1, len(sheets), layout="constrained", figsize=size, sharex=True, sharey=True)[1]
    panels = np.atleast_1d(np.asarray(ax, dtype=object)).reshape(-1)
    if len(panels) != len(sheets):
        raise InputError(f"{len(panels)} axes for {len(sheets)} sheets; give one for each, or one with sheet=1 or sheet=-1")
    style = {"s": 1.0, "linewidths": 0, "plotnonfinite": True} | style | points
    x, y = (found.psi, found.theta) if projection == "torus" else _disc(found)
    for panel, side in zip(panels, sheets, strict=True):
        here = found.sheet == side
        panel.scatter(x[here], y[here], c=values[here], rasterized=True, **style)
        panel.set_title(f"{'T' if projection == 'torus' else 'S'}{'⁺' if side > 0 else '⁻'}")
        if projection == "torus":
            panel.set(xlim=(0, 2 * np.pi), ylim=(np.pi, 0), xlabel="ψ′", ylabel="ϑ′")
        else:
            panel.set_aspect("equal")
            panel.axis("off")
    if isinstance(color, str) and color == "verdict":
        for name, tone in VERDICTS.items():
            if name not in found.verdict:
                continue
            panels[-1].scatter([], [], c=tone, s=12, label=name)
        panels[-1].legend(loc="upper right", fontsize="small")
    return panels


THUMBNAIL = 4000
"""Points that a notebook shows of a section."""


def thumbnail(found: "Section") -> str:
    """A small picture as SVG, without matplotlib: both sheets of the torus, coloured by verdict."""
    width, height, gap = 240.0, 120.0, 16.0
    step = -(-len(found) // THUMBNAIL) or 1
    verdicts = np.array(found.verdict, dtype=object)[found.orbit]
    parts = []
    for place, side in enumerate((1, -1)):
        left = place * (width + gap)
        parts.append(f'<rect x="{left:g}" width="{width:g}" height="{height:g}" fill="none" stroke="currentColor"/>')
        for name, tone in VERDICTS.items():
            here = np.flatnonzero((found.sheet == side) & (verdicts == name))[::step]
            x, y = left + found.psi[here] * (width / (2 * np.pi)), found.theta[here] * (height / np.pi)
            points = "".join(f"M{a:.1f} {b:.1f}h0" for a, b in zip(x.tolist(), y.tolist(), strict=True))
            parts.append(
                f'<path d="{points}" stroke="{tone}" stroke-linecap="round" stroke-width="1.5"/>' if points else ""
            )
    box = f"-1 -1 {2 * width + gap + 2:g} {height + 2:g}"
    title = "ψ′ from 0 to 2π to the right, ϑ′ from 0 to π downwards; left T⁺, right T⁻"
    return f'<svg viewBox="{box}" width="500" role="img"><title>{title}</title>{"".join(parts)}</svg>'


def _colors(found: "Section", color: Any) -> tuple[npt.NDArray[Any], dict[str, Any]]:
    """A value for each point, and how values become colours."""
    if isinstance(color, str) and color == "verdict":
        values = np.array([list(VERDICTS).index(verdict) for verdict in found.verdict], dtype=int)[found.orbit]
        return values, {
            "cmap": needed("matplotlib.colors", "plot").ListedColormap(list(VERDICTS.values())),
            "vmin": 0,
            "vmax": len(VERDICTS) - 1,
        }
    names = [name for name in found.columns if getattr(found, name).ndim == 1]
    if isinstance(color, str) and color not in names:
        raise InputError(f'color = {color!r}: give "verdict", one of the columns {", ".join(names)}, or an array')
    values = found.orbit if color is None else np.asarray(getattr(found, color) if isinstance(color, str) else color)
    if values.shape != found.orbit.shape or values.dtype.kind not in "iufb":
        raise InputError(
            f"color has the shape {values.shape} and the dtype {values.dtype}; {len(found)} numbers are needed, one a point"
        )
    finite = values[np.isfinite(values)]
    ends = {"vmin": finite.min(), "vmax": finite.max()} if finite.size else {}
    return values, {"cmap": needed("matplotlib", "plot").colormaps["turbo"].with_extremes(bad="0.7")} | ends


def _disc(found: "Section") -> tuple[Array, Array]:
    """Lambert's map of equal areas about +r̂: the disc of radius 2 is the whole sphere."""
    radius = 2 * np.sin(found.theta / 2)
    return radius * np.cos(found.psi), radius * np.sin(found.psi)
