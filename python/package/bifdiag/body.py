"""Bodies."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from typing import Any

from . import _core, exact
from .diagrams import Diagrams
from .errors import BodyWarning
from .exact import Number
from .given import Given
from .motions import Motions
from .real_parts import RealParts

UNPHYSICAL = (
    "no mass distribution has these moments and this centre of mass "
    "(it needs Ai + Aj > Ak, or Ai + Aj = Ak with rk = 0); the equations hold all the same"
)


class Body(RealParts, Diagrams, Motions):
    """A heavy rigid body with a fixed point, given by exact numbers: ``Body(A=[2, "11/10", 1], r=[1, 0, 0])``.

    A are the principal moments about the fixed point, r the centre of mass in principal axes, times m g.
    `preset`, `from_inertia` and `from_part` make bodies, too. ``help(body.section)`` explains
    one question, the page "Examples" has one of each.

    ====================================  ====================================================
    **the (h, l) plane**
    ``atlas(accuracy, certificate)``      all regions, curves and events: `Atlas`
    ``classify(h, l, accuracy)``          the topology at a point: `Classification`
    **steady rotations**
    ``critical(l, threads, invalid)``     at one l or many: `Equilibria`, a table
    ``critical_spin(axis, tolerance)``    spins where they change: `CriticalSpins`, a table
    **motion**
    ``orbit(gamma, l, t, …)``             in space: `Motion`, a table; also proved
    ``section(h, l, orbits, …)``          Poincaré's section: `Section`, a table
    ``chaos(h, l, …)``                    the chaotic share: `ChaosPoint`; a map: `ChaosMap`
    ``periodic_orbits(h, l, crossings)``  all short ones: `PeriodicOrbits`, a table
    ``periodic_families(l | h, …)``       from steady rotations: tuple of `PeriodicFamily`
    **pictures**
    ``plot(ax)``, ``plot_sphere(h, l)``   ellipsoid of inertia; U on the Poisson sphere
    **numbers**
    ``A``, ``r``, ``exact``               texts as given: ``body.exact.A``
    ``moments``, ``com``, ``weight``      floats
    ``units``, ``part``                   of a real part; else None
    ``physical``, ``measured``            some mass has these moments; some number has ±
    ====================================  ====================================================

    An int, a str, a Fraction and a Decimal are used as they are, a float as its shortest
    decimal: ``1.1`` and ``"11/10"`` are the same number. Bodies are equal if their numbers are.
    h has the unit of r, l that of √(A r): H = ½⟨l, A⁻¹ l⟩ − ⟨γ, r⟩. γ points *down*: the body
    hangs at γ = +r̂. The page "Conventions" has the equations.
    Wrong input raises `InputError` or `BodyError`, a question without an answer `RangeError`; a
    body that no mass distribution can have gives a `BodyWarning`, but a part that was given with
    ``unphysical=True``. ``threads``: None is one, 0 one per core, with the same results.
    """

    __slots__ = ()

    def __init__(self, A: Iterable[Number], r: Iterable[Number]) -> None:
        self._inner = _core.Body(exact.triple(A, "A"), exact.triple(r, "r"))
        self._given, self._source = (), None
        if not self.physical:
            warnings.warn(UNPHYSICAL, BodyWarning, stacklevel=2)

    @classmethod
    def preset(cls, name: str) -> Body:
        """A named body.

        ``"paper"`` (of 2008, with nine regions), ``"kovalevskaya"``, ``"goryachev-chaplygin"``, ``"lagrange"``,
        ``"euler"`` (r = 0), ``"katok:1"`` … ``"katok:7"`` (each of Katok's classes), ``"projpm"``, ``"projections12"``
        (in the paper's figures), ``"isotropic"``, ``"plate"``, ``"rod"``, ``"ten"`` (with ten equilibria at one l).
        """
        return cls._of(_core.Body.preset(name))

    def __reduce__(self) -> tuple[Any, ...]:
        if self._source is not None:
            return Body._of_part, (self._source, self._given)
        return Body._of_document, ({"A": self.A, "r": self.r, "part": self.part},)


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


Given._made_of = Body._of_document
