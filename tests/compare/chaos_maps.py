"""What maps of chaos must show, and what they found: python3 chaos_maps.py PROGRAM TASK [--cells N] [--error E] [--keep DIR]

integrable  0 chaotic orbits over the diagrams of Lagrange's, Euler's and Kovalevskaya's tops, and of Goryachev-Chaplygin's at l = 0
perturbed   the same tops with moments and center moved by 1e-4, 1e-3 and 1e-2: how much becomes chaotic
doubled     the paper's body with twice the steps: no cell moves by more than three standard errors and the open share
katok       the seven Katok bodies and the paper's: how much is chaotic, and where it begins beside the unstable equilibria
path        from Kovalevskaya's top to the paper's body; with --keep, one figure of the maps is written there

Maps are kept in --keep and not made again. It needs only the standard library.
"""
import argparse
import json
import math
import re
import pathlib
import subprocess
import sys
import tempfile

ORBITS = 3000
WINDOW = "-2:12,0:6"
PAPER = ("2,1.1,1", "0.94868,0,0.61623")
INTEGRABLE = {
    "Lagrange": ((1.5, 1, 1), (1, 0, 0)),
    "Euler": ((2, 1.5, 1), (0, 0, 0)),
    "Kovalevskaya": ((2, 2, 1), (1, 0, 0)),
}
KATOK = {
    "katok:1": ("1,1.6,1.3", "1,0,0"),
    "katok:2": ("1,1.4,0.875", "1,0,0"),
    "katok:3": ("1,1.3,0.5", "1,0,0"),
    "katok:4": ("1,0.925,0.825", "1,0,0"),
    "katok:5": ("1,0.875,0.5", "1,0,0"),
    "katok:6": ("1,0.7,0.5", "1,0,0"),
    "katok:7": ("1,0.55,0.52", "1,0,0"),
    "paper": PAPER,
}
PATH = (0, 0.001, 0.01, 0.1, 0.3, 1)


class Maps:
    def __init__(self, options, directory):
        self.program, self.cells, self.error = options.program, options.cells, options.error
        self.directory = pathlib.Path(directory)

    def run(self, *arguments):
        return subprocess.run([self.program, *arguments, "--threads", "1"], capture_output=True, text=True)

    def map(self, name, body, steps=20480, window=WINDOW):
        """The document of a map, which is made once."""
        file = self.directory / f"{name}-{self.cells}-{self.error}-{steps}.json"
        if not file.exists():
            done = self.run("chaos", "--A", body[0], "--r", body[1], f"--window={window}", "--cells", f"{self.cells}x{self.cells}",
                            "--error", str(self.error), "--steps", str(steps), "-q", "--out", str(file))
            if done.returncode != 0:
                sys.exit(f"{name}: {done.stderr}")
        return file, json.loads(file.read_text())


def text(numbers):
    return ",".join(str(number) for number in numbers)


def orbits(document):
    """Orbits, chaotic ones and open ones: the cells of a block have the same."""
    blocks = {}
    for row in document["rows"]:
        side = row["block"]
        blocks[row["cell"][0] // side, row["cell"][1] // side, side, row["region"], row["component"]] = row
    counts = [0, 0, 0]
    for row in blocks.values():
        if row["orbits"]:
            part = row["orbits"], row["fraction"] * row["orbits"], row["open"] * row["orbits"]
            counts = [count + round(more) for count, more in zip(counts, part)]
    return counts


def known(document):
    return [row for row in document["rows"] if row["orbits"]]


def mean(document, name="fraction"):
    """The mean over the accessible part of the window and the components there."""
    components = {}
    for row in known(document):
        key = (*row["cell"], row["region"])
        components[key] = components.get(key, 0) + 1
    weight = lambda row: row["part"] / components[(*row["cell"], row["region"])]
    rows = known(document)
    return sum(weight(row) * row[name] for row in rows) / sum(map(weight, rows))


def integrable(maps):
    total = [0, 0, 0]
    for name, body in INTEGRABLE.items():
        counts = orbits(maps.map(name, tuple(map(text, body)))[1])
        total = [a + b for a, b in zip(total, counts)]
        print(f"{name}: {counts[0]} orbits, {counts[1]} chaotic, {counts[2]} open", flush=True)
    counts = [0, 0, 0]
    for k in range(1, 9):
        h = round(-1 + 0.61 * k, 2)
        done = maps.run("chaos", "--body", "goryachev-chaplygin", f"--h={h}", "--l", "0", "--error", str(1 / ORBITS), "--json")
        for share in json.loads(done.stdout)["components"]:
            part = share["orbits"], share["fraction"] * share["orbits"], share["open"] * share["orbits"]
            counts = [count + round(more) for count, more in zip(counts, part)]
    print(f"Goryachev-Chaplygin, l = 0: {counts[0]} orbits, {counts[1]} chaotic, {counts[2]} open")
    total = [a + b for a, b in zip(total, counts)]
    print(f"together: {total[0]} orbits, {total[1]} chaotic, {total[2]} open")
    return total[1] == 0


def perturbed(maps):
    for name, (moments, center) in INTEGRABLE.items():
        for size in (1e-4, 1e-3, 1e-2):
            a = text(round(x * (1 + size * s), 9) for x, s in zip(moments, (0.31, -0.57, 0.83)))
            r = text(round(x + size * s, 9) for x, s in zip(center, (0.37, 0.61, -0.49)))
            document = maps.map(f"{name}-{size}", (a, r))[1]
            counts, most = orbits(document), max(known(document), key=lambda row: row["fraction"])
            print(f"{name}, moved by {size:g}: chaotic {100 * mean(document):.3f} % + {100 * mean(document, 'open'):.3f} % open, "
                  f"{counts[1]} of {counts[0]} orbits; most {most['fraction']:.3f} at ({most['h']:.2f}, {most['l']:.2f})", flush=True)
    return True


def doubled(maps):
    once, twice = (maps.map("paper", PAPER, steps)[1] for steps in (20480, 40960))
    of = lambda document: {(*row["cell"], row["region"], row["component"]): row for row in known(document)}
    first, second = of(once), of(twice)
    beyond, worst = 0, 0.0
    for key in first.keys() & second.keys():
        a, b = first[key], second[key]
        error = math.hypot(a["error"], b["error"])
        distance = max(b["fraction"] - a["fraction"] - a["open"], a["fraction"] - b["fraction"] - b["open"], 0.0) / error
        worst, beyond = max(worst, distance), beyond + (distance > 3)
    print(f"{len(first.keys() & second.keys())} rows, beyond three standard errors and the open share: {beyond}, the farthest {worst:.2f}")
    for document in (once, twice):
        print(f"{document['steps']} steps: chaotic {100 * mean(document):.2f} %, open {100 * mean(document, 'open'):.2f} %")
    return beyond == 0


def onsets(maps, body, document, least=0.05):
    """For each row of cells: the lowest h with a share of at least this, above the lowest unstable equilibrium at that l."""
    found = []
    for l in sorted({row["l"] for row in known(document)}):
        chaotic = [row["h"] for row in known(document) if row["l"] == l and row["fraction"] >= least]
        answer = json.loads(maps.run("critical", "--A", body[0], "--r", body[1], f"--l={l}", "--json").stdout)
        unstable = [point["h"] for point in answer["critical"] if point["stable"] is False]
        if chaotic and unstable:
            found.append(min(chaotic) - min(unstable))
        elif chaotic:
            found.append(math.nan)
    return found


def katok(maps):
    for name, body in KATOK.items():
        document = maps.map(name, body)[1]
        most = max(known(document), key=lambda row: row["fraction"])
        above = onsets(maps, body, document)
        with_both = sorted(x for x in above if x == x)
        middle = with_both[len(with_both) // 2] if with_both else math.nan
        cell = (document["window"]["h"][1] - document["window"]["h"][0]) / document["cells"][0]
        print(f"{name}: chaotic {100 * mean(document):.1f} % + {100 * mean(document, 'open'):.1f} % open, most {most['fraction']:.2f} at "
              f"({most['h']:.2f}, {most['l']:.2f}); chaos begins at {len(above)} of {len({row['l'] for row in document['rows']})} momenta, "
              f"above the lowest unstable equilibrium by {with_both[0] if with_both else math.nan:+.2f} to "
              f"{with_both[-1] if with_both else math.nan:+.2f}, the middle {middle:+.2f} (a cell: {cell:.2f}), without one {len(above) - len(with_both)}",
              flush=True)
    return True


def path(maps):
    pictures = []
    for t in PATH:
        body = text((2, round(2 - 0.9 * t, 9), 1)), text((round(1 - 0.05132 * t, 9), 0, round(0.61623 * t, 9)))
        file, document = maps.map(f"path-{t}", body)
        most = max(known(document), key=lambda row: row["fraction"])
        print(f"t = {t:g}: chaotic {100 * mean(document):.2f} % + {100 * mean(document, 'open'):.2f} % open, most {most['fraction']:.2f} at "
              f"({most['h']:.2f}, {most['l']:.2f})", flush=True)
        folder = maps.directory / f"picture-{t}"
        drawn = maps.run("chaos", "map", str(file), "--out", str(folder))
        if drawn.returncode != 0:
            sys.exit(drawn.stderr)
        pictures.append((folder / "chaos.svg").read_text())
    figure(pictures, maps.directory / "chaos-path.svg")
    return True


def figure(pictures, file):
    """The pictures side by side, three in a row."""
    sizes = [[float(x) for x in picture.split('viewBox="')[1].split('"')[0].split()[2:]] for picture in pictures]
    width = max(w for w, _ in sizes)
    parts, below = [], 0.0
    for row in range(0, len(pictures), 3):
        for place, (picture, (w, h)) in enumerate(zip(pictures[row:row + 3], sizes[row:row + 3])):
            # Millimetres would be those of a page of its own.
            inner = re.sub(r'width="[^"]*" height="[^"]*"', f'width="{w:g}" height="{h:g}"', picture[picture.index("<svg"):], count=1)
            parts.append(f'<g transform="translate({place * width:g} {below:g})">{inner}</g>')
        below += max(h for _, h in sizes[row:row + 3])
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {3 * width:g} {below:g}" width="{3 * width / 20:g}" height="{below / 20:g}">'
    file.write_text("\n".join([head, *parts, "</svg>"]) + "\n")
    print(f"written: {file.name}")


TASKS = {"integrable": integrable, "perturbed": perturbed, "doubled": doubled, "katok": katok, "path": path}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("task", choices=TASKS)
    parser.add_argument("--cells", type=int, default=32)
    parser.add_argument("--error", type=float, default=0.06)
    parser.add_argument("--keep")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        directory = options.keep or temporary
        pathlib.Path(directory).mkdir(parents=True, exist_ok=True)
        sys.exit(not TASKS[options.task](Maps(options, directory)))


if __name__ == "__main__":
    main()
