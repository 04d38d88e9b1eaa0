"""Motions with proved bounds."""

import json
import pickle
from fractions import Fraction

import numpy as np
import pytest

import bifdiag

START = {"gamma": ["0.6", 0, "0.8"], "omega": [1, "0.3", 1]}
LINE = ("--body=paper", "--gamma=0.6,0,0.8", "--omega=1,0.3,1")


@pytest.fixture(scope="module")
def proved(paper):
    return paper.orbit(**START, t=np.linspace(0, 5, 11), proved=True)


def test_the_file_is_the_command_lines(proved, command, tmp_path):
    command("orbit", *LINE, "--times=0:5:11", "--proved", "--data", tmp_path / "theirs.npz")
    proved.save(tmp_path / "ours.npz")
    theirs, ours = (bifdiag.ProvedMotion.load(tmp_path / name) for name in ("theirs.npz", "ours.npz"))
    assert theirs.columns == ours.columns == proved.columns == bifdiag.ProvedMotion.NAMES
    assert all(np.array_equal(theirs[name], proved[name]) for name in proved.columns)
    # The presets say 1.1, the fixture 11/10.
    assert {k: v for k, v in theirs.meta.items() if k not in ("A", "command")} == {
        k: v for k, v in proved.meta.items() if k not in ("A", "command")
    }
    assert proved.meta["command"].endswith("--times 0:5:11 --proved --json")
    preset = bifdiag.Body.preset("paper").orbit(**START, t=np.linspace(0, 5, 11), proved=True)
    preset.save(tmp_path / "preset.npz")
    assert (tmp_path / "preset.npz").read_bytes() == (tmp_path / "theirs.npz").read_bytes()


@pytest.mark.parametrize("digits", [None, 40])
def test_the_decimals_are_the_commands(command, digits):
    more = () if digits is None else (f"--digits={digits}", "--bound=1e-30")
    theirs = json.loads(command("orbit", *LINE, "--times=-1:1:3", "--proved", "--json", *more))
    bound = {} if digits is None else {"digits": digits, "bound": 1e-30}
    ours = bifdiag.Body.preset("paper").orbit(**START, t=[-1, 0, 1], proved=True, **bound)
    assert ours.decimals == theirs.pop("enclosures")
    assert ours.meta == theirs
    assert ours.proved == (theirs["proved_from"], theirs["proved_to"]) and ours.widest == theirs["widest"]
    # Both hold the same motion, and doubles cannot tell more than 1e-16.
    for k, row in enumerate(ours.decimals["omega"]):
        for i, (lo, hi) in enumerate(row):
            low, high = map(Fraction, ours.omega[k, i].tolist())
            assert low <= Fraction(hi) and Fraction(lo) <= high
            assert high - low <= 2 * (Fraction(hi) - Fraction(lo)) + Fraction(1, 10**15)


def test_enclosures_hold_the_plain_motion(proved, paper):
    plain = paper.orbit(**{name: [float(x) for x in v] for name, v in START.items()}, t=proved.time)
    assert (
        proved.gamma.shape == (11, 3, 2)
        and proved.rotation.shape == (11, 3, 3, 2)
        and proved.quaternion.shape == (11, 4, 2)
    )
    for name, values in (("gamma", plain.gamma), ("omega", plain.omega), ("rotation", plain.axes())):
        ends = getattr(proved, name)
        assert (ends[..., 0] <= ends[..., 1]).all()
        # The plain motion is off by its own error.
        assert np.abs(ends.mean(axis=-1) - values).max() < 1e-12
    assert np.abs(proved.quaternion.mean(axis=-1) - plain.quaternion).max() < 1e-12
    assert np.array_equal(proved.rotation[:, 2], proved.gamma)
    wide = proved.gamma.mean(axis=-1)
    assert proved.contains("gamma", wide).all() and not proved.contains("gamma", wide + 1e-6).any()
    with pytest.raises(bifdiag.InputError, match="shape"):
        proved.contains("gamma", wide[:2])


def test_numbers_are_taken_exactly(paper):
    thirds = paper.orbit(gamma=[Fraction(1, 3), 0, 1], l=["1/7", 0, 1], t=[0], proved=True)
    assert thirds.meta["start"]["gamma"] == ["1/3", "0", "1"]
    assert thirds.meta["start"]["omega"] == ["1/14", "0", "1"]
    arrays = paper.orbit(gamma=np.array([0.6, 0, 0.8]), omega=np.array([1, 0.3, 1]), t=1.0, proved=True)
    assert arrays.meta["start"]["gamma"] == ["0.6", "0.0", "0.8"] and len(arrays) == 201
    assert "--times 0:1:201" in arrays.meta["command"]
    assert "--times=- " in paper.orbit(**START, t=[0, 1, 3], proved=True).meta["command"]


def test_a_proof_that_ends_says_where_and_why(paper):
    short = paper.orbit(**START, t=[0, 1, 50, 100], proved=True, digits=15, bound=1e-13)
    assert not short.complete and len(short) == short.time.size < 4
    assert "from there enclosures outrun" in short.why and "--digits" in short.why
    assert short.proved[1] < 100 and "not complete" in repr(short)


def test_wrong_questions_are_refused(paper):
    for options, told in [
        ({"digits": 4}, "digits"),
        ({"bound": 2}, "bound"),
        ({"tolerance": 1e-9}, "no tolerance"),
        ({"l": [1, 0, 0]}, "either l"),
        ({"gamma": [0, 0, 0]}, "no direction"),
        ({"t": [1, 0]}, "sort the times"),
        ({"phi": "x"}, "not a number"),
    ]:
        with pytest.raises(bifdiag.InputError, match=told):
            paper.orbit(**(START | {"t": [0, 1], "proved": True} | options))
    with pytest.raises(bifdiag.InputError, match="proved=True"):
        paper.orbit(gamma=[0.6, 0, 0.8], omega=[1, 0.3, 1], digits=30)


def test_copies_are_equal(proved, tmp_path):
    again = pickle.loads(pickle.dumps(proved))
    assert again == proved and again.decimals == proved.decimals
    proved.save(tmp_path / "motion.npz")
    assert bifdiag.ProvedMotion.load(tmp_path / "motion.npz") == proved
    assert bifdiag.ProvedMotion.load(tmp_path / "motion.npz").decimals is None
    with pytest.raises(bifdiag.InputError, match="a proved motion"):
        bifdiag.Motion.load(tmp_path / "motion.npz")
