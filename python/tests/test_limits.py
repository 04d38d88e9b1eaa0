"""What a long-running process needs: interrupts, memory, the lock of the interpreter, speed."""

import _thread
import resource
import signal
import threading
import time

import numpy as np
import pytest

import bifdiag


def interrupted(work):
    """The seconds from Ctrl-C to the end of the work."""
    # A shell that starts a process in the background has it ignore Ctrl-C.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    told = []

    def press():
        told.append(time.perf_counter())
        _thread.interrupt_main()

    timer = threading.Timer(0.4, press)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            work()
    finally:
        timer.join()
        signal.signal(signal.SIGINT, before)
    return time.perf_counter() - told[0]


def test_ctrl_c_ends_the_work(atlas, paper):
    # Points on a curve are decided exactly, one after the other, which takes long.
    on_the_line = bifdiag.Body.preset("kovalevskaya").atlas()
    l = np.arange(1, 2_000_001) * 1e-6
    h = (l * l / 4 - 1).round(14)
    assert interrupted(lambda: [on_the_line.region(h, l) for _ in range(100)]) < 0.5
    assert interrupted(lambda: paper.section(3.8, 3.25, orbits=400, crossings=10**6)) < 0.5
    assert interrupted(lambda: paper.orbit([0.6, 0, 0.8], omega=[1, 0.3, 1], t=np.linspace(0, 1e6, 10**6))) < 0.5


def _points(count):
    rng = np.random.default_rng(0)
    return rng.uniform(0, 9, count), rng.uniform(0, 6, count)


@pytest.mark.parametrize(
    "work",
    [
        lambda body: body.atlas().region(*_points(2_000_000)),
        lambda body: body.atlas().margin(*_points(300_000)),
        lambda body: body.critical(np.linspace(0.01, 4, 4000)).stable,
        lambda body: [body.atlas(certificate=True) for _ in range(20)],
    ],
    ids=["regions", "margins", "equilibria", "proofs"],
)
def test_other_threads_go_on(paper, work):
    over, counted = threading.Event(), []

    def count():
        turns = 0
        while not over.is_set():
            time.sleep(0.001)
            turns += 1
        counted.append(turns)

    counter = threading.Thread(target=count)
    counter.start()
    begin = time.perf_counter()
    work(paper)
    seconds = time.perf_counter() - begin
    over.set()
    counter.join()
    # A counter that had to wait for the lock would count once or twice.
    assert counted[0] > 20 * seconds


def test_memory_does_not_grow(paper):
    def work(calls):
        for number in range(calls):
            atlas = bifdiag.Body([2 + number * 1e-6, 1.1, 1], [0.9, 0.1, 0.6]).atlas()
            assert atlas.region(3.8, 3.25) >= -1
            if number % 100 == 0:
                assert len(atlas.regions) > 2 and atlas.to_json()
                paper.section(3.8, 3.25, orbits=1, crossings=10)

    work(2000)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    work(6000)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 4000  # kB


def test_grids_are_quick(atlas):
    h, l = np.linspace(-1, 9, 500), np.linspace(0.01, 6, 500)
    best = min(_seconds(lambda: atlas.region(h[:, None], l)) for _ in range(3))
    # Ten times what it takes on one core of the machine it was measured on.
    assert best / 250_000 < 1e-6


def _seconds(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin
