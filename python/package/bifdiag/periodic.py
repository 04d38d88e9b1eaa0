"""Periodic orbits as tables."""

import json
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from . import _core, exact, pictures
from .errors import InputError
from .exact import Number
from .tables import StoredTable


class _Orbits(StoredTable):
    h: npt.NDArray[np.float64]
    l: npt.NDArray[np.float64]
    gamma: npt.NDArray[np.float64]
    omega: npt.NDArray[np.float64]
    period: npt.NDArray[np.float64]
    crossings: npt.NDArray[np.int32]
    multipliers: npt.NDArray[np.complex128]
    stability: npt.NDArray[np.str_]
    action: npt.NDArray[np.float64]
    symmetric: npt.NDArray[np.bool_]
    proved: npt.NDArray[np.bool_]

    NAMES: ClassVar[tuple[str, ...]] = (
        *("h", "l", "gamma", "omega", "period", "crossings", "multipliers"),
        *("stability", "action", "symmetric", "proved"),
    )
    SELECTS: ClassVar[bool] = False


class PeriodicOrbits(_Orbits):
    """Periodic orbits of γ and ω, a row for each; made by `Body.periodic_orbits`.

    Attributes
    ----------
    h, l : array (n,)
        Energy and vertical angular momentum.
    gamma, omega : array (n, 3)
        A point of the orbit, in the body's axes: where the centre of mass is lowest, if it has such a point.
    period : array (n,)
        Period of γ and ω; the body itself need not be back.
    crossings : array (n,) of int
        Crossings of the section P in a period, inward and outward.
    multipliers : array (n, 2) of complex
        The Floquet multipliers beside those that h, l and the flow make 1; their product is 1.
    stability : array (n,) of str
        ``"elliptic"`` (linearly stable), ``"hyperbolic"``, ``"inverse-hyperbolic"`` (unstable), ``"parabolic"`` (not
        decided by the linear terms).
    action : array (n,)
        ∮⟨l, ω⟩ dt over a period.
    symmetric : array (n,) of bool
        Whether a reversor takes the orbit to itself.
    proved : array (n,) of bool
        Whether its existence was proved: ``enclosure`` of the orbit in `meta` then has bounds. The rows are those of
        ``meta["orbits"]`` and, after them, of ``meta["continua"]``.
    continuum : array (n,) of bool
        Whether it stands for a continuum of orbits of one period, such as a resonant torus.
    meta : dict
        The document of ``bifdiag periodic --json``.
    """

    continuum: npt.NDArray[np.bool_]

    NAMES = (*_Orbits.NAMES, "continuum")
    KIND: ClassVar[str] = "list of periodic orbits"

    @classmethod
    def _compute(cls, body: _core.Body, h: Number, l: Number, crossings: int, threads: int | None) -> "PeriodicOrbits":
        most = exact.whole(crossings, "crossings", 2, 24)
        if most % 2:
            raise InputError(
                f"crossings = {crossings}: a periodic orbit crosses P inward as often as outward; 2, 4, … up to 24"
            )
        text = _core.periodic_orbits(body, exact.text(h, "h"), exact.text(l, "l"), most, exact.threads(threads))
        document = json.loads(text)
        orbits, continua = document["orbits"], document["continua"]
        columns = _columns([*orbits, *continua])
        columns["continuum"] = np.arange(len(orbits) + len(continua)) >= len(orbits)
        return cls(columns, text)

    @property
    def complete(self) -> bool:
        """Whether every cell of the section was decided."""
        complete: bool = self.meta["complete"]
        return complete

    @property
    def why(self) -> str:
        """What completeness rests on, or what may be missing."""
        why: str = self.meta["why"]
        return why

    def __repr__(self) -> str:
        told = "complete" if self.complete else "not complete"
        point = f"(h, l) = ({self.meta['h']}, {self.meta['l']})"
        return f"PeriodicOrbits at {point}: {len(self)}, {told} [{', '.join(self.columns)}, meta]"


class PeriodicFamily(_Orbits):
    """A family of periodic orbits, a row for each, from the relative equilibrium on; made by `Body.periodic_families`.

    It has the columns of `PeriodicOrbits`, but for ``continuum``; none of its orbits is proved.

    Attributes
    ----------
    meta : dict
        The family of the document of ``bifdiag periodic family --json`` without its members: ``curve``, ``frequency``,
        ``events``, ``end``, of a branch ``end`` alone; and ``free``, ``"h"`` or ``"l"``, which changes along it.
    """

    KIND: ClassVar[str] = "family of periodic orbits"

    @classmethod
    def _of(cls, document: dict[str, Any], free: str) -> "PeriodicFamily":
        about = {name: value for name, value in document.items() if name != "members"} | {"free": free}
        return cls(_columns(document["members"]), json.dumps(about))

    @property
    def curve(self) -> str | None:
        """The curve of the diagram on which the equilibrium lies where the family begins; None of a branch."""
        curve: str | None = self.meta.get("curve")
        return curve

    @property
    def frequency(self) -> float | None:
        """The frequency of small oscillations about that equilibrium, to which 2π/period tends; None of a branch."""
        frequency: float | None = self.meta.get("frequency")
        return frequency

    @property
    def free(self) -> str:
        """What changes along the family, ``"h"`` or ``"l"``."""
        free: str = self.meta["free"]
        return free

    @property
    def end(self) -> str:
        """How it ends; ``meta["end"]`` has more.

        ``"equilibrium"``, ``"separatrix"``, ``"circle"`` (of equilibria), ``"joined"``, ``"members"`` (so many were asked
        for), ``"lost"`` (without rows where it was not begun); ``"resonant"`` or ``"not-isolated"`` (not begun).
        """
        end: str = self.meta["end"]["kind"]
        return end

    @property
    def events(self) -> list[dict[str, Any]]:
        """Its special orbits.

        Each has ``kind`` (``"fold"``, ``"branch"``, ``"doubling"``, ``"tripling"``), ``after`` (which member), ``h``,
        ``l``, ``period`` and ``error``.
        """
        events: list[dict[str, Any]] = self.meta.get("events", [])
        return [{name: value for name, value in event.items() if name != "branches"} for event in events]

    @property
    def branches(self) -> "list[PeriodicFamily]":
        """The families that begin at its special orbits, if they were followed."""
        found = [branch for event in self.meta.get("events", []) for branch in event["branches"]]
        return [PeriodicFamily._of(branch, self.free) for branch in found]

    def plot(self, ax: Any = None, **options: Any) -> Any:
        """Draws the periods over h or l with matplotlib; see `bifdiag.pictures.family`."""
        return pictures.family(self, ax, **options)

    def __repr__(self) -> str:
        begin = "a branch" if self.curve is None else f"from {self.curve}"
        return f"PeriodicFamily {begin}: {len(self)} orbits, end: {self.end} [{', '.join(self.columns)}, meta]"


def families(
    body: _core.Body, h: Number | None, l: Number | None, curve: str | None, members: int, branches: bool
) -> tuple[PeriodicFamily, ...]:
    """The families from the relative equilibria at one l, or of one energy."""
    if (h is None) == (l is None):
        raise InputError("give either l, which all orbits then have, or h")
    held, value = ("l", exact.text(l, "l")) if h is None else ("h", exact.text(h, "h"))
    most = exact.whole(members, "members", 1, 10**6)
    document = json.loads(_core.periodic_families(body, held, value, curve, most, bool(branches)))
    free = "h" if held == "l" else "l"
    return tuple(PeriodicFamily._of(family, free) for family in document["families"])


def _columns(orbits: list[dict[str, Any]]) -> dict[str, npt.NDArray[Any]]:
    """The columns of orbits of a document."""

    def column(name: str, kind: Any = np.float64) -> npt.NDArray[Any]:
        return np.array([orbit[name] for orbit in orbits], dtype=kind)

    def vectors(name: str, width: int) -> npt.NDArray[np.float64]:
        return column(name).reshape(len(orbits), width)

    pairs = column("multipliers").reshape(len(orbits), 2, 2)
    return {
        "h": column("h"),
        "l": column("l"),
        "gamma": vectors("gamma", 3),
        "omega": vectors("omega", 3),
        "period": column("period"),
        "crossings": column("crossings", np.int32),
        "multipliers": pairs[:, :, 0] + 1j * pairs[:, :, 1],
        "stability": column("stability", np.str_),
        "action": column("action"),
        "symmetric": column("symmetric", np.bool_),
        "proved": column("proved", np.bool_),
    }
