"""Maps of the chaotic share of energy surfaces."""

import json
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from . import _core, exact, pictures
from .errors import InputError
from .exact import Number
from .given import body_of
from .optional import needed
from .records import ChaosPoint
from .tables import StoredTable

if TYPE_CHECKING:
    import xarray

    from .body import Body

STEPS = (160, 2**24)
"""The fewest and the most steps of an orbit."""


class ChaosMap(StoredTable):
    """The chaotic share over a window of the (h, l) plane, a row for each component of E in each region in each cell; made
    by ``Body.chaos(window=…)``.

    Shares are of the Liouville measure of the component. No number is a mean over two regions: a cell through which a curve
    goes has a row for each.

    Attributes
    ----------
    i, j : array (n,) of int
        The cell, from 0 along h and along l.
    h, l : array (n,)
        Its centre.
    region : array (n,) of int
        The region, as an index into `Atlas.regions`; `id` has the names, which tables have as ``region``.
    component : array (n,) of int
        The component of E, in the order of `Body.classify`.
    part : array (n,)
        Which part of the block belongs to the region, of 16 points.
    block : array (n,) of int
        Cells along a side of the block that was measured as one.
    fraction : array (n,)
        The share of the orbits that are known to be chaotic; NaN without orbits. The whole lies between this and
        ``fraction + open``.
    error : array (n,)
        One standard deviation of ``fraction``.
    open : array (n,)
        The share of the orbits without a verdict.
    orbits : array (n,) of int
        How many were judged.
    crossings : array (n,)
        How often they crossed the section S = 0.
    meta : dict
        The document of ``bifdiag chaos`` without its rows: ``window``, ``cells``, ``error``, ``steps``, ``seed``.
    """

    i: npt.NDArray[np.int32]
    j: npt.NDArray[np.int32]
    h: npt.NDArray[np.float64]
    l: npt.NDArray[np.float64]
    region: npt.NDArray[np.int32]
    component: npt.NDArray[np.int32]
    part: npt.NDArray[np.float64]
    block: npt.NDArray[np.int32]
    fraction: npt.NDArray[np.float64]
    error: npt.NDArray[np.float64]
    open: npt.NDArray[np.float64]
    orbits: npt.NDArray[np.int32]
    crossings: npt.NDArray[np.int32]

    NAMES = (
        *("i", "j", "h", "l", "region", "component", "part", "block"),
        *("fraction", "error", "open", "orbits", "crossings"),
    )
    KIND: ClassVar[str] = "chaos map"

    @classmethod
    def _compute(
        cls,
        body: _core.Body,
        window: Any,
        cells: Any,
        error: float,
        steps: int,
        seed: int,
        threads: int | None,
    ) -> "ChaosMap":
        ranges = None
        if window is not None:
            if len(window) != 2:
                raise InputError(f"window = {window!r}: two ranges are needed, (h0, h1), (l0, l1)")
            ranges = [exact.span(window[0], "window[0]"), exact.span(window[1], "window[1]")]
        if np.ndim(cells) == 0:
            cells = (cells, cells)
        if len(cells) != 2:
            raise InputError(f"cells = {cells!r}: two numbers are needed, along h and along l")
        counts = [exact.whole(count, f"cells[{k}]", 1, 10**8) for k, count in enumerate(cells)]
        if counts[0] * counts[1] > 10**8:
            raise InputError(f"cells = {cells!r}: at most 100000000 cells are possible")
        options = _options(error, steps, seed, threads)
        columns = _core.chaos_map(body, ranges, counts, *options)
        return cls(columns, columns.pop("meta"))

    @property
    def id(self) -> npt.NDArray[np.object_]:
        """The id of the region of each row."""
        names = np.array([f"R{k + 1}" for k in range(int(self.region.max(initial=-1)) + 1)], dtype=object)
        return names[self.region]

    def flat(self) -> dict[str, npt.NDArray[Any]]:
        """The columns of tables: ``region`` is the id there, ``code`` the index."""
        out: dict[str, npt.NDArray[Any]] = {}
        for name, column in super().flat().items():
            out |= {"code": column, "region": self.id} if name == "region" else {name: column}
        return out

    @property
    def shape(self) -> tuple[int, int]:
        """Cells along h and along l."""
        n, m = self.meta["cells"]
        return n, m

    @property
    def window(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Ranges of h and l."""
        h, l = self.meta["window"]["h"], self.meta["window"]["l"]
        return (h[0], h[1]), (l[0], l[1])

    @property
    def body(self) -> "Body":
        """The body of the map."""
        return body_of(self.meta)

    def axes(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """The centres of the cells along h and along l."""
        (h, l), (n, m) = self.window, self.shape
        along = [low + (high - low) * (np.arange(k) + 0.5) / k for (low, high), k in zip((h, l), (n, m), strict=True)]
        return along[0], along[1]

    def grid(self, name: str = "fraction") -> npt.NDArray[np.float64]:
        """A column over the cells, (n, m): of the rows of a cell the first with the largest part; NaN in forbidden cells.

        `to_xarray` keeps regions and components apart.
        """
        out = np.full(self.shape, np.nan)
        order = np.lexsort((-self.component, self.part))
        out[self.i[order], self.j[order]] = self[name][order]
        return out

    def to_xarray(self) -> "xarray.Dataset":
        """A Dataset over ``region``, ``component``, ``h`` and ``l``; NaN where a cell has no such row.

        ``bifdiag[tables]`` installs xarray.
        """
        xr = needed("xarray", "tables")
        h, l = self.axes()
        regions, places = np.unique(self.region, return_inverse=True)
        components = int(self.component.max(initial=-1)) + 1
        variables = {}
        for name in ("fraction", "error", "open", "orbits", "part"):
            values = np.full((len(regions), components, *self.shape), np.nan)
            values[places.reshape(-1), self.component, self.i, self.j] = self[name]
            variables[name] = (("region", "component", "h", "l"), values)
        coords = {"region": [f"R{k + 1}" for k in regions], "component": np.arange(components), "h": h, "l": l}
        data: xarray.Dataset = xr.Dataset(variables, coords=coords, attrs={"meta": self._meta})
        return data

    def plot(self, ax: Any = None, **options: Any) -> Any:
        """Draws the map with matplotlib, the curves and names of regions over it; see `bifdiag.pictures.chaos`."""
        return pictures.chaos(self, ax, **options)

    def __repr__(self) -> str:
        n, m = self.shape
        return f"ChaosMap of {n} × {m} cells: {len(self)} rows [{', '.join(self.columns)}, meta]"


def point(body: _core.Body, h: Number, l: Number, error: float, steps: int, seed: int, threads: int | None) -> ChaosPoint:
    """The shares at one point."""
    options = _options(error, steps, seed, threads)
    return ChaosPoint._of(json.loads(_core.chaos_point(body, exact.text(h, "h"), exact.text(l, "l"), *options)))


def _options(error: float, steps: int, seed: int, threads: int | None) -> tuple[float, int, int, int]:
    wanted = exact.real(error, "error")
    if not 1e-4 <= wanted <= 0.5:
        raise InputError(f"error = {error}: a standard deviation from 0.0001 to 0.5 is needed")
    least, most = STEPS
    return wanted, exact.whole(steps, "steps", least, most), exact.whole(seed, "seed", 0), exact.threads(threads)
