"""Critical spins as tables."""

import json
import math
import pickle

import numpy as np
import pytest

import bifdiag

TYPES = ("stability", "stability-and-region")


def part(*, com, inertia=((2, 0, 0), (0, 2, 0), (0, 0, 1))):
    return bifdiag.Body.from_inertia(inertia, com=com, mass=0.25)


@pytest.fixture
def moving():
    """A part of which no axis is permanent."""
    return part(inertia=[[2, 0, 0.1], [0, 2.2, 0], [0.1, 0, 1]], com=[0.01, 0, 0.05])


def test_the_sleeping_top_has_its_textbook_spin():
    found = part(com=[0, 0, 0.05]).critical_spin("z")
    sleeping = found[found.up == "+axis"]
    # l² = 4 A1 M g c.
    assert sleeping.rad_per_s.tolist() == pytest.approx([2 * math.sqrt(2 * 0.25 * 9.80665 * 0.05)], rel=1e-14)
    assert sleeping.rpm == pytest.approx(sleeping.rad_per_s * 30 / math.pi) and sleeping.error_bound[0] < 1e-14
    assert (sleeping.stable_below.tolist(), sleeping.stable_above.tolist()) == ([False], [True])
    assert sleeping.axis_up.tolist() == [[0, 0, 1]] and found[found.up == "-axis"].axis_up.tolist() == [[0, 0, -1]]
    assert found.kind.tolist() == ["stability", "stability-and-region"] and found.event.tolist() == ["", "fork"]


@pytest.mark.parametrize(("name", "axis"), [("katok:7", "x"), ("katok:6", "x"), ("lagrange", "x"), ("katok:2", None)])
def test_both_sides_are_what_critical_says_there(name, axis):
    body = bifdiag.Body.preset(name)
    found = body.critical_spin(axis)
    # Along an axis that moves, l may fall while the spin rises.
    rows = [row for row in found if np.isclose(abs(row["axis_up"]).max(), 1) and row["kind"] in ("region", *TYPES)]
    assert len(rows) > 1 and all(isinstance(row["stable_below"], bool) for row in rows)
    for row in rows:
        for side, factor in (("below", 1 - 1e-7), ("above", 1 + 1e-7)):
            there = body.critical(row["l"] * factor)
            near = np.linalg.norm(there.gamma + row["axis_up"], axis=1)
            own = there[np.flatnonzero(near < 0.01)]
            kinds = {(told, stable) for told, stable in zip(own.stability.tolist(), own.stable.tolist(), strict=True)}
            # Words of the document tell minima apart.
            told = row[side].removesuffix(" (local minimum)")
            assert not told or (told, row[f"stable_{side}"]) in kinds


def test_rows_are_those_of_the_document(command, moving):
    line = ["--inertia=2,2.2,1,0,0.1,0", "--products=tensor", "--com=0.01,0,0.05", "--mass=0.25", "--json"]
    for axis in (None, "z"):
        found = moving.critical_spin(axis)
        document = json.loads(command("critical-spin", *line, *([] if axis is None else [f"--axis={axis}"])))
        del document["command"]
        assert document.items() <= found.meta.items()
        starts = [one for family in document["families"] for one in family["stretches"] if one["from"]]
        theirs = sorted(one["from"]["spin"]["rpm"] for one in starts)
        assert sorted(found[found.kind != "isolated"].rpm.tolist()) == theirs
        ranges = [one for family in document["families"] for one in family["stretches"]]
        assert found.ranges.stability.tolist() == [one["stability"] for one in ranges]
        assert found.ranges.isolated.sum() == (found.kind == "isolated").sum() == 3
    begun = found[found.kind == "start"]
    assert begun.event.tolist() == ["fold"] and begun.below.tolist() == [""] and begun.stable_below.mask.all()
    # What begins is masked below, so neither the one nor the other.
    assert not (found[~found.stable_below].kind == "start").any() and not (found[found.stable_below].kind == "start").any()
    assert [found.meta["families"][k]["branch"] for k in found.family] == found.branch.tolist()
    resonance = found[found.event == "1:2"]
    assert resonance.verdict.tolist() == ["unstable"] and resonance.stable_above.tolist() == [True]
    assert found.up.tolist() == ["+axis"] * 2 + ["-axis"] * 5 and "here unstable" in repr(found)


def test_bounds_hold_the_spins():
    top = bifdiag.Body.from_inertia(
        [["0.24±1%", 0, 0], [0, 0.24, 0], [0, 0, 0.17]], com=[0, 0, "80±0.5 mm"], mass="2 kg", g=9.81
    )
    found = top.critical_spin("z")
    bounds = found.bounds
    assert all(((bounds.rpm_from <= rpm) & (rpm <= bounds.rpm_to)).any() for rpm in found.rpm)
    # Where the moments may differ, the upright end has another type at rest.
    assert bounds.below.tolist() == ["", "complex", "elliptic (local minimum)"] and bounds.rpm_from[0] == 0
    assert part(com=[0, 0, 0.05]).critical_spin("z").bounds is None
    assert len(part(com=[0, 0, 0.05]).critical_spin("z", tolerance="1%").bounds) >= 2


def test_what_never_changes_has_ranges_only():
    euler = bifdiag.Body([2, 1.1, 1], [0, 0, 0]).critical_spin("x")
    assert len(euler) == 0 and euler.stable_above.dtype == bool
    assert euler.ranges.rpm_to.tolist() == [math.inf] * 2 and euler.ranges.survives_friction.tolist() == [True] * 2


def test_tables_are_handed_on(moving):
    pd, xr, pa = (pytest.importorskip(name) for name in ("pandas", "xarray", "pyarrow"))
    found = moving.critical_spin()
    for table in (found, found.ranges, found[:0]):
        frame, data, arrow = table.to_pandas(), table.to_xarray(), table.to_arrow()
        assert isinstance(frame, pd.DataFrame) and isinstance(data, xr.Dataset) and isinstance(arrow, pa.Table)
        assert list(frame.columns) == arrow.column_names and len(frame) == arrow.num_rows == len(table)
        assert pickle.loads(pickle.dumps(table)) == table and repr(table) and table._repr_html_()
    frame = found.to_pandas()
    assert str(frame["stable_above"].dtype) == "boolean" and frame["rpm"].dtype == float
    assert frame["stable_below"].isna().sum() == (found.kind == "start").sum()
    assert frame.loc[frame["stable_above"] & ~frame["stable_below"].fillna(False), "rpm"].max() == pytest.approx(
        9.663175436748414
    )


def test_changes_beside_an_axis_that_is_not_permanent_are_rows():
    body = bifdiag.Body([2, 1.3, 1], [0, 0, 1])
    for axis in ([0, "1/3", 1], [0, 1, 3]):
        found = body.critical_spin(axis)
        changes = found[found.kind == "stability"]
        expected = [1.1710918254567828, 23.69856332099955, 9.549296585513721, 17.434550493976417]
        assert changes.rpm.tolist() == pytest.approx(expected)
        assert list(changes.event) == ["real-collision", "hamiltonian-hopf", "zero", "zero"]
        ends = found.ranges.rpm_from[found.ranges.rpm_from > 0]
        assert sorted(ends) == pytest.approx(sorted(changes.rpm))


def test_a_unit_of_one_number_is_not_that_of_the_others() -> None:
    """The command takes a unit behind the last of some numbers for that of all."""
    plain = bifdiag.Body.from_inertia([[1, 0, 0], [0, 2, 0], [0, 0, 2.5]], [0.01, 0, 0.03], 2, g=10)
    moments = [["1 kg m2", 0, 0], [0, "20000 kg cm2", 0], [0, 0, 2.5]]
    for com in ([0.01, 0, "3 cm"], ["1 cm", 0, 0.03]):
        body = bifdiag.Body.from_inertia(moments, com, 2, g=10)
        assert body == plain
        assert body.critical_spin().meta["r"] == plain.critical_spin().meta["r"] == ["0.2", "0", "0.6"]
    known = bifdiag.Body.from_inertia([[1, 0, 0], [0, 2, 0], [0, 0, 2.5]], [0, 0, "30±1 mm"], 2, g=10)
    assert known.critical_spin("z").meta["part"]["com"] == ["0", "0", "0.03"]
