"""Units of parts, and exact texts beside floats."""

from dataclasses import dataclass, field
from typing import NamedTuple


class Exact(NamedTuple):
    """Exact texts of a body."""

    A: tuple[str, str, str]
    r: tuple[str, str, str]


class ExactPoint(NamedTuple):
    """Exact texts of a point."""

    h: str
    l: str


@dataclass(frozen=True)
class Units:
    """Units of a part and of its results: ``x * units.energy`` is in J.

    Attributes
    ----------
    name : str
        The units of mass, length and time, such as ``"kg,mm,s"``.
    mass, length, time : float
        The units in kg, m and s.
    moment : float
        That of moments of inertia in kg m².
    energy : float
        That of r and h in J.
    momentum : float
        That of l in kg m²/s.
    """

    name: str
    mass: float
    length: float
    time: float
    moment: float = field(init=False)
    energy: float = field(init=False)
    momentum: float = field(init=False)

    def __post_init__(self) -> None:
        moment = self.mass * self.length**2
        for name, value in (("moment", moment), ("energy", moment / self.time**2), ("momentum", moment / self.time)):
            object.__setattr__(self, name, value)
