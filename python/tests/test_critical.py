"""Relative equilibria as structured arrays."""

import json
import pickle
import time

import numpy as np
import pytest

import bifdiag


@pytest.mark.parametrize(("name", "l"), [("paper", "3.25"), ("lagrange", "1.9"), ("katok:3", "0"), ("euler", "1/3")])
def test_rows_say_what_the_command_line_says(name, l, command):
    found = bifdiag.Body.preset(name).critical(l)
    told = json.loads(command("critical", "--body", name, "--l", l, "--json"))["critical"]
    assert len(found) == len(told)
    for row, entry in zip(found, told, strict=True):
        assert (row["h"], row["omega"], row["index"]) == (entry["h"], entry["omega"], entry["index"])
        assert row["gamma"].tolist() == entry["gamma"]
        assert row["multiplicity"] == str(entry["multiplicity"])
        assert row["stability"] == entry["stability"]
        nonlinear = entry["nonlinear"]
        assert (row["verdict"], row["stable_by"]) == (nonlinear["verdict"], nonlinear["why"])
        assert row["stable"] is {"stable": True, "unstable": False, "open": None}[nonlinear["verdict"]]
        # The contract: the word of the document is false exactly if the boolean is.
        assert (entry["stable"] is False) == (row["stable"] is False)
        assert row["survives_friction"] == (entry["friction"]["conserving_l"] == "survives")
        assert [[value.real, value.imag] for value in row["eigenvalues"]] == entry["eigenvalues"]
        assert (row["branch"], row["branch_name"]) == (entry["branch"], entry["branch_name"])


def test_many_momenta_are_one_array(paper):
    l = np.linspace(0.1, 5, 40).round(3).reshape(8, 5)
    found = paper.critical(l)
    assert np.array_equal(found["l"], l.ravel()[found["l_index"]])
    for place, momentum in enumerate(l.flat):
        rows = found[found["l_index"] == place]
        one = paper.critical(momentum)
        assert all(np.array_equal(rows[name], one[name]) for name in one.dtype.names)
    assert len(paper.critical([])) == 0


def test_wrong_momenta_are_told(paper):
    with pytest.raises(bifdiag.InputError, match=r"l\[1\] = nan is no finite number"):
        paper.critical([1, float("nan")], invalid="raise")
    with pytest.raises(bifdiag.InputError, match=r"l\[1\] is masked"):
        paper.critical(np.ma.masked_array([1.0, 2, 3], [0, 1, 0]), invalid="raise")
    with pytest.raises(bifdiag.InputError, match=r"^l = nan is no finite number in range$"):
        paper.critical(float("nan"))
    with pytest.raises(bifdiag.InputError, match=r"l\[1\]: `x` is not a number"):
        paper.critical(["1", "x"])
    with pytest.raises(bifdiag.InputError, match="str"):
        paper.critical(None)


def test_what_is_open_is_neither_stable_nor_unstable():
    # A pitchfork without an answer by degree, and a resonance: some body has an open verdict at some l.
    found = bifdiag.Body.preset("paper").critical(["2.01143465931742592992412", "3.25"])
    assert found.stable.dtype == bool and np.ma.isMaskedArray(found["stable"])
    assert [row["stable"] for row in found] == found.stable.tolist()
    assert (np.ma.getmaskarray(found.stable) == (found.verdict == "open")).all()
    assert (found[~found.stable].verdict == "unstable").all() and (found[found.stable].verdict == "stable").all()


def test_verdicts_come_when_they_are_read(paper):
    l = np.linspace(2.5, 4, 200)
    found, eager = paper.critical(l), paper.critical([str(value) for value in l])
    assert found._later is not None and found[found["index"] == 2]._later is not None
    part = found[found["index"] == 2][::3]
    assert part.stable_by.tolist() == found.stable_by[found["index"] == 2][::3].tolist() and found._later is None
    assert found == eager == pickle.loads(pickle.dumps(paper.critical(l)))
    one = paper.critical(l[7])
    assert (
        found[found.l_index == 7].stable_by.tolist()
        == one.stable_by.tolist()
        == ["energy"] * 2 + one.stable_by[2:].tolist()
    )
    assert paper.critical(l, threads=2) == found


def test_rows_are_those_of_a_structured_array(paper):
    found = paper.critical([1, 3.25])
    rows = np.asarray(found)
    assert rows.dtype == found.dtype and rows.dtype.names == found.columns and len(rows) == len(found) == found.size
    assert rows["h"].tolist() == found.h.tolist() and found[-1] == rows[-1] and [*found][2] == rows[2]
    assert len(found[[]]) == 0 == len(found[found.h > 1e9]) and found[1:3] == found[[1, 2]]
    assert found[["h", "index"]].tolist() == rows[["h", "index"]].tolist()
    with pytest.raises(KeyError, match="stability"):
        found["stabel"]
    with pytest.raises(AttributeError, match="stability"):
        found.stabel  # noqa: B018
    assert "arnold" in repr(paper.critical(3.25)) and "<th>stable_by</th>" in found._repr_html_()


def test_equilibria_are_handed_on(paper):
    pd, xr, pa = (pytest.importorskip(name) for name in ("pandas", "xarray", "pyarrow"))
    found = paper.critical([0.5, "2.01143465931742592992412", 3.25])
    frame = found.to_pandas()
    assert str(frame["stable"].dtype) == "boolean" and frame["stable"].isna().sum() == (found.verdict == "open").sum()
    assert frame["gamma_2"].tolist() == found.gamma[:, 1].tolist()
    assert frame["eigenvalues_1_im"].tolist() == found.eigenvalues[:, 0].imag.tolist()
    table = found.to_arrow()
    assert table["stable"].null_count == (found.verdict == "open").sum() and pa.table(found).equals(table)
    data = found.to_xarray()
    assert data["gamma"].dims == ("row", "axis") and data["eigenvalues_im"].dims == ("row", "pair")
    assert (data["eigenvalues_re"] + 1j * data["eigenvalues_im"]).to_numpy().tolist() == found.eigenvalues.tolist()
    assert isinstance(data, xr.Dataset) and isinstance(frame, pd.DataFrame) and json.loads(data.attrs["meta"])["complete"]


def test_datasets_are_stored(paper, tmp_path):
    xr = pytest.importorskip("xarray")
    pytest.importorskip("scipy")
    data = paper.critical([0.5, 3.25]).to_xarray()
    # The oldest format, which has neither complex numbers nor bools.
    data.to_netcdf(tmp_path / "found.nc", engine="scipy")
    with xr.open_dataset(tmp_path / "found.nc", engine="scipy") as again:
        assert again["eigenvalues_im"].to_numpy().tolist() == data["eigenvalues_im"].to_numpy().tolist()


def test_ten_thousand_momenta_are_quick(paper):
    l = np.linspace(0.01, 4, 10**4)

    def seconds():
        begin = time.process_time()
        assert len(paper.critical(l)) > 3e4
        return time.process_time() - begin

    # Measured 0.08 s; 1.6 s through documents.
    assert min(seconds() for _ in range(3)) < 0.8


def test_gaps_leave_the_rest_as_it_is(paper):
    l = np.array([1, np.nan, 3.25, np.inf, 1e200, 2])
    found, kept = paper.critical(l), paper.critical([1, 3.25, 2])
    assert found.meta["invalid"] == [1, 3, 4] and sorted(set(found.l_index.tolist())) == [0, 2, 5]
    assert np.array_equal(found.l, l[found.l_index]) and found.h.tolist() == kept.h.tolist()
    assert found.stable_by.tolist() == kept.stable_by.tolist() and "l_index 1, 3, 4" in repr(found)
    masked = paper.critical(np.ma.masked_array([[1.0, 2], [3, 4]], [[0, 1], [0, 0]]))
    assert sorted(set(masked.l_index.tolist())) == [0, 2, 3] and masked.meta["invalid"] == [1]
    assert paper.critical(["3.25", None]).h.tolist() == paper.critical("3.25").h.tolist()
    assert pickle.loads(pickle.dumps(found)) == found and len(paper.critical([np.nan])) == 0


def test_the_index_of_pandas_is_kept(paper):
    pd = pytest.importorskip("pandas")
    l = pd.Series([1.0, None, 3.25], index=pd.Index(["a", "b", "c"], name="case"))
    found = paper.critical(l)
    frame = found.to_pandas()
    assert frame.index.name == "case" and frame.index.tolist() == [l.index[k] for k in found.l_index]
    assert (frame.loc["c", "l"] == 3.25).all() and "b" not in frame.index
    some = pickle.loads(pickle.dumps(found[found["index"] == 0]))
    assert some.to_pandas().index.tolist() == ["a", "c"][: len(some)] + ["c"] * (len(some) - 2)
    pytest.importorskip("xarray")
    assert (
        found.to_xarray()["case"].dims == ("row",) and found.to_xarray()["case"].to_numpy().tolist() == frame.index.tolist()
    )


def test_dimensions_of_xarray_are_kept(paper):
    xr = pytest.importorskip("xarray")
    values = [[1, 2, np.nan], [3, 3.25, 4]]
    l = xr.DataArray(values, dims=("spin", "trial"), coords={"spin": [10, 20], "site": ("trial", list("pqr")), "run": 7})
    found = paper.critical(l)
    data = found.to_xarray()
    for row in range(len(found)):
        spin, trial = data["spin"].item(row), data["trial"].item(row)
        assert l.sel(spin=spin).isel(trial=trial).item() == data["l"].item(row)
        assert data["site"].item(row) == "pqr"[trial]
    pd = pytest.importorskip("pandas")
    assert isinstance(found.to_pandas().index, pd.MultiIndex) and found.to_pandas().index.names == ["spin", "trial"]
    line = xr.DataArray([1.0, 2], dims="l", coords={"l": [1.0, 2]})
    assert "l" in paper.critical(line).to_xarray().coords and paper.critical(line).to_pandas().index.name == "l"
    assert paper.critical(xr.DataArray(3.25)).h.tolist() == paper.critical(3.25).h.tolist()
