"""What is asked of a body about its motion."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, TypeAlias, overload

import numpy as np
import numpy.typing as npt

from .chaos import ChaosMap, point
from .errors import InputError
from .exact import Number
from .given import Given
from .motion import Motion
from .periodic import PeriodicFamily, PeriodicOrbits, families
from .proved import ProvedMotion
from .records import ChaosPoint
from .section import Section

Triple: TypeAlias = Sequence[Number] | npt.NDArray[np.floating[Any] | np.integer[Any]]
"""Three numbers."""

Window: TypeAlias = Sequence[Sequence[float]] | npt.NDArray[np.float64]
"""Ranges of h and of l."""


class Motions(Given):
    """Sections and motions."""

    __slots__ = ()

    def section(
        self,
        h: Number,
        l: Number,
        orbits: int = 24,
        crossings: int = 500,
        seed: int = 0,
        *,
        starts: Any = None,
        max_time: float | None = None,
        condition: Literal["height", "angular-momentum"] = "height",
        tolerance: float = 1e-15,
        chaos: bool = True,
        threads: int | None = None,
    ) -> Section:
        """The Poincaré section S = d⟨γ, r⟩/dt = 0 at one point (h, l).

        Parameters
        ----------
        h, l : number
            Energy and vertical angular momentum, off the curves of the bifurcation diagram. The section at −l is the mirror
            image of that at l, with time reversed: (γ, l, t) → (γ, −l, −t), and the sheets exchanged.
        orbits : int
            Number of orbits, distributed evenly over all components of the section.
        crossings : int
            Crossings of each orbit, in both directions.
        seed : int
            Selects another set of starting points.
        starts : array (n, 3), optional
            ``theta, psi, sheet`` of n starting points on the PP-torus, as in the columns of a `Section`, instead of
            `orbits` evenly distributed ones.
        max_time : float, optional
            Stop each orbit at this time even if it has fewer crossings.
        condition : {"height", "angular-momentum"}
            The section condition: S = d⟨γ, r⟩/dt = ⟨ω, r × γ⟩, or S = ⟨l, γ × r⟩ = −½ d⟨l, l⟩/dt.
        tolerance : float
            Error of a step relative to the size of the motion.
        chaos : bool
            Compute verdict, Lyapunov exponent and rotation number of each orbit. Without them a section usually takes less
            than half of the time, and every verdict is ``"open"``.
        threads : int, optional
            As of all questions: `Body`.
        """
        return Section._compute(
            self._exactly(), h, l, orbits, crossings, seed, starts, max_time, condition, tolerance, chaos, threads
        )

    @overload
    def orbit(
        self,
        gamma: npt.ArrayLike,
        l: npt.ArrayLike | None = None,
        t: npt.ArrayLike = 10.0,
        *,
        omega: npt.ArrayLike | None = None,
        phi: float = 0.0,
        tolerance: float = 1e-15,
        proved: Literal[False] = False,
    ) -> Motion: ...

    @overload
    def orbit(
        self,
        gamma: Triple,
        l: Triple | None = None,
        t: npt.ArrayLike = 10.0,
        *,
        omega: Triple | None = None,
        phi: Number = 0.0,
        proved: Literal[True],
        digits: int | None = None,
        bound: float = 1e-10,
    ) -> ProvedMotion: ...

    def orbit(
        self,
        gamma: Any,
        l: Any = None,
        t: Any = 10.0,
        *,
        omega: Any = None,
        phi: Any = 0.0,
        tolerance: float | None = None,
        proved: bool = False,
        digits: int | None = None,
        bound: float | None = None,
    ) -> Motion | ProvedMotion:
        """The motion in space from a state at time 0; with ``proved=True`` intervals that are proved to hold it.

        The equations are dγ/dt = γ × ω and dl/dt = l × ω − γ × r with ω = A⁻¹ l; the page "Conventions" has the frames.

        Parameters
        ----------
        gamma : three numbers, or array (…, 3) of many starts
            The downward vertical in the body's axes at time 0; its length does not matter.
        l : three numbers, or array (…, 3)
            Angular momentum in the body's axes at time 0. It broadcasts against `gamma`.
        t : array of float, or float
            Times in non-decreasing order; negative ones lie in the past. A single number t means 201 equidistant times
            from 0 to t, or from t to 0 if it is negative; 0 means only that time.
        omega : three numbers, or array (…, 3), optional
            Angular velocity in the body's axes at time 0, instead of `l`.
        phi : number
            Euler's angle φ at time 0: the rotation about the vertical, which γ does not determine.
        tolerance : float, optional
            Error of a step relative to the size of the motion, by default 1e-15; not with a proof.
        proved : bool
            Enclose the motion; numbers are then taken exactly, as those of a body are.
        digits : int, optional
            Digits of the proof's arithmetic, from 5 to 250; by default as many as are needed.
        bound : float, optional
            The widest interval wanted, by default 1e-10: the proof ends where the motion cannot be told so well.

        Returns
        -------
        Motion or ProvedMotion
            Of many starts one table, whose column ``orbit`` is the place of the start; a proof takes one at a time.
        """
        if not proved:
            if digits is not None or bound is not None:
                raise InputError("digits and bound are those of a proof; give proved=True with them")
            error = 1e-15 if tolerance is None else tolerance
            return Motion._compute(self._exactly(), gamma, l, omega, t, phi, error)
        if tolerance is not None:
            raise InputError("a proof has no tolerance; give bound, the widest interval wanted")
        if max(np.ndim(gamma), np.ndim(l), np.ndim(omega)) > 1:
            raise InputError("a proof takes one start at a time; call orbit for each")
        widest = 1e-10 if bound is None else bound
        return ProvedMotion._compute(self._exactly(), gamma, l, omega, t, phi, digits, widest)

    @overload
    def chaos(
        self,
        h: Number,
        l: Number,
        *,
        error: float = 0.03,
        steps: int = 20_480,
        seed: int = 0,
        threads: int | None = None,
    ) -> ChaosPoint: ...

    @overload
    def chaos(
        self,
        *,
        window: Window | None = None,
        cells: int | tuple[int, int] = (200, 200),
        error: float = 0.03,
        steps: int = 20_480,
        seed: int = 0,
        threads: int | None = None,
    ) -> ChaosMap: ...

    def chaos(
        self,
        h: Number | None = None,
        l: Number | None = None,
        *,
        window: Window | None = None,
        cells: int | tuple[int, int] | None = None,
        error: float = 0.03,
        steps: int = 20_480,
        seed: int = 0,
        threads: int | None = None,
    ) -> ChaosPoint | ChaosMap:
        """The share of the energy surface that is chaotic, in Liouville measure: at one point, or over a window.

        Orbits start at random, as the invariant measure of the energy surface has it, and each is followed until it is
        known to be regular or chaotic.

        Parameters
        ----------
        h, l : number, optional
            A point off the curves of the diagram; without them a map is made.
        window : pair of ranges, optional
            The part of the plane that is mapped, ``(h0, h1), (l0, l1)``; by default that of the diagram.
        cells : int or (int, int), optional
            Cells of the map along h and along l, by default 200 each.
        error : float
            Standard deviation that is wanted of each share.
        steps : int
            Steps of the integrator after which an orbit stays open.
        seed : int
            Another choice of the orbits, equally spread.
        threads : int, optional
            As of all questions: `Body`.
        """
        if h is not None and l is not None:
            if window is not None or cells is not None:
                raise InputError("window and cells are those of a map; leave them out, or h and l")
            return point(self._exactly(), h, l, error, steps, seed, threads)
        if h is not None or l is not None:
            raise InputError("one of h and l is missing: give both for a point, neither for a map")
        counts = (200, 200) if cells is None else cells
        return ChaosMap._compute(self._exactly(), window, counts, error, steps, seed, threads)

    def periodic_orbits(self, h: Number, l: Number, crossings: int = 2, *, threads: int | None = None) -> PeriodicOrbits:
        """Every periodic orbit at one point with few crossings of the section P.

        They are found from cells that cover P, with an index for each, and proved one by one.

        Parameters
        ----------
        h, l : number
            Energy and vertical angular momentum, off the curves of the diagram.
        crossings : int
            The most crossings of P in a period, inward and outward: 2, 4, … 24.
        threads : int, optional
            As of all questions: `Body`.
        """
        return PeriodicOrbits._compute(self._exactly(), h, l, crossings, threads)

    def periodic_families(
        self,
        *,
        l: Number | None = None,
        h: Number | None = None,
        curve: str | None = None,
        members: int = 200,
        branches: bool = False,
    ) -> tuple[PeriodicFamily, ...]:
        """The families of periodic orbits that begin at relative equilibria, one from each imaginary pair of eigenvalues.

        Parameters
        ----------
        l, h : number
            Vertical angular momentum or energy, whichever all orbits have; just one of the two.
        curve : str, optional
            Only from equilibria on this curve of the diagram, such as ``"G2.1"``.
        members : int
            The most orbits of a family.
        branches : bool
            Follow the families that begin at doublings and crossings too.
        """
        return families(self._exactly(), h, l, curve, members, branches)
