"""Sections and motions as arrays."""

import json
import pickle
import sys

import numpy as np
import pytest

import bifdiag


def test_a_section_has_its_columns(section):
    own = ("orbit", "index", "time", "gamma", "l", "sheet", "s_dot", "theta", "psi")
    assert section.columns == (*own, "lyapunov", "rotation", "exponent")
    assert paper_section(chaos=False).columns == own
    assert len(section) == 6 * 41 and section.gamma.shape == section.l.shape == (246, 3)
    assert section.gamma.flags.c_contiguous and section.orbit.dtype == np.int32
    assert np.allclose((section.gamma**2).sum(axis=1), 1)
    assert np.allclose((section.gamma * section.l).sum(axis=1), 3.25)
    assert section.signature == "S2+T2" and set(section.sheet) == {-1, 1}
    with pytest.raises(AttributeError, match="it has orbit, index"):
        section.nothing  # noqa: B018


def test_the_file_is_the_command_lines(section, command, tmp_path):
    body = ["--A=2,11/10,1", "--r=0.94868,0,0.61623"]
    point = ["--h=3.8", "--l=3.25", "--orbits=6", "--crossings=40"]
    command("section", *body, *point, "--no-plot", "--verdict=whole", "--data", tmp_path / "theirs.npz")
    section.save(tmp_path / "ours.npz")
    assert (tmp_path / "ours.npz").read_bytes() == (tmp_path / "theirs.npz").read_bytes()
    loaded = bifdiag.Section.load(tmp_path / "theirs.npz")
    assert loaded == section == pickle.loads(pickle.dumps(section))
    loaded.save(tmp_path / "again.npz")
    assert (tmp_path / "again.npz").read_bytes() == (tmp_path / "theirs.npz").read_bytes()
    assert loaded != paper_section(seed=1)


def paper_section(**options):
    return bifdiag.Body.preset("paper").section(3.8, 3.25, **({"orbits": 6, "crossings": 40} | options))


def test_threads_change_nothing():
    assert paper_section(threads=3, orbits=20) == paper_section(orbits=20)


def test_starts_are_followed(section):
    first = section.index == 0
    starts = np.stack([section.theta[first], section.psi[first], section.sheet[first]], axis=1)
    again = paper_section(starts=starts)
    assert np.allclose(again.gamma[again.index == 0], section.gamma[first], atol=1e-12)
    with pytest.raises(bifdiag.InputError, match="sheet"):
        paper_section(starts=[[1, 1, 0]])
    with pytest.raises(bifdiag.InputError, match="shape"):
        paper_section(starts=[1, 1, 1])


def test_chaos_gives_exponents():
    found = paper_section(orbits=2, crossings=300, chaos=True)
    assert found.lyapunov.shape == found.time.shape
    for orbit in found.meta["orbits"]:
        exponents = set(found.lyapunov[found.orbit == orbit["orbit"]])
        assert exponents == {orbit["chaos"]["lyapunov"]["exponent"]}
    assert np.isnan(found.exponent[found.index == 0]).all() and np.isfinite(found.exponent[found.index > 0]).all()


def test_verdicts_tell_regular_from_chaotic():
    found = bifdiag.Body.preset("paper").section(5.3, 3.25, orbits=24, crossings=1000)
    assert len(found.verdict) == len(found.reason) == 24
    assert {"regular", "chaotic"} <= set(found.verdict) <= {"regular", "chaotic", "open"}
    integrable = bifdiag.Body.preset("kovalevskaya").section(3.4, 2.87, orbits=24, crossings=500)
    assert set(integrable.verdict) <= {"regular", "open"}
    assert "linearly" in integrable.reason[integrable.verdict.index("regular")]
    unasked = paper_section(orbits=2, crossings=10, chaos=False)
    assert unasked.verdict == ("open", "open") and "not asked" in unasked.reason[0]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"h": -5, "l": 3}, "forbidden"),
        ({"h": float("nan"), "l": 3}, "h = nan"),
        ({"h": 3.8, "l": 3.25, "orbits": 0}, "orbits = 0"),
        ({"h": 3.8, "l": 3.25, "crossings": 2.5}, "crossings = 2.5"),
        ({"h": 3.8, "l": 3.25, "condition": "x"}, "angular-momentum"),
        ({"h": 3.8, "l": 3.25, "tolerance": -1}, "1e-18 to 1e-2"),
        ({"h": 3.8, "l": 3.25, "threads": -1}, "threads"),
    ],
)
def test_wrong_sections_are_told(paper, arguments, message):
    with pytest.raises(bifdiag.InputError, match=message):
        paper.section(**arguments)


def test_files_that_are_none_are_told(tmp_path):
    (tmp_path / "x.npz").write_text("x")
    with pytest.raises(bifdiag.InputError, match="archive of `bifdiag section"):
        bifdiag.Section.load(tmp_path / "x.npz")
    bifdiag.Body.preset("paper").atlas().save(tmp_path / "atlas.json")
    with pytest.raises(bifdiag.InputError, match=r"is an atlas .JSON., no section: bifdiag.Atlas.load reads it"):
        bifdiag.Section.load(tmp_path / "atlas.json")
    with pytest.raises(bifdiag.InputError, match=r"no motion: bifdiag.Section.load"):
        bifdiag.Motion.load(_saved(tmp_path))
    np.savez(tmp_path / "other.npz", a=1)
    with pytest.raises(bifdiag.InputError, match="other arrays"):
        bifdiag.Section.load(tmp_path / "other.npz")
    with pytest.raises(FileNotFoundError):
        bifdiag.Section.load(tmp_path / "nothing.npz")
    (tmp_path / "diagram.svg").write_text("<svg/>")
    with pytest.raises(bifdiag.InputError, match=r"diagram.svg is no atlas: an atlas.json of .* is needed here$"):
        bifdiag.Atlas.load(tmp_path / "diagram.svg")
    np.savez(tmp_path / "y.npz", orbit=[1], meta="{}")
    with pytest.raises(bifdiag.InputError, match="no array 'index'"):
        bifdiag.Section.load(tmp_path / "y.npz")


def _saved(folder):
    paper_section(orbits=1, crossings=5).save(folder / "section.npz")
    return folder / "section.npz"


def test_missing_packages_name_their_extra(section, monkeypatch):
    for module, hand_on in [
        ("pandas", section.to_pandas),
        ("xarray", section.to_xarray),
        ("pyarrow", section.__arrow_c_stream__),
    ]:
        monkeypatch.setitem(sys.modules, module, None)
        with pytest.raises(ImportError, match=rf"{module}: pip install 'bifdiag\[tables\]'"):
            hand_on()
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match=r"bifdiag\[plot\]"):
        section.plot()
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match=r"bifdiag\[plot\]"):
        section.plot()


def test_islands_are_counted(paper):
    found = paper.section(5.3, 3.25, orbits=24, crossings=600)
    chains = [orbit for orbit in found.meta["orbits"] if (orbit["chaos"]["rotation"] or {}).get("angle") == "islands"]
    assert chains
    for orbit in chains:
        rotation = orbit["chaos"]["rotation"]
        steps = rotation["number"] * rotation["islands"]
        assert steps == pytest.approx(round(steps)) and set(found.rotation[found.orbit == orbit["orbit"]]) == {
            rotation["number"]
        }


def test_the_section_at_minus_l_is_the_mirror_image(paper):
    found = paper_section(chaos=False)
    starts = np.stack([found.theta, found.psi, -found.sheet], axis=1)[found.index == 0]
    mirrored = paper.section(3.8, -3.25, starts=starts, crossings=1, chaos=False)
    first = mirrored.index == 0
    assert np.allclose(mirrored.gamma[first], found.gamma[found.index == 0])
    assert np.allclose(mirrored.l[first], -found.l[found.index == 0], atol=1e-12)


def test_symbols_are_those_of_the_conventions(paper, section):
    A, r = np.array([2, 1.1, 1]), np.array([0.94868, 0, 0.61623])
    omega = section.l / A
    energy = (section.l * omega).sum(axis=1) / 2 - section.gamma @ r
    assert np.allclose(energy, 3.8)
    speed = np.cross(section.gamma, omega)
    assert np.allclose(speed @ r, 0, atol=1e-12)
    change = np.cross(section.l, omega) - np.cross(section.gamma, r)
    rate = (np.cross(speed, omega) + np.cross(section.gamma, change / A)) @ r
    assert np.allclose(rate, section.s_dot)
    delta = (np.cross(omega, section.gamma) * (np.cross(section.gamma, r) / A)).sum(axis=1)
    assert (np.sign(delta) == section.sheet).all()
    # (ϑ′, ψ′) about r̂, counted from the direction in which e₃ is seen.
    r_hat = r / np.linalg.norm(r)
    e_y = np.array([0, 0, 1]) - r_hat[2] * r_hat
    e_y /= np.linalg.norm(e_y)
    e_x = np.cross(e_y, r_hat)
    theta, psi = section.theta[:, None], section.psi[:, None]
    gamma = np.sin(theta) * (np.sin(psi) * e_x + np.cos(psi) * e_y) + np.cos(theta) * r_hat
    assert np.allclose(gamma, section.gamma)


def test_tables_are_handed_on(section):
    pd, xr, pa = (pytest.importorskip(name) for name in ("pandas", "xarray", "pyarrow"))
    frame = section.to_pandas()
    assert isinstance(frame, pd.DataFrame) and frame["gamma_2"].to_numpy().tolist() == section.gamma[:, 1].tolist()
    data = section.to_xarray()
    assert isinstance(data, xr.Dataset) and json.loads(data.attrs["meta"]) == section.meta
    table = pa.table(section)
    assert table.num_rows == len(section) and table["psi"].to_pylist() == section.psi.tolist()


def test_a_motion_turns_the_vertical_up(paper):
    times = np.linspace(-2, 5, 71)
    motion = paper.orbit(gamma=[3, 0, 4], omega=[1, 0.3, 1], t=times)
    assert motion.time.tolist() == times.tolist()
    start = np.searchsorted(times, 0)
    assert np.allclose(motion.gamma[start], [0.6, 0, 0.8]) and np.allclose(motion.l[start], [2, 0.33, 1])
    axes = motion.axes()
    assert np.allclose(np.einsum("nij,nj->ni", axes, motion.gamma), [0, 0, 1], atol=1e-12)
    assert np.allclose(np.linalg.det(axes), 1)
    assert np.array_equal(motion.attitude(scalar_first=False)[:, 3], motion.quaternion[:, 0])
    assert pickle.loads(pickle.dumps(motion)) == motion


def test_euler_angles_are_those_of_the_conventions(paper):
    motion = paper.orbit(gamma=[0.6, 0, 0.8], omega=[1, 0.3, 1], t=9, phi=0.4)
    zero = np.zeros(len(motion))

    def about(axis, angle):
        c, s = np.cos(angle), np.sin(angle)
        rows = {
            "x": [[zero + 1, zero, zero], [zero, c, -s], [zero, s, c]],
            "z": [[c, -s, zero], [s, c, zero], [zero, zero, zero + 1]],
        }
        return np.moveaxis(np.array(rows[axis]), -1, 0)

    turned = about("z", motion.phi) @ about("x", motion.theta) @ about("z", motion.psi)
    assert np.allclose(turned, motion.axes(), atol=1e-9) and motion.phi[0] == 0.4
    assert np.allclose(motion.axes()[:, 2], motion.gamma, atol=1e-9)
    # The attitude obeys dR/dt = R [ω]: by central differences of the rows in space.
    speed = np.gradient(motion.axes(), motion.time, axis=0)[1:-1]
    spin = np.cross(motion.omega[:, None, :], np.eye(3)[None]).transpose(0, 2, 1)[1:-1]
    assert np.abs(speed - motion.axes()[1:-1] @ spin).max() < 0.01


def test_times_may_be_a_single_number(paper):
    state = {"gamma": [0, 0, 1], "omega": [1, 1, 1]}
    forth, back, now = (paper.orbit(**state, t=t).time for t in (5, -5, 0))
    assert (len(forth), forth[0], forth[-1]) == (201, 0, 5)
    assert (len(back), back[0], back[-1]) == (201, -5, 0)
    assert now.tolist() == [0]
    assert paper.orbit(**state, t=[0, 0, 1]).time.tolist() == [0, 0, 1]


def test_motions_agree_with_the_command_line(paper, command):
    text = command("orbit", "--A=2,11/10,1", "--r=0.94868,0,0.61623", "--gamma=0.6,0,0.8", "--l-vector=1,0.3,1",
                   "--times=0:3:7", "--json")  # fmt: skip
    samples = json.loads(text)["samples"]
    motion = paper.orbit(gamma=[0.6, 0, 0.8], l=[1, 0.3, 1], t=[sample["time"] for sample in samples])
    assert motion.gamma.tolist() == [sample["gamma"] for sample in samples]
    assert motion.quaternion.tolist() == [sample["attitude"] for sample in samples]


def test_motions_of_the_command_line_are_read(paper, command, tmp_path):
    path = tmp_path / "theirs.npz"
    command("orbit", "--A=2,11/10,1", "--r=0.94868,0,0.61623", "--gamma=0.6,0,0.8", "--l-vector=1,0.3,1",
            "--times=0:3:7", "--data", path)  # fmt: skip
    theirs, ours = bifdiag.Motion.load(path), paper.orbit(gamma=[0.6, 0, 0.8], l=[1, 0.3, 1], t=np.linspace(0, 3, 7))
    assert theirs.columns == ours.columns
    assert all(np.array_equal(theirs[name], ours[name]) for name in ours.columns)
    document = theirs.meta.pop("document")
    assert theirs.meta == ours.meta | {"momentum": document["l"]} and document["complete"]
    assert np.array_equal(theirs.energy, ours.energy)
    bifdiag.Motion.load(path).save(tmp_path / "again.npz")
    assert bifdiag.Motion.load(tmp_path / "again.npz") == bifdiag.Motion.load(path)
    np.savez(tmp_path / "other.npz", attitude=np.zeros((1, 4)), meta="{}")
    with pytest.raises(bifdiag.InputError, match="no array 'time'"):
        bifdiag.Motion.load(tmp_path / "other.npz")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"gamma": [0, 0, 0], "l": [1, 0, 0], "t": 1}, "no direction"),
        ({"gamma": [0, 0, 1], "t": 1}, "either l"),
        ({"gamma": [0, 0, 1], "l": [1, 0], "t": 1}, "shape"),
        ({"gamma": [0, 0, 1], "l": [1, 0, 0], "t": [2, 1]}, "sort the times"),
        ({"gamma": [0, 0, 1], "l": [1, 0, np.inf], "t": 1}, "finite"),
    ],
)
def test_wrong_motions_are_told(paper, arguments, message):
    with pytest.raises(bifdiag.InputError, match=message):
        paper.orbit(**arguments)


def test_many_starts_are_one_table(paper):
    rng = np.random.default_rng(5)
    gamma, l = rng.normal(size=(2, 3, 3)), rng.normal(size=3)
    times = np.linspace(0, 2, 5)
    found = paper.orbit(gamma, l, times)
    assert len(found) == 2 * 3 * 5 and found.columns[0] == "orbit" and len(found.meta["energy"]) == 6
    for number, start in enumerate(gamma.reshape(-1, 3)):
        one, part = paper.orbit(start, l, times), found[found.orbit == number]
        assert all(np.array_equal(one[name], part[name]) for name in one.columns)
        assert found.meta["energy"][number] == one.meta["energy"]
    assert np.ptp(found.energy.reshape(6, 5), axis=1).max() < 1e-12 and "of 6 orbits" in repr(found)
    assert pickle.loads(pickle.dumps(found)) == found and len(paper.orbit(np.empty((0, 3)), l)) == 0
    turning = paper.orbit([0.6, 0, 0.8], omega=np.eye(3), t=1)
    assert turning.orbit.max() == 2 and len(paper.orbit([[0.6, 0, 0.8]], l, 1)) == 201
    for wrong, message in [
        ((5, 3), "do not broadcast"),
        ((4,), "three numbers are needed"),
        ((), "three numbers are needed"),
    ]:
        with pytest.raises(bifdiag.InputError, match=message):
            paper.orbit(gamma, np.ones(wrong), times)
    with pytest.raises(bifdiag.InputError, match="one start at a time"):
        paper.orbit(gamma, l, times, proved=True)


def test_many_motions_are_saved_and_labelled(paper, tmp_path):
    xr = pytest.importorskip("xarray")
    found = paper.orbit(np.eye(3), [0.1, 0.2, 0.3], t=[0, 1, 2, 3])
    found.save(tmp_path / "many.npz")
    assert bifdiag.Motion.load(tmp_path / "many.npz") == found
    data = found.to_xarray()
    assert isinstance(data, xr.Dataset) and data["gamma"].dims == ("orbit", "time", "axis")
    here = data["gamma"].sel(orbit=1, time=2, axis=3).item()
    assert here == found[(found.orbit == 1) & (found.time == 2)].gamma[0, 2]
    one = found[found.orbit == 2].to_xarray()
    assert one["quaternion"].sel(component="w").shape == (1, 4)
    alone = paper.orbit([1, 0, 0], [0.1, 0.2, 0.3], t=[0, 1, 2, 3]).to_xarray()
    assert alone["theta"].dims == ("time",) and float(alone["theta"].interp(time=0.5)) > 0
    with pytest.raises(bifdiag.InputError, match="different times"):
        found[:6].to_xarray()


def test_rows_of_tables_are_selected(paper, section):
    upper = section[section.sheet == 1]
    assert type(upper) is bifdiag.Section and (upper.sheet == 1).all() and len(upper) == (section.sheet == 1).sum()
    assert section[3]["time"] == section.time[3] and section[-2:].time.tolist() == section.time[-2:].tolist()
    assert np.asarray(section)["gamma"].shape == section.gamma.shape and next(iter(section))["index"] == 0
    motion = paper.orbit([0.6, 0, 0.8], omega=[1, 0.3, 1], t=np.arange(5))
    assert motion[[0, 2]].time.tolist() == [0, 2] and len(motion[[]]) == 0
    assert motion[["time", "theta"]].dtype.names == ("time", "theta")
    with pytest.raises(IndexError, match="no row 9 of 5"):
        motion[9]
    with pytest.raises(KeyError, match="no column 'thetta'"):
        motion["thetta"]
    # What is said of all periodic orbits is not said of some of them.
    orbits = paper.periodic_orbits("2.6", "3.25")
    some = orbits[orbits.proved]
    assert isinstance(some, np.ndarray) and some["period"].tolist() == orbits.period[orbits.proved].tolist()
    assert isinstance(paper.orbit([0.6, 0, 0.8], omega=[1, 0.3, 1], t=1, proved=True)[:2], np.ndarray)


def test_starts_may_be_exact_texts(paper):
    told = paper.orbit(["0.6", 0, "0.8"], omega=[1, "1/3", 1], t=2)
    assert told == paper.orbit([0.6, 0, 0.8], omega=[1, 1 / 3, 1], t=2)
    for options, message in [
        ({"omega": [1, "x", 1]}, "omega: 'x' is not a number"),
        ({"omega": [1, "1/0", 1]}, "omega: '1/0' is not a number"),
        ({"omega": [1, 1, 1], "tolerance": -1}, "tolerance = -1 is not usable"),
        ({"omega": [1, 1, 1], "t": [3, 2, 1]}, r"t\[1\] = 2.0 is before t\[0\]"),
        ({"omega": [1, 1, 1], "t": []}, "one or more"),
        ({"omega": [1, 1, 1], "t": np.inf}, "finite"),
    ]:
        with pytest.raises(bifdiag.InputError, match=message):
            paper.orbit([0.6, 0, 0.8], **options)
