"""Maps of bodies."""

import warnings
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ..errors import BodyWarning, RangeError
from .axes import Size, axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..atlas import Atlas
    from ..body import Body


def plane(
    body_at: Callable[[float, float], "Body | None"],
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    ax: "Axes | None" = None,
    *,
    figsize: Size | None = None,
    value: Callable[["Atlas"], float | str] = lambda atlas: len(atlas.regions),
    **mesh: Any,
) -> "Axes":
    """A map of bodies: something of the atlas of each body of a plane, by default the number of its regions.

    Parameters
    ----------
    body_at : function of two floats
        The body at a place; None where there is none, or where none is wanted. Bodies that cannot exist are mapped
        without a warning; `Body.physical` tells them.
    x, y : array (n,), array (m,)
        The places.
    ax : Axes, optional
        Where; None makes a new figure.
    figsize : pair of float, optional
        Width and height of a new figure in inches.
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
    ax = axes(ax, figsize)
    across, up = np.asarray(x, dtype=float), np.asarray(y, dtype=float)

    def found(place: float, height: float) -> float | str | None:
        try:
            given = body_at(place, height)
            return None if given is None else value(given.atlas())
        except RangeError:
            return None

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", BodyWarning)
        values = [[found(float(place), float(height)) for place in across] for height in up]
    texts = sorted({cell for row in values for cell in row if isinstance(cell, str)})
    numbers = [[np.nan if v is None else texts.index(v) if isinstance(v, str) else v for v in row] for row in values]
    style: dict[str, Any] = {"cmap": "viridis"} | mesh
    image = ax.pcolormesh(across, up, np.array(numbers, dtype=float), **style)
    bar = ax.figure.colorbar(image, ax=ax)
    if texts:
        bar.set_ticks(range(len(texts)), labels=texts)
    return ax
