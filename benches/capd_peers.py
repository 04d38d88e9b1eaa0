#!/usr/bin/env python3
"""Sets `bifdiag orbit --proved` beside CAPD: how wide enclosures are, how far they reach and what they cost, in doubles.

    python3 benches/capd_peers.py --build DIR [--program bifdiag]

Fetches the sources that PyPI's uj-capdpy 0.5.1 holds (there is no wheel), compiles what `capd_peer.cpp` needs of them in
DIR (two to five minutes; g++ only), and follows the same motions with both: the four regular orbits of the paper's body of
data/oracles/orbit_reference.csv and a chaotic one of the body `ten`. CAPD encloses gamma and omega, six numbers; bifdiag
the quaternion and omega, seven, and gamma from them; widths are those of gamma and omega. For each motion CAPD runs with
four settings; the narrowest at time 100 and the one that reaches furthest with 0.01 are recorded, with their times.

Writes data/benchmarks/capd.csv and prints it as a table in Markdown.
"""
import argparse
import csv
import json
import pathlib
import resource
import subprocess
import sys
import tarfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
VERSION = "0.5.1"
PARTS = """capdAlg/src/capd/basicalg/* capdAlg/src/capd/intervals/* capdAlg/src/capd/rounding/*
capdAlg/src/capd/vectalg/Container capdAlg/src/capd/vectalg/[DI]Matrix capdAlg/src/capd/vectalg/[DI]Vector
capdAlg/src/capd/vectalg/Multiindex capdAlg/src/capd/vectalg/Norm capdAlg/src/capd/matrixAlgorithms/float*
capdDynSys/src/capd/autodiff/* capdDynSys/src/capd/map/* capdDynSys/src/capd/diffAlgebra/*
capdDynSys/src/capd/dynset/C0* capdDynSys/src/capd/dynset/C1[ADH]* capdDynSys/src/capd/dynset/CoordR*
capdDynSys/src/capd/dynset/FactorR* capdDynSys/src/capd/dynsys/[CDO]* capdDynSys/src/capd/geomset/*
capdDynSys/src/capd/poincare/*""".split()
SETTINGS = [(20, "1e-16", "doubleton"), (20, "1e-16", "tripleton"), (30, "1e-16", "doubleton"), (30, "1e-16", "tripleton")]
TEN = ("0.57847392 0.53739099 1 0.00595273 0.00176367 -0.99998073 0 0.1 1 0.173542176 0.107478198 0.5").split()
FAR = "2000"


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def build(folder):
    """The peer program; objects that are there are taken as they are."""
    folder.mkdir(parents=True, exist_ok=True)
    if not list(folder.glob("uj_capdpy*")):
        run(sys.executable, "-m", "pip", "download", "--no-deps", f"uj-capdpy=={VERSION}", "-d", folder)
        with tarfile.open(next(folder.glob("uj_capdpy*.tar.gz"))) as archive:
            archive.extractall(folder, filter="data")
    capd = folder / f"uj_capdpy-{VERSION}" / "lib" / "CAPD"
    flags = ["-std=c++17", "-O2", "-frounding-math", "-D__USE_NATIVE__", "-w"]
    flags += [f"-I{capd / part / 'include'}" for part in ("capdAux", "capdAlg", "capdDynSys", "capdExt")]
    sources = sorted({path for part in PARTS for path in capd.glob(part + ".cpp")})
    objects = []
    for source in [*sources, HERE / "capd_peer.cpp"]:
        target = folder / (source.parent.name + "_" + source.stem + ".o")
        if not target.exists():
            subprocess.run(["g++", *flags, "-c", source, "-o", target], check=True)
        objects.append(target)
    program = folder / "capd_peer"
    subprocess.run(["g++", *objects, "-o", program], check=True)
    return program


def capd(program, motion, time, bound, setting):
    order, tolerance, kind = setting
    answer = run(program, *motion, time, str(order), tolerance, kind, bound).split()
    return [float(x) for x in answer]


def ours(program, motion, time, bound):
    """The last time that is proved, the width there, steps, CPU seconds of the whole process."""
    a, r, gamma, momentum = (",".join(motion[k:k + 3]) for k in (0, 3, 6, 9))
    command = [program, "orbit", "--A", a, "--r", r, "--gamma", gamma, "--l-vector", momentum,
               "--times", f"{time}:{time}:1", "--proved", "--digits", "15", "--bound", bound, "--json", "--quiet"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    answer = json.loads(subprocess.run(command, capture_output=True, text=True, check=False).stdout)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    width = 0.0
    for name in ("gamma", "omega"):
        for row in answer["enclosures"][name]:
            width = max([width, *(float(hi) - float(lo) for lo, hi in row)])
    return [answer["proved_to"], width, answer["steps"], seconds]


def motions():
    with open(ROOT / "data" / "oracles" / "orbit_reference.csv", newline="") as file:
        regular = [row for row in csv.DictReader(file) if row["h"] == "2.6"]
    for number, row in enumerate(regular, 1):
        start = [row[f"start_{name}_{i}"] for name in ("gamma", "l") for i in (1, 2, 3)]
        yield f"regular {number}", ["2", "1.1", "1", "0.94868", "0", "0.61623", *start]
    yield "chaotic", TEN


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--build", type=pathlib.Path, required=True)
    options.add_argument("--program", default=str(ROOT / "target" / "release" / "bifdiag"))
    options = options.parse_args()
    peer = build(options.build)
    rows = []
    for name, motion in motions():
        row = {"motion": name}
        near = [capd(peer, motion, "100", "0.01", setting) for setting in SETTINGS]
        far = [capd(peer, motion, FAR, "0.01", setting) for setting in SETTINGS]
        for program, at, reach in (("capd", min(near, key=lambda run: (-run[0], run[1])), max(far)),
                                   ("bifdiag", ours(options.program, motion, "100", "0.01"),
                                    ours(options.program, motion, FAR, "0.01"))):
            row |= {f"{program}_width_100": f"{at[1]:.2g}", f"{program}_seconds_100": f"{at[3]:.3f}",
                    f"{program}_steps_100": int(at[2]), f"{program}_reach": f"{reach[0]:.5g}",
                    f"{program}_seconds_reach": f"{reach[3]:.3f}"}
        rows.append(row)
    with open(ROOT / "data" / "benchmarks" / "capd.csv", "w", newline="") as file:
        table = csv.DictWriter(file, rows[0], lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    print("| motion | width at 100, CAPD | bifdiag | s, CAPD | bifdiag | 0.01 reached at, CAPD | bifdiag |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    for row in rows:
        fields = ("width_100", "seconds_100", "reach")
        cells = [row[f"{program}_{field}"] for field in fields for program in ("capd", "bifdiag")]
        print(f"| {row['motion']} | {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
