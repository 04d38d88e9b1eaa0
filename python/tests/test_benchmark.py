"""The heavy-top benchmark."""

import importlib.util
import json
import math
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import bifdiag
from bifdiag import benchmark

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "examples" / "heavy-top-benchmark"
PAGE = Path(__file__).parents[1] / "docs" / "benchmark.rst"


@pytest.fixture(scope="module")
def simulate():
    """The engine of the page."""
    text = PAGE.read_text(encoding="utf-8")
    lines = re.findall(r"^(?:>>>|\.\.\.) ?(.*)$", text, re.M)
    end = next(k for k, line in enumerate(lines) if line.startswith("from bifdiag"))
    names: dict = {}
    exec("\n".join(lines[:end]), names)
    return names["simulate"]


def test_the_tops_are_those_of_the_example():
    files = sorted(path.stem for path in (EXAMPLE / "models").glob("*.json"))
    assert sorted(map(str, benchmark.tops())) == files and len(files) == 24
    for name in files:
        theirs = json.loads((EXAMPLE / "models" / f"{name}.json").read_text(encoding="utf-8"))
        assert benchmark.top(name).model == theirs
    with pytest.raises(bifdiag.InputError, match="the tops are euler-flip, "):
        benchmark.top("spinning")


@pytest.mark.parametrize("top", benchmark.tops(), ids=str)
def test_the_truth_is_that_of_the_example(top):
    theirs = json.loads((EXAMPLE / "truth" / f"{top}.json").read_text(encoding="utf-8"))
    ours = benchmark.truth(top)
    assert ours.times.tolist() == theirs["times"] and ours.bound <= 1e-12
    # Numbers of a hundred digits are read as doubles.
    reading = 1e-15 * max(1.0, np.abs(ours.omega).max())
    for name in ("q", "omega"):
        values = np.array([[float(x) for x in row] for row in theirs[name]])
        assert np.abs(getattr(ours, name) - values).max() <= ours.bound + theirs["bound"] + reading


def test_the_scores_are_those_of_the_example(simulate):
    spec = importlib.util.spec_from_file_location("heavytop", EXAMPLE / "heavytop.py")
    heavytop = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(heavytop)
    for name in ("lagrange-nodding", "euler-tumble"):
        theirs = heavytop.score(simulate, name, 1e-2, most=10)
        ours = benchmark.score(simulate, benchmark.top(name), 1e-2, most=10)
        for key in ("angle", "omega", "energy", "momentum", "length"):
            assert getattr(ours, key) == pytest.approx(theirs[key], rel=1e-3, abs=1e-13)


def test_planted_mistakes_are_named():
    """All twenty are flagged, at least fifteen by their name; nothing is found in the engine without one."""
    run = subprocess.run([sys.executable, str(EXAMPLE / "toy.py")], capture_output=True, text=True, check=False)
    lines = run.stdout.splitlines()
    found = re.fullmatch(r"(\d+) of 20 named, 20 flagged", lines[-1])
    assert run.returncode == 0 and found and int(found[1]) >= 15, run.stdout
    assert lines[0].startswith("named    planted: nothing; found: nothing") and len(lines) == 22


def test_wrong_engines_are_told(simulate):
    top = benchmark.top("ball")

    def lost(model, q0, omega0, times, step):
        return [([math.nan] * 4, omega0) for _ in times]

    score = benchmark.score(lost, top, 0.1)
    assert score.angle == math.pi and score.energy == math.inf
    with pytest.raises(bifdiag.InputError, match="201 times"):
        benchmark.score(lambda *_: [], top, 0.1)


def test_ten_lines_test_an_engine(simulate, tmp_path):
    text = PAGE.read_text(encoding="utf-8")
    block = re.search(r"code-block:: python\n\n((?:   .*\n|\n)+)", text)
    lines = [line.removeprefix("   ") for line in block[1].splitlines()]
    assert sum(bool(line.strip()) for line in lines) <= 10
    (tmp_path / "test_engine.py").write_text("\n".join(lines), encoding="utf-8")
    page = re.findall(r"^(?:>>>|\.\.\.) ?(.*)$", text, re.M)
    end = next(k for k, line in enumerate(page) if line.startswith("from bifdiag"))
    (tmp_path / "my_engine.py").write_text("\n".join(page[:end]), encoding="utf-8")
    line = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "test_engine.py", "-k"]
    run = lambda names: subprocess.run([*line, names], cwd=tmp_path, capture_output=True, text=True, check=False)  # noqa: E731
    right = run("rod-still")
    assert right.returncode == 0 and "1 passed" in right.stdout, right.stdout
