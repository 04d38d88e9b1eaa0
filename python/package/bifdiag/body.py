"""Bodies."""

import json
import os
import warnings
from collections.abc import Iterable
from typing import Any, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _core, exact, pictures
from .atlas import Atlas
from .behaviour import table
from .command import command
from .critical import Equilibria
from .errors import BodyWarning, InputError
from .exact import Number
from .motion import Motion
from .records import Classification
from .section import Section
from .units import Exact, Units

UNPHYSICAL = (
    "no distribution of mass has these moments and this centre of mass "
    "(it needs Ai + Aj > Ak, or Ai + Aj = Ak with rk = 0); the answers are those of the equations"
)


Accuracy: TypeAlias = Literal["exact", "fast"]
"""Levels of accuracy."""

Axis: TypeAlias = Literal["x", "y", "z"] | Iterable[Number]
"""An axis of a part."""


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
    Made also by `preset`, `from_inertia` (a tensor) and `from_part` (a file). Its numbers are `A` and `r` as texts, `exact`
    both; `moments`, `com` and `weight` are floats, and `units`, `part`, `physical`, `measured` tell of real parts.
    Questions: `atlas` (the whole (h, l) plane), `classify` (one point), `critical` (steady rotations at one l or many),
    `critical_spin` (spins at which these change), `section` (a Poincaré section), `orbit` (a motion). Pictures: `plot`,
    `plot_sphere`.

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

    __slots__ = ("_given", "_inner", "_source")
    _inner: _core.Body
    # The options of the command line for a part, as it was given.
    _given: tuple[str, ...]
    # What made a part with ±, to make it again: a function of the compiled part, and its arguments.
    _source: tuple[str, tuple[Any, ...]] | None

    def __init__(self, A: Iterable[Number], r: Iterable[Number]) -> None:
        self._inner = _core.Body(exact.triple(A, "A"), exact.triple(r, "r"))
        self._given, self._source = (), None
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
        about: Literal["fixed point", "centre of mass"] = "fixed point",
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
            Units of mass, length and time of all inputs and results, such as ``"g,mm,s"``. Any number may also be a text
            with its own unit, ``"250 g"``, and with what it is known to, ``"1.2±0.01"``, ``"1.2+-1%"``: `critical_spin`.
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
        arguments = (rows, place, weight, gravity, about == "centre of mass", units, unphysical)
        upper = [_told_entry(rows[i][k], rows[k][i]) for i, k in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
        option = "--inertia-com" if about == "centre of mass" else "--inertia"
        given = [f"{option}={','.join(upper)}", "--products=tensor", f"--com={','.join(place)}", f"--mass={weight}"]
        given += [f"--g={gravity}", f"--units={units}", *(["--unphysical"] if unphysical else [])]
        return cls._of_part(("body_of_tensor", arguments), tuple(given))

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
            One of the two for a mesh, in `units`, or with its own: ``"2.7 g/cm3"``.
        link : str, optional
            Which link of a ``.urdf`` or ``.xml``.
        pivot : three numbers
            The fixed point, in the file's frame; ``"10±0.2 mm"`` is understood, too.
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
        absolute = os.path.abspath(path)
        arguments = (absolute, weight, link, place, gravity, units, unphysical)
        named = [("density", weight[0]), ("mass", weight[1]), ("link", link), ("units", units)]
        options = [f"--{name}={value}" for name, value in named if value is not None]
        given = [f"--part={absolute}", *options, f"--pivot={','.join(place)}", f"--g={gravity}"]
        return cls._of_part(("body_of_file", arguments), (*given, *(["--unphysical"] if unphysical else [])))

    @classmethod
    def _of(cls, inner: _core.Body) -> "Body":
        body = cls.__new__(cls)
        body._inner, body._given, body._source = inner, (), None
        return body

    @classmethod
    def _of_part(cls, source: tuple[str, tuple[Any, ...]], given: tuple[str, ...]) -> "Body":
        make, arguments = source
        body = cls._of(getattr(_core, make)(*arguments))
        body._given, body._source = given, source if body.measured else None
        return body

    def _exactly(self) -> _core.Body:
        """The compiled body, unless its numbers are known to within so much only."""
        if self._inner.measured():
            raise InputError(
                "this part has numbers with ±, for which only critical_spin answers; leave out ± and what follows it"
            )
        return self._inner

    def _options(self) -> tuple[str, ...]:
        """The body as options of the command line."""
        return self._given or (f"--A={','.join(self.A)}", f"--r={','.join(self.r)}")

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
    def measured(self) -> bool:
        """Whether some number of the part is known to within so much only, as ``"1.2±0.01"``.

        `moments`, `com`, `part` are then those of the nominal numbers, and only `critical_spin` answers questions.
        """
        return self._inner.measured()

    @property
    def moments(self) -> npt.NDArray[np.float64]:
        """The principal moments of inertia A as floats."""
        return _floats(self.A)

    @property
    def com(self) -> npt.NDArray[np.float64]:
        """The centre of mass from the fixed point in principal axes, as floats: r/`weight`.

        Of a part in its unit of length; of any other body r itself.
        """
        return _floats(self.r) / self.weight if self.weight else _floats(self.r)

    @property
    def weight(self) -> float:
        """M g of a part, in its units; of any other body 1, since r contains m g."""
        part, units = self.part, self.units
        if part is None or units is None:
            return 1.0
        return float(exact.value(part["mass"]) * exact.value(part["g"])) * units.time**2 / units.length

    @property
    def units(self) -> Units | None:
        """The units of a part and of its results, as factors to SI units; None for other bodies, whose units are free."""
        part, scales = self.part, self._inner.scales()
        return None if part is None or scales is None else Units(part["units"], *scales)

    @property
    def exact(self) -> Exact:
        """The texts of A and r, ``body.exact.A``: exact, but of a part rounded where ``part["exact"]`` is False."""
        return Exact(self.A, self.r)

    @property
    def A(self) -> tuple[str, str, str]:
        """The principal moments as given, exact texts; `moments` are floats."""
        first, second, third = self._inner.moments
        return first, second, third

    @property
    def r(self) -> tuple[str, str, str]:
        """The centre of mass times m g as given, exact texts."""
        first, second, third = self._inner.center
        return first, second, third

    def atlas(self, accuracy: Accuracy = "exact", *, certificate: bool = False) -> Atlas:
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
        self._exactly()
        return Atlas(self, accuracy, certificate=certificate)

    def classify(self, h: Number, l: Number, accuracy: Accuracy = "exact") -> Classification:
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
        document = self._exactly().classify(exact.text(h, "h"), exact.text(l, "l"), accuracy)
        return Classification._of(json.loads(document))

    def critical(self, l: Any, *, threads: int | None = None) -> Equilibria:
        """All relative equilibria, as a table.

        Parameters
        ----------
        l : number, or array of them
            Vertical angular momentum. At −l the same equilibria rotate in the opposite direction; at l = 0 the body is
            at rest, hanging or standing.
        threads : int, optional
            None: one; 0: one per core. The result does not depend on it.

        Returns
        -------
        Equilibria
            A row for each relative equilibrium, by increasing h: a structured array with named columns, which `Equilibria`
            explains, and with `to_pandas`, `to_arrow` and `to_xarray`. For an array of l the additional column ``l_index``
            is the position in ``np.ravel(l)``. Angular velocities and eigenvalues are in radians per unit of time.

        Raises
        ------
        InputError
            If an l is not a finite number; the message names the first.

        Examples
        --------
        >>> import bifdiag
        >>> found = bifdiag.Body.preset("paper").critical("3.25")
        >>> found["index"]
        array([0, 0, 1, 1, 2, 2], dtype=int8)
        >>> found[found["index"] == 2].stable_by.tolist()
        ['arnold', 'arnold']
        """
        return Equilibria._compute(self._exactly(), l, threads)

    def critical_spin(self, axis: Axis | None = None, *, tolerance: str | None = None) -> dict[str, Any]:
        """The spins at which the stability or the region of a steady rotation changes, like ``bifdiag critical-spin``.

        It is the question for parts whose numbers are known to within so much only, as ``"1.2±0.01"``: bounds hold for
        every part within them.

        Parameters
        ----------
        axis : {"x", "y", "z"} or three numbers, optional
            An axis in the frame of the part; None: all axes about which it can turn steadily.
        tolerance : str, optional
            Such as ``"1%"``: of the moments and the weight, in place of ± on single numbers.

        Returns
        -------
        dict
            The document of ``bifdiag critical-spin --json``; the page "Formats" of the program's documentation explains it.

        Raises
        ------
        InputError
            If the command line refuses an argument.

        Examples
        --------
        >>> import bifdiag
        >>> tensor = [["0.24±1%", 0, 0], [0, 0.24, 0], [0, 0, 0.17]]
        >>> top = bifdiag.Body.from_inertia(tensor, com=[0, 0, "80±0.5 mm"], mass="2 kg", g=9.81)
        >>> top.measured, top.com.tolist()
        (True, [0.0, 0.0, 0.08])
        >>> sorted(top.critical_spin("z"))[:3]
        ['A', 'axis', 'changes']
        """
        arguments = ["critical-spin", "--json", *self._options()]
        if axis is not None:
            arguments.append(f"--axis={axis if isinstance(axis, str) else ','.join(exact.triple(axis, 'axis'))}")
        if tolerance is not None:
            arguments.append(f"--tolerance={tolerance}")
        document: dict[str, Any] = json.loads(command(*arguments))
        return document

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
            self._exactly(), h, l, orbits, crossings, seed, starts, max_time, condition, tolerance, chaos, threads
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
        return Motion._compute(self._exactly(), gamma, l, omega, t, phi, tolerance)

    def plot(self, ax: Any = None, **options: Any) -> Any:
        """Draws the body with matplotlib: its ellipsoid of inertia and its centre of mass; see `bifdiag.pictures.body`."""
        return pictures.body(self, ax, **options)

    def plot_sphere(self, h: float, l: float, ax: Any = None, **options: Any) -> Any:
        """Draws U at one point (h, l) on the Poisson sphere with matplotlib; see `bifdiag.pictures.sphere`."""
        return pictures.sphere(self, h, l, ax, **options)

    # Equal bodies have equal numbers, whatever their texts; with ± they are those that are given alike.
    def _identity(self) -> tuple[Any, ...]:
        return tuple(self._inner.values()), self._given if self.measured else ()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Body) and self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def __reduce__(self) -> tuple[Any, ...]:
        if self._source is not None:
            return Body._of_part, (self._source, self._given)
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
        if self.measured:
            return (
                f"Body of a part with ±, nominally in {self.part['units']}: A = [{moments}], r = [{center}] [critical_spin]"
            )
        return f"Body of a part in {self.part['units']}: A = [{moments}], r = [{center}] [A, r, part have all digits]"

    def _repr_html_(self) -> str:
        moments, center = self._told()
        return table([("A", moments), ("r", center), *([("units", self.part["units"])] if self.part else [])])


def bodies() -> dict[str, Body]:
    """The named bodies, which `Body.preset` knows.

    Returns
    -------
    dict of str to Body

    Examples
    --------
    >>> import bifdiag
    >>> bifdiag.bodies()["kovalevskaya"]
    Body(A=[2, 2, 1], r=[1, 0, 0])
    """
    return {name: Body.preset(name) for name, _ in _core.Body.presets()}


def _floats(texts: Iterable[str]) -> npt.NDArray[np.float64]:
    return np.array([float(exact.value(text)) for text in texts])


def _told_entry(above: str, below: str) -> str:
    """Of two equal entries of a tensor that with ±."""
    return below if any(sign in below for sign in ("±", "+-", "+/-")) else above


Atlas._body_of = Body._of_document
