"""Atlases say what the command line says, and answer arrays as they answer points."""

import copy
import gc
import json
import pickle
import weakref
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
    for curve in atlas.curves:
        assert curve.points.tolist() == atlas.document["drawing"]["curves"][curve.id]["polyline"]
    for region, told in zip(atlas.regions, document["regions"], strict=True):
        assert (region.id, region.bounded, list(region.boundary)) == (told["id"], told["bounded"], told["boundary"])
        assert region.neighbours[0].curve == told["neighbours"][0]["curve"]
        assert [(cell.lower, cell.upper) for cell in region.cells] == [(c["lower"], c["upper"]) for c in told["cells"]]


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


@pytest.mark.filterwarnings("ignore::bifdiag.BodyWarning")
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
        ([1, np.nan], 1, r"h\[1\] = nan is no finite number"),
        (1, np.inf, "l = inf is no finite number"),
        ([1, 2], [1, 2, 3], "broadcast"),
        ([True], 1, "bool"),
        ([1j], 1, "complex"),
        (["x"], 1, "not a number"),
        (None, 1, "NoneType"),
        (np.array([1], dtype="M8[s]"), 1, "datetime"),
        (1e200, 1, "range"),
        (np.ma.array([[1, 2], [3, 4]], mask=[[0, 0], [1, 0]]), 1, r"h\[1, 0\]"),
    ],
)
def test_wrong_points_are_told(atlas, h, l, message):
    for answer in (atlas.region, atlas.margin):
        with pytest.raises(bifdiag.InputError, match=message):
            answer(h, l, invalid="raise")


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
    for change, message in [({"schema_version": "1"}, "bifdiag atlas --A"), ({"regions": []}, "make it anew")]:
        path.write_text(json.dumps(document | change))
        with pytest.raises(bifdiag.InputError, match=message):
            bifdiag.Atlas.load(path)
    # One of another version of the program, in another layout, says the same.
    path.write_text(json.dumps(document | {"version": "0.0.9"}))
    assert bifdiag.Atlas.load(path) == atlas and bifdiag.Atlas.load(path).to_json() == path.read_text()


def test_files_that_are_no_atlas_are_told(atlas, section, tmp_path):
    section.save(tmp_path / "section.npz")
    (tmp_path / "other.json").write_text("{}")
    (tmp_path / "bytes").write_bytes(b"\xff\xfe\x00")
    (tmp_path / "empty").touch()
    for name, words in [
        ("section.npz", "section.npz is a section .NPZ., no atlas: bifdiag.Section.load reads it"),
        ("other.json", "another document"),
        ("bytes", "bytes is no atlas: an atlas.json of"),
        ("empty", "empty"),
    ]:
        for read in (bifdiag.Atlas.load, bifdiag.verify):
            with pytest.raises(bifdiag.InputError, match=words):
                read(tmp_path / name)
    with pytest.raises(FileNotFoundError):
        bifdiag.Atlas.load(tmp_path / "nothing.json")


def test_atlases_of_the_command_line_are_loaded(atlas, command, tmp_path):
    path = tmp_path / "atlas.json"
    asked = [[], ["--certificate"], ["--no-drawing"], ["--window=2:5,2:4"], ["--accuracy=fast"]]
    loaded = []
    for option in asked:
        path.write_text(command(*options(atlas.body), "--json", *option))
        loaded.append(bifdiag.Atlas.load(path))
        assert loaded[-1].to_json() == path.read_text()
        again = pickle.loads(pickle.dumps(loaded[-1]))
        assert again == loaded[-1] and hash(again) == hash(loaded[-1]) and again.to_json() == path.read_text()
        # Numbers of regions are those of the whole plane, whatever the document keeps to.
        assert loaded[-1].regions[loaded[-1].region(3.8, 3.25)].signature == "S2+T2"
    assert [other == atlas for other in loaded] == [True, False, False, False, False]
    assert len(set(loaded)) == len(asked)
    assert loaded[1].certificate and not loaded[2].regions[0].polygon


def test_equal_atlases_are_those_of_equal_bodies(atlas):
    again = bifdiag.Body(["2.0", 1.1, 1], atlas.body.r).atlas()
    assert again == atlas and hash(again) == hash(atlas) and atlas != "atlas"
    assert atlas != atlas.body.atlas("fast") and atlas != bifdiag.Body.preset("kovalevskaya").atlas()


@pytest.mark.parametrize("body", BODIES[:3], ids=str)
def test_certificates_are_the_command_lines(body, command, tmp_path):
    proved = body.atlas(certificate=True)
    assert proved.to_json() == command(*options(body), "--certificate", "--json")
    assert proved.certificate == json.loads(proved.to_json())["certificate"]
    assert body.atlas().certificate is None
    assert bifdiag.verify(proved) == bifdiag.verify(proved.document) == len(proved.regions)
    for event in proved.events:
        low, high = map(Fraction, event.enclosure.l)
        assert low <= high and abs(Fraction(event.l) - low) <= Fraction(event.l_error) + (high - low)
    assert [region.id for region in proved.regions] == [region.id for region in body.atlas().regions]
    for region, told in zip(proved.regions, proved.document["regions"], strict=True):
        assert (region.sample.h, region.sample.l) == (told["sample"]["h"], told["sample"]["l"])
    proved.save(tmp_path / "atlas.json")
    assert bifdiag.verify(tmp_path / "atlas.json") == len(proved.regions)
    changed = proved.to_json().replace('"bounded": true', '"bounded": false', 1)
    (tmp_path / "atlas.json").write_text(changed + " " if changed == proved.to_json() else changed)
    with pytest.raises(bifdiag.VerifyError):
        bifdiag.verify(tmp_path / "atlas.json")
    (tmp_path / "atlas.json").write_text(json.dumps(proved.document))
    with pytest.raises(bifdiag.VerifyError, match="its bytes"):
        bifdiag.verify(tmp_path / "atlas.json")


def test_a_part_is_proved_too(command):
    part = bifdiag.Body.from_inertia([[2, 0, 0], [0, 1.5, 0], [0, 0, 1]], [0, 0, 0.2], 1, "9.81")
    line = ["--inertia=2,1.5,1,0,0,0", "--com=0,0,0.2", "--mass=1", "--g=9.81", "--certificate", "--json"]
    assert part.atlas(certificate=True).to_json() == command(*line)


def test_fast_atlases_have_no_certificate(paper):
    with pytest.raises(bifdiag.InputError, match="fast"):
        paper.atlas("fast", certificate=True)


def test_curves_are_as_fine_as_is_wanted(atlas):
    for tolerance in (1e-3, 1e-6, 1e-9):
        points = atlas.polyline("G1.2", (2.1, 3), tolerance=tolerance)
        middles = (points[1:] + points[:-1]) / 2
        found = atlas.body.critical(middles[:: max(1, len(middles) // 40), 1])
        exact = found["h"][found["branch"] == "G1.2"]
        assert np.abs(exact - middles[:: max(1, len(middles) // 40), 0]).max() <= 1.1 * tolerance
    assert atlas.polyline("G1.2", (90, 91)).shape[1] == 2
    # A pole line on an axis whose branch has two pieces: h = l²/4 + 1.
    points = bifdiag.Body([2, 2, 1], [1, 0, 0]).atlas().polyline("P-", (0, 5))
    h, l = points.T
    assert points[0].tolist() == [1, 0] and l[-1] == 5 and (np.diff(l) > 0).all()
    assert np.allclose(h, l**2 / 4 + 1, rtol=0, atol=1e-12) and np.isclose(l, 2, rtol=0, atol=1e-12).any()
    for arguments, message in [
        (("X", (1, 2)), "the curves are"),
        (("G1.2", (2, 1)), "from < to"),
        (("G1.2", (1, 2, 3)), "shape"),
    ]:
        with pytest.raises(bifdiag.InputError, match=message):
            atlas.polyline(*arguments)
    with pytest.raises(bifdiag.InputError, match="positive"):
        atlas.polyline("G1.2", (2, 3), tolerance=0)


def test_outlines_of_a_window_agree_with_the_regions(atlas):
    path = pytest.importorskip("matplotlib.path", exc_type=ImportError)
    h, l = np.linspace(1.5, 3.5, 120), np.linspace(1.9, 2.8, 110)
    points = np.stack(np.meshgrid(h, l, indexing="ij"), axis=-1).reshape(-1, 2)
    inside = np.full(len(points), -1)
    for number, outlines in enumerate(atlas.outlines((1.4, 3.6), (1.8, 2.9))):
        for outline in outlines:
            inside[path.Path(outline).contains_points(points)] = number
    wrong = inside != atlas.region(points[:, 0], points[:, 1])
    # Those near a curve may be off by the thousandth that is promised.
    assert wrong.mean() < 0.002
    with pytest.raises(bifdiag.InputError, match="from < to"):
        atlas.outlines((3, 3), (1, 2))


def test_the_picture_is_the_command_lines(atlas, command, tmp_path):
    command(*options(atlas.body), "--out", tmp_path)
    assert atlas.svg() == (tmp_path / "diagram.svg").read_text(encoding="utf-8")


def test_events_are_beside_their_floats(atlas):
    for event in atlas.events:
        found = atlas.classify(event.h, event.l)
        assert found.status in ("regular", "forbidden") and found.margin.h <= 10 * (event.h_error + event.l_error * 10)


def test_the_half_plane_is_mirrored(atlas):
    for h, l in [(3.8, "3.25"), (1, "0"), (0.3, "1")]:
        there, mirrored = atlas.classify(h, l), atlas.classify(h, "-" + l)
        assert (there.region, there.components) == (mirrored.region, mirrored.components)
        assert atlas.region(h, float(l)) == atlas.region(h, -float(l))


def test_reprs_name_what_can_be_had(atlas):
    assert "R1: D2 + D2" in repr(bifdiag.Body.preset("euler").atlas())
    assert "9 regions" in repr(atlas) and "R5: S2+T2" in repr(atlas) and "stability_changes" in repr(atlas)
    assert "neighbours" in repr(atlas.regions[0]) and "stability" in repr(atlas.curves[0])
    assert atlas._repr_svg_().startswith("<svg")
    assert "S2 + T2" in atlas.classify(3.8, 3.25)._repr_html_()


def test_an_atlas_needs_no_garbage_collector():
    gc.disable()
    try:
        atlas = bifdiag.Body.preset("paper").atlas()
        regions, width = atlas.regions, atlas.regions[0].h_width
        assert atlas.events and atlas.curves and len(regions[0].polygon) > 0
        alive = weakref.ref(atlas)
        del atlas
        assert alive() is None and regions[0].h_width == width and pickle.loads(pickle.dumps(regions[0])).h_width == width
    finally:
        gc.enable()
