"""Bodies."""

import json
from collections.abc import Iterable
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core, exact
from .atlas import Atlas
from .critical import equilibria
from .exact import Number
from .motion import Motion
from .records import Classification, table
from .section import Section


class Body:
    """A heavy rigid body with a fixed point, exact.

    Parameters
    ----------
    A : three numbers
        Principal moments of inertia about the fixed point, A_i > 0.
    r : three numbers
        Centre of mass in the principal axes, times mass and g.

    Raises
    ------
    BodyError
        If a moment is not positive.
    InputError
        If something is no number.

    Notes
    -----
    An int, a str, a Fraction and a Decimal are taken as they are, a float as its shortest decimal: ``1.1`` and ``"11/10"``
    are the same number. Units are those of A and r: with U = l²/(2J) − ⟨γ, r⟩, h has the unit of r, and l that of √(A r).

    Examples
    --------
    >>> import bifdiag
    >>> body = bifdiag.Body(A=[2, "11/10", 1], r=[0.94868, 0, 0.61623])
    >>> body
    Body(A=[2, 11/10, 1], r=[0.94868, 0, 0.61623])
    >>> body.classify(3.8, 3.25).signature
    'S2+T2'
    """

    __slots__ = ("_inner",)
    _inner: _core.Body

    def __init__(self, A: Iterable[Number], r: Iterable[Number]) -> None:
        self._inner = _core.Body(exact.triple(A, "A"), exact.triple(r, "r"))

    @classmethod
    def preset(cls, name: str) -> "Body":
        """A named body.

        Parameters
        ----------
        name : str
            ``"paper"``, ``"kovalevskaya"``, ``"lagrange"``, ``"euler"``, ``"katok:1"`` … ``"katok:7"``, …

        Raises
        ------
        InputError
            If there is none of this name; the message lists those that there are.

        Examples
        --------
        >>> import bifdiag
        >>> bifdiag.Body.preset("kovalevskaya")
        Body(A=[2, 2, 1], r=[1, 0, 0])
        """
        body = cls.__new__(cls)
        body._inner = _core.Body.preset(name)
        return body

    @property
    def A(self) -> tuple[str, str, str]:
        """The principal moments as they were given."""
        first, second, third = self._inner.moments
        return first, second, third

    @property
    def r(self) -> tuple[str, str, str]:
        """The centre of mass as it was given."""
        first, second, third = self._inner.center
        return first, second, third

    def atlas(self, accuracy: str = "exact") -> Atlas:
        """Every region of the (h, l) plane, with its topology.

        Parameters
        ----------
        accuracy : {"exact", "fast"}
            ``"exact"`` decides everything; ``"fast"`` is floating point with error bounds, and may leave points undecided.

        Returns
        -------
        Atlas

        Raises
        ------
        RangeError
            If the atlas of this body cannot be computed.

        Examples
        --------
        >>> import bifdiag
        >>> atlas = bifdiag.Body.preset("paper").atlas()
        >>> len(atlas.regions)
        9
        """
        return Atlas(self, accuracy)

    def classify(self, h: Number, l: Number, accuracy: str = "exact") -> Classification:
        """The type of U, E and P at one point.

        Parameters
        ----------
        h, l : number
            Energy and vertical angular momentum; scalars only. `Atlas.region` takes arrays.
        accuracy : {"exact", "fast"}
            As in `atlas`.

        Returns
        -------
        Classification

        Raises
        ------
        InputError
            If h or l is no finite number.
        RangeError
            If the point cannot be answered.

        Examples
        --------
        >>> import bifdiag
        >>> bifdiag.Body.preset("kovalevskaya").classify(2, 2).status
        'critical'
        """
        document = self._inner.classify(exact.text(h, "h"), exact.text(l, "l"), accuracy)
        return Classification.of(json.loads(document))

    def critical(self, l: Any) -> npt.NDArray[np.void]:
        """All relative equilibria.

        Parameters
        ----------
        l : number, or array of them
            Vertical angular momentum.

        Returns
        -------
        structured array
            A row for each relative equilibrium, by rising h, with the fields ``l``, ``h``, ``gamma`` (3), ``omega``,
            ``index``, ``multiplicity`` (``"1"``, ``"2"``, ``"circle"``, ``"sphere"``), ``stability``, ``stable``
            (``"energy"``, ``"integral"``, ``"spectrum"``, ``"false"``, ``"null"``), ``eigenvalues`` (2, complex),
            ``eigenvalue_error``, ``branch`` and ``branch_name``. For an array of l there is the further field
            ``l_index``, the position in ``np.ravel(l)``.

        Raises
        ------
        InputError
            If some l is no finite number.

        Examples
        --------
        >>> import bifdiag
        >>> found = bifdiag.Body.preset("paper").critical("3.25")
        >>> found["index"]
        array([0, 0, 1, 1, 2, 2], dtype=int8)
        """
        return equilibria(self._inner, l)

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
        condition: str = "height",
        tolerance: float = 1e-15,
        chaos: bool = True,
        threads: int | None = None,
    ) -> Section:
        """The Poincaré section S = d/dt ⟨γ, r⟩ = 0 at one point (h, l).

        Parameters
        ----------
        h, l : number
            Energy and vertical angular momentum, off the curves of the bifurcation diagram.
        orbits : int
            Number of orbits, spread evenly over all components of the section.
        crossings : int
            Crossings of each orbit.
        seed : int
            Another choice of the starting points.
        starts : array (n, 3), optional
            ``theta, psi, sheet`` of n starting points, instead of `orbits` spread ones.
        max_time : float, optional
            Stop each orbit at this time even if it has fewer crossings.
        condition : {"height", "angular-momentum"}
            What vanishes: d/dt ⟨γ, r⟩, or ⟨l, γ × r⟩.
        tolerance : float
            Error of a step relative to the size of the motion.
        chaos : bool
            Compute verdict, Lyapunov exponent and rotation number of each orbit. Without them a section takes a quarter
            of the time, and every verdict is ``"open"``.
        threads : int, optional
            None: one; 0: as many as there are cores. The result does not depend on it.

        Returns
        -------
        Section

        Raises
        ------
        InputError
            If (h, l) is forbidden or on a curve, or r = 0.
        RangeError
            If the section cannot be computed.

        Examples
        --------
        >>> import bifdiag
        >>> section = bifdiag.Body.preset("paper").section(3.8, 3.25, orbits=4, crossings=10)
        >>> section.gamma.shape
        (44, 3)
        """
        return Section.compute(
            self._inner, h, l, orbits, crossings, seed, starts, max_time, condition, tolerance, chaos, threads
        )

    def orbit(
        self,
        gamma: npt.ArrayLike,
        l: npt.ArrayLike | None = None,
        t: npt.ArrayLike = 10.0,
        *,
        omega: npt.ArrayLike | None = None,
        phi: float = 0.0,
        tolerance: float = 1e-15,
    ) -> Motion:
        """The motion in space from a state at time 0.

        Parameters
        ----------
        gamma : three floats
            The vertical in the body's axes; its length does not matter.
        l : three floats
            Angular momentum in the body's axes.
        t : array of float, or float
            Times, rising; negative ones lie in the past. A single number t stands for 201 times from 0 to t.
        omega : three floats, optional
            Angular velocity in the body's axes, instead of `l`.
        phi : float
            Euler's angle φ at the start.
        tolerance : float
            Error of a step relative to the size of the motion.

        Returns
        -------
        Motion

        Raises
        ------
        InputError
            For states and times that are none.
        RangeError
            If the integrator cannot go on.

        Examples
        --------
        >>> import bifdiag
        >>> motion = bifdiag.Body.preset("paper").orbit(gamma=[0.6, 0, 0.8], omega=[1, 0.3, 1], t=[0, 1, 2])
        >>> motion.quaternion.shape
        (3, 4)
        """
        return Motion.compute(self._inner, gamma, l, omega, t, phi, tolerance)

    # Equal bodies have equal numbers, whatever their texts.
    def __eq__(self, other: object) -> bool:
        return isinstance(other, Body) and self._inner.values() == other._inner.values()

    def __hash__(self) -> int:
        return hash(tuple(self._inner.values()))

    def __reduce__(self) -> tuple[type["Body"], tuple[tuple[str, ...], tuple[str, ...]]]:
        return Body, (self.A, self.r)

    def __repr__(self) -> str:
        return f"Body(A=[{', '.join(self.A)}], r=[{', '.join(self.r)}])"

    def _repr_html_(self) -> str:
        return table([("A", ", ".join(self.A)), ("r", ", ".join(self.r))])
