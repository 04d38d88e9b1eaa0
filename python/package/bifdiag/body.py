"""Bodies."""

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

    __slots__ = ()

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
