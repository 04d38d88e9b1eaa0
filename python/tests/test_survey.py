"""Scans, searches and the check of atlases."""

import json
import resource
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import bifdiag


@pytest.mark.parametrize("suffix", ["csv", "jsonl", "parquet"])
def test_scans_write_the_command_lines_file(suffix, command, tmp_path):
    summary = bifdiag.scan(family="general", samples=300, out=tmp_path / f"ours.{suffix}", threads=2)
    command("scan", "--family", "general", "--samples", 300, "--out", tmp_path / f"theirs.{suffix}", "--json")
    assert (tmp_path / f"ours.{suffix}").read_bytes() == (tmp_path / f"theirs.{suffix}").read_bytes()
    assert isinstance(summary, dict)


def test_a_range_is_one_text_or_several(tmp_path, command):
    body = bifdiag.Body.preset("lagrange")
    told = [bifdiag.scan(body=body, vary=vary, out=tmp_path / "x.csv") for vary in ("A1=1:2:3", ["A1=1:2:3"])]
    assert told[0] == told[1] and told[0]["rows"] == 3


def test_wrong_scans_are_told(tmp_path):
    with pytest.raises(bifdiag.InputError, match=r"^samples is missing; give samples=100000"):
        bifdiag.scan(out=tmp_path / "x.csv")
    with pytest.raises(bifdiag.InputError, match=r"a range is written.*\d$"):
        bifdiag.scan(body=bifdiag.Body.preset("lagrange"), vary="A", out=tmp_path / "x.csv")
    with pytest.raises(bifdiag.InputError, match="family"):
        bifdiag.scan(family="nobody", samples=3, out=tmp_path / "x.csv")
    with pytest.raises(bifdiag.InputError, match="samples"):
        bifdiag.scan(samples=-3, out=tmp_path / "x.csv")
    with pytest.raises(bifdiag.InputError, match=r"use .parquet, .csv or .jsonl$"):
        bifdiag.scan(samples=3, out=tmp_path / "x.txt")


def test_what_is_found_shows_what_was_sought():
    witness = bifdiag.find("M4")
    assert witness and witness.body is not None
    found = witness.body.classify(witness.h, witness.l)
    assert found.components == witness.components and "M4" in found.signature
    assert "document" not in repr(witness) and witness.document["found"]
    assert bifdiag.find(signature="T2+S2", samples=2000, seed=3).found


def test_what_theorems_exclude_does_not_exist():
    witness = bifdiag.find("k0n1")
    assert not witness and witness.exists is False and witness.why


def test_wrong_searches_are_told():
    with pytest.raises(bifdiag.InputError, match="say what is sought"):
        bifdiag.find()
    with pytest.raises(bifdiag.InputError, match="X7"):
        bifdiag.find("X7")


def test_atlases_without_certificate_are_not_confirmed(atlas, tmp_path):
    with pytest.raises(bifdiag.VerifyError, match="certificate"):
        bifdiag.verify(atlas)
    with pytest.raises(bifdiag.InputError):
        bifdiag.verify({})
    (tmp_path / "atlas.json").write_text("[]")
    with pytest.raises(bifdiag.InputError):
        bifdiag.verify(tmp_path / "atlas.json")


def test_the_command_line_is_in_the_package(command):
    assert "bifdiag" in command("--version")
    assert json.loads(command("classify", "--body", "paper", "--h", 3.8, "--l", 3.25, "--json"))["status"] == "regular"
    assert "--A" in command("classify", "--A", "1,2", "--r", "1,0,0", "--h", 1, "--l", 1, status=2)


def rows(count, seed=0):
    rng = np.random.default_rng(seed)
    x, y, z = rng.uniform(0.05, 1, (3, count)).round(3)
    return np.stack([y + z, z + x, x + y], axis=1).round(3), rng.uniform(-1, 1, (count, 3)).round(3)


def test_own_bodies_are_scanned(tmp_path):
    A, r = rows(40)
    found = bifdiag.scan(bodies=(A, r), threads=2)
    assert len(found) == 40 == found.meta["rows"] and (A[:, 1] == found.A2).all() and (found.r3 == r[:, 2]).all()
    counts = [len(bifdiag.Body(*body).atlas().regions) for body in zip(A.tolist(), r.tolist(), strict=True)]
    assert found.regions.tolist() == counts
    table = dict(zip(["A1", "A2", "A3", "r1", "r2", "r3"], np.hstack([A, r]).T, strict=True))
    bodies = [bifdiag.Body(*body) for body in zip(A.tolist(), r.tolist(), strict=True)]
    for same in (np.hstack([A, r]), table, bodies):
        assert bifdiag.scan(bodies=same) == found
    # Nothing is left behind, and nothing was written that was not asked for.
    summary = bifdiag.scan(bodies=(A, r), out=tmp_path / "own.csv")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["own.csv", "own.csv.summary.json"]
    assert summary["design"]["samples"] == 40 and summary["design"]["bodies"]["family"] == "listed"
    shards = [tmp_path / f"shard-{part}.csv" for part in (1, 2, 3)]
    for part, path in enumerate(shards, 1):
        bifdiag.scan(bodies=(A, r), shard=(part, 3), out=path)
    bifdiag.merge(shards, out=tmp_path / "merged.csv")
    assert (tmp_path / "merged.csv").read_bytes() == (tmp_path / "own.csv").read_bytes()


def test_own_bodies_are_quick():
    bodies = np.hstack(rows(2000))
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert len(bifdiag.scan(bodies=bodies)) == 2000
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    # Measured 0.3 s, the start of the process included.
    assert after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime < 3


def test_a_scan_without_a_file_writes_none(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = bifdiag.scan(family="general", samples=20)
    assert len(found) == 20 and not [*tmp_path.iterdir()] and "regions" in repr(found)
    pd = pytest.importorskip("pandas")
    assert isinstance(found.to_pandas(), pd.DataFrame)


def test_finished_scans_are_not_overwritten(tmp_path):
    A, r = rows(5)
    out = tmp_path / "own.csv"
    first = bifdiag.scan(bodies=(A, r), out=out)
    written = out.read_bytes(), out.stat().st_mtime_ns
    # The same again is the same, and nothing is done.
    assert bifdiag.scan(bodies=(A, r), out=out) == first and (out.read_bytes(), out.stat().st_mtime_ns) == written
    for other in ({"bodies": (A + 1, r)}, {"family": "general", "samples": 5}, {"bodies": (A, r), "shard": (1, 2)}):
        with pytest.raises(bifdiag.InputError, match=r"holds another finished scan.*overwrite=True"):
            bifdiag.scan(**other, out=out)
    assert out.read_bytes() == written[0]
    assert bifdiag.scan(bodies=(A + 1, r), out=out, overwrite=True)["rows"] == 5 and out.read_bytes() != written[0]
    (tmp_path / "notes.csv").write_text("mine")
    with pytest.raises(bifdiag.InputError, match="is not a finished scan"):
        bifdiag.scan(bodies=(A, r), out=tmp_path / "notes.csv")
    assert (tmp_path / "notes.csv").read_text() == "mine"


def test_interrupted_scans_of_own_bodies_go_on(tmp_path):
    A, r = rows(20_000)
    np.savez(tmp_path / "bodies.npz", A=A, r=r)
    out = tmp_path / "own.csv"
    work = f"import bifdiag, numpy; f = numpy.load(r'{tmp_path / 'bodies.npz'}'); "
    work += f"bifdiag.scan(bodies=(f['A'], f['r']), out=r'{out}')"
    with subprocess.Popen([sys.executable, "-c", work], stderr=subprocess.DEVNULL) as process:
        partial = tmp_path / "own.csv.partial"
        for _ in range(600):
            if partial.exists() and partial.stat().st_size > 20_000:
                break
            time.sleep(0.05)
        process.send_signal(signal.SIGTERM)
    deadline = time.monotonic() + 20
    while time.monotonic() < deadline:
        try:
            summary = bifdiag.scan(bodies=(A, r), out=out, threads=0)
            break
        except bifdiag.InputError as error:
            # The process of the command may take a moment to end.
            if "another process" not in str(error):
                raise
            time.sleep(0.2)
    assert summary["rows"] == 20_000 and not partial.exists()


@pytest.mark.parametrize(
    ("bodies", "message"),
    [
        ([[1, 2, 3]], "shape"),
        ({"A1": [1]}, "no column A2"),
        (np.zeros(3, dtype=[("A1", float), ("A2", float)]), "no column A3"),
        ([], "shape"),
        ([[1, 1, 1, 1, np.nan, 0]], r"bodies\[0\]: r2 = nan is no finite number; no other body"),
        ([["x"] * 6], "could not convert"),
    ],
)
def test_wrong_lists_of_bodies_are_told(bodies, message):
    with pytest.raises(bifdiag.InputError, match=message):
        bifdiag.scan(bodies=bodies)
    with pytest.raises(bifdiag.InputError, match="give one of them"):
        bifdiag.scan(bodies=bodies, family="general")
    measured = bifdiag.Body.from_inertia([["2±1%", 0, 0], [0, 2, 0], [0, 0, 1]], com=[0, 0, 0.05], mass=1)
    with pytest.raises(bifdiag.InputError, match="only critical_spin answers"):
        bifdiag.scan(bodies=[measured])


def test_a_table_of_the_command_line_names_what_is_wrong(command, tmp_path):
    table = tmp_path / "bodies.csv"
    for text, message in [
        ("A1,A2,A3,r1,r2\n1,1,1,1,0\n", "no column r3"),
        ("A1,A2,A3,r1,r2,r3\n1,1,x,1,0,0\n", "body 0, numbered from 0: A3"),
        ("A1,A2,A3,r1,r2,r3\n", "no body"),
    ]:
        table.write_text(text)
        assert message in command("scan", "--bodies", table, "--out", tmp_path / "x.csv", status=2)
    table.write_text("r1,r2,r3,A1,A2,A3\n1,0,0,11/10,1,1\n")
    told = command("scan", "--bodies", table, "--body", "paper", "--out", tmp_path / "x.csv", status=2)
    assert "single body" in told
    command("scan", "--bodies", table, "--out", tmp_path / "x.csv")
    assert "1.1" in (tmp_path / "x.csv").read_text()


def test_witnesses_have_numbers_and_exact_texts():
    witness = bifdiag.find("M4")
    assert isinstance(witness.h, float) and witness.h == float(witness.exact.h)
    assert witness.body.classify(*witness.exact).components == witness.components
    assert bifdiag.find("k0n1").exact is None


def test_messages_name_arguments(tmp_path):
    A, r = rows(3)
    lagrange = bifdiag.Body.preset("lagrange")
    for options, message in [
        ({"bodies": (A, r), "samples": 3}, "leave out samples and vary"),
        ({"bodies": (A, r[:2])}, "3 moments A and 2 centres r"),
        ({"body": lagrange, "vary": "A1=1:2"}, r"^samples is missing; give samples=100000, or .* such as vary=\"A2="),
        ({"bodies": (A, r), "out": tmp_path / "x.txt"}, "."),
        ({"body": lagrange, "vary": "A1=1:2:3", "family": "katok"}, "give one of them"),
    ]:
        with pytest.raises(bifdiag.InputError, match=message) as told:
            bifdiag.scan(**options)
        assert "--" not in str(told.value) and "Usage" not in str(told.value)
    with pytest.raises(bifdiag.InputError, match=r"^invalid value 'w' for 'axis'") as told:
        bifdiag.Body.from_inertia([[2, 0, 0], [0, 2, 0], [0, 0, 1]], com=[0, 0, 1], mass=1).critical_spin("w")
    assert "--" not in str(told.value)


def test_a_scan_of_a_frame_has_its_index():
    pd = pytest.importorskip("pandas")
    A, r = rows(5)
    frame = pd.DataFrame(np.hstack([A, r]), columns=["A1", "A2", "A3", "r1", "r2", "r3"], index=list("vwxyz"))
    frame["name"] = [f"body {k}" for k in range(5)]
    found = bifdiag.scan(bodies=frame)
    assert found.to_pandas().index.tolist() == list("vwxyz") and found[found.A1 > 0].to_pandas().index.tolist() == list(
        "vwxyz"
    )
    joined = frame[["name"]].join(found.to_pandas())
    assert joined.loc["x", "A1"] == A[2, 0] and joined.loc["x", "name"] == "body 2"
    assert found[1:3].to_pandas().index.tolist() == ["w", "x"]


def test_texts_of_counts_become_numbers():
    A, r = rows(6)
    found = bifdiag.scan(bodies=(np.vstack([A, [[-1, 1, 1]]]), np.vstack([r, [[1, 0, 0]]])))
    counts, types = found.counts(), found.counts("types")
    assert sum(counts.values())[:6].tolist() == found.regions[:6].tolist() and all(
        array[6] == 0 for array in counts.values()
    )
    for row, body in enumerate(zip(A.tolist(), r.tolist(), strict=True)):
        regions = bifdiag.Body(*body).atlas().regions
        for name, array in counts.items():
            assert array[row] == sum("+".join(sorted(region.signature.split("+"))) == name for region in regions)
        assert types["k1n0"][row] == sum(
            any((c.boundary_circles, len(c.poles)) == (1, 0) for c in one.components) for one in regions
        )
    with pytest.raises(bifdiag.InputError, match='"signatures" and "types"'):
        found.counts("regions")


@pytest.mark.parametrize(
    ("suffix", "words"), [("csv", "a scan .CSV.*pandas.read_csv"), ("jsonl", "a scan .JSON Lines.*read_json")]
)
def test_a_scan_is_known_as_one(suffix, words, tmp_path):
    path = tmp_path / f"scan.{suffix}"
    bifdiag.scan(samples=2, out=path)
    with pytest.raises(bifdiag.InputError, match=words):
        bifdiag.Atlas.load(path)


def test_gaps_leave_the_rest_as_it_is(tmp_path):
    A, r = rows(6)
    whole = bifdiag.scan(bodies=(A, r))
    assert whole.meta["invalid"] == [] and whole.regions.dtype == int and whole.unphysical.dtype == bool
    gaps = np.ma.masked_array(A, np.zeros(A.shape, dtype=bool))
    gaps[1, 2] = np.ma.masked
    other = r.copy()
    other[3, 1], other[4, 0] = np.nan, np.inf
    found = bifdiag.scan(bodies=(gaps, other))
    assert found.index.tolist() == list(range(6)) and found.meta["invalid"] == [1, 3, 4] and found.meta["rows"] == 3
    assert found.status.tolist() == ["classified", "invalid", "classified", "invalid", "invalid", "classified"]
    wrong = found[found.status == "invalid"]
    assert wrong.error.tolist() == [
        "A3 is masked",
        "r2 = nan is no finite number",
        "r1 = inf is no finite number",
    ]
    assert np.isnan(wrong.regions).all() and wrong.plane.mask.all() and wrong.signatures.tolist() == [None] * 3
    # The numbers that there are stay.
    assert found.r3.tolist() == r[:, 2].tolist() and np.isnan(found.A3[1]) and found.A1[1] == A[1, 0]
    kept = found[found.status != "invalid"]
    for name in whole.columns:
        here, there = kept[name].tolist(), whole[[0, 2, 5]][name].tolist()
        assert here == there or all(value in (None, there[0]) or np.isnan(there[0]) for value in here), name
    assert found.counts()["T2"].tolist() == [0 if k in (1, 3, 4) else whole.counts()["T2"][k] for k in range(6)]
    for options, message in [
        ({"invalid": "raise"}, r"^bodies\[1\]: A3 is masked; leave it out, or give invalid=\"mark\"$"),
        ({"out": tmp_path / "x.csv"}, r"^bodies\[1\]: A3 is masked; files and shards have no row for it"),
        ({"shard": (1, 2)}, r"files and shards"),
        ({"invalid": "drop"}, "mark"),
    ]:
        with pytest.raises(bifdiag.InputError, match=message):
            bifdiag.scan(bodies=(gaps, other), **options)
    assert not [*tmp_path.iterdir()]


def test_gaps_of_frames_have_rows():
    pd = pytest.importorskip("pandas")
    A, r = rows(4)
    frame = pd.DataFrame(np.hstack([A, r]), columns=["A1", "A2", "A3", "r1", "r2", "r3"], index=list("wxyz"))
    frame.loc["x", "r2"] = np.nan
    for kind in ("float64", "Float64"):
        found = bifdiag.scan(bodies=frame.astype(kind)).to_pandas()
        assert found.index.tolist() == list("wxyz") and found["status"].tolist()[1] == "invalid"
        assert found["regions"].isna().tolist() == [False, True, False, False] == found["plane"].isna().tolist()
    pytest.importorskip("xarray")
    found = bifdiag.scan(bodies=frame.rename_axis("rotor").to_xarray())
    assert found.to_pandas().index.tolist() == list("wxyz") and found.to_pandas().index.name == "rotor"
    assert found[1:3].to_xarray()["rotor"].to_numpy().tolist() == ["x", "y"]
    pl, pa = pytest.importorskip("polars"), pytest.importorskip("pyarrow")
    part = frame.drop(columns="r3")
    for wrong in (part, pl.DataFrame(part), pa.table(part), part.to_xarray()):
        with pytest.raises(bifdiag.InputError, match="bodies has no column r3"):
            bifdiag.scan(bodies=wrong)
    found = bifdiag.scan(bodies=pl.DataFrame(frame.where(frame.notna(), None).to_dict("list")))
    assert found.meta["invalid"] == [1] and pl.DataFrame(found)["plane"].null_count() == 1
