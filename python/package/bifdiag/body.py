"""Bodies."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from typing import Any

from . import _core, exact
from .atlas import Atlas
from .diagrams import Diagrams
from .errors import BodyWarning
from .exact import Number
from .motions import Motions
from .real_parts import RealParts

UNPHYSICAL = (
    "no distribution of mass has these moments and this centre of mass "
    "(it needs Ai + Aj > Ak, or Ai + Aj = Ak with rk = 0); the answers are those of the equations"
)


class Body(RealParts, Diagrams, Motions):
    """A heavy rigid body with a fixed point, given by exact numbers.

    ======================  ===========================================================================================
    ``Body(A, r)``          principal moments about the fixed point; centre of mass in principal axes, times m g
    made also by            `preset` (a name), `from_inertia` (a tensor), `from_part` (a file)
    numbers                 `A`, `r`, `exact` (texts); `moments`, `com`, `weight` (floats)
    real parts              `units`, `part`, `physical`, `measured` (known to ±)
    the (h, l) plane        `atlas` (all of it), `classify` (a point)
    steady rotations        `critical` (at one l or many), `critical_spin` (where they change)
    motion                  `orbit` (in space, also proved), `section` (Poincaré's)
    chaos, periodic orbits  `chaos` (a share, a map), `periodic_orbits` (all at a point), `periodic_families`
    pictures                `plot`, `plot_sphere`, ``body.atlas().plot()``
    ======================  ===========================================================================================

    An int, a str, a Fraction and a Decimal are used as they are, a float as its shortest decimal: ``1.1`` and
    ``"11/10"`` are the same number. h has the unit of r, l that of √(A r): H = ½⟨l, A⁻¹ l⟩ − ⟨γ, r⟩. γ points *down*: the
    body hangs at γ = +r̂. The page "Conventions" has the equations. Bodies are equal if their numbers are.

    What is wrong with a question raises `InputError`, a moment that is not positive `BodyError`; a question without an
    answer raises `RangeError`. A body that no distribution of mass can have gives a `BodyWarning`. ``threads``: None is
    one, 0 one per core; no result depends on it. The page "Examples" has one of each question.
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
        ``"euler"`` (r = 0), ``"katok:1"`` … ``"katok:7"`` (one of each of Katok's classes), ``"projpm"`` and
        ``"projections12"`` (of figures of the paper), ``"isotropic"`` (equal moments), ``"plate"``, ``"rod"``,
        ``"ten"`` (with ten relative equilibria at one l).
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


Atlas._body_of = Body._of_document
