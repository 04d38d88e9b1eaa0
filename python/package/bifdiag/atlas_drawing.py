"""Atlases as pictures: their lines in numbers, with matplotlib, as SVG and as the explorer's page."""

import json
import math
from contextlib import suppress
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np
import numpy.typing as npt

from . import _core, exact, pictures
from .atlas_document import AtlasDocument, Span
from .behaviour import Document, counted
from .errors import InputError, RangeError
from .exact import Number
from .explorer import Explorer

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .atlas import Atlas


class AtlasDrawing(AtlasDocument):
    """What is drawn of an atlas; `Atlas` is one."""

    def _view(self) -> Document:
        """Where the diagram is seen, also of a file without a drawing."""
        source = self._source
        whole = source.traced if source.drawing else json.loads(self._inner.to_json(source.ranges, True, False))
        view: Document = whole["drawing"]["view"]
        return view

    def polyline(self, curve: str, l: Span, *, tolerance: float = 1e-6) -> npt.NDArray[np.float64]:
        """Points of a curve to a given tolerance.

        Parameters
        ----------
        curve : str
            The id of a curve, such as ``"G1.2"`` or ``"P+"``.
        l : (float, float)
            A range of l.
        tolerance : float
            Largest deviation in h of the straight line between neighbours, up to rounding.

        Returns
        -------
        array (n, 2)
            Points [h, l] by increasing l, over the part of the range on which the curve exists; possibly none.

        Raises
        ------
        InputError
            If there is no such curve, the range is invalid, or more than 10⁷ points were needed.

        Examples
        --------
        >>> import bifdiag
        >>> atlas = bifdiag.Body.preset("paper").atlas()
        >>> points = atlas.polyline("G1.2", (2.1, 2.2), tolerance=1e-9)
        >>> len(points) > 100, points[[0, -1], 1].tolist()
        (True, [2.1, 2.2])
        """
        known = {known.id: known for known in self.curves}
        if curve not in known:
            raise InputError(f"curve = {curve!r}: the curves are {', '.join(known)}")
        finest = exact.real(tolerance, "tolerance")
        if finest <= 0:
            raise InputError(f"tolerance = {tolerance}: a positive number is needed")
        span = exact.span(l, "l")
        first, last = known[curve].l_range
        length = min(span[1], last) - max(span[0], first)
        # Far out h = l²/(2A), which needs this many chords.
        if length > 1e7 * math.sqrt(8 * finest * max(self.body.moments)):
            raise InputError(
                f"l = {l}: more than 10 million points at this tolerance; give a larger one, or a smaller range"
            )
        points = self._inner.polyline(curve, span, finest)
        return np.empty((0, 2)) if points is None else points

    def outlines(self, h: Span, l: Span) -> tuple[tuple[npt.NDArray[np.float64], ...], ...]:
        """The regions as polygons within a window, at the resolution of a picture.

        Parameters
        ----------
        h, l : (float, float)
            The window.

        Returns
        -------
        tuple of tuples of arrays (n, 2)
            For each of `regions` its closed outlines of points [h, l]; holes are separate outlines. Corners lie on the
            curves; between them an outline deviates by at most a thousandth of the range of h, except where a curve would
            need more than 256 chords between two events.

        Raises
        ------
        InputError
            If a range is invalid.
        """
        found = self._inner.outlines([exact.span(h, "h"), exact.span(l, "l")])
        return tuple(tuple(outlines) for outlines in found)

    def plot(
        self,
        ax: "Axes | None" = None,
        *,
        figsize: Span | None = None,
        view: Literal["plane", "straight", "auto"] = "plane",
        h: Span | None = None,
        l: Span | None = None,
        regions: bool = True,
        labels: bool = True,
        events: bool | Literal["ids"] = True,
        insets: bool | None = None,
        legend: bool | None = None,
        **line: Any,
    ) -> "Axes":
        """Draws the bifurcation diagram with matplotlib; `bifdiag.pictures.diagram` explains the options."""
        shown: Any = {"regions": regions, "labels": labels, "events": events, "insets": insets, "legend": legend}
        return pictures.diagram(cast("Atlas", self), ax, figsize=figsize, view=view, h=h, l=l, **shown, **line)

    @cached_property
    def _straightened(self) -> _core.Straightened:
        return self._inner.straightened(False)

    def straightened(self, h: npt.ArrayLike, l: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Where points (h, l) lie in ``plot(view="straight")``, whose axes are the unit square.

        Parameters
        ----------
        h, l : array of float
            They are broadcast.

        Returns
        -------
        array (..., 2)
            NaN where there is no motion, and beyond the last l that is shown.

        Raises
        ------
        RangeError
            If the plane cannot be straightened.
        """
        exact.unmasked(h, "h")
        exact.unmasked(l, "l")
        first, second = np.broadcast_arrays(exact.floats(h, "h"), exact.floats(l, "l"))
        flat = [np.ascontiguousarray(array).reshape(-1) for array in (first, second)]
        return self._straightened.positions(*flat).reshape(*first.shape, 2)

    def svg(self) -> str:
        """The command line's picture as SVG."""
        return self._inner.svg()

    def explore(self, h: Number | None = None, l: Number | None = None, *, height: int = 720) -> Explorer:
        """The explorer's page with this body, in a cell of a notebook or at its ``url`` in a browser on this machine.

        Parameters
        ----------
        h, l : number, optional
            The initial point; both or neither.
        height : int
            Height of the cell in pixels.

        Raises
        ------
        InputError
            If one of h and l is missing or not a number.
        BifdiagError
            If the package was built without the page.

        Notes
        -----
        The page is served to this machine only, at ``127.0.0.1``, until the process ends. A notebook on another machine
        can show it if the port in ``url`` is forwarded: ``ssh -L PORT:127.0.0.1:PORT``.
        """
        if (h is None) != (l is None):
            raise InputError("give both h and l, or none of them")
        state = f"A={','.join(self.body.A)}&r={','.join(self.body.r)}"
        if h is not None or l is not None:
            point = exact.text(h, "h"), exact.text(l, "l")
            # It refuses what is no number; a point without an answer can be shown.
            with suppress(RangeError):
                self._inner.place(*point)
            state += f"&h={point[0]}&l={point[1]}"
        return Explorer(state, height)

    def _repr_svg_(self) -> str:
        return self.svg()

    def _repr_html_(self) -> str:
        count = counted(len(self.regions), "region")
        regions = f"<details><summary>{count}</summary>{self.regions._repr_html_()}</details>"
        return f"<div>{self.svg()}{regions}</div>"
