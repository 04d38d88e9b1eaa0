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
