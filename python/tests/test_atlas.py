"""Atlases say what the command line says, and answer arrays as they answer points."""

import copy
import json
import pickle
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import bifdiag

BODIES = [
    bifdiag.Body.preset("paper"),
    bifdiag.Body.preset("kovalevskaya"),
    bifdiag.Body.preset("lagrange"),
    bifdiag.Body.preset("katok:6"),
    bifdiag.Body(["2", "1.5", "1.2"], ["0.5", "1/3", "-1e-3"]),
]


def options(body):
    return [f"--A={','.join(body.A)}", f"--r={','.join(body.r)}"]


def test_the_papers_body_has_nine_regions(atlas):
    assert [region.id for region in atlas.regions] == [f"R{n}" for n in range(1, 10)]
    expected = ["M2", "M2", "M3", "S2", "S2+S2", "S2+T2", "T2", "T2", "T2+T2"]
    assert sorted(region.signature for region in atlas.regions) == expected
    assert atlas.complete and atlas.body.A == ("2", "11/10", "1")


@pytest.mark.parametrize("body", BODIES, ids=str)
def test_the_document_is_the_command_lines(body, command):
    assert body.atlas().to_json() == command(*options(body), "--json")


@pytest.mark.parametrize("body", BODIES, ids=str)
def test_every_sample_is_in_its_region(body):
    atlas = body.atlas()
    for number, region in enumerate(atlas.regions):
        assert atlas.region(*region.sample) == number
        assert atlas.region(region.sample.h, -region.sample.l) == number
        found = atlas.classify(*region.sample)
        assert (found.signature, found.components) == (region.signature, region.components)


def test_records_hold_what_the_document_says(atlas):
    document = json.loads(atlas.to_json())
    assert [event.kind for event in atlas.events] == [event["kind"] for event in document["events"]]
    assert [curve.id for curve in atlas.curves] == [curve["id"] for curve in document["curves"]]
    for curve, told in zip(atlas.curves, document["curves"], strict=True):
        assert curve.points.tolist() == told["polyline"]
    for region, told in zip(atlas.regions, document["regions"], strict=True):
        assert (region.id, region.bounded, list(region.boundary)) == (told["id"], told["bounded"], told["boundary"])
        assert region.neighbours[0].curve == told["neighbours"][0]["curve"]


def test_places_broadcast(atlas):
    h, l = np.linspace(-2, 8, 31), np.linspace(0.01, 6, 23)
    grid = atlas.region(h[:, None], l)
    assert grid.shape == (31, 23) and grid.dtype.kind == "i" and grid.flags.c_contiguous
    assert np.array_equal(atlas.region(h, l[:, None]), grid.T)
    assert np.array_equal(atlas.region(*np.meshgrid(h, l, indexing="ij")), grid)
    assert atlas.region(h[5], l[7]) == grid[5, 7]
    assert isinstance(atlas.region(3.8, 3.25), int)
    assert atlas.region([], 1.0).shape == (0,)
    assert atlas.region(np.zeros((2, 0, 3)), l[0]).shape == (2, 0, 3)


def place(atlas, h, l):
    found = atlas.classify(h, l)
    ids = {region.id: number for number, region in enumerate(atlas.regions)}
    return {"forbidden": -1, "critical": -2, "undecided": -3}.get(found.status, ids.get(found.region))


def test_ties_are_critical(atlas):
    # The pole lines h = l²/(2A₁) ∓ 1 of Kovalevskaya's top, A₁ = 2.
    kovalevskaya = bifdiag.Body.preset("kovalevskaya").atlas()
    l = np.array([Fraction(1, 2), Fraction(2), Fraction(3, 7)], dtype=object)
    on_the_line = l * l / 4 - 1
    assert (kovalevskaya.region(on_the_line, l) == -2).all()
    assert (kovalevskaya.region(on_the_line + Fraction(1, 10**30), l) >= 0).all()
    assert kovalevskaya.region(0, 2) == -2 == kovalevskaya.region("0", "2")
    # Doubles mean their shortest decimals: 0.01 - 1 is exactly h on the line over l = 0.2.
    assert kovalevskaya.region(np.array([-0.99, -0.99]), np.array([0.2, 0.2])).tolist() == [-2, -2]


def test_ten_thousand_cells_answer_as_scalars_do():
    kovalevskaya = bifdiag.Body.preset("kovalevskaya").atlas()
    # Every cell twice: as doubles, and as fractions, of which those on a pole line are ties.
    l = [Fraction(k, 40) for k in range(1, 101)]
    h = [Fraction(k, 40) ** 2 / 4 - 1 for k in range(1, 101)]
    exact = kovalevskaya.region(np.array(h, dtype=object)[:, None], np.array(l, dtype=object))
    doubles = kovalevskaya.region(np.array(h, dtype=float)[:, None], np.array(l, dtype=float))
    assert exact.shape == doubles.shape == (100, 100)
    assert exact.tolist() == [[place(kovalevskaya, x, y) for y in l] for x in h]
    assert doubles.tolist() == [[place(kovalevskaya, float(x), float(y)) for y in l] for x in h]
    assert (np.diag(exact) == -2).all() and (exact >= 0).any() and (exact == -1).any()


@settings(max_examples=40, deadline=None)
@given(
    st.tuples(*[st.integers(1, 40)] * 3, *[st.integers(-20, 20)] * 3).filter(lambda numbers: any(numbers[3:])),
    st.lists(st.tuples(st.integers(-60, 120), st.integers(0, 80)), min_size=1, max_size=30),
)
def test_arrays_answer_as_scalars_do(numbers, points):
    body = bifdiag.Body([f"{n}/20" for n in numbers[:3]], [f"{n}/20" for n in numbers[3:]])
    atlas = body.atlas()
    h, l = np.array(points).T / 20
    found = atlas.region(h, l)
    # A second time, over momenta that come again.
    assert np.array_equal(atlas.region(np.concatenate([h, h, h]), np.concatenate([l, l, l])), np.concatenate([found] * 3))
    assert found.tolist() == [place(atlas, *point) for point in zip(h.tolist(), l.tolist(), strict=True)]


def test_threads_change_nothing(atlas):
    rng = np.random.default_rng(1)
    h, l = rng.uniform(-2, 9, 300_000), rng.uniform(0, 6, 300_000)
    one = atlas.region(h, l)
    for threads in (0, 2, 5):
        assert np.array_equal(atlas.region(h, l, threads=threads), one)


@pytest.mark.parametrize(
    ("h", "l", "message"),
    [
        ([1, np.nan], 1, "h has entries that are not finite"),
        (1, np.inf, "l has entries that are not finite"),
        ([1, 2], [1, 2, 3], "broadcast"),
        ([True], 1, "bool"),
        ([1j], 1, "complex"),
        (["x"], 1, "not a number"),
        ([None], 1, "NoneType"),
        (np.array([1], dtype="M8[s]"), 1, "datetime"),
        (1e200, 1, "range"),
    ],
)
def test_wrong_points_are_told(atlas, h, l, message):
    with pytest.raises(bifdiag.InputError, match=message):
        atlas.region(h, l)


def test_wrong_accuracies_name_the_right_ones(paper):
    with pytest.raises(bifdiag.InputError, match='"exact" and "fast"'):
        paper.atlas(accuracy="standard")


def test_atlases_are_saved_and_loaded(atlas, tmp_path):
    path = tmp_path / "atlas.json"
    atlas.save(path)
    loaded = bifdiag.Atlas.load(path)
    assert loaded == atlas and loaded.to_json().encode() == path.read_bytes()
    assert pickle.loads(pickle.dumps(atlas)) == atlas == copy.copy(atlas)
    assert pickle.loads(pickle.dumps(atlas.regions)) == atlas.regions
    document = json.loads(atlas.to_json())
    for change, message in [({"schema_version": "1"}, "bifdiag --A"), ({"regions": []}, "make it anew"), ({}, None)]:
        path.write_text(json.dumps(document | change))
        if message:
            with pytest.raises(bifdiag.InputError, match=message):
                bifdiag.Atlas.load(path)
    path.write_text("{")
    with pytest.raises(bifdiag.InputError, match="no atlas"):
        bifdiag.Atlas.load(path)


def test_reprs_name_what_can_be_had(atlas):
    assert "9 regions" in repr(atlas) and "R5: S2+T2" in repr(atlas) and "stability_changes" in repr(atlas)
    assert "neighbours" in repr(atlas.regions[0]) and "stability" in repr(atlas.curves[0])
    assert atlas._repr_svg_().startswith("<svg")
    assert "S2 + T2" in atlas.classify(3.8, 3.25)._repr_html_()
