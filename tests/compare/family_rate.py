#!/usr/bin/env python3
"""Members of families of periodic orbits in a second of processor time, beside hiten: family_rate.py RATE [--rounds N]

RATE is the program of `cargo run --release --example rate`, which follows families of heavy tops. hiten continues a family of the
restricted three-body problem, its own domain, as its documentation does: halo orbits about L1 of Earth and Moon, with its steps and
tolerances. The two take turns; hiten is compiled before, and time for that does not count. A member of hiten is corrected to a
residual of 1e-12 after half a period; one of ours to 1e-13 along a whole one, with its multipliers, and events along the family are
located. Needs hiten.
"""
import argparse
import os
import re
import statistics
import subprocess
import time

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

import importlib.metadata
import logging

from hiten import System
from hiten.algorithms.continuation.options import OrbitContinuationOptions
from hiten.algorithms.types.states import SynodicState

MEMBERS = 100


def continued():
    """Members of the family and the processor time of their continuation, without that of the first orbit."""
    point = System.from_bodies("earth", "moon").get_libration_point(1)
    orbit = point.create_orbit("halo", amplitude_z=0.2, zenith="southern")
    orbit.correct()
    z = orbit.initial_state[SynodicState.Z]
    options = OrbitContinuationOptions(target=([z], [z + 2.0]), step=0.02, max_members=MEMBERS)
    begun = time.process_time()
    found = orbit.generate(options)
    return found, time.process_time() - begun


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rate")
    parser.add_argument("--rounds", type=int, default=5)
    arguments = parser.parse_args()
    logging.disable(logging.WARNING)
    first, used = continued()
    print(f"hiten {importlib.metadata.version('hiten')}: {first.accepted_count} halo orbits, {first.rejected_count} tries more, "
          f"{used:.1f} s with its compilation", flush=True)
    ours, theirs = [], []
    for _ in range(arguments.rounds):
        line = subprocess.run([arguments.rate], check=True, capture_output=True, text=True).stdout
        ours.append(float(re.search(r"(\d+) members a second", line)[1]))
        found, used = continued()
        theirs.append(found.accepted_count / used)
        print(f"bifdiag {ours[-1]:.0f} members a second, hiten {theirs[-1]:.1f} ({found.accepted_count} in {used:.2f} s)", flush=True)
    middle, other = statistics.median(ours), statistics.median(theirs)
    print(f"medians: bifdiag {middle:.0f}, hiten {other:.1f}: {middle / other:.0f} times as many")


if __name__ == "__main__":
    main()
