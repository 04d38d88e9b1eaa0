"""The guest gives what the command line gives."""

import json
import os
import pathlib
import pickle
import subprocess
from decimal import Decimal
from fractions import Fraction

import bifdiag
import pytest

PAPER = {"A": [2, "11/10", 1], "r": [0.94868, 0, Decimal("0.61623")]}


def program():
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", pathlib.Path(__file__).parents[2] / "target"))
    return target / "release" / "bifdiag"


def test_the_papers_body_has_nine_regions():
    atlas = bifdiag.Body(**PAPER).atlas()
    assert [region.id for region in atlas.regions] == [f"R{n}" for n in range(1, 10)]
    assert sorted(region.signature for region in atlas.regions) == sorted(
        ["S2", "T2", "S2+T2", "T2+T2", "M3", "M2", "T2", "M2", "S2+S2"]
    )
    region = next(region for region in atlas.regions if region.id == atlas.region(3.8, 3.25))
    assert region.signature == "S2+T2" == bifdiag.Body(**PAPER).classify("3.8", "13/4").signature
    assert atlas.region(0, 3.25) is None


def test_the_document_is_the_command_lines():
    for body in [bifdiag.Body.preset("paper"), bifdiag.Body(["2", "1.5", "1.2"], ["0.5", "1/3", "-1e-3"])]:
        numbers = [f"--A={','.join(body.A)}", f"--r={','.join(body.r)}"]
        expected = subprocess.run([program(), *numbers, "--json"], check=True, capture_output=True, text=True).stdout
        assert body.atlas().to_json() == expected
        assert json.loads(expected)["body"]["A"] == body.A


def test_numbers_are_exact_and_floats_are_their_shortest_decimals():
    assert bifdiag.Body([0.1, Fraction(1, 3), 10**30], [0, 1, 2]).A == ["0.1", "1/3", str(10**30)]


def test_points_on_a_line_are_critical():
    found = bifdiag.Body.preset("kovalevskaya").classify("2", "2")
    assert found.status == "critical" and found.components is None and len(found.candidates) > 1


def test_equilibria_are_sorted():
    found = bifdiag.Body(**PAPER).critical("3.25")
    assert [point.index for point in found] == [0, 0, 1, 1, 2, 2]
    assert found[0].h == pytest.approx(1.639699408, abs=1e-9)


def test_errors_have_their_classes():
    with pytest.raises(bifdiag.BodyError, match="A2"):
        bifdiag.Body([1, -1, 1], [1, 0, 0])
    with pytest.raises(ValueError, match="three"):
        bifdiag.Body([1, 1], [1, 0, 0])
    with pytest.raises(bifdiag.InputError, match="paper"):
        bifdiag.Body.preset("nothing")
    with pytest.raises(bifdiag.InputError):
        bifdiag.Body([1, float("nan"), 1], [1, 0, 0])
    with pytest.raises(TypeError):
        bifdiag.Body([True, 1, 1], [1, 0, 0])
    assert issubclass(bifdiag.RangeError, ArithmeticError)


def test_bodies_are_pickled():
    body = bifdiag.Body(**PAPER)
    assert pickle.loads(pickle.dumps(body)) == body
