"""Where pictures are drawn."""

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ..optional import needed

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = npt.NDArray[np.float64]


def pyplot() -> Any:
    """Matplotlib's figures."""
    return needed("matplotlib.pyplot", "plot")


def axes(ax: "Axes | None") -> "Axes":
    """The axes that are given, or those of a new figure."""
    if ax is not None:
        return ax
    made: Axes = pyplot().subplots(layout="constrained")[1]
    return made
