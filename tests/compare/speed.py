"""CPU time of two programs, file to file, on one thread: python3 tests/compare/speed.py OLD NEW > tests/compare/speed.txt

Each task runs three times with each program in turn, and the least user and system time counts; what the program needs for an
empty task of the same kind is taken off (of a grid nothing). A dash: the program has no such question.
"""
import json
import os
import random
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

ROUNDS = 3
PAPER = ["--A", "2,1.1,1", "--r", "0.94868,0,0.61623"]


def bodies(count, generator):
    for _ in range(count):
        a = [f"{generator.uniform(0.5, 2):.6f}" for _ in range(3)]
        r = [f"{generator.uniform(-1, 1):.6f}" for _ in range(3)]
        yield {"A": a, "r": r}


def point(generator):
    return {"h": f"{generator.uniform(-1, 6):.6f}", "l": f"{generator.uniform(0.01, 4):.6f}"}


def lines(path, rows):
    path.write_text("".join(json.dumps(row) + "\n" for row in rows))
    return str(path)


def seconds(program, words, place):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(place / "out", "wb") as out:
        done = subprocess.run([program, *words], stdout=out, stderr=subprocess.PIPE, cwd=place)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        return None
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def tasks(place):
    """Name, words of the old program (None: has no such question), of the new one, the same with nothing to do, parts, goal."""
    generator = random.Random(18)
    one = lines(place / "one.jsonl", (point(generator) for _ in range(100_000)))
    mixed = lines(place / "mixed.jsonl", ({**body, **point(generator)} for body in bodies(5_000, generator)))
    momenta = lines(place / "momenta.jsonl", ({**body, "l": point(generator)["l"]} for body in bodies(5_000, generator)))
    single = lines(place / "single.jsonl", ({"l": point(generator)["l"]} for _ in range(20_000)))
    empty = lines(place / "empty.jsonl", [])
    batch = lambda command, path, *more: [command, *more, "--batch", path, "--threads", "1"]
    grid = lambda n, file: ["classify", *PAPER, "--grid", f"-1:6:{n},0:4:{n}", "--out", file, "--threads", "1"]
    momentum = lambda n: ["critical", *PAPER, "--l", f"0.01:4:{n}", "--out", "l.npz", "--threads", "1"]
    yield ("classify --batch, one body, a line", batch("classify", one, *PAPER), batch("classify", one, *PAPER),
           batch("classify", empty, *PAPER), 100_000, 5e-6)
    yield ("classify --batch --no-region, many bodies, a line", batch("classify", mixed), batch("classify", mixed, "--no-region"),
           batch("classify", empty), 5_000, "old")
    yield ("critical --batch, many bodies, a line", batch("critical", momenta), batch("critical", momenta),
           batch("critical", empty), 5_000, None)
    yield ("critical --batch, one body, a line", batch("critical", single, *PAPER), batch("critical", single, *PAPER),
           batch("critical", empty, *PAPER), 20_000, None)
    yield ("critical --l a:b:n to NPZ, one l", None, momentum(20_001), momentum(2), 19_999, 5e-6)
    yield ("classify --grid 200 x 200 to NPZ", None, grid(200, "g.npz"), ["--version"], 1, 0.04)
    yield ("classify --grid 200 x 200 to PNG", None, grid(200, "g.png"), ["--version"], 1, 0.04)
    yield ("classify --grid 2000 x 2000 to NPZ", None, grid(2000, "g.npz"), ["--version"], 1, 1.0)
    yield ("classify --grid 2000 x 2000 to PNG", None, grid(2000, "g.png"), ["--version"], 1, 1.0)


def shown(time):
    if time is None:
        return "-"
    unit, factor = next((unit for unit in (("s", 1), ("ms", 1e3)) if time * unit[1] >= 1), ("µs", 1e6))
    return f"{time * factor:.3g} {unit}"


def main():
    old, new = (os.path.abspath(path) for path in sys.argv[1:3])
    print(f"{'task':52} {'old':>9} {'new':>9} {'goal':>9}")
    missed = False
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        for name, words_old, words_new, nothing, parts, goal in tasks(place):
            runs = {(program, words): [] for program in ("old", "new") for words in ("task", "nothing")}
            for _ in range(ROUNDS):
                for program, path, words in (("old", old, words_old), ("new", new, words_new)):
                    if words is not None:
                        runs[program, "task"].append(seconds(path, words, place))
                        runs[program, "nothing"].append(seconds(path, nothing, place))
            least = {key: min(times) if times and None not in times else None for key, times in runs.items()}
            cost = {}
            for program in ("old", "new"):
                whole, start = least[program, "task"], least[program, "nothing"]
                cost[program] = None if whole is None or start is None else max(whole - start, 0.0) / parts
            wanted = cost["old"] if goal == "old" else goal
            late = wanted is not None and cost["new"] is not None and cost["new"] > wanted
            missed |= late
            mark = "  MISSED" if late else ""
            print(f"{name:52} {shown(cost['old']):>9} {shown(cost['new']):>9} {shown(wanted):>9}{mark}", flush=True)
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
