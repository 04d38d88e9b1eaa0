"""The motion of a body in space."""

import json
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core, exact
from .errors import InputError
from .tables import Table

SAMPLES = 201
"""Times if only the last one is said."""


class Motion(Table):
    """A motion in space: a row for each time; made by `Body.orbit`.

    Attributes
    ----------
    time : array (n,)
        Times.
    gamma, l, omega : array (n, 3)
        Vertical, angular momentum and angular velocity, in the body's axes.
    theta, psi, phi : array (n,)
        Euler's angles of the third axis.
    quaternion : array (n, 4)
        The attitude w, x, y, z: takes vectors of the body to space, continuous in time.
    """

    NAMES = ("time", "gamma", "l", "omega", "theta", "psi", "phi", "quaternion")

    @classmethod
    def compute(
        cls,
        body: _core.Body,
        gamma: npt.ArrayLike,
        l: npt.ArrayLike | None,
        omega: npt.ArrayLike | None,
        t: npt.ArrayLike,
        phi: float,
        tolerance: float,
    ) -> "Motion":
        vertical = exact.vector(gamma, "gamma", 3)
        if not vertical.any():
            raise InputError("gamma = 0 is no direction")
        if (l is None) == (omega is None):
            raise InputError("give either l, the angular momentum, or omega, the angular velocity")
        name, turning = ("l", l) if omega is None else ("omega", omega)
        request = {
            "gamma": vertical.tolist(),
            "l": exact.vector(turning, name, 3).tolist(),
            "is_omega": omega is not None,
            "times": _times(t),
            "phi": exact.real(phi, "phi"),
            "tolerance": exact.real(tolerance, "tolerance"),
        }
        columns = _core.motion(body, request)
        meta = {name: columns.pop(name) for name in [name for name in columns if name not in cls.NAMES]}
        about = {"A": body.moments, "r": body.center, "version": _core.__version__, "tolerance": float(tolerance)}
        return cls(columns, json.dumps(about | meta))

    def attitude(self, *, scalar_first: bool = True) -> npt.NDArray[np.float64]:
        """The quaternions in either order.

        Parameters
        ----------
        scalar_first : bool
            True: w, x, y, z. False: x, y, z, w, as ``scipy.spatial.transform.Rotation.from_quat`` takes them by default.

        Returns
        -------
        array (n, 4)
        """
        return self.quaternion if scalar_first else np.roll(self.quaternion, -1, axis=1)

    def axes(self) -> npt.NDArray[np.float64]:
        """The body's axes in space: ``axes()[k, :, i]`` is the i-th at time k."""
        w, x, y, z = self.quaternion.T
        rows = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
        return np.moveaxis(np.array(rows), -1, 0)

    def __repr__(self) -> str:
        return f"Motion of {len(self)} times [{', '.join(self.columns)}, meta]"


def _times(t: Any) -> list[float]:
    try:
        times: npt.NDArray[np.float64] = np.asarray(t, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InputError(f"t = {t!r}: {error}") from error
    if times.ndim == 0:
        times = np.linspace(0.0, float(times), SAMPLES) if times >= 0 else np.linspace(float(times), 0.0, SAMPLES)
    if times.ndim != 1 or not len(times) or not np.isfinite(times).all() or (np.diff(times) < 0).any():
        raise InputError("t: finite times that rise are needed")
    found: list[float] = times.tolist()
    return found
