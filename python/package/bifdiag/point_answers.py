"""What an atlas says of points, one or many."""

import json
from typing import Any, Literal, TypeAlias, overload

import numpy as np
import numpy.typing as npt

from . import arrays, exact
from .atlas_document import AtlasDocument
from .exact import Number
from .points import Classifications
from .records import Classification

Numbers: TypeAlias = npt.NDArray[Any] | list[Any] | tuple[Any, ...]
"""Arrays of numpy, and what becomes one; those of xarray and pandas keep their labels."""

Policy: TypeAlias = Literal["mark", "raise"]
"""What becomes of an invalid point."""


class PointAnswers(AtlasDocument):
    """Regions, types and margins of points; `Atlas` is one."""

    @overload
    def region(self, h: Number, l: Number, *, threads: int | None = None, invalid: Policy = "mark") -> int: ...
    @overload
    def region(
        self, h: Numbers, l: Number | Numbers, *, threads: int | None = None, invalid: Policy = "mark"
    ) -> npt.NDArray[np.int64]: ...
    @overload
    def region(
        self, h: Number, l: Numbers, *, threads: int | None = None, invalid: Policy = "mark"
    ) -> npt.NDArray[np.int64]: ...
    @overload
    def region(self, h: Any, l: Any, *, threads: int | None = None, invalid: Policy = "mark") -> Any: ...
    def region(self, h: Any, l: Any, *, threads: int | None = None, invalid: str = "mark") -> Any:
        """Indices of the regions of points.

        Parameters
        ----------
        h, l : number, or array of them
            Energies and vertical angular momenta, of shapes that broadcast. The floats of an array mean their shortest
            decimals, as scalars do. Arrays of Fraction or str are exact. The sign of l does not matter. A
            ``xarray.DataArray`` broadcasts by its dimensions, and a ``pandas.Series`` or ``DataFrame`` by its labels.
        threads : int, optional
            None: one; 0: one per core. The result does not depend on it.
        invalid : {"mark", "raise"}
            What becomes of a point with a float that is NaN, masked, infinite, or beyond 1e±150: its code is −4, or an
            error names it. A text, Decimal, Fraction or int that is no number in range is always an error, and so is a
            float beyond 1e±150 in an array of such objects.

        Returns
        -------
        int, or array of int, or as h and l a DataArray, a Series or a DataFrame
            Indices into `regions`; −1 forbidden, −2 on a curve, −3 undecided (only with the accuracy ``"fast"``), −4
            invalid.

        Raises
        ------
        InputError
            If a value is not a number, or the shapes do not broadcast; with ``invalid="raise"`` for an invalid number.
        RangeError
            If a point cannot be decided.

        Examples
        --------
        >>> import bifdiag
        >>> atlas = bifdiag.Body.preset("paper").atlas()
        >>> atlas.region([0, 3.8, float("nan")], 3.25)
        array([-1,  4, -4])
        >>> atlas.regions[4]
        Region R5: S2+T2 near ...
        """
        exact.threads(threads)
        if _is_plain(h) and _is_plain(l):
            return self._inner.place(exact.text(h, "h"), exact.text(l, "l"))
        given = arrays.points(h, l, invalid)
        if isinstance(given.h, list):
            pairs = zip(given.h, given.l, strict=True)
            with given.named():
                places = np.array([self._inner.place(*pair) for pair in pairs], dtype=np.int64)
        else:
            places = self._inner.places(given.h, given.l, exact.threads(threads))
        return given.dress(given.spread(places, arrays.INVALID), "region")

    @overload
    def classify(self, h: Number, l: Number) -> Classification: ...
    @overload
    def classify(
        self, h: Numbers, l: Number | Numbers, *, threads: int | None = None, invalid: Policy = "mark"
    ) -> Classifications: ...
    @overload
    def classify(
        self, h: Number, l: Numbers, *, threads: int | None = None, invalid: Policy = "mark"
    ) -> Classifications: ...
    @overload
    def classify(self, h: Any, l: Any, *, threads: int | None = None, invalid: Policy = "mark") -> Any: ...
    def classify(self, h: Any, l: Any, *, threads: int | None = None, invalid: str = "mark") -> Any:
        """The type of U, E and P at one point, or at each of many.

        Parameters
        ----------
        h, l, threads, invalid
            As of `region`.

        Returns
        -------
        Classification or Classifications
            Of two scalars like `Body.classify`, but faster; of arrays a table with the codes of `region`, the components of
            each code, and the distance to the nearest curve.

        Raises
        ------
        InputError
            As of `region`, and for a single point that is invalid.
        RangeError
            If a point cannot be decided.

        Examples
        --------
        >>> import bifdiag
        >>> atlas = bifdiag.Body.preset("paper").atlas()
        >>> found = atlas.classify([0, 3.8], 3.25)
        >>> found.code, found.region, found.signature
        (array([-1,  4]), array([None, 'R5'], dtype=object), array([None, 'S2+T2'], dtype=object))
        >>> atlas.classify(3.8, 3.25).margin.nearest == found.nearest[1]
        True
        """
        if _is_scalar(h) and _is_scalar(l):
            return Classification._of(json.loads(self._inner.classify(exact.text(h, "h"), exact.text(l, "l"))))
        given = arrays.points(h, l, invalid)
        return Classifications._of(given, self._measured(given, threads), self.regions)

    @overload
    def margin(self, h: Number, l: Number, *, threads: int | None = None, invalid: Policy = "mark") -> float: ...
    @overload
    def margin(
        self, h: Numbers, l: Number | Numbers, *, threads: int | None = None, invalid: Policy = "mark"
    ) -> npt.NDArray[np.float64]: ...
    @overload
    def margin(
        self, h: Number, l: Numbers, *, threads: int | None = None, invalid: Policy = "mark"
    ) -> npt.NDArray[np.float64]: ...
    @overload
    def margin(self, h: Any, l: Any, *, threads: int | None = None, invalid: Policy = "mark") -> Any: ...
    def margin(self, h: Any, l: Any, *, threads: int | None = None, invalid: str = "mark") -> Any:
        """Distances in h of points from the nearest critical curve or pole line at their l.

        Parameters
        ----------
        h, l, threads, invalid
            As of `region`.

        Returns
        -------
        float, or array of float, or as h and l a DataArray, a Series or a DataFrame
            ``|h − h_c|``; NaN where the point is invalid. `classify` also names the curve, and bounds the error.

        Raises
        ------
        InputError, RangeError
            As of `region`.

        Examples
        --------
        >>> import bifdiag
        >>> atlas = bifdiag.Body.preset("paper").atlas()
        >>> atlas.margin([3.8, 4], 3.25).round(4)
        array([0.3153, 0.2319])
        """
        given = arrays.points(h, l, invalid)
        return given.dress(given.spread(self._measured(given, threads)["margin"], np.nan), "margin")

    def _measured(self, given: arrays.Points, threads: int | None) -> dict[str, Any]:
        with given.named():
            return self._inner.measured(given.h, given.l, exact.threads(threads))


def _is_scalar(value: Any) -> bool:
    """One number, and no array of any kind with one entry."""
    return isinstance(value, str) or (np.ndim(value) == 0 and not hasattr(value, "dims"))


def _is_plain(value: Any) -> bool:
    """A number of Python in range, as most single points are."""
    return type(value) in (int, float) and (value == 0 or 1 / exact.LARGEST <= abs(value) <= exact.LARGEST)
