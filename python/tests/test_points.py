"""Many points: margins, types, and arrays with labels."""

import pickle
from fractions import Fraction

import numpy as np
import pytest

import bifdiag


@pytest.fixture
def points():
    rng = np.random.default_rng(3)
    return rng.uniform(-2, 9, 200).round(3), rng.uniform(-6, 6, 200).round(3)


def test_margins_and_types_are_those_of_single_points(atlas, points):
    h, l = points
    found = atlas.classify(h, l)
    assert (found.code == atlas.region(h, l)).all() and (found.margin == atlas.margin(h, l)).all()
    for place, (x, y) in enumerate(zip(h, l, strict=True)):
        one = atlas.classify(x, y)
        assert (found.margin[place], found.error_bound[place]) == (one.margin.h, one.margin.error_bound)
        assert (found.nearest[place], found.status[place]) == (one.margin.nearest, one.status)
        assert (found.region[place], found.signature[place]) == (one.region, one.signature or None)
        if one.status == "regular":
            assert found.components[found.code[place]] == one.components
        assert atlas.margin(x, y) == one.margin.h
    again = pickle.loads(pickle.dumps(found))
    assert (again.code == found.code).all() and again.components == found.components
    assert (atlas.classify(h, l, threads=2).margin == found.margin).all()
    with pytest.raises(AttributeError, match="margin"):
        found.margins  # noqa: B018


def test_types_broadcast(atlas):
    found = atlas.classify(np.linspace(0, 5, 6)[:, None], [1, 3.25])
    assert found.shape == (6, 2) == found.status.shape and atlas.margin([[]], 1).shape == (1, 0)
    assert "regular" in repr(found) and isinstance(atlas.margin(3.8, 3.25), float)
    exact = atlas.margin(np.array([Fraction(19, 5), "3.8"], dtype=object), "3.25")
    assert exact.tolist() == [atlas.margin(3.8, 3.25)] * 2


def test_points_on_curves_are_critical():
    kovalevskaya = bifdiag.Body.preset("kovalevskaya").atlas()
    found = kovalevskaya.classify(np.array([-0.99, 9.0]), np.array([0.2, 0.2]))
    assert (
        found.code.tolist()[0] == -2
        and found.region[0] is None
        and found.status[0] == "critical"
        and found.signature[0] is None
    )
    assert found.margin[0] < 1e-12


def test_what_is_missing_is_marked_and_the_rest_is_answered(atlas):
    h = np.array([0, np.nan, 3.8, np.inf, 1e200, 1e-200])
    assert atlas.region(h, 3.25).tolist() == [-1, -4, 4, -4, -4, -4]
    assert np.isnan(atlas.margin(h, 3.25)).tolist() == [False, True, False, True, True, True]
    masked = np.ma.array([3.8, 3.8, 0], mask=[1, 0, 0])
    assert atlas.region(masked, 3.25).tolist() == [-4, 4, -1]
    objects = np.array([Fraction(19, 5), np.nan, "0"], dtype=object)
    assert atlas.region(objects, 3.25).tolist() == [4, -4, -1]
    found = atlas.classify(h, 3.25)
    assert found.status.tolist() == ["forbidden", "invalid", "regular", "invalid", "invalid", "invalid"]
    assert found.nearest[1] is None and np.isnan(found.h[1])
    assert atlas.region(float("nan"), 1) == -4
    with pytest.raises(bifdiag.InputError, match="invalid"):
        atlas.region(h, 1, invalid="drop")
    with pytest.raises(bifdiag.InputError, match="h = nan"):
        atlas.classify(float("nan"), 1)


def test_dimensions_of_xarray_are_kept(atlas):
    xr = pytest.importorskip("xarray")
    h = xr.DataArray([0, 3.8, 5], dims="h", coords={"h": [0, 3.8, 5]})
    l = xr.DataArray([3.25, 1, 2], dims="l", coords={"l": [3.25, 1, 2]})
    plain = atlas.region(h.to_numpy()[:, None], l.to_numpy())
    found = atlas.region(h, l)
    assert found.dims == ("h", "l") and (found.to_numpy() == plain).all() and found.name == "region"
    assert found.sel(h=3.8, l=3.25).item() == 4 and atlas.margin(h, 3.25).dims == ("h",)
    data = atlas.classify(h, l).to_xarray()
    assert data["margin"].dims == ("h", "l") and data["l"].to_numpy().tolist() == [3.25, 1, 2]
    sites = xr.DataArray([1.0, 2], dims="trial", coords={"site": ("trial", ["p", "q"])})
    assert atlas.region(3.8, sites)["site"].to_numpy().tolist() == ["p", "q"]
    with pytest.raises(bifdiag.InputError, match="both with theirs"):
        atlas.region(h, [1, 2, 3])


def test_the_index_of_pandas_is_kept(atlas):
    pd = pytest.importorskip("pandas")
    h = pd.Series([0, 3.8, None], index=list("abc"))
    assert atlas.region(h, 3.25).to_dict() == {"a": -1, "b": 4, "c": -4}
    assert atlas.margin(h, pd.Series([3.25, 3.25], index=list("ba"))).isna().to_dict() == {
        "a": False,
        "b": False,
        "c": True,
    }
    nullable = pd.Series([0, 3.8, pd.NA], dtype="Float64")
    assert atlas.region(nullable, 3.25).tolist() == [-1, 4, -4]
    frame = atlas.classify(h, 3.25).to_pandas()
    assert frame.index.tolist() == list("abc") and frame.loc["b", "signature"] == "S2+T2"


def test_the_labels_of_a_data_frame_are_kept(atlas):
    pd = pytest.importorskip("pandas")
    h = pd.DataFrame({"p": [0, 3.8], "q": [5, None]}, index=["a", "b"])
    found = atlas.region(h, 3.25)
    assert found.loc["a"].tolist() == [-1, atlas.region(5, 3.25)] and found.loc["b"].to_dict() == {"p": 4, "q": -4}
    l = pd.DataFrame({"q": [1, 2.0], "p": [3.25, 3]}, index=["b", "a"])
    assert atlas.margin(h, l).at["a", "p"] == atlas.margin(0, 3) and atlas.margin(l=l, h=h).at["b", "p"] == atlas.margin(
        3.8, 3.25
    )
    assert atlas.region(h.astype("Float64"), l).at["b", "p"] == atlas.region(3.8, l.at["b", "p"])
    table = atlas.classify(h, l).to_pandas()
    assert table.index.tolist() == [("a", "p"), ("a", "q"), ("b", "p"), ("b", "q")]
    assert table.loc[("b", "p"), "l"] == l.at["b", "p"]
    for other in (pd.Series([1, 2], index=["a", "b"]), np.array([1, 2])):
        with pytest.raises(bifdiag.InputError, match="two tables, or a number"):
            atlas.region(h, other)


def test_types_are_handed_to_arrow(atlas, points):
    pa = pytest.importorskip("pyarrow")
    table = pa.table(atlas.classify(*points))
    assert table.num_rows == 200 and table["region"].null_count == (atlas.region(*points) < 0).sum()


def test_every_table_of_types_has_the_same_columns(atlas, points):
    pd, xr = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    found = atlas.classify(*points)
    frame, data = found.to_pandas(), found.to_xarray()
    assert isinstance(frame, pd.DataFrame) and isinstance(data, xr.Dataset)
    assert sorted(frame.columns) == sorted(data.variables)
    for name in ("code", "region", "status", "signature", "nearest"):
        here = getattr(found, name).tolist()
        assert [None if value != value else value for value in frame[name].tolist()] == here
        assert [None if value != value else value for value in data[name].to_numpy().tolist()] == here
    # A name of a region leads to it.
    known = frame.dropna(subset="region")
    assert all(
        atlas.regions[name].signature == signature for name, signature in zip(known.region, known.signature, strict=True)
    )


def test_the_place_of_what_is_wrong_is_told(atlas):
    assert atlas.region([0, None, 3.8], 3.25).tolist() == [-1, -4, 4]
    for answer in (atlas.region, atlas.margin, atlas.classify):
        with pytest.raises(bifdiag.InputError, match=r"^h\[2\]: `x` is not a number"):
            answer(["4", "9/2", "x"], 2)
        with pytest.raises(bifdiag.InputError, match=r"^l\[1, 0\] = \[\] is a list"):
            answer(1, np.array([[1, 2], [[], 4]], dtype=object))
    with pytest.raises(bifdiag.InputError, match="threads"):
        atlas.region(1, 2, threads=-1)


def test_files_say_what_is_missing(atlas, points, tmp_path):
    xr = pytest.importorskip("xarray")
    pytest.importorskip("scipy")
    found = atlas.classify(*points)
    data = found.to_xarray()
    assert [name for name in data if "missing" in data[name].attrs] == ["region", "signature"]
    data.to_netcdf(tmp_path / "points.nc", engine="scipy")
    with xr.open_dataset(tmp_path / "points.nc", engine="scipy") as again:
        for name in ("region", "signature"):
            told = getattr(found, name).tolist()
            assert None in told and again[name].to_numpy().tolist() == [text or "" for text in told]
            assert again[name].attrs["missing"].startswith("None; an empty text")
            assert again[name].where(again[name] != "").isnull().to_numpy().tolist() == [text is None for text in told]
        assert "missing" not in again["status"].attrs
