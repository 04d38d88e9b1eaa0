"""Prints the figures of the installed package: ``python measure.py``, on a machine as quiet as it gets.

CPU time of one thread but for interrupts, which are waited for. Memory is watched over ``--calls`` bodies.
"""

import _thread
import argparse
import os
import random
import resource
import threading
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

import bifdiag

ROUNDS = 5


def best(work: Callable[[], object]) -> float:
    """The shortest CPU time of some rounds, in seconds."""

    def once() -> float:
        begin = time.process_time()
        work()
        return time.process_time() - begin

    return min(once() for _ in range(ROUNDS))


def waited(work: Callable[[], object]) -> float:
    """The seconds from Ctrl-C to the end of the work."""
    told = 0.0

    def press() -> None:
        nonlocal told
        told = time.perf_counter()
        _thread.interrupt_main()

    timer = threading.Timer(0.5, press)
    timer.start()
    try:
        work()
    except KeyboardInterrupt:
        return time.perf_counter() - told
    finally:
        timer.join()
    raise SystemExit("the work was over before it was interrupted")


def say(what: str, value: str) -> None:
    """One line."""
    print(f"{what:58} {value}", flush=True)


def arrays(atlas: bifdiag.Atlas) -> None:
    """Regions of many points."""
    h, l = np.linspace(-1, 9, 1000), np.linspace(0.01, 6, 1000)
    say("10^6 points of a grid", f"{best(lambda: atlas.region(h[:, None], l)):.3f} s (goal 0.15)")
    rng = np.random.default_rng(0)
    h, l = rng.uniform(-1, 9, 10**6), rng.uniform(0.01, 6, 10**6)
    say("a scattered point", f"{best(lambda: atlas.region(h, l)):.3f} µs (goal 0.5)")


def tables(paper: bifdiag.Body) -> None:
    """Equilibria at many momenta, types of many points."""
    l = np.linspace(0.01, 4, 10**4)
    say("equilibria at 10^4 momenta", f"{best(lambda: paper.critical(l)):.3f} s (goal 0.15)")
    say("with verdicts", f"{best(lambda: paper.critical(l).stable):.3f} s")
    rng = np.random.default_rng(0)
    h, l, atlas = rng.uniform(-1, 9, 10**5), rng.uniform(0.01, 6, 10**5), paper.atlas()
    say("a classified point of an array", f"{best(lambda: atlas.classify(h, l)) * 10:.3f} µs")


def scans(count: int) -> None:
    """Scans of own bodies, by a process of its own."""

    def children() -> float:
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime

    x, y, z = np.random.default_rng(1).uniform(0.05, 1, (3, count))
    moments = np.stack([y + z, z + x, x + y], axis=1)
    centers = np.random.default_rng(2).uniform(-1, 1, (count, 3))
    begin = children()
    bifdiag.scan(bodies=(moments, centers))
    say(f"a scan of {count} own bodies", f"{count / (children() - begin):.0f} a second (goal 5000)")


def pairs(count: int) -> None:
    """Atlases with regions in one thread and in two: by the clock, so on a machine that is quiet."""
    bodies = [bifdiag.Body([2 + number * 1e-6, 1.1, 1], [0.9, 0.1, 0.6]) for number in range(count)]

    def seconds(threads: int) -> float:
        def work(first: int) -> None:
            for body in bodies[first::threads]:
                len(body.atlas().regions)

        begin = time.perf_counter()
        running = [threading.Thread(target=work, args=(first,)) for first in range(threads)]
        for thread in running:
            thread.start()
        for thread in running:
            thread.join()
        return time.perf_counter() - begin

    best_of = {threads: min(seconds(threads) for _ in range(ROUNDS)) for threads in (1, 2)}
    say("atlases with regions, two threads over one", f"{best_of[1] / best_of[2]:.2f} times (goal 1.8)")


def bodies(count: int) -> None:
    """Atlases of bodies that exist."""
    draw = random.Random(1)
    numbers = []
    for _ in range(count):
        x, y, z = (0.05 + draw.random() for _ in range(3))
        numbers.append(([y + z, z + x, x + y], [2 * draw.random() - 1 for _ in range(3)]))
    begin = time.process_time()
    regions = 0
    for A, r in numbers:
        regions += bifdiag.Body(A, r).atlas().region(1, 1) >= 0
    seconds = time.process_time() - begin
    say(f"atlases of {count} random bodies, each asked for a point", f"{count / seconds:.0f} a second (goal 3000)")
    begin = time.process_time()
    for A, r in numbers[: count // 10]:
        regions += sum(region.bounded for region in bifdiag.Body(A, r).atlas().regions)
    seconds = time.process_time() - begin
    say(f"atlases of {count // 10} of them, with all records of regions", f"{count / 10 / seconds:.0f} a second")


def interrupts(paper: bifdiag.Body) -> None:
    """How soon work ends."""
    line = bifdiag.Body.preset("kovalevskaya").atlas()
    l = np.arange(1, 2_000_001) * 1e-6
    h = (l * l / 4 - 1).round(14)
    works = {
        "points on a curve": lambda: [line.region(h, l) for _ in range(100)],
        "a section": lambda: paper.section(3.8, 3.25, orbits=400, crossings=10**6),
        "a motion": lambda: paper.orbit([0.6, 0, 0.8], omega=[1, 0.3, 1], t=np.linspace(0, 1e6, 10**6)),
        "equilibria at many l": lambda: paper.critical(np.linspace(0.01, 4, 10**7)),
    }
    for name, work in works.items():
        say(
            f"Ctrl-C during {name}, the longest of {ROUNDS}", f"{max(waited(work) for _ in range(ROUNDS)):.3f} s (goal 0.2)"
        )


def memory(calls: int) -> None:
    """Whether the process grows."""

    def resident() -> int:
        return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def work(count: int) -> None:
        for number in range(count):
            atlas = bifdiag.Body([2 + number % 1000 * 1e-6, 1.1, 1], [0.9, 0.1, 0.6]).atlas()
            atlas.region(3.8, 3.25)
            atlas.classify("3.8", 3.25)
            if number % 100 == 0:
                len(atlas.regions), atlas.to_json()
                atlas.body.section(3.8, 3.25, orbits=1, crossings=10)

    work(2000)
    before = resident()
    work(calls)
    say(f"memory after {calls} bodies, atlases, answers", f"{(resident() - before) / 1000:+.0f} kB")


def main() -> None:
    """Prints all of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bodies", type=int, default=10**5)
    parser.add_argument("--calls", type=int, default=10**5)
    options = parser.parse_args()
    say("machine", f"{os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")
    paper = bifdiag.Body.preset("paper")
    arrays(paper.atlas())
    tables(paper)
    scans(options.bodies // 10)
    pairs(options.bodies // 20)
    bodies(options.bodies)
    interrupts(paper)
    memory(options.calls)


if __name__ == "__main__":
    main()
