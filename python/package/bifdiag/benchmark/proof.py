"""Where the tops of the benchmark are."""

import math
from dataclasses import dataclass
from functools import cache
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from ..errors import RangeError
from .table import Top

TIMES = 200
"""Times of a truth, beside the start."""

BOUND = 2e-14
"""The widest enclosure of a truth; with the roundings of doubles no number is farther off than 1e-12."""

Floats: TypeAlias = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Truth:
    """Where a top is: no number is farther from the exact one than `bound`.

    Attributes
    ----------
    times : array (201,)
        s.
    q : array (201, 4)
        Quaternions w, x, y, z, continuous in time; q and −q are the same attitude.
    omega : array (201, 3)
        Angular velocities in the body's axes, rad/s.
    bound : float
        Of all components of both.
    """

    times: Floats
    q: Floats
    omega: Floats
    bound: float


@cache
def truth(top: Top) -> Truth:
    """Where a top is at 200 times and at the start, proved anew and kept.

    Raises
    ------
    RangeError
        If it cannot be proved.
    """
    times = [float(top.end) * k / TIMES for k in range(TIMES + 1)]
    found = top.body.orbit(gamma=top.down, omega=top.omega, t=times, proved=True, bound=BOUND)
    if not found.complete:
        raise RangeError(f"{top}: {found.why}")
    # The third axis of the program's space points down. A half turn about x makes it up: (0, 1, 0, 0)(w, x, y, z).
    w, x, y, z = np.moveaxis(found.quaternion, 1, 0)
    q = np.stack([-x[:, ::-1], w, -z[:, ::-1], y], axis=1)
    middles = [ends.mean(axis=-1) for ends in (q, found.omega)]
    off = [np.abs(ends - middle[..., None]).max() for ends, middle in zip((q, found.omega), middles, strict=True)]
    return Truth(np.array(times), middles[0], middles[1], float(np.nextafter(max(off) * (1 + 1e-15), math.inf)))
