"""The motion of a body in space."""

import json
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from . import _core, exact, pictures
from .errors import InputError
from .optional import needed
from .tables import StoredTable
from .times import times

if TYPE_CHECKING:
    import xarray


class Motion(StoredTable):
    """A motion in space: a row for each time; made by `Body.orbit`. Of many starts a row for each time of each.

    The frame in space is right-handed and its **third axis points down**, along gravity, as γ does; the first two are
    fixed by ``phi`` at the start. The body's axes are the principal axes, in the order of A. See the page
    "Conventions".

    Attributes
    ----------
    orbit : array (n,) of int
        The place of the row's start among the starts, flat; only of many: ``motion[motion.orbit == 3]`` is one of them.
    time : array (n,)
        Times.
    gamma, l, omega : array (n, 3)
        The downward vertical γ, the angular momentum and the angular velocity ω = A⁻¹ l, in the body's axes.
    theta, psi, phi : array (n,)
        Euler's angles of R = R_z(φ) R_x(ϑ) R_z(ψ), which takes vectors from the body frame to space; γ is its third
        row: γ = (sin ψ sin ϑ, cos ψ sin ϑ, cos ϑ). So ϑ in [0, π] is the angle between the body's third axis and *down*;
        ψ is in (−π, π], and φ, the angle about the vertical, is continuous while γ is not at ±e₃. These are not the
        ``theta`` and ``psi`` of a `Section`.
    quaternion : array (n, 4)
        The same R as w, x, y, z; continuous in time.
    meta : dict
        ``A`` and ``r``, ``energy`` H and ``momentum`` ⟨γ, l⟩ of the start, ``energy_drift``, the largest deviation from
        that energy at the times (of many starts lists of these), ``tolerance`` and ``version``; of a file of ``bifdiag
        orbit`` also its ``document``.
    """

    orbit: npt.NDArray[np.int32]
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
        if (l is None) == (omega is None):
            raise InputError("give either l, the angular momentum, or omega, the angular velocity")
        name, turning = ("l", l) if omega is None else ("omega", omega)
        starts = [_vectors(gamma, "gamma"), _vectors(turning, name)]
        if not starts[0].any(axis=-1).all():
            raise InputError("gamma = 0 is no direction")
        try:
            shape = np.broadcast_shapes(*(start.shape for start in starts))
        except ValueError as error:
            shapes = " and ".join(str(start.shape) for start in starts)
            raise InputError(f"gamma and {name} have the shapes {shapes}, which do not broadcast") from error
        wanted, step = times(t), exact.real(tolerance, "tolerance")
        if not 1e-18 <= step <= 1e-2:
            raise InputError(f"tolerance = {tolerance} is not usable; 1e-18 to 1e-2 is possible")
        request = {
            "is_omega": omega is not None,
            "times": wanted.tolist(),
            "phi": exact.real(phi, "phi"),
            "tolerance": step,
        }
        found = [
            _core.motion(body, request | {"gamma": vertical, "l": momentum})
            for vertical, momentum in zip(
                *(np.broadcast_to(start, shape).reshape(-1, 3).tolist() for start in starts), strict=True
            )
        ]
        about: dict[str, Any] = {
            "A": body.moments,
            "r": body.center,
            "version": _core.__version__,
            "tolerance": float(tolerance),
        }
        if len(shape) == 1:
            (columns,) = found
            meta = {name: value for name, value in columns.items() if name not in cls.NAMES}
            return cls({name: columns[name] for name in cls.NAMES}, json.dumps(about | meta))
        names = ("energy", "momentum", "energy_drift")
        meta = {name: [one[name] for one in found] for name in names}
        rows: dict[str, npt.NDArray[Any]] = {"orbit": np.repeat(np.arange(len(found), dtype=np.int32), len(wanted))}
        width = {"gamma": (0, 3), "l": (0, 3), "omega": (0, 3), "quaternion": (0, 4)}
        for name in cls.NAMES:
            rows[name] = np.concatenate([np.empty(width.get(name, 0)), *(one[name] for one in found)])
        return cls(rows, json.dumps(about | meta))

    @classmethod
    def _of_command(cls, arrays: dict[str, npt.NDArray[Any]]) -> dict[str, npt.NDArray[Any]]:
        if "attitude" not in arrays or "quaternion" in arrays:
            return arrays
        try:
            document = json.loads(str(arrays["meta"]))
            about = {name: document[name] for name in ("A", "r", "version")}
            about |= {"tolerance": document["integrator"]["tol"], "energy": document["h"], "momentum": document["l"]}
            about |= {"energy_drift": document["summary"]["drift"]["h"], "document": document}
        except (KeyError, TypeError, ValueError):
            return arrays
        named = {"quaternion" if name == "attitude" else name: array for name, array in arrays.items()}
        return named | {"meta": np.array(json.dumps(about))}

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
        """Draws the path of the centre of mass in space, of each orbit, with matplotlib; see `bifdiag.pictures.motion`."""
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

    def to_xarray(self) -> "xarray.Dataset":
        """A Dataset over ``time``, of many starts over ``orbit`` too, and ``axis`` or ``component`` (w, x, y, z)."""
        xr = needed("xarray", "tables")
        names = [name for name in self.NAMES if name != "time"]
        size = {"gamma": "axis", "l": "axis", "omega": "axis", "quaternion": "component"}
        coords: dict[str, Any] = {"time": self.time, "axis": [1, 2, 3], "component": list("wxyz")}
        first: tuple[str, ...] = ("time",)
        shape: tuple[int, ...] = (len(self),)
        if "orbit" in self.columns:
            orbits, counts = np.unique(self.orbit, return_counts=True)
            shape = (len(orbits), int(counts[0]) if len(counts) else 0)
            whole = len(set(counts.tolist())) < 2 and (np.diff(self.orbit) >= 0).all()
            if not whole or (self.time.reshape(shape) != self.time[: shape[1]]).any():
                raise InputError("the orbits have different times here; select one of them, or whole ones")
            first, coords = ("orbit", "time"), coords | {"time": self.time[: shape[1]], "orbit": orbits}
        columns = {
            name: ((*first, size[name]) if name in size else first, self[name].reshape(*shape, *self[name].shape[1:]))
            for name in names
        }
        data: xarray.Dataset = xr.Dataset(columns, coords=coords, attrs={"meta": self._meta})
        return data

    def _parts(self) -> "list[Motion]":
        """Each orbit on its own."""
        return [self[self.orbit == k] for k in np.unique(self.orbit)] if "orbit" in self.columns else [self]

    def __repr__(self) -> str:
        of = f" of {len(np.unique(self.orbit))} orbits" if "orbit" in self.columns else ""
        return f"Motion of {len(self)} times{of} [{', '.join(self.columns)}, meta]"


def _vectors(values: Any, name: str) -> npt.NDArray[np.float64]:
    """One vector, or an array of them."""
    found: npt.NDArray[np.float64] = exact.floats(values, name)
    if found.ndim == 0 or found.shape[-1] != 3:
        raise InputError(f"{name} has the shape {found.shape}; three numbers are needed, or an array (…, 3)")
    if not np.isfinite(found).all():
        raise InputError(f"{name} = {values!r} is not finite")
    return found
