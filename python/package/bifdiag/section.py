"""Poincaré sections."""

import math
from collections import Counter
from typing import Any, ClassVar, Literal

import numpy as np
import numpy.typing as npt

from . import _core, exact, pictures
from .behaviour import table
from .errors import InputError
from .exact import Number
from .pictures.section import thumbnail
from .tables import StoredTable

ORBITS, CROSSINGS = 10**6, 2**31 - 1
"""The most orbits and crossings."""


class Section(StoredTable):
    """A Poincaré section: a row for each crossing, in the order of the orbits; made by `Body.section`.

    It contains the states with energy h and momentum l at which S = d⟨γ, r⟩/dt vanishes, that is, at which the centre of
    mass is highest or lowest. The page "Conventions" defines the symbols.

    Attributes
    ----------
    orbit, index : array (n,) of int
        Number of the orbit, and of the crossing; `index` 0 is the start itself, where it lies on
        this section, as it does on the paper's.
    time : array (n,)
        Time since the start.
    gamma, l : array (n, 3)
        The downward vertical γ and the angular momentum, in the body's axes.
    sheet : array (n,) of int
        +1 on the half T⁺ of the PP-torus, where Δ = ⟨ω × γ, A⁻¹(γ × r)⟩ > 0, −1 on T⁻, where Δ < 0. Over each γ
        inside U but ±r̂ lie two states of the section, one on each sheet.
    s_dot : array (n,)
        dS/dt: negative where the crossing is incoming (centre of mass lowest), positive where outgoing. With
        ``condition="angular-momentum"`` S is ⟨l, γ × r⟩, which vanishes where ``|l|`` is extremal.
    theta, psi : array (n,)
        ϑ′ in [0, π] and ψ′ in [0, 2π), the point on the PP-torus: ϑ′ is the angle between γ and r, ψ′ the longitude about
        r. These are not the Euler angles ``theta`` and ``psi`` of a `Motion`.
    lyapunov : array (n,)
        Lyapunov exponent of the row's orbit, one number for each orbit; NaN where there is none; not with ``chaos=False``.
    rotation : array (n,)
        Rotation number of the row's orbit under the return map to the incoming half, in turns per return, reduced to [0,
        1/2]; NaN where the crossings do not follow a closed curve in order (chaos, or too few returns). For a chain of q
        islands visited in turn it is exactly p/q; the rotation within an island is not measured. In this case
        ``meta["orbits"][k]["chaos"]["rotation"]`` has ``"angle"`` equal to ``"islands"``, with their number
        ``"islands"``.
    exponent : array (n,)
        λ(t), the Lyapunov exponent up to this crossing; NaN at the start.
    meta : dict
        The document of ``bifdiag section --json``: body, point, parameters, and of each orbit its start, end, drift of the
        integrals, verdict and measures.
    """

    orbit: npt.NDArray[np.int32]
    index: npt.NDArray[np.int32]
    time: npt.NDArray[np.float64]
    gamma: npt.NDArray[np.float64]
    l: npt.NDArray[np.float64]
    sheet: npt.NDArray[np.int8]
    s_dot: npt.NDArray[np.float64]
    theta: npt.NDArray[np.float64]
    psi: npt.NDArray[np.float64]
    lyapunov: npt.NDArray[np.float64]
    rotation: npt.NDArray[np.float64]
    exponent: npt.NDArray[np.float64]

    NAMES = ("orbit", "index", "time", "gamma", "l", "sheet", "s_dot", "theta", "psi")
    KIND: ClassVar[str] = "section"

    @classmethod
    def _compute(
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
        """The names of the section's surfaces joined by ``+``; None if they are not those of the region."""
        signature: str | None = self.meta["signature"]
        return signature

    @property
    def verdict(self) -> tuple[str, ...]:
        """``"regular"``, ``"chaotic"`` or ``"open"`` for each orbit; `reason` explains it.

        Chaotic is not unstable: an unstable periodic orbit is not chaotic.
        """
        return tuple(orbit["verdict"] for orbit in self.meta["orbits"])

    @property
    def reason(self) -> tuple[str, ...]:
        """The reason for the verdict of each orbit."""
        return tuple(orbit["reason"] for orbit in self.meta["orbits"])

    def plot(self, ax: Any = None, projection: Literal["torus", "sphere"] = "torus", **options: Any) -> Any:
        """Draws the section with matplotlib.

        Parameters
        ----------
        ax : pair of Axes, optional
            One for each sheet; None makes a new figure. A single one with ``sheet=1`` or ``sheet=-1``.
        projection : {"torus", "sphere"}
            The PP-torus, or the Poisson sphere.
        **options
            As `bifdiag.pictures.section` takes them: ``color``, ``sheet`` and whatever ``Axes.scatter`` knows.

        Returns
        -------
        array of two Axes, or of one

        Raises
        ------
        InputError
            If a projection or colour is unknown, or the number of axes differs from that of the sheets.
        ImportError
            If matplotlib is missing; ``bifdiag[plot]`` installs it.
        """
        return pictures.section(self, ax, projection, **options)

    def _repr_html_(self) -> str:
        verdicts = Counter(self.verdict)
        return thumbnail(self) + table(
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
    exact.unmasked(values, "starts")
    array: npt.NDArray[np.float64] = np.asarray(values, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 3 or not np.isfinite(array).all():
        raise InputError(f"starts has the shape {array.shape}; rows of finite theta, psi, sheet are needed")
    for theta, _, sheet in array:
        if not 0 <= theta <= math.pi:
            raise InputError(f"starts: theta = {theta} is the angle between gamma and r, from 0 to pi")
        if sheet not in (-1, 1):
            raise InputError(f"starts: sheet = {sheet} is neither 1 nor -1")
    return [(float(theta), float(psi), int(sheet)) for theta, psi, sheet in array]
