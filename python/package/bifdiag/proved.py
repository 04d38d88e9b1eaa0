"""Motions with proved bounds."""

import json
from typing import Any, ClassVar, Literal

import numpy as np
import numpy.typing as npt

from . import _core, exact
from .errors import InputError
from .exact import Number
from .tables import StoredTable
from .times import span, times

Ends = npt.NDArray[np.float64]


class ProvedMotion(StoredTable):
    """Enclosures of a motion, a row for each time; made by ``Body.orbit(..., proved=True)``.

    The exact motion from exactly the numbers that were given lies between the lower and the upper ends: a theorem with its
    hypotheses checked in interval arithmetic, not an estimate. Frames and signs are those of `Motion`.

    Attributes
    ----------
    time : array (n,)
        Times. Where the proof did not reach all that were asked for, `complete` is False and `why` says how it goes
        further.
    gamma_lo, gamma_hi, omega_lo, omega_hi : array (n, 3)
        Ends of γ and ω, doubles rounded outward; `gamma` and `omega` hold both.
    rotation1_lo, … rotation3_hi : array (n, 3)
        Ends of the rows of the matrix that takes vectors from the body frame to space; `rotation` holds all.
    attitude_lo, attitude_hi : array (n, 4)
        Ends of the quaternion w, x, y, z, continuous in time; `quaternion` holds both.
    meta : dict
        The document of ``bifdiag orbit --proved --json`` without the enclosures: ``start``, ``widest``, ``proved_to``,
        ``proved_from``, ``bits``, ``steps``, ``complete``, ``notes``.
    """

    time: npt.NDArray[np.float64]
    gamma_lo: npt.NDArray[np.float64]
    gamma_hi: npt.NDArray[np.float64]
    omega_lo: npt.NDArray[np.float64]
    omega_hi: npt.NDArray[np.float64]
    rotation1_lo: npt.NDArray[np.float64]
    rotation1_hi: npt.NDArray[np.float64]
    rotation2_lo: npt.NDArray[np.float64]
    rotation2_hi: npt.NDArray[np.float64]
    rotation3_lo: npt.NDArray[np.float64]
    rotation3_hi: npt.NDArray[np.float64]
    attitude_lo: npt.NDArray[np.float64]
    attitude_hi: npt.NDArray[np.float64]

    NAMES = (
        "time",
        *(f"{name}_{end}" for name in ("gamma", "omega", "rotation1", "rotation2", "rotation3") for end in ("lo", "hi")),
        "attitude_lo",
        "attitude_hi",
    )
    SELECTS: ClassVar[bool] = False
    KIND: ClassVar[str] = "proved motion"

    def __init__(self, columns: dict[str, npt.NDArray[Any]], meta: str, decimals: str = "null") -> None:
        super().__init__(columns, meta)
        self._decimals = decimals

    @classmethod
    def _compute(
        cls,
        body: _core.Body,
        gamma: Any,
        l: Any,
        omega: Any,
        t: Any,
        phi: Number,
        digits: int | None,
        bound: float,
    ) -> "ProvedMotion":
        vertical = exact.triple(_listed(gamma), "gamma")
        if not any(map(exact.value, vertical)):
            raise InputError("gamma = 0 is no direction")
        if (l is None) == (omega is None):
            raise InputError("give either l, the angular momentum, or omega, the angular velocity")
        name, turning = ("l", l) if omega is None else ("omega", omega)
        wanted = exact.real(bound, "bound")
        if not 1e-140 <= wanted <= 1:
            raise InputError(f"bound = {bound}: the widest interval wanted is from 1e-140 to 1, such as 1e-12")
        wanted_times = times(t)
        request = {
            "gamma": vertical,
            "l": exact.triple(_listed(turning), name),
            "is_omega": omega is not None,
            "phi": exact.text(phi, "phi"),
            "times": wanted_times.tolist(),
            "span": span(wanted_times),
            "digits": None if digits is None else exact.whole(digits, "digits", 5, 250),
            "bound": wanted,
        }
        columns = _core.proved_motion(body, request)
        meta, decimals = columns.pop("meta"), columns.pop("decimals")
        return cls(columns, meta, decimals)

    @property
    def gamma(self) -> Ends:
        """Lower and upper ends of γ: (n, 3, 2)."""
        return self._ends("gamma")

    @property
    def omega(self) -> Ends:
        """Lower and upper ends of ω: (n, 3, 2)."""
        return self._ends("omega")

    @property
    def rotation(self) -> Ends:
        """Lower and upper ends of the matrix from the body frame to space: (n, 3, 3, 2)."""
        return np.stack([self._ends(f"rotation{row}") for row in (1, 2, 3)], axis=1)

    @property
    def quaternion(self) -> Ends:
        """Lower and upper ends of the quaternion w, x, y, z: (n, 4, 2)."""
        return self._ends("attitude")

    def _ends(self, name: str) -> Ends:
        return np.stack([self[f"{name}_lo"], self[f"{name}_hi"]], axis=-1)

    @property
    def widest(self) -> float:
        """The widest enclosure of all, rounded up; in the columns the ends are rounded outward, so it is a little wider."""
        widest: float = self.meta["widest"]
        return widest

    @property
    def proved(self) -> tuple[float, float]:
        """From when to when every enclosure is within the bound; the first is 0 or in the past."""
        return self.meta["proved_from"], self.meta["proved_to"]

    @property
    def complete(self) -> bool:
        """Whether all times are enclosed."""
        complete: bool = self.meta["complete"]
        return complete

    @property
    def why(self) -> str | None:
        """Where the proof ended and what goes further; None if it is complete."""
        return "; ".join(self.meta.get("notes", [])) or None

    @property
    def decimals(self) -> dict[Literal["gamma", "omega", "rotation", "quaternion"], list[list[list[str]]]] | None:
        """The ends as decimals with all the digits that are proved, as the command prints them; None of a file.

        ``decimals["gamma"][k][i]`` are the two ends of the i-th component at the k-th time; the rotation has nine
        components, by rows.
        """
        found: dict[Any, Any] | None = json.loads(self._decimals)
        return found

    def contains(self, name: Literal["gamma", "omega", "rotation", "quaternion"], values: npt.ArrayLike) -> Any:
        """Whether values lie within the ends, one answer for each time: a test of another program.

        Parameters
        ----------
        name : {"gamma", "omega", "rotation", "quaternion"}
            What the values are.
        values : array
            In the shape of that attribute without its last axis.
        """
        ends: Ends = getattr(self, name)
        found = np.asarray(values, dtype=np.float64)
        if found.shape != ends.shape[:-1]:
            raise InputError(f"values have the shape {found.shape}; {ends.shape[:-1]} is needed")
        inside = (ends[..., 0] <= found) & (found <= ends[..., 1])
        return inside.reshape(len(inside), -1).all(axis=1)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._columns, self._meta, self._decimals)

    def __repr__(self) -> str:
        start, end = self.proved
        told = "complete" if self.complete else "not complete"
        return f"ProvedMotion of {len(self)} times, proved from {start:g} to {end:g} within {self.widest:.2g} ({told})"


def _listed(values: Any) -> Any:
    """Plain numbers of an array, each of which means its shortest decimal."""
    return values.tolist() if isinstance(values, np.ndarray) else values
