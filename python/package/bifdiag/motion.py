"""The motion of a body in space."""

import json
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from . import _core, exact, pictures
from .errors import InputError
from .tables import StoredTable
from .times import times


class Motion(StoredTable):
    """A motion in space: a row for each time; made by `Body.orbit`.

    The frame in space is right-handed and its **third axis points down**, along gravity, as γ does; the first two are
    fixed by ``phi`` at the start. The body's axes are the principal axes, in the order of A. See the page
    "Conventions".

    Attributes
    ----------
    time : array (n,)
        Times.
    gamma, l, omega : array (n, 3)
        The downward vertical γ, the angular momentum and the angular velocity ω = A⁻¹ l, in the body's axes.
    theta, psi, phi : array (n,)
        Euler's angles of R = R_z(φ) R_x(ϑ) R_z(ψ), which takes vectors from the body frame to space; γ is its third
        row: γ = (sin ψ sin ϑ, cos ψ sin ϑ, cos ϑ). So ϑ in [0, π] is the angle between the body's third axis and *down*;
        ψ is in (−π, π], and φ, the angle about the vertical, is continuous. These are not the ``theta`` and ``psi`` of a
        `Section`.
    quaternion : array (n, 4)
        The same R as w, x, y, z; continuous in time.
    meta : dict
        ``A`` and ``r``, ``energy`` H and ``momentum`` ⟨γ, l⟩ of the start, ``energy_drift``, the largest deviation from
        that energy at the times, ``tolerance`` and ``version``.
    """

    time: npt.NDArray[np.float64]
    gamma: npt.NDArray[np.float64]
    l: npt.NDArray[np.float64]
    omega: npt.NDArray[np.float64]
    theta: npt.NDArray[np.float64]
    psi: npt.NDArray[np.float64]
    phi: npt.NDArray[np.float64]
    quaternion: npt.NDArray[np.float64]

    NAMES = ("time", "gamma", "l", "omega", "theta", "psi", "phi", "quaternion")
    KIND: ClassVar[str] = "motion"

    @classmethod
    def _compute(
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
            "times": times(t).tolist(),
            "phi": exact.real(phi, "phi"),
            "tolerance": exact.real(tolerance, "tolerance"),
        }
        columns = _core.motion(body, request)
        meta = {name: columns.pop(name) for name in [name for name in columns if name not in cls.NAMES]}
        about = {"A": body.moments, "r": body.center, "version": _core.__version__, "tolerance": float(tolerance)}
        return cls(columns, json.dumps(about | meta))

    @property
    def energy(self) -> npt.NDArray[np.float64]:
        """H = ½⟨l, ω⟩ − ⟨γ, r⟩ at each time; constant but for the error of the integrator."""
        energy: npt.NDArray[np.float64] = (self.l * self.omega).sum(axis=1) / 2 - self.gamma @ self.center
        return energy

    @property
    def center(self) -> npt.NDArray[np.float64]:
        """The body's r as floats."""
        return np.array([float(exact.value(text)) for text in self.meta["r"]])

    def plot(self, ax: Any = None, *, figsize: "tuple[float, float] | None" = None, **line: Any) -> Any:
        """Draws the path of the centre of mass in space with matplotlib; see `bifdiag.pictures.motion`."""
        return pictures.motion(self, ax, figsize=figsize, **line)

    def attitude(self, *, scalar_first: bool = True) -> npt.NDArray[np.float64]:
        """The quaternions in either order; they take vectors from the body frame to space.

        Parameters
        ----------
        scalar_first : bool
            True: w, x, y, z. False: x, y, z, w, the default of ``scipy.spatial.transform.Rotation.from_quat``.

        Returns
        -------
        array (n, 4)
        """
        return self.quaternion if scalar_first else np.roll(self.quaternion, -1, axis=1)

    def axes(self) -> npt.NDArray[np.float64]:
        """The matrices R from the body frame to space: ``axes()[k, :, i]`` is the body's i-th axis at time k.

        ``axes()[k] @ gamma[k]`` is (0, 0, 1), down.

        Returns
        -------
        array (n, 3, 3)
        """
        w, x, y, z = self.quaternion.T
        rows = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
        return np.moveaxis(np.array(rows), -1, 0)

    def __repr__(self) -> str:
        return f"Motion of {len(self)} times [{', '.join(self.columns)}, meta]"
