"""Bodies."""

import json
import os
import warnings
from collections.abc import Iterable
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core, exact, pictures
from .atlas import Atlas
from .behaviour import table
from .critical import equilibria
from .errors import BodyWarning, InputError
from .exact import Number
from .motion import Motion
from .records import Classification
from .section import Section

UNPHYSICAL = (
    "no distribution of mass has these moments and this centre of mass "
    "(it needs Ai + Aj > Ak, or Ai + Aj = Ak with rk = 0); the answers are those of the equations"
)


class Body:
    """A heavy rigid body with a fixed point, given by exact numbers.

    Parameters
    ----------
    A : three numbers
        Principal moments of inertia about the fixed point, A_i > 0.
    r : three numbers
        Centre of mass relative to the fixed point in principal axes, times m g.

    Raises
    ------
    BodyError
        If a moment is not positive.
    InputError
        If a value is not a number.

    Warns
    -----
    BodyWarning
        If no distribution of mass has these moments and this centre of mass (it needs A_i + A_j > A_k, or equality and
        r_k = 0). The answers are those of the equations.

    Notes
    -----
    An int, a str, a Fraction and a Decimal are used as they are, a float as its shortest decimal: ``1.1`` and
    ``"11/10"`` are the same number. Units are those of A and r: with H = ½⟨l, A⁻¹ l⟩ − ⟨γ, r⟩, h has the unit of r, and l
    that of √(A r). γ points *down*: the body hangs at γ = +r̂ and stands at γ = −r̂. The page "Conventions" has the
    equations of motion. Bodies are equal if their numbers are equal.

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
        if not self.physical:
            warnings.warn(UNPHYSICAL, BodyWarning, stacklevel=2)

    @classmethod
    def preset(cls, name: str) -> "Body":
        """A named body.

        Parameters
        ----------
        name : str
            ``"paper"`` (of 2008, with nine regions), ``"kovalevskaya"``, ``"goryachev-chaplygin"``, ``"lagrange"``,
            ``"euler"`` (r = 0), ``"katok:1"`` … ``"katok:7"`` (one of each of Katok's classes), ``"projpm"`` and
            ``"projections12"`` (of figures of the paper), ``"isotropic"`` (equal moments), ``"plate"``, ``"rod"``,
            ``"ten"`` (with ten relative equilibria at one l).

        Raises
        ------
        InputError
            If there is no body of this name; the message lists the names.

        Examples
        --------
        >>> import bifdiag
        >>> bifdiag.Body.preset("kovalevskaya")
        Body(A=[2, 2, 1], r=[1, 0, 0])
        """
        return cls._of(_core.Body.preset(name))

    @classmethod
    def from_inertia(
        cls,
        tensor: Iterable[Iterable[Number]],
        com: Iterable[Number],
        mass: Number,
        g: Number = "9.80665",
        about: str = "fixed point",
        *,
        units: str = "kg,m,s",
        unphysical: bool = False,
    ) -> "Body":
        """A real part from its tensor of inertia, which is kept exactly, without rounding.

        Parameters
        ----------
        tensor : 3 × 3 numbers
            The symmetric matrix itself, with Ixy = −∫ x y dm off the diagonal. Products of inertia printed as +∫ x y dm
            must change sign.
        com : three numbers
            Centre of mass, from the fixed point, in the axes of the tensor.
        mass : number
            Mass.
        g : number
            Acceleration of gravity, always in m/s².
        about : {"fixed point", "centre of mass"}
            The reference point of the tensor.
        units : str
            Units of mass, length and time of all inputs and results, such as ``"g,mm,s"``.
        unphysical : bool
            Accept an unphysical part, which no distribution of mass can have.

        Raises
        ------
        BodyError
            If the part cannot exist, or its mass is not positive.
        InputError
            If a value is not a number, the tensor is not symmetric, or a unit is unknown.

        Examples
        --------
        >>> import bifdiag
        >>> top = bifdiag.Body.from_inertia(
        ...     [[2, 0.1, 0], [0.1, 1.5, 0], [0, 0, 1]], com=[0, 0, 50], mass=0.25, about="centre of mass", units="kg,mm,s"
        ... )
        >>> [round(moment, 6) for moment in top.part["principal_com"]["moments"]]
        [1.0, 1.480742, 2.019258]
        """
        if about not in ("fixed point", "centre of mass"):
            raise InputError(f'about = {about!r}: the points are "fixed point" and "centre of mass"')
        rows = [exact.triple(row, f"tensor[{place}]") for place, row in enumerate(tensor)]
        if len(rows) != 3:
            raise InputError(f"tensor needs three rows, {len(rows)} given")
        place, weight, gravity = exact.triple(com, "com"), exact.text(mass, "mass"), exact.text(g, "g")
        return cls._of(_core.body_of_tensor(rows, place, weight, gravity, about == "centre of mass", units, unphysical))

    @classmethod
    def from_part(
        cls,
        path: str | os.PathLike[str],
        *,
        density: Number | None = None,
        mass: Number | None = None,
        link: str | None = None,
        pivot: Iterable[Number] = (0, 0, 0),
        g: Number = "9.80665",
        units: str | None = None,
        unphysical: bool = False,
    ) -> "Body":
        """A real part from a file.

        Parameters
        ----------
        path : path
            A mesh (``.stl``, ``.obj``, ``.ply``) or an inertial block (``.urdf``, MJCF ``.xml``).
        density, mass : number, optional
            One of the two for a mesh, in `units`.
        link : str, optional
            Which link of a ``.urdf`` or ``.xml``.
        pivot : three numbers
            The fixed point, in the file's frame.
        g : number
            Acceleration of gravity, always in m/s².
        units : str, optional
            Units of mass, length and time, such as ``"kg,mm,s"``: of a mesh and of all results.
        unphysical : bool
            Accept an unphysical part, which no distribution of mass can have.

        Raises
        ------
        BodyError
            If the part cannot exist.
        InputError
            If the file does not define a part: it is missing, the mesh is open or inside out, its mass is not given, …
        """
        weight = [
            None if value is None else exact.text(value, name) for name, value in (("density", density), ("mass", mass))
        ]
        place, gravity = exact.triple(pivot, "pivot"), exact.text(g, "g")
        return cls._of(_core.body_of_file(path, weight, link, place, gravity, units, unphysical))

    @classmethod
    def _of(cls, inner: _core.Body) -> "Body":
        body = cls.__new__(cls)
        body._inner = inner
        return body

    @classmethod
    def _of_document(cls, document: dict[str, Any]) -> "Body":
        """The body of the block ``body`` of a document."""
        part = document.get("part")
        if part is None:
            return cls._of(_core.Body(document["A"], document["r"]))
        return cls.from_inertia(
            part["inertia"], part["com"], part["mass"], part["g"], units=part["units"], unphysical=not part["physical"]
        )

    @property
    def part(self) -> dict[str, Any] | None:
        """The real part as understood, in the form of the block ``part`` of the documents; None for other bodies."""
        text = self._inner.part()
        return None if text is None else json.loads(text)

    @property
    def physical(self) -> bool:
        """Whether a distribution of mass can have these moments and this centre of mass.

        It needs A_i + A_j > A_k, or equality and r_k = 0; for a part, about its centre of mass. If False, the
        answers are those of the equations.
        """
        return self._inner.physical()

    @property
    def A(self) -> tuple[str, str, str]:
        """The principal moments as given."""
        first, second, third = self._inner.moments
        return first, second, third

    @property
    def r(self) -> tuple[str, str, str]:
        """The centre of mass as given."""
        first, second, third = self._inner.center
        return first, second, third

    def atlas(self, accuracy: str = "exact", *, certificate: bool = False) -> Atlas:
        """Every region of the (h, l) plane, with its topology.

        Parameters
        ----------
        accuracy : {"exact", "fast"}
            ``"exact"`` decides everything; ``"fast"`` is floating point with error bounds, and may leave points undecided.
        certificate : bool
            Prove the whole diagram and include in the document what `bifdiag.verify` needs to check it, like ``bifdiag
            --certificate``. This takes about ten times as long.

        Returns
        -------
        Atlas

        Raises
        ------
        RangeError
            If the atlas of this body cannot be computed or proved.
        InputError
            If a certificate is requested for a fast atlas.

        Examples
        --------
        >>> import bifdiag
        >>> atlas = bifdiag.Body.preset("paper").atlas()
        >>> len(atlas.regions)
        9
        """
        return Atlas(self, accuracy, certificate=certificate)

    def classify(self, h: Number, l: Number, accuracy: str = "exact") -> Classification:
        """The type of U, E and P at one point.

        Parameters
        ----------
        h, l : number
            Energy and vertical angular momentum; scalars only; `Atlas.region` takes arrays. Everything depends only on l²,
            so the sign of l does not matter.
        accuracy : {"exact", "fast"}
            As in `atlas`.

        Returns
        -------
        Classification

        Raises
        ------
        InputError
            If h or l is not a finite number.
        RangeError
            If the point cannot be decided.

        Examples
        --------
        >>> import bifdiag
        >>> bifdiag.Body.preset("kovalevskaya").classify(2, 2).status
        'critical'
        """
        document = self._inner.classify(exact.text(h, "h"), exact.text(l, "l"), accuracy)
        return Classification._of(json.loads(document))

    def critical(self, l: Any) -> npt.NDArray[np.void]:
        """All relative equilibria.

        Parameters
        ----------
        l : number, or array of them
            Vertical angular momentum. At −l the same equilibria rotate in the opposite direction; at l = 0 the body is
            at rest, hanging or standing.

        Returns
        -------
        structured array
            A row for each relative equilibrium, by increasing h. For an array of l the additional field ``l_index``
            is the position in ``np.ravel(l)``. Angular velocities and eigenvalues are in radians per unit of time.

            ========================= ====================================================================================
            ``l``, ``h``              Momentum and energy.
            ``gamma`` (3)             The downward vertical, in the body's axes; the body turns about it.
            ``omega``                 The angular velocity l/⟨γ, A γ⟩, signed as l.
            ``index``                 Negative eigenvalues of the Hessian of U_l: 0 minimum, 1 saddle, 2 maximum,
                                      unless ``multiplicity`` is ``"2"``.
            ``multiplicity``          ``"1"``; ``"2"``: degenerate, where two meet (a cusp) or three, or one and a
                                      circle (a pitchfork); ``"circle"`` and ``"sphere"`` of them. Two that are
                                      mirror images are two rows.
            ``stability``             Linear type: ``"elliptic"`` (two imaginary pairs), ``"saddle-centre"`` (one
                                      real, one imaginary), ``"saddle"`` (two real), ``"complex"`` (a quadruple),
                                      ``"double-elliptic"``, ``"double-real"`` (a double pair), ``"zero"`` (an
                                      eigenvalue 0). Across a circle of them there is one pair only: ``"elliptic"``
                                      imaginary, ``"saddle"`` real, ``"zero"`` 0; along it the eigenvalues are 0.
            ``stable``                Proved stable, at fixed l, up to rotation about the vertical.
            ``stable_by``             Why: ``"energy"`` (a minimum), ``"integral"`` (a further integral),
                                      ``"arnold"`` (Arnold's theorem); where it is not stable, ``"spectrum"`` (an
                                      eigenvalue), ``"resonance 1:1"``, …, ``"degenerate"``.
            ``verdict``               ``"stable"``, ``"unstable"`` or ``"open"``.
            ``survives_friction``     It stays stable with a small friction that conserves l.
            ``eigenvalues`` (2)       Of the pairs ±λ₁, ±λ₂ of the flow reduced by l, with re ≥ 0 and im ≥ 0; of a
                                      circle its transverse pair, then 0. A quadruple gives the same one twice.
            ``eigenvalue_error``      Bound on their error.
            ``branch``                Id of the curve in the atlas; the page "Conventions" explains ids.
            ``branch_name``           Where the branch begins, such as ``"from +r̂"``.
            ========================= ====================================================================================

        Raises
        ------
        InputError
            If an l is not a finite number.

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
            Compute verdict, Lyapunov exponent and rotation number of each orbit. Without them a section takes a quarter
            of the time, and every verdict is ``"open"``.
        threads : int, optional
            None: one; 0: one per core. The result does not depend on it.

        Returns
        -------
        Section

        Raises
        ------
        InputError
            If (h, l) is forbidden or on a curve, if r = 0, or if a start is not in U.
        RangeError
            If the section cannot be computed.

        Examples
        --------
        >>> import bifdiag
        >>> section = bifdiag.Body.preset("paper").section(3.8, 3.25, orbits=4, crossings=10)
        >>> section.gamma.shape
        (44, 3)
        """
        return Section._compute(
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

        The equations are dγ/dt = γ × ω and dl/dt = l × ω − γ × r with ω = A⁻¹ l; the page "Conventions" has the frames.

        Parameters
        ----------
        gamma : three floats
            The downward vertical in the body's axes at time 0; its length does not matter.
        l : three floats
            Angular momentum in the body's axes at time 0.
        t : array of float, or float
            Times in non-decreasing order; negative ones lie in the past. A single number t means 201 equidistant times
            from 0 to t, or from t to 0 if it is negative; 0 means only that time.
        omega : three floats, optional
            Angular velocity in the body's axes at time 0, instead of `l`.
        phi : float
            Euler's angle φ at time 0: the rotation about the vertical, which γ does not determine.
        tolerance : float
            Error of a step relative to the size of the motion.

        Returns
        -------
        Motion

        Raises
        ------
        InputError
            If the state or the times are invalid.
        RangeError
            If the integrator cannot continue.

        Examples
        --------
        >>> import bifdiag
        >>> motion = bifdiag.Body.preset("paper").orbit(gamma=[0.6, 0, 0.8], omega=[1, 0.3, 1], t=[0, 1, 2])
        >>> motion.quaternion.shape
        (3, 4)
        """
        return Motion._compute(self._inner, gamma, l, omega, t, phi, tolerance)

    def plot(self, ax: Any = None, **options: Any) -> Any:
        """Draws the body with matplotlib: its ellipsoid of inertia and its centre of mass; see `bifdiag.pictures.body`."""
        return pictures.body(self, ax, **options)

    def plot_sphere(self, h: float, l: float, ax: Any = None, **options: Any) -> Any:
        """Draws U at one point (h, l) on the Poisson sphere with matplotlib; see `bifdiag.pictures.sphere`."""
        return pictures.sphere(self, h, l, ax, **options)

    # Equal bodies have equal numbers, whatever their texts.
    def __eq__(self, other: object) -> bool:
        return isinstance(other, Body) and self._inner.values() == other._inner.values()

    def __hash__(self) -> int:
        return hash(tuple(self._inner.values()))

    def __reduce__(self) -> tuple[Any, ...]:
        return Body._of_document, ({"A": self.A, "r": self.r, "part": self.part},)

    def _told(self) -> tuple[str, str]:
        """A and r, to read: of a part, whose texts have many digits, as doubles; the rest loses nothing."""

        def told(texts: tuple[str, ...]) -> str:
            return ", ".join(texts if self.part is None else [repr(float(exact.value(text))) for text in texts])

        return told(self.A), told(self.r)

    def __repr__(self) -> str:
        moments, center = self._told()
        if self.part is None:
            return f"Body(A=[{moments}], r=[{center}])"
        return f"Body of a part in {self.part['units']}: A = [{moments}], r = [{center}] [A, r, part have all digits]"

    def _repr_html_(self) -> str:
        moments, center = self._told()
        return table([("A", moments), ("r", center), *([("units", self.part["units"])] if self.part else [])])


Atlas._body_of = Body._of_document
