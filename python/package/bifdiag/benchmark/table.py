"""The tops of the benchmark."""

from dataclasses import dataclass
from fractions import Fraction
from typing import TypedDict

from ..body import Body
from ..errors import InputError

GRAVITY = Fraction("9.81")
"""m/s², along −z of the world."""


class Model(TypedDict):
    """What an engine is given of a top, in SI units; the same as ``models/NAME.json`` of the program's benchmark.

    ``inertia`` are the principal moments about the fixed point, ``com`` the centre of mass in the same axes,
    ``inertia_com`` the tensor about the centre of mass, with I_xy = −∫xy dm off the diagonal, as URDF and MJCF have it.
    """

    name: str
    about: str
    gravity: float
    mass: float
    com: list[float]
    inertia: list[float]
    inertia_com: list[list[float]]
    omega0: list[float]
    end: float


@dataclass(frozen=True)
class Top:
    """A top of the benchmark, exactly; ``str(top)`` is its name.

    Attributes
    ----------
    name, about : str
        Its name, and what it is.
    mass : Fraction
        kg.
    com : three Fractions
        Centre of mass from the fixed point, in principal axes, m.
    inertia : three Fractions
        Principal moments about the fixed point, kg m².
    down : three Fractions
        The direction of gravity at the start, in the body's axes, of any length.
    omega : three Fractions
        Angular velocity at the start, in the body's axes, rad/s.
    end : Fraction
        The last time, s.
    """

    name: str
    about: str
    mass: Fraction
    com: tuple[Fraction, ...]
    inertia: tuple[Fraction, ...]
    down: tuple[Fraction, ...]
    omega: tuple[Fraction, ...]
    end: Fraction

    def __str__(self) -> str:
        return self.name

    @property
    def body(self) -> Body:
        """The top as a `Body`, in SI units."""
        return Body(A=self.inertia, r=[self.mass * GRAVITY * x for x in self.com])

    @property
    def model(self) -> Model:
        """What an engine is given."""
        square = sum(x * x for x in self.com)

        def entry(i: int, k: int) -> float:
            own = self.inertia[i] - self.mass * square if i == k else Fraction(0)
            return float(own + self.mass * self.com[i] * self.com[k])

        return {
            "name": self.name,
            "about": self.about,
            "gravity": float(GRAVITY),
            "mass": float(self.mass),
            "com": [float(x) for x in self.com],
            "inertia": [float(x) for x in self.inertia],
            "inertia_com": [[entry(i, k) for k in range(3)] for i in range(3)],
            "omega0": [float(x) for x in self.omega],
            "end": float(self.end),
        }


def tops() -> tuple[Top, ...]:
    """The 24 tops.

    Examples
    --------
    >>> from bifdiag import benchmark
    >>> len(benchmark.tops()), str(benchmark.tops()[0])
    (24, 'euler-flip')
    """
    return TOPS


def top(name: str) -> Top:
    """The top of a name.

    Raises
    ------
    InputError
        If there is none; the message lists the names.
    """
    found = next((one for one in TOPS if one.name == name), None)
    if found is None:
        raise InputError(f"there is no top {name!r}; the tops are {', '.join(map(str, TOPS))}")
    return found


def _top(name: str, numbers: str) -> Top:
    title, about = name.split(": ", 1)
    mass, com, inertia, down, omega, end = (tuple(map(Fraction, texts.split(","))) for texts in numbers.split("|"))
    return Top(title, about, mass[0], com, inertia, down, omega, end[0])


TABLE = """
euler-flip: Euler: free, about the middle axis, which flips
    1 | 0,0,0 | 0.002,0.003,0.004 | 0,0,-1 | 0.002,3,0.001 | 40
euler-tumble: Euler: free, far from every axis
    1 | 0,0,0 | 0.02,0.035,0.05 | 0,0.6,-0.8 | 4,1,3 | 10
lagrange-asleep: Lagrange: upright and fast, a hair off
    0.5 | 0,0,0.05 | 0.003,0.003,0.001 | 0.001,0,-1 | 0,0,60 | 10
lagrange-nodding: Lagrange: nutation without loops
    0.5 | 0,0,0.05 | 0.003,0.003,0.001 | 0.6,0,-0.8 | 2,0,40 | 10
lagrange-looping: Lagrange: nutation with loops
    0.5 | 0,0,0.05 | 0.003,0.003,0.001 | 0.6,0,-0.8 | -6,0,40 | 10
lagrange-cusps: Lagrange: released with its axis at rest
    0.5 | 0,0,0.05 | 0.003,0.003,0.001 | 0.6,0,-0.8 | 0,0,40 | 10
lagrange-hanging: Lagrange: spinning below the pivot
    0.5 | 0,0,0.05 | 0.003,0.003,0.001 | 0.28,0,0.96 | 1,2,10 | 10
kovalevskaya-1: Kovalevskaya: A1 = A2 = 2 A3, r on the first axis
    1 | 0.1,0,0 | 0.06,0.06,0.03 | 0.6,0,-0.8 | 1,3,4 | 10
kovalevskaya-2: Kovalevskaya, slower
    1 | 0.1,0,0 | 0.06,0.06,0.03 | 0.28,0.96,0 | 0.5,-2,1 | 10
goryachev-chaplygin: Goryachev and Chaplygin: A1 = A2 = 4 A3, l = 0
    1 | 0.09,0,0 | 0.08,0.08,0.02 | 0.8,0,-0.6 | 1.5,2,8 | 10
paper-regular: The paper's body, scaled: a fast regular motion
    1 | 0.047434,0,0.0308115 | 0.1,0.055,0.05 | 0.6,0,0.8 | 6,2,6 | 10
paper-chaotic: The paper's body: a chaotic motion
    1 | 0.047434,0,0.0308115 | 0.1,0.055,0.05 | 0.6,0.2,-0.8 | 0.5,1,0.5 | 10
rod: A thin rod, its end held
    0.3 | 0,0,0.25 | 0.025,0.025,0.00005 | 0.6,0,0.8 | 1,2,30 | 10
rod-still: A thin rod as a spherical pendulum
    0.3 | 0,0,0.25 | 0.025,0.025,0.00001 | 0.28,0,0.96 | 3,1,0 | 10
plate: A thin plate, pivot at its edge
    0.8 | 0.1,0,0 | 0.004,0.012,0.0159 | 0.6,0.64,0.48 | 2,1,3 | 10
plate-corner: A thin plate, pivot at its corner, in principal axes
    0.8 | 0.06,0.03,0 | 0.004,0.012,0.0159 | 0.36,0.48,-0.8 | 1,2,4 | 10
nearly-equal: Three moments within a thousandth
    1 | 0.02,0.01,0.03 | 0.01,0.01001,0.01002 | 0.6,0,-0.8 | 1,2,5 | 10
ball: Three equal moments
    1 | 0,0,0.03 | 0.01,0.01,0.01 | 0.6,0,-0.8 | 1,2,5 | 10
large-spin: A rotor at 6,000 rpm
    2 | 0,0,0.08 | 0.016,0.016,0.003 | 0.6,0,-0.8 | 0,0.1,628 | 4
slow-precession: A gyroscope's wheel on an arm: a turn a minute
    1.5 | 0,0,0.004 | 0.006,0.006,0.009 | 1,0,0 | 0,0,60 | 40
upright: Released a little off its unstable rest
    1 | 0.02,0.01,0.1 | 0.03,0.02,0.018 | -0.19611,-0.098,-0.98 | 0,0.001,0 | 10
chaotic: Three different moments, nothing special
    1.2 | 0.05,-0.04,0.09 | 0.05,0.04,0.03 | 0.48,0.6,-0.64 | 1,-2,3 | 10
hanging-small: Small oscillations about the rest below
    1.2 | 0.05,-0.04,0.09 | 0.05,0.04,0.03 | 0.46,-0.36,0.81 | 0.1,-0.1,0.1 | 20
bracket: A real part: a milled bracket of 180 g, pivot 40 mm below its centre of mass
    0.18 | 0,0,0.04 | 0.000317625,0.000319,0.00005625 | 0.6,0,-0.8 | 1,2,50 | 10
"""
"""Mass | centre of mass | moments | down | omega | last time of each top."""

LINES = TABLE.strip().splitlines()

TOPS = tuple(map(_top, LINES[::2], LINES[1::2]))
