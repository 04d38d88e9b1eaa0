"""What is asked of a body about its steady rotations and its (h, l) plane."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, cast

from . import exact, pictures
from .atlas import Atlas
from .command import command
from .critical import Equilibria
from .critical_spins import CriticalSpins
from .exact import Number
from .given import Given
from .records import Classification

if TYPE_CHECKING:
    from .body import Body

Accuracy: TypeAlias = Literal["exact", "fast"]
"""Levels of accuracy."""

Axis: TypeAlias = Literal["x", "y", "z"] | Iterable[Number]
"""An axis of a part."""


class Diagrams(Given):
    """Atlas, classification, steady rotations."""

    __slots__ = ()

    def atlas(self, accuracy: Accuracy = "exact", *, certificate: bool = False) -> Atlas:
        """Every region of the (h, l) plane, with its topology.

        Parameters
        ----------
        accuracy : {"exact", "fast"}
            ``"exact"`` decides everything; ``"fast"`` is floating point with error bounds, and may leave points undecided.
        certificate : bool
            Prove the whole diagram and include in the document what `bifdiag.verify` needs to check it, like ``bifdiag
            --certificate``. Making the atlas then takes far longer, usually some milliseconds, and `to_json` up to about
            twice as long.
        """
        self._exactly()
        return Atlas(cast("Body", self), accuracy, certificate=certificate)

    def classify(self, h: Number, l: Number, accuracy: Accuracy = "exact") -> Classification:
        """The type of U, E and P at one point.

        Parameters
        ----------
        h, l : number
            Energy and vertical angular momentum; scalars only; `Atlas.region` takes arrays. Everything depends only on l²,
            so the sign of l does not matter.
        accuracy : {"exact", "fast"}
            As in `atlas`.
        """
        document = self._exactly().classify(exact.text(h, "h"), exact.text(l, "l"), accuracy)
        return Classification._of(json.loads(document))

    def critical(self, l: Any, *, threads: int | None = None, invalid: Literal["mark", "raise"] = "mark") -> Equilibria:
        """All relative equilibria, as a table.

        Parameters
        ----------
        l : number, or array of them
            Vertical angular momentum. At −l the same equilibria rotate in the opposite direction; at l = 0 the body is
            at rest: hanging or standing, or without weight in any orientation.
        threads : int, optional
            As of all questions: `Body`.
        invalid : {"mark", "raise"}
            What becomes of an entry of an array of floats that is NaN, masked, infinite, or beyond 1e±150: it has no row,
            and ``meta["invalid"]`` its place; or an error names it. A text, Decimal, Fraction or int that is no number in
            range is always an error.

        Returns
        -------
        Equilibria
            A row for each, by increasing h, in radians per unit of time. For an array of l the column ``l_index`` is the
            position in ``np.ravel(l)``; an index of pandas, and dimensions and coordinates of xarray are kept.
        """
        return Equilibria._compute(self._exactly(), l, threads, invalid)

    def critical_spin(self, axis: Axis | None = None, *, tolerance: str | None = None) -> CriticalSpins:
        """The spins at which a steady rotation begins or changes its stability, or about a permanent axis its region, like
        ``bifdiag critical-spin``.

        It is the question for parts whose numbers are known to within so much only, as ``"1.2±0.01"``: bounds hold for
        every part within them.

        Parameters
        ----------
        axis : {"x", "y", "z"} or three numbers, optional
            An axis in the frame of the part; None: all axes about which it can turn steadily, with ± or a tolerance the
            one that is permanent at every spin, if there is one alone.
        tolerance : str, optional
            Such as ``"1%"``: of the moments and the weight, in place of ± on single numbers.

        Returns
        -------
        CriticalSpins
            A row for each spin. ``found.ranges`` are the spins between them with stability, ``found.bounds`` what ± does;
            ``found.meta`` is the document of ``bifdiag critical-spin --json``.
        """
        arguments = ["critical-spin", "--json", *self._options()]
        if axis is not None:
            arguments.append(f"--axis={axis if isinstance(axis, str) else ','.join(exact.triple(axis, 'axis'))}")
        if tolerance is not None:
            arguments.append(f"--tolerance={tolerance}")
        return CriticalSpins._of(command(*arguments))

    def plot(self, ax: Any = None, **options: Any) -> Any:
        """Draws the body with matplotlib: its ellipsoid of inertia and its centre of mass; see `bifdiag.pictures.body`."""
        return pictures.body(cast("Body", self), ax, **options)

    def plot_sphere(self, h: float, l: float, ax: Any = None, **options: Any) -> Any:
        """Draws U at one point (h, l) on the Poisson sphere with matplotlib; see `bifdiag.pictures.sphere`."""
        return pictures.sphere(cast("Body", self), h, l, ax, **options)
