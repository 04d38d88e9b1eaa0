"""Spins at which steady rotation changes, as tables."""

import json
from typing import Any

import numpy as np
import numpy.typing as npt

from . import spin_rows
from .behaviour import all_apart
from .tables import Table

Document = dict[str, Any]
Texts = npt.NDArray[np.str_]
Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Bools = np.ma.MaskedArray[Any, np.dtype[np.bool_]]


class SpinRanges(Table):
    """Ranges of spins in which a steady rotation has one linear type; made by `CriticalSpins.ranges`.

    Attributes
    ----------
    up : array (n,) of str
        Which end of the axis of the question is up: ``"+axis"`` or ``"-axis"``, of a circle of axes, which has both, the
        former; ``""`` where all axes are meant.
    family : array (n,) of int
        Steady axes that move together: their place in ``meta["families"]``; −1 of the permanent axis that was asked for.
    branch : array (n,) of str
        Id of the branch of relative equilibria; ``""`` for the permanent axis that was asked for.
    axis_up : array (n, 3)
        The end of the axis that is up, at the slowest of these spins, in the frame of the question.
    rpm_from, rpm_to : array (n,)
        From rest or a critical spin to the next one, or ``inf``.
    stability : array (n,) of str
        The linear type, as in `Equilibria`; where the question is about an axis that is permanent, with ``(local minimum)``
        where U_l has one.
    stable : masked array (n,) of bool
        Stable at each of these spins but the isolated ones; masked where that is open.
    stable_by : array (n,) of str
        Why, as in `Equilibria`; ``""`` where no reason is given; ``"spectrum"`` where ``stable`` is masked: all
        eigenvalues are imaginary, and no more is known.
    survives_friction : masked array (n,) of bool
        It stays stable with a small friction that conserves l; masked where nothing is known of that, and of families,
        of which it is not told: there it survives where ``stable_by`` is ``"energy"``.
    isolated : array (n,) of int
        Isolated spins inside at which the usual conditions of Arnold's theorem fail, rows of `CriticalSpins`; −1 where not
        all are known.
    """

    up: Texts
    family: Ints
    branch: Texts
    axis_up: Floats
    rpm_from: Floats
    rpm_to: Floats
    stability: Texts
    stable: Bools
    stable_by: Texts
    survives_friction: Bools
    isolated: Ints

    def __repr__(self) -> str:
        lines = [self._head()]
        for row in self:
            low, high = all_apart([row["rpm_from"], row["rpm_to"]])
            told = f"{low} to {high} rpm: {row['stability']}, {_word(row['stable'])}"
            lines.append(f"  {_name(row)}, {told}")
        return "\n".join(lines)


class SpinBounds(Table):
    """What the tolerance of a part does to its critical spins; made by `CriticalSpins.bounds`.

    Bounds, not samples: outside these ranges the linear type of no part within the tolerance changes.

    Attributes
    ----------
    up : array (n,) of str
        Which end of the axis is up.
    below, above : array (n,) of str
        The linear types of all parts below and above the range; ``""`` where it begins at rest or has no end.
    rpm_from, rpm_to : array (n,)
        The range, perhaps to ``inf``.
    between : array (n,) of str
        Types that some sampled part has inside; ``""`` with ± on single numbers, where they are not sought.
    widest_by : array (n,) of str
        The number that alone moves the spin most, with ± by bounds; ``""`` where none does or that was not found.
    widest_rpm : array (n,)
        So far, in rpm: ``inf`` where the change vanishes with it or its bounds have no end, NaN where ``widest_by`` is
        ``""``.
    """

    up: Texts
    below: Texts
    above: Texts
    rpm_from: Floats
    rpm_to: Floats
    between: Texts
    widest_by: Texts
    widest_rpm: Floats

    def __repr__(self) -> str:
        lines = [self._head()]
        for row in self:
            # Rounded outwards.
            low, high = row["rpm_from"] * (1 - 5e-6), row["rpm_to"] * (1 + 5e-6)
            told = f"{low:.6g} to {high:.6g} rpm, {row['below'] or '–'} to {row['above'] or '–'}"
            lines.append(f"  {row['up']} up, {told}")
        return "\n".join(lines)


class CriticalSpins(Table):
    """The spins at which a steady rotation begins or changes, a row for each; made by `Body.critical_spin`.

    Columns are attributes; an array of bools, a slice or a list of numbers selects rows, ``found[found.stable_above].rpm``;
    what is masked is not selected, nor is its ``~``. `to_pandas`, `to_arrow` and `to_xarray` hand them on.

    Attributes
    ----------
    up : array (n,) of str
        Which end of the axis of the question is up: ``"+axis"`` or ``"-axis"``, of a circle of axes, which has both, the
        former; ``""`` where all axes are meant.
    family : array (n,) of int
        Steady axes that move together: their place in ``meta["families"]``; −1 of the permanent axis that was asked for.
    branch : array (n,) of str
        Id of the branch of relative equilibria; ``""`` for the permanent axis that was asked for.
    axis_up : array (n, 3)
        The end of the axis that is up, in the frame of the question; NaN where it moves and ``kind`` is ``"isolated"``. The
        axis of the question is meant as it was given, also where a permanent one within 0.5° of it is followed.
    rpm, rad_per_s : array (n,)
        The spin.
    l, h : array (n,)
        Momentum and energy; NaN where ``kind`` is ``"isolated"``.
    kind : array (n,) of str
        What changes: ``"stability"``, ``"region"`` (of the diagram beside it), ``"stability-and-region"``; ``"start"``
        where the rotation itself begins; ``"isolated"`` where at this spin alone the usual conditions of Arnold's theorem
        fail. Of an axis that moves with the spin, or that is not the one that was asked for, only the stability is looked
        at, not the regions beside it; without ``axis`` all permanent ones are asked for.
    event : array (n,) of str
        What happens: ``"fork"``, ``"crossing"``, ``"cusp"``, ``"fold"`` of curves, ``"hamiltonian-hopf"``,
        ``"real-collision"``, ``"zero"`` of eigenvalues, ``"1:2"``, ``"D4"``, … of an isolated spin; ``""`` where only the
        type of rotation about a permanent axis changes, unless the question was about an axis that is not permanent.
    below, above : array (n,) of str
        The linear types of rotation below and above, as in `Equilibria`, for an axis that is permanent with ``(local
        minimum)`` where U_l has one, unless another axis was asked for; ``""`` where there is none.
    stable_below, stable_above : masked array (n,) of bool
        Whether it is stable there; masked where that is open, or where there is none.
    verdict : array (n,) of str
        At an isolated spin ``"stable"``, ``"unstable"`` or ``"open"``; else ``""``.
    error_bound : array (n,)
        Bound on the error of the spin, in rad/s; NaN where ``kind`` is ``"isolated"``.
    meta : dict
        The document of ``bifdiag critical-spin --json``, which the page "Formats" of the program's documentation explains.
    """

    up: Texts
    family: Ints
    branch: Texts
    axis_up: Floats
    rpm: Floats
    rad_per_s: Floats
    l: Floats
    h: Floats
    kind: Texts
    event: Texts
    below: Texts
    above: Texts
    stable_below: Bools
    stable_above: Bools
    verdict: Texts
    error_bound: Floats

    @classmethod
    def _of(cls, text: str) -> "CriticalSpins":
        document = json.loads(text)
        ranges = [*spin_rows.ranges(document)]
        rows = [*spin_rows.changes(document, ranges), *spin_rows.starts(ranges), *spin_rows.isolated(ranges)]
        rows.sort(key=lambda row: (row["up"] == "-axis", row["branch"], row["family"], row["rpm"]))
        return cls(_table(rows, cls), text)

    @property
    def ranges(self) -> SpinRanges:
        """The spins between the changes of the linear type, with the verdict on rotation there."""
        return SpinRanges(_table([one.row() for one in spin_rows.ranges(self.meta)], SpinRanges), self._meta)

    @property
    def bounds(self) -> SpinBounds | None:
        """Bounds on the critical spins of every part within the tolerance.

        None without a tolerance, with ± on the density or mass of a mesh alone, on which no spin depends, and where no
        bounds are given: ``meta["note"]`` then says why. Without rows where no spin depends on it.
        """
        told = self.meta.get("tolerance")
        if told is None:
            return None
        return SpinBounds(_table([*spin_rows.bounds(told["ranges"])], SpinBounds), self._meta)

    def __repr__(self) -> str:
        lines = [self._head("ranges", "bounds")]
        for row in self[:12]:
            told = f"{row['rpm']:.6g} rpm: {row['kind']}" + (f" ({row['event']})" if row["event"] else "")
            before, after = _side(row, "below"), _side(row, "above")
            around = before if before == after else f"{before} to {after}"
            lines.append(f"  {_name(row)}, {told}, {around}" + (f", here {row['verdict']}" if row["verdict"] else ""))
        return "\n".join([*lines, *(["  …"] if len(self) > 12 else [])])


def _table(rows: list[Document], kind: type[Table]) -> dict[str, npt.NDArray[Any]]:
    """Rows as columns of a kind of table."""
    columns: dict[str, npt.NDArray[Any]] = {}
    for name, form in kind.__annotations__.items():
        values = [row[name] for row in rows]
        if form is Bools:
            known = np.array([bool(value) for value in values], dtype=bool)
            columns[name] = np.ma.MaskedArray(known, mask=np.array([value is None for value in values], dtype=bool))
        elif form is Texts:
            columns[name] = np.array([value or "" for value in values], dtype=np.str_)
        else:
            shape = (len(rows), 3) if name == "axis_up" else (len(rows),)
            columns[name] = np.array(values, dtype=np.float64 if form is Floats else np.int64).reshape(shape)
    return columns


def _name(row: np.void) -> str:
    return f"{row['branch'] or 'axis'} {row['up']}".strip()


def _word(stable: bool | None) -> str:
    return {True: "stable", False: "unstable", None: "open"}[stable]


def _side(row: np.void, side: str) -> str:
    return f"{row[side]} ({_word(row[f'stable_{side}'])})" if row[side] else "nothing"
