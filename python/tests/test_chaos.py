"""The chaotic share of energy surfaces."""

import json
import pickle
import signal
import threading
import time

import numpy as np
import pytest

import bifdiag

WINDOW = ((5, 6), (1, 2))


@pytest.fixture(scope="module")
def chart():
    return bifdiag.Body.preset("paper").chaos(window=WINDOW, cells=4, error=0.2)


def test_a_point_is_the_commands(command):
    theirs = json.loads(command("chaos", "--body=paper", "--h=3.8", "--l=3.25", "--error=0.15", "--json"))
    ours = bifdiag.Body.preset("paper").chaos("3.8", "3.25", error=0.15)
    assert (ours.h, ours.l, ours.region, ours.steps) == ("3.8", "3.25", "R5", theirs["steps"])
    assert len(ours.components) == len(theirs["components"]) == 2
    for share, document in zip(ours.components, theirs["components"], strict=True):
        assert {name: getattr(share, name) for name in document} == document
        assert 0 <= share.fraction <= share.fraction + share.open <= 1 and share.error <= 0.15


def test_a_map_is_the_commands(chart, command, tmp_path):
    line = ("chaos", "--body=paper", "--window=5:6,1:2", "--cells=4x4", "--error=0.2")
    command(*line, "--out", tmp_path / "theirs.npz")
    chart.save(tmp_path / "ours.npz")
    assert (tmp_path / "ours.npz").read_bytes() == (tmp_path / "theirs.npz").read_bytes()
    command(*line, "--out", tmp_path / "theirs.json")
    rows = json.loads((tmp_path / "theirs.json").read_text(encoding="utf-8"))["rows"]
    assert chart.id.tolist() == [row["region"] for row in rows]
    assert np.stack([chart.i, chart.j], axis=1).tolist() == [row["cell"] for row in rows]
    assert bifdiag.ChaosMap.load(tmp_path / "theirs.npz") == chart == pickle.loads(pickle.dumps(chart))


def test_threads_change_nothing(chart):
    assert chart == bifdiag.Body.preset("paper").chaos(
        window=np.array(WINDOW, dtype=float), cells=(4, 4), error=0.2, threads=2
    )


def test_a_map_keeps_regions_and_components_apart(chart):
    assert chart.shape == (4, 4) and chart.window == ((5.0, 6.0), (1.0, 2.0))
    h, l = chart.axes()
    assert h.tolist() == [5.125, 5.375, 5.625, 5.875] and np.allclose(l, h - 4)
    data = chart.to_xarray()
    assert data["fraction"].dims == ("region", "component", "h", "l")
    for row in range(len(chart)):
        found = data.sel(region=chart.id[row], component=chart.component[row], h=chart.h[row], l=chart.l[row])
        assert np.array_equal(float(found["fraction"]), chart.fraction[row], equal_nan=True)
        assert float(found["part"]) == chart.part[row]
    assert int(np.isfinite(data["part"]).sum()) == len(chart)
    grid = chart.grid()
    assert grid.shape == (4, 4) and np.isfinite(grid).all() and (chart.grid("orbits") > 0).all()
    assert chart.body == bifdiag.Body.preset("paper")
    assert len(chart.to_pandas()) == len(chart) and chart.meta["cells"] == [4, 4]


def test_without_a_window_it_is_that_of_the_diagram():
    body = bifdiag.Body.preset("lagrange")
    view = body.atlas().document["drawing"]["view"]["main"]
    chart = body.chaos(cells=2, error=0.3)
    assert chart.window == (tuple(view["h"]), tuple(view["l"]))
    known = chart.fraction[np.isfinite(chart.fraction)]
    assert known.size and (known == 0).all()


def test_wrong_questions_are_refused(paper):
    for options, told in [
        ({"h": 1}, "one of h and l is missing"),
        ({"h": 3.8, "l": 3.25, "cells": 3}, "those of a map"),
        ({"h": 0, "l": 3.25}, "forbidden"),
        ({"h": 3.8, "l": 3.25, "error": 1}, "standard deviation"),
        ({"cells": (2, 0)}, r"cells\[1\]"),
        ({"cells": (2, 2, 2)}, "two numbers"),
        ({"window": (1, 2)}, "window"),
        ({"h": 3.8, "l": 3.25, "steps": 1}, "steps"),
    ]:
        with pytest.raises(bifdiag.InputError, match=told):
            paper.chaos(**options)
    with pytest.raises(bifdiag.InputError, match="on the curve"):
        bifdiag.Body.preset("kovalevskaya").chaos(2, 2)


def test_it_stops_at_once(paper):
    # A job in the background of a shell ignores it.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        paper.chaos(cells=200, error=0.01)
    # Some cores of this machine have other work.
    assert time.monotonic() - begin < 20


def test_a_picture_shows_every_cell(chart):
    figure = pytest.importorskip("matplotlib.figure")
    from bifdiag.pictures.chaos import UNKNOWN, squares

    ax = figure.Figure().subplots()
    assert chart.plot(ax) is ax
    (image,) = ax.images
    assert image.get_extent() == [5, 6, 1, 2] and ax.get_xlim() == (5, 6)
    values = squares(chart, chart.body.atlas())
    assert values.shape == (48, 48)
    whole = np.flatnonzero((chart.part == 1) & (chart.component == 0))
    for row in whole:
        assert values[chart.i[row] * 12 + 3, chart.j[row] * 12] == chart.fraction[row]
    assert ((values <= 1) | (values == UNKNOWN) | np.isnan(values)).all()
    assert {line.get_gid() for line in ax.lines} <= set(chart.body.atlas().curves.ids)


def test_tables_of_a_map_name_the_regions(chart):
    pytest.importorskip("pandas")
    frame = chart.to_pandas()
    assert frame["region"].tolist() == chart.id.tolist() and frame["code"].tolist() == chart.region.tolist()
    some = chart[chart.part == 1]
    assert type(some) is bifdiag.ChaosMap and some.shape == chart.shape and (some.part == 1).all()
