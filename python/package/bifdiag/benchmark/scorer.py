"""How far an engine is from the truth."""

import math
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from ..errors import InputError
from .proof import Floats, truth
from .table import Model, Top

Engine: TypeAlias = Callable[[Model, list[float], list[float], list[float], float], Iterable[Sequence[Any]]]
"""``engine(model, q0, omega0, times, step)`` gives (q, omega) at each of the times, the first of which is 0."""


@dataclass(frozen=True)
class Score:
    """What an engine did on a top.

    Attributes
    ----------
    name : str
        The top.
    step : float
        The step.
    seconds : float
        CPU time.
    angle : float
        The largest angle between the attitudes, rad.
    omega : float
        The largest error of ω, relative to the largest ω.
    energy, momentum : float
        The largest drift of the energy, and of the angular momentum about the vertical, relative to the size of the motion.
    length : float
        How far the quaternion is from length 1 at most.
    """

    name: str
    step: float
    seconds: float
    angle: float
    omega: float
    energy: float
    momentum: float
    length: float


def score(engine: Engine, top: Top, step: float, most: int | None = None) -> Score:
    """Runs an engine on a top.

    Parameters
    ----------
    engine : function
        See `Engine`.
    top : Top
        The top.
    step : float
        The time step, s, or a tolerance where the engine has no fixed step.
    most : int, optional
        Only so many of the times.

    Raises
    ------
    InputError
        If the engine does not give a pair for each time.
    """
    exact, model = truth(top), top.model
    end = None if most is None else most + 1
    times, q, omega = exact.times[:end], exact.q[:end], exact.omega[:end]
    start = time.process_time()
    rows = list(engine(model, q[0].tolist(), omega[0].tolist(), times.tolist(), step))
    seconds = time.process_time() - start
    if len(rows) != len(times) or any(len(row) != 2 for row in rows):
        raise InputError(f"the engine gave {len(rows)} rows for {len(times)} times; a pair (q, omega) for each is needed")
    found = np.array([row[0] for row in rows], dtype=float)
    turning = np.array([row[1] for row in rows], dtype=float)
    if not (np.isfinite(found).all() and np.isfinite(turning).all()):
        return Score(top.name, step, seconds, math.pi, math.inf, math.inf, math.inf, math.inf)
    lengths = np.linalg.norm(found, axis=1)
    unit = found / np.where(lengths == 0, 1, lengths)[:, None]
    size = float(np.linalg.norm(exact.omega, axis=1).max()) or 1.0
    largest = max(model["inertia"])
    joule = largest * size**2 / 2 + model["mass"] * model["gravity"] * math.hypot(*model["com"])
    energies, momenta = _integrals(model, unit, turning)
    right = _integrals(model, q[:1], omega[:1])
    return Score(
        name=top.name,
        step=step,
        seconds=seconds,
        angle=float(_angles(unit, q).max()),
        omega=float(np.linalg.norm(turning - omega, axis=1).max()) / size,
        energy=float(np.abs(energies - right[0]).max()) / joule,
        momentum=float(np.abs(momenta - right[1]).max()) / (largest * size),
        length=float(np.abs(lengths - 1).max()),
    )


def order(engine: Engine, top: Top, step: float, most: int | None = None) -> float | None:
    """The order of convergence from a step to half of it; None where an error is at the level of roundings or not small."""
    coarse, fine = (score(engine, top, h, most).angle for h in (step, step / 2))
    return math.log2(coarse / fine) if fine > 1e-12 and 0 < coarse < 0.3 else None


def _angles(p: Floats, q: Floats) -> Floats:
    """Angles between attitudes, well conditioned for small ones."""
    scalar, vector = p[:, 0] * q[:, 0] + (p[:, 1:] * q[:, 1:]).sum(axis=1), np.cross(q[:, 1:], p[:, 1:])
    vector += p[:, :1] * q[:, 1:] - q[:, :1] * p[:, 1:]
    angles: Floats = 2 * np.arctan2(np.linalg.norm(vector, axis=1), np.abs(scalar))
    return angles


def _integrals(model: Model, q: Floats, omega: Floats) -> tuple[Floats, Floats]:
    """Energies and angular momenta about the vertical."""
    w, x, y, z = q.T
    up = np.stack([2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z], axis=1)
    moments = np.array(model["inertia"])
    weight = model["mass"] * model["gravity"]
    return (moments * omega**2).sum(axis=1) / 2 + weight * up @ np.array(model["com"]), (moments * omega * up).sum(axis=1)
