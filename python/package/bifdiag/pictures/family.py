"""Families of periodic orbits."""

from itertools import groupby
from typing import TYPE_CHECKING, Any

from .axes import Size, axes, line_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..periodic import PeriodicFamily

LINES = {"elliptic": "-", "hyperbolic": (0, (5, 3)), "inverse-hyperbolic": (0, (5, 2, 1, 2)), "parabolic": ":"}
"""Lines by what the multipliers say: solid where the orbits are linearly stable."""

MARKERS = {"fold": "D", "branch": "o", "doubling": "^", "tripling": "s"}
"""Marks of special orbits."""


def family(
    found: "PeriodicFamily",
    ax: "Axes | None" = None,
    *,
    figsize: Size | None = None,
    events: bool = True,
    **line: Any,
) -> "Axes":
    """The periods of a family, and of its branches, over what changes along it.

    Solid where the orbits are linearly stable, dashed where they are unstable (with dots where the multipliers are
    negative). Diamonds are folds, rings other families that cross, triangles doublings, squares triplings.

    Parameters
    ----------
    found : PeriodicFamily
        The family.
    ax : Axes, optional
        Where; None makes a new figure.
    figsize : pair of float, optional
        Width and height of a new figure in inches.
    events : bool
        Whether special orbits are marked.
    **line
        Whatever ``Axes.plot`` knows.

    Returns
    -------
    Axes
    """
    ax = axes(ax, figsize)
    along = found[found.free]
    style: dict[str, Any] = {"color": "C0", "linewidth": 1.2} | line_style(line)
    first = 0
    for kind, members in groupby(found.stability.tolist()):
        # Up to the first member of the next stretch, so that no gap is left.
        end = first + len(list(members))
        piece = slice(first, min(end + 1, len(found)))
        ax.plot(along[piece], found.period[piece], linestyle=LINES[kind], gid=kind, **style)
        first = end
    for event in found.events if events else ():
        ring: dict[str, Any] = {"markerfacecolor": "none"} if event["kind"] == "branch" else {}
        ax.plot(event[found.free], event["period"], MARKERS[event["kind"]], color=style["color"], gid=event["kind"], **ring)
    for branch in found.branches:
        inner: dict[str, Any] = style | {"color": "C1"} | line
        family(branch, ax, events=events, **inner)
    ax.set(xlabel=f"${found.free}$", ylabel="period")
    return ax
