"""Poincaré sections."""

import math
from collections import Counter
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core, exact, pictures
from .errors import InputError
from .exact import Number
from .records import table
from .tables import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

ORBITS, CROSSINGS = 10**6, 2**31 - 1
"""The most orbits and crossings."""


class Section(Table):
    """A Poincaré section: a row for each crossing, in the order of the orbits; made by `Body.section`.

    Attributes
    ----------
    orbit, index : array (n,) of int
        Number of the orbit, and of the crossing; `index` 0 is the start itself.
    time : array (n,)
        Time since the start.
    gamma, l : array (n, 3)
        Vertical and angular momentum, in the body's axes.
    sheet : array (n,) of int
        ±1, the sign of Δ.
    s_dot : array (n,)
        dS/dt.
    theta, psi : array (n,)
        The point on the PP-torus.
    lyapunov, rotation : array (n,)
        Lyapunov exponent and rotation number of the row's orbit, NaN where there is none; not with ``chaos=False``.
    exponent : array (n,)
        λ(t), the Lyapunov exponent until then; NaN at the start.
    """

    NAMES = ("orbit", "index", "time", "gamma", "l", "sheet", "s_dot", "theta", "psi")

    @classmethod
    def compute(
        cls,
        body: _core.Body,
        h: Number,
        l: Number,
        orbits: int,
        crossings: int,
        seed: int,
        starts: Any,
        max_time: float | None,
        condition: str,
        tolerance: float,
        chaos: bool,
        threads: int | None,
    ) -> "Section":
        request = {
            "orbits": exact.whole(orbits, "orbits", 1, ORBITS),
            "crossings": exact.whole(crossings, "crossings", 1, CROSSINGS),
            "seed": exact.whole(seed, "seed", 0),
            "starts": None if starts is None else _starts(starts),
            "max_time": math.inf if max_time is None else exact.real(max_time, "max_time"),
            "condition": condition,
            "tolerance": exact.real(tolerance, "tolerance"),
            "chaos": bool(chaos),
        }
        columns = _core.section(body, exact.text(h, "h"), exact.text(l, "l"), request, exact.threads(threads))
        return cls(columns, columns.pop("meta"))

    @property
    def signature(self) -> str | None:
        """The names of the section's surfaces joined by ``+``; None where they are not those of the region."""
        signature: str | None = self.meta["signature"]
        return signature

    @property
    def verdict(self) -> tuple[str, ...]:
        """``"regular"``, ``"chaotic"`` or ``"open"`` for each orbit; `reason` tells why.

        Chaotic is not unstable: an unstable periodic orbit is not chaotic.
        """
        return tuple(orbit["verdict"] for orbit in self.meta["orbits"])

    @property
    def reason(self) -> tuple[str, ...]:
        """Why the verdict of each orbit is what it is."""
        return tuple(orbit["reason"] for orbit in self.meta["orbits"])

    def plot(self, ax: "Axes | None" = None, projection: str = "torus", **options: Any) -> Any:
        """Draws the section with matplotlib.

        Parameters
        ----------
        ax : Axes or pair of them, optional
            Where; None makes a new figure with two axes, one for each sheet.
        projection : {"torus", "sphere"}
            The PP-torus, or the Poisson sphere.
        **options
            As `bifdiag.pictures.section` takes them: `color` and whatever ``Axes.scatter`` knows.

        Returns
        -------
        array of two Axes
        """
        return pictures.section(self, ax, projection, **options)

    def _repr_html_(self) -> str:
        verdicts = Counter(self.verdict)
        return table(
            [
                ("section at (h, l)", f"({self.meta['h']}, {self.meta['l']})"),
                ("surface", self.signature or "not that of the region"),
                ("points", f"{len(self)} of {len(self.meta['orbits'])} orbits"),
                ("orbits", ", ".join(f"{verdicts[name]} {name}" for name in ("regular", "chaotic", "open"))),
            ]
        )

    def __repr__(self) -> str:
        point = f"(h, l) = ({self.meta['h']}, {self.meta['l']})"
        orbits = len(self.meta["orbits"])
        return f"Section at {point}: {len(self)} points of {orbits} orbits [{', '.join(self.columns)}, meta]"


def _starts(values: Any) -> list[tuple[float, float, int]]:
    array: npt.NDArray[np.float64] = np.asarray(values, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 3 or not np.isfinite(array).all():
        raise InputError(f"starts has the shape {array.shape}; rows of finite theta, psi, sheet are needed")
    for theta, _, sheet in array:
        if not 0 <= theta <= math.pi:
            raise InputError(f"starts: theta = {theta} is the angle between gamma and r, from 0 to pi")
        if sheet not in (-1, 1):
            raise InputError(f"starts: sheet = {sheet} is neither 1 nor -1")
    return [(float(theta), float(psi), int(sheet)) for theta, psi, sheet in array]
