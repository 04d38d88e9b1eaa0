"""The held cases, whose answers were found by means that share nothing with the program (data/cases, data/oracles)."""

import json
from pathlib import Path

import numpy as np
import pytest

import bifdiag

DATA = Path(__file__).parents[2] / "data"
pytestmark = [
    pytest.mark.skipif(not DATA.is_dir(), reason="the held cases lie in the repository"),
    pytest.mark.filterwarnings("ignore::bifdiag.BodyWarning"),
]


def cases(name):
    """The lines of a file; numbers as they are written."""
    return [json.loads(line, parse_float=str) for line in (DATA / name).read_text().splitlines()]


def body(case):
    return bifdiag.Body(case["A"], case["r"])


def counts(components):
    return sorted((found.boundary_circles, len(found.poles), found.genus) for found in components)


def test_points_have_their_components():
    for case in cases("cases/classify.jsonl"):
        given, atlas = body(case), body(case).atlas()
        told = sorted((found["boundary_circles"], found["poles"], found["genus"]) for found in case["components"])
        assert counts(given.classify(case["h"], case["l"]).components) == told
        assert counts(atlas.regions[atlas.region(case["h"], case["l"])].components) == told
        assert counts(atlas.regions[atlas.region(np.array([float(case["h"])]), float(case["l"]))[0]].components) == told


@pytest.mark.parametrize("name", ["cases/regions.jsonl", "oracles/regions2.jsonl"])
def test_atlases_have_their_regions_and_events(name):
    for case in cases(name):
        atlas = body(case).atlas()
        assert len(atlas.regions) == case["regions"]
        events = case["events"]
        if isinstance(events, int):
            assert len(atlas.events) == events
        else:
            found = sorted((event.kind, event.l) for event in atlas.events)
            told = sorted((event["kind"], float(event["l"])) for event in events)
            assert [kind for kind, _ in found] == [kind for kind, _ in told]
            assert np.allclose([l for _, l in found], [l for _, l in told], rtol=1e-11)


def test_points_beside_curves_are_on_their_side():
    told = cases("oracles/classify2.jsonl")
    for case in told:
        atlas = body(case).atlas()
        near, middle = atlas.region(np.array([case["h"], case["middle"]]), case["l"])
        assert near == middle and (near == -1) == (case["below"] is None)
        # Also of bodies whose atlas must be proved, because doubles do not tell the order of their curves.
        found = atlas.body.classify(case["h"], case["l"])
        assert found.components == (atlas.regions[near].components if near >= 0 else ())
    assert len(told) > 1000


def test_equilibria_have_their_energies():
    for case in cases("cases/extremes.jsonl"):
        found = body(case).critical(case["l"])
        told = sorted(case["critical"], key=lambda point: float(point["h"]))
        assert len(found) == len(told)
        h = np.array([float(point["h"]) for point in told])
        scale = 1 + np.abs(h) + float(np.linalg.norm(np.array(case["r"], dtype=float)))
        assert (np.abs(found["h"] - h) <= 1e-12 * scale).all()


def test_equilibria_have_their_eigenvalues():
    compared = 0
    for case in cases("oracles/stability.jsonl"):
        found = body(case).critical(case["l"])
        for point in case["points"]:
            row = found[np.abs(found["h"] - float(point["h"])).argmin()]
            # Of a circle the transverse pair tells the type.
            assert row["stability"] == point["type"] or (row["multiplicity"] == "circle" and point["type"] == "zero")
            values = sorted((abs(float(re)), abs(float(im))) for re, im in point["eigenvalues"])
            own = sorted((value.real, value.imag) for value in row["eigenvalues"])
            assert np.allclose(own, values, atol=1e-8 + 2 * row["eigenvalue_error"], rtol=1e-8)
            compared += 1
    assert compared > 1000
