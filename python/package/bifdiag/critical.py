"""Relative equilibria as a table."""

import json
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, overload

import numpy as np
import numpy.typing as npt

from . import _core, arrays, exact
from .arrays import Labels
from .behaviour import counted
from .tables import Table, frame_of
from .verdicts import LATER, VERDICTS, Columns, deferred, place, worded

if TYPE_CHECKING:
    import pandas
    import xarray


class Equilibria(Table):
    """Relative equilibria, a row for each; made by `Body.critical`.

    Columns are attributes, or items as of a structured array: ``found.h`` is ``found["h"]``. An array of bools, a slice or
    a list of numbers selects rows: ``found[found["index"] == 0]``, and of masked bools those that are True; ``found[3]`` is
    one row, and ``numpy.asarray(found)`` the structured array of all of them. `to_pandas`, `to_arrow` and `to_xarray` hand
    them on.

    Attributes
    ----------
    l_index : array (n,) of int
        The place of the row's l in ``np.ravel(l)``; only of an array of l. `to_pandas` and `to_xarray` also have the index
        of pandas or the dimensions and coordinates of xarray that l had.
    l, h : array (n,)
        Momentum and energy.
    gamma : array (n, 3)
        The downward vertical, in the body's axes; the body turns about it.
    omega : array (n,)
        The angular velocity l/⟨γ, A γ⟩, signed as l.
    index : array (n,) of int
        Negative eigenvalues of the Hessian of U_l: 0 minimum, 1 saddle, 2 maximum, unless ``multiplicity`` is ``"2"``.
        Of a circle in its one normal direction: 0 minima, 1 maxima; 0 also where that is degenerate, at a cusp.
    multiplicity : array (n,) of str
        ``"1"``; ``"2"``: degenerate, where two meet (a cusp) or three, or one and a circle (a pitchfork), more where a cusp
        lies at a pitchfork; ``"circle"`` and ``"sphere"`` of them. Two that are mirror images are two rows.
    stability : array (n,) of str
        Linear type: ``"elliptic"`` (two imaginary pairs), ``"saddle-centre"`` (one real, one imaginary), ``"saddle"`` (two
        real), ``"complex"`` (a quadruple), ``"double-elliptic"``, ``"double-real"`` (a double pair), ``"zero"`` (an
        eigenvalue 0). Across a circle of them there is one pair only: ``"elliptic"`` imaginary, ``"saddle"`` real,
        ``"zero"`` 0; along it the eigenvalues are 0.
    stable : masked array (n,) of bool
        Stable at fixed l, up to rotation about the vertical (of a circle or sphere of them, the whole of it); masked where
        that is open (pandas: NA; in a row: None).
    stable_by : array (n,) of str
        Why: ``"energy"`` (a minimum), ``"integral"`` (a further integral), ``"arnold"`` (Arnold's theorem), ``"spectrum"``
        (an eigenvalue with positive real part); ``"resonance 1:1"``, ``"resonance 1:2"``, ``"resonance 1:3"`` and
        ``"degenerate"`` where none of these decides: ``stable`` may be True, False or masked there.
    verdict : array (n,) of str
        ``"stable"``, ``"unstable"`` or ``"open"``.
    survives_friction : array (n,) of bool
        It stays stable with a small friction that conserves l.
    eigenvalues : array (n, 2) of complex
        Of the pairs ±λ₁, ±λ₂ of the flow reduced by l, with re ≥ 0 and im ≥ 0; of a circle its transverse pair, then 0. A
        quadruple gives the same one twice.
    eigenvalue_error : array (n,)
        Bound on their error.
    branch : array (n,) of str
        Id of the curve in the atlas, or ``"l=0"`` at rest without weight, which is on none; the page "Conventions" explains
        ids.
    branch_name : array (n,) of str
        The branch in words, such as ``"from +r̂"`` or ``"pair over axis 2"``.
    meta : dict
        ``A``, ``r``, ``version``; ``error_bound`` of every h; ``complete``: False where it could not be decided whether
        there are more; ``invalid``: the places of an l without rows, since it is missing, infinite or out of range.

    Notes
    -----
    Where Arnold's theorem is needed, a verdict takes several times as long as all the rest of its row. So ``stable``,
    ``stable_by`` and ``verdict`` of many momenta are computed when one of them is first read, or when the table is handed
    on.
    """

    l_index: npt.NDArray[np.int64]
    l: npt.NDArray[np.float64]
    h: npt.NDArray[np.float64]
    gamma: npt.NDArray[np.float64]
    omega: npt.NDArray[np.float64]
    index: npt.NDArray[np.int8]
    multiplicity: npt.NDArray[np.str_]
    stability: npt.NDArray[np.str_]
    stable: np.ma.MaskedArray[Any, np.dtype[np.bool_]]
    stable_by: npt.NDArray[np.str_]
    verdict: npt.NDArray[np.str_]
    survives_friction: npt.NDArray[np.bool_]
    eigenvalues: npt.NDArray[np.complex128]
    eigenvalue_error: npt.NDArray[np.float64]
    branch: npt.NDArray[np.str_]
    branch_name: npt.NDArray[np.str_]

    _quick: Columns

    def __init__(
        self, columns: Columns, meta: str, later: Callable[[], Columns] | None = None, labels: Labels | None = None
    ) -> None:
        self._later, self._labels = later, labels
        super().__init__(columns, meta)

    @classmethod
    def _compute(cls, body: _core.Body, l: Any, threads: int | None, invalid: str) -> "Equilibria":
        scalar = np.ndim(l) == 0
        given = arrays.points(0.0, l, "raise" if scalar else invalid)
        asked, places = given.l, np.flatnonzero(given.valid)
        count = exact.threads(threads)
        with given.named():
            found = _core.critical(body, asked, scalar, count)
        about: dict[str, Any] = {"A": list(body.moments), "r": list(body.center), "version": _core.__version__}
        about |= {name: found.pop(name) for name in ("error_bound", "complete")}
        meta = json.dumps(about | {"invalid": np.flatnonzero(~given.valid).tolist()})
        words = found.pop("words")
        codes = found["branch"], found["verdict"], found["stable_by"]
        verdicts = worded(codes[1], codes[2], words)
        later = None
        if (codes[1] == LATER).any():
            later = deferred(body, asked, found["l_index"], words, codes, count)
        found["l_index"] = places[found["l_index"]]
        return cls(_columns(found, words, None if later else verdicts, scalar), meta, later, Labels.of(given))

    @property
    def _columns(self) -> Columns:
        if self._later is not None:
            quick, later = self._quick, self._later()
            before, after = list(quick)[: place(quick)], list(quick)[place(quick) :]
            ordered = [*before, *VERDICTS, *after]
            self._quick = {name: later[name] if name in VERDICTS else quick[name] for name in ordered}
            self._later = None
        return self._quick

    @_columns.setter
    def _columns(self, columns: Columns) -> None:
        self._quick = columns

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of the columns."""
        names = list(self._quick)
        if self._later is not None:
            names[place(self._quick) : place(self._quick)] = VERDICTS
        return tuple(names)

    @property
    def shape(self) -> tuple[int]:
        """The number of rows, as a tuple."""
        return (len(self),)

    @overload
    def __getitem__(self, key: str) -> npt.NDArray[Any]: ...
    @overload
    def __getitem__(self, key: int) -> np.void: ...
    @overload
    def __getitem__(self, key: "slice | npt.NDArray[Any] | list[int] | list[bool]") -> "Equilibria": ...
    def __getitem__(self, key: Any) -> Any:
        # A column that is there already needs no verdicts.
        return self._quick[key] if isinstance(key, str) and key in self._quick else super().__getitem__(key)

    def _selected(self, kept: Any) -> "Equilibria":
        rows = {name: column[kept] for name, column in self._quick.items()}
        later = None
        if self._later is not None:
            later = lambda: {name: self._columns[name][kept] for name in VERDICTS}  # noqa: E731
        return Equilibria(rows, self._meta, later, self._labels)

    # Type checkers know the columns by name, so that they find typing errors.
    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> npt.NDArray[Any]:
            quick: Columns = self.__dict__.get("_quick", {})
            if name in quick:
                return quick[name]
            if not quick or name not in self.columns:
                columns = ", ".join(self.columns) if quick else "none yet"
                raise AttributeError(f"Equilibria has no column {name!r}; it has {columns}")
            return self._columns[name]

    def __dir__(self) -> list[str]:
        return [*object.__dir__(self), *self.columns]

    def __len__(self) -> int:
        return len(self._quick["h"])

    def to_pandas(self) -> "pandas.DataFrame":
        """A DataFrame; if l had an index or dimensions, each row has the label of its l. ``meta`` is its ``attrs``."""
        frame = frame_of(self.flat(), None if self._labels is None else self._labels.index(self.l_index))
        frame.attrs.update(self.meta)
        return frame

    def to_xarray(self) -> "xarray.Dataset":
        """A Dataset over ``row``; if l had coordinates or an index, these are coordinates of the rows, too.

        Eigenvalues are two variables, ``eigenvalues_re`` and ``eigenvalues_im``, which every file can store.
        """
        data = super().to_xarray()
        if self._labels is None:
            return data
        labels = self._labels.columns(self.l_index)
        # Where a dimension is called l, the column is the coordinate.
        found = data.set_coords([name for name in labels if name in data])
        return found.assign_coords({name: ("row", values) for name, values in labels.items() if name not in data})

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._columns, self._meta, None, self._labels)

    def _repr_html_(self) -> str:
        shown = ("l", "h", "index", "stability", "stable", "stable_by", "branch")
        heads = "".join(f"<th>{name}</th>" for name in shown)
        few = self[:20]
        rows = "".join("<tr>" + "".join(f"<td>{_cell(row[name])}</td>" for name in shown) + "</tr>" for row in few)
        more = f"<p>and {counted(len(self) - len(few), 'more row')}</p>" if len(self) > len(few) else ""
        return f"<table><tr>{heads}</tr>{rows}</table>{more}"

    def __repr__(self) -> str:
        lines = [self._head()]
        for row in self[:12]:
            stable = {True: "stable", False: "unstable", None: "open"}[row["stable"]]
            why = f"{stable} ({row['stable_by']})"
            lines.append(f"  l = {row['l']:.6g}, h = {row['h']:.6g}: {row['branch']}, index {row['index']}, {why}")
        without = self.meta["invalid"]
        places = ", ".join(map(str, without[:8]))
        told = [f"  without rows, since l is missing, infinite or out of range there: l_index {places}"]
        told[0] += ", …" if len(without) > 8 else ""
        return "\n".join([*lines, *(["  …"] if len(self) > 12 else []), *(told if without else [])])


def _cell(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _columns(found: dict[str, Any], words: dict[str, Any], verdicts: Columns | None, scalar: bool) -> Columns:
    """The columns in their order, without the verdicts where these come later."""
    ids, names = ([branch[part] for branch in words["branches"]] or [""] for part in (0, 1))
    pairs = found["eigenvalues"]
    out = {} if scalar else {"l_index": found["l_index"]}
    out |= {name: found[name] for name in ("l", "h", "gamma", "omega", "index")}
    out |= {name: np.array(words[name])[found[name]] for name in ("multiplicity", "stability")}
    out |= verdicts or {}
    out["survives_friction"] = found["survives_friction"]
    out["eigenvalues"] = pairs.view(np.complex128)
    out["eigenvalue_error"] = found["eigenvalue_error"]
    return out | {"branch": np.array(ids)[found["branch"]], "branch_name": np.array(names)[found["branch"]]}
