"""Periodic orbits."""

import json
import pickle

import numpy as np
import pytest

import bifdiag

POINT = ("4.45", "3.25")


@pytest.fixture(scope="module")
def orbits():
    return bifdiag.Body.preset("paper").periodic_orbits(*POINT)


def test_they_are_the_commands(orbits, command):
    theirs = json.loads(command("periodic", "--body=paper", "--h=4.45", "--l=3.25", "--json"))
    assert orbits.meta == theirs and orbits.complete == theirs["complete"] and orbits.why == theirs["why"]
    listed = theirs["orbits"] + theirs["continua"]
    assert len(orbits) == len(listed) > 0
    for k, orbit in enumerate(listed):
        assert orbits.gamma[k].tolist() == orbit["gamma"] and orbits.omega[k].tolist() == orbit["omega"]
        assert [[z.real, z.imag] for z in orbits.multipliers[k]] == orbit["multipliers"]
        for name in ("h", "l", "period", "crossings", "stability", "action", "symmetric", "proved"):
            assert orbits[name][k] == orbit[name]
    assert orbits.continuum.sum() == len(theirs["continua"])
    assert np.allclose(orbits.multipliers.prod(axis=1), 1, atol=1e-9)


def test_each_closes(orbits):
    body = bifdiag.Body.preset("paper")
    for gamma, omega, period in zip(orbits.gamma, orbits.omega, orbits.period, strict=True):
        end = body.orbit(gamma=gamma, omega=omega, t=[0, period])
        assert np.abs(end.gamma[1] - end.gamma[0]).max() < 1e-8
        assert np.abs(end.omega[1] - end.omega[0]).max() < 1e-8


def test_they_convert(orbits, tmp_path):
    frame = orbits.to_pandas()
    assert len(frame) == len(orbits) and {"gamma_1", "stability", "multipliers_1_re"} <= set(frame.columns)
    assert pickle.loads(pickle.dumps(orbits)) == orbits
    orbits.save(tmp_path / "orbits.npz")
    assert bifdiag.PeriodicOrbits.load(tmp_path / "orbits.npz") == orbits
    assert bifdiag.Body.preset("paper").periodic_orbits(*POINT, threads=2) == orbits


def test_wrong_questions_are_refused(paper):
    for arguments, told in [
        ((0, 3.25), "forbidden|below"),
        ((4.45, 3.25, 3), "crosses P inward as often as outward"),
        ((4.45, 3.25, 26), "crossings"),
    ]:
        with pytest.raises(bifdiag.InputError, match=told):
            paper.periodic_orbits(*arguments)
    with pytest.raises(bifdiag.InputError):
        bifdiag.Body.preset("euler").periodic_orbits(1, 1)


@pytest.fixture(scope="module")
def family():
    (found, *_) = bifdiag.Body.preset("paper").periodic_families(l="1.5", curve="G2.1", members=40, branches=True)
    return found


def test_families_are_the_commands(family, command):
    line = ("periodic", "family", "--body=paper", "--from=G2.1", "--l=1.5", "--members=40", "--branches", "--json")
    theirs = json.loads(command(*line))["families"]
    ours = bifdiag.Body.preset("paper").periodic_families(l="1.5", curve="G2.1", members=40, branches=True)
    assert len(ours) == len(theirs)
    for one, document in zip(ours, theirs, strict=True):
        assert one.gamma.tolist() == [orbit["gamma"] for orbit in document["members"]]
        assert one.period.tolist() == [orbit["period"] for orbit in document["members"]]
        assert (one.curve, one.frequency, one.end) == (document["curve"], document["frequency"], document["end"]["kind"])
        assert [event["kind"] for event in one.events] == [event["kind"] for event in document["events"]]
        branches = [branch for event in document["events"] for branch in event["branches"]]
        assert [len(branch) for branch in one.branches] == [len(branch["members"]) for branch in branches]
    assert family.free == "h" and np.allclose(family.l, 1.5, rtol=1e-12)
    assert (family.meta["l"], family.curve) == (1.5, "G2.1")


def test_families_at_one_energy(family):
    (found, *_) = bifdiag.Body.preset("paper").periodic_families(h=1, curve="G2.1", members=5)
    assert found.free == "l" and np.allclose(found.h, 1, atol=1e-9)


def test_families_convert_and_are_drawn(family, tmp_path):
    assert pickle.loads(pickle.dumps(family)) == family
    family.save(tmp_path / "family.npz")
    assert bifdiag.PeriodicFamily.load(tmp_path / "family.npz") == family
    with pytest.raises(bifdiag.InputError, match="a family of periodic orbits"):
        bifdiag.PeriodicOrbits.load(tmp_path / "family.npz")
    figure = pytest.importorskip("matplotlib.figure")
    ax = figure.Figure().subplots()
    assert family.plot(ax) is ax and ax.get_xlabel() == "$h$"
    kinds = {line.get_gid() for line in ax.lines}
    assert set(family.stability.tolist()) <= kinds and {event["kind"] for event in family.events} <= kinds
    ends = [line.get_xdata()[-1] for line in ax.lines if line.get_gid() in set(family.stability.tolist())]
    assert family.h[-1] in ends


def test_wrong_families_are_refused(paper):
    for options, told in [
        ({}, "either l"),
        ({"l": 1, "h": 1}, "either l"),
        ({"l": 1.5, "curve": "G9.9"}, "it has G0"),
        ({"h": -100}, "no equilibrium there"),
        ({"l": 1, "members": 0}, "members"),
    ]:
        with pytest.raises(bifdiag.InputError, match=told):
            paper.periodic_families(**options)
