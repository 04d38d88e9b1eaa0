"""Where pictures are drawn."""

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ..errors import InputError
from ..optional import needed

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = npt.NDArray[np.float64]


def pyplot() -> Any:
    """Matplotlib's figures."""
    return needed("matplotlib.pyplot", "plot")


Size = tuple[float, float]
"""Width and height of a figure in inches."""


def axes(ax: "Axes | None", figsize: Size | None = None) -> "Axes":
    """The axes that are given, or those of a new figure.

    Raises
    ------
    InputError
        If a size is given for a figure that is there already.
    """
    if ax is not None:
        refuse_size(figsize)
        return ax
    made: Axes = pyplot().subplots(layout="constrained", figsize=figsize)[1]
    return made


def space(ax: Any, figsize: Size | None = None) -> Any:
    """Likewise axes of three dimensions."""
    if ax is not None:
        refuse_size(figsize)
        if not hasattr(ax, "plot_surface"):
            raise InputError('ax has two dimensions; make axes of three by fig.add_subplot(projection="3d")')
        return ax
    return pyplot().figure(layout="constrained", figsize=figsize).add_subplot(projection="3d")


def line_style(given: dict[str, Any]) -> dict[str, Any]:
    """What is given of lines, by whole names: ``linewidth`` for ``lw``."""
    line = needed("matplotlib.lines", "plot").Line2D
    named: dict[str, Any] = needed("matplotlib.cbook", "plot").normalize_kwargs(given, line)
    known = needed("matplotlib.artist", "plot").ArtistInspector(line).get_setters()
    for name in named:
        if name not in known:
            raise InputError(f"{name} is an option neither of this picture nor of matplotlib's lines")
    return named


def refuse_size(figsize: Size | None) -> None:
    """No size for axes that are given."""
    if figsize is not None:
        raise InputError("figsize is the size of a new figure; with ax leave it out, and set it where the figure is made")
