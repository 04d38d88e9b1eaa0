"""What is recorded in data/, and what the program answers."""
import csv
import json
import os
import subprocess
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = os.environ.get("BIFDIAG", str(ROOT / "target/release/bifdiag"))


@cache
def rows(name):
    with open(ROOT / "data" / name, newline="", encoding="utf-8") as file:
        return tuple(csv.DictReader(file))


def text(name):
    return (ROOT / "data" / name).read_text(encoding="utf-8")


@cache
def document(name):
    return json.loads(text(name))


def total(table, column):
    return sum(int(row[column]) for row in table)


def run(*words, given=None):
    return subprocess.run([PROGRAM, *words], input=given, check=True, capture_output=True, text=True).stdout


@cache
def answer(*words):
    return json.loads(run(*words, "--json"))


@cache
def verified(*body):
    """What `verify` says about the certificate of a body: regions, events, pairs of curves."""
    certificate = run("atlas", *body, "--certificate", "--no-drawing", "--json")
    words = run("verify", "-", given=certificate).split()
    assert words[0] == "verified:", words
    return words[1], words[3], words[5]


def peer(work, column):
    return next(float(row[column]) for row in rows("benchmarks/peers.csv") if row["work"].startswith(work))


def criterion(benchmark):
    """The median in microseconds."""
    return next(float(row["median_ns"]) for row in rows("benchmarks/criterion.csv") if row["benchmark"] == benchmark) / 1e3


UNITS = ((1e6, "s"), (1e3, "ms"), (1, "µs"))


def rounded(microseconds, digits=2):
    """In the unit in which it is at least a half."""
    size, unit = next(((size, unit) for size, unit in UNITS if microseconds >= size / 2), UNITS[-1])
    return f"{float(f'{microseconds / size:.{digits}g}'):g} {unit}"
