"""What both programs are asked, stratum by stratum."""

import shlex
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

import points
import strata

HERE = Path(__file__).parent
CHUNK = 100  # lines of a batch
PROVABLE = ("generic", "plane", "axis", "Lagrange", "impossible", "Katok", "paper, ten", "rational")


@dataclass
class Task:
    """Commands for an empty directory; the last one's answer is compared."""

    stratum: str
    kind: str
    command: list
    lines: list = field(default_factory=list)  # of a batch on stdin, one case each
    before: list = field(default_factory=list)  # commands that come first
    files: list = field(default_factory=list)  # what is written, compared too


def of_body(body):
    return [f"--A={','.join(body[0])}", f"--r={','.join(body[1])}"]


def batches(stratum, kind, command, lines):
    for start in range(0, len(lines), CHUNK):
        yield Task(stratum, kind, [*command, "--batch", "-"], lines[start : start + CHUNK])


def of_stratum(old, seed, name, count):
    """Tasks of one stratum: a momentum and two energies for each body, atlases for half of them."""
    bodies, rng = strata.bodies(seed, name, count), strata.generator(seed, f"{name}/points")
    momenta = [points.momentum(rng, body) for body in bodies]
    lines = [points.line(rng, *body, l=l) for body, l in zip(bodies, momenta)]
    answers = points.ask(old, ["critical"], lines)
    tasks = list(batches(name, "critical", ["critical"], lines))
    asked = []
    for body, l, answer in zip(bodies, momenta, answers):
        for h in points.energies(rng, body, l, answer):
            asked.append(points.line(rng, *body, h=h, l=l))
        exact = points.on_a_pole_line(rng, body, l) if name == "rational" else None
        if exact is not None:
            asked.append(points.line(rng, *body, h=exact, l=l))
    for body in bodies[: count // 10]:
        asked += [points.line(rng, *body, h=h, l=l) for h, l in points.near_events(rng, old, body)]
    tasks += batches(name, "classify", ["classify"], asked)
    if name in PROVABLE:
        # The first of the two energies, among the curves.
        proved = asked[:20:2] if name != "rational" else asked[:10]
        tasks += batches(name, "classify proved", ["classify"], proved)
        tasks += [certificate(name, body) for body in bodies[8:12]]
    tasks += [atlas(name, body) for body in bodies[: count // 2]]
    if name != "scales":  # a window far beyond the body's own scale
        tasks += [atlas(name, body, "--window", "0:3,0.5:2") for body in bodies[:12]]
    tasks += motions(name, rng, bodies[:100], momenta, answers)
    return tasks


def atlas(stratum, body, *options):
    return Task(stratum, "atlas " + " ".join(options[1:2]), [*of_body(body), "--json", *options])


def certificate(stratum, body):
    """Each program's verifier on its own proof."""
    make = [*of_body(body), "--certificate", "--out", "proof", "--no-plot"]
    return Task(stratum, "verify", ["verify", "proof/atlas.json"], before=[make])


SECTIONS = (
    "--data crossings.csv",
    "--data crossings.npz --color lyapunov",
    "--tol 1e-12 --data crossings.jsonl",
    "--condition angular-momentum --data crossings.csv --tol 1e-9",
    "--color rotation --max-time 60",
    "--tol 1e-15 --seed 7",
)
ORBITS = ("--times 0:5:6", "--times -3:3:4 --tol 1e-12", "--times 0:2:3 --data motion.npz")


def motions(stratum, rng, bodies, momenta, answers):
    """A few sections and orbits of the bodies of everyday size."""
    usable = []
    for body, l, answer in zip(bodies, momenta, answers):
        heights = [entry["h"] for entry in answer.get("critical", [])]
        r = points.length(points.floats(body)[1])
        if heights and 1e-3 < r < 1e3 and abs(float(Fraction(l))) < 20 and max(map(abs, heights)) < 1e3:
            usable.append((body, l, max(heights) + r * rng.choice([-0.3, 0.1, 0.5])))
    for k, (body, l, h) in enumerate(usable[: 3 * len(SECTIONS)]):
        options = SECTIONS[k % len(SECTIONS)].split()
        files = [option for option in options if option.startswith("crossings.")]
        point = [f"--h={h:.6g}", f"--l={l}", "--orbits=2", "--crossings=12", "--json", "--no-plot"]
        yield Task(stratum, "section", ["section", *of_body(body), *point, *options], files=files)
    for k, (body, _, _) in enumerate(usable[: 3 * len(ORBITS)]):
        options = ORBITS[k % len(ORBITS)].split()
        start = ["--gamma=0.6,0,0.8", f"--omega={rng.uniform(-2, 2):.3f},0.3,{rng.uniform(-2, 2):.3f}", "--json"]
        files = [option for option in options if option.startswith("motion.")]
        yield Task(stratum, "orbit", ["orbit", *of_body(body), *start, *options], files=files)


def presets():
    for name in strata.PRESETS:
        body = ["--body", name]
        yield Task("presets", "table", [*body, "--no-plot", "--out", "made"], files=["made/atlas.json"])
        for options in ("", "--window 0:3,0.5:2"):
            yield Task("presets", "atlas", [*body, "--json", *options.split()])
        yield Task("presets", "text", ["classify", *body, "--h", "2.1", "--l", "13/10"])
        yield Task("presets", "text", ["critical", *body, "--l", "1.3"])
        few = "--h 6.1 --l 1.3 --orbits 2 --crossings 9 --no-plot --json"
        yield Task("presets", "section", ["section", *body, *few.split()])


SCHEMAS = "atlas classify critical section sections orbit bodies batch-error scan-row scan-summary scan-border find"
COMMANDS = "atlas,classify,critical,section,orbit,scan,scan merge,scan map,scan border,find,verify"


def pages():
    for command in ("bodies", "bodies --json", "schema", "completions bash", "man"):
        yield Task("pages", "pages", command.split())
    for name in SCHEMAS.split():
        yield Task("pages", "schema", ["schema", name])
    for command in ["", *COMMANDS.split(",")]:
        yield Task("pages", "help", [*command.split(), "--help"])


PARTS = (
    "--inertia 0.30,0.21,0.17,0.01,0,-0.02 --com 0,0.02,0.15 --mass 2.5 --g 9.80665",
    "--inertia 1,1,1,0,0,0 --com 0,0,1/2 --mass 2 --g 9.81",
    "--inertia 2e-4,2e-4,3e-5,0,0,1e-6 --com 0.001,0,0.04 --mass 0.1 --g 9.81",
    "--inertia 30,20,11,1,2,3 --com 0.1,0.2,0.3 --mass 7 --g 1.62",
)


def parts():
    for part in map(str.split, PARTS):
        yield Task("parts", "atlas", [*part, "--json"])
        yield Task("parts", "atlas", [*part, "--json", "--accuracy", "certified"])
        yield Task("parts", "text", ["classify", *part, "--h", "3.3", "--l", "0.7"])
        yield Task("parts", "critical", ["critical", *part, "--l", "0.7", "--json"])


SCANS = (
    "--family general --samples 1500 --out scan.csv --json",
    "--family positive --samples 800 --out scan.jsonl --json --seed 3",
    "--family katok --vary A2=0.3025:1.6925:25,A3=0.3075:1.6975:25 --out scan.csv",
    "--body paper --vary r2=0:0.5:9 --vary r3=0:0.5:9 --out scan.csv",
    "--family general --samples 300 --shard 2/3 --out scan.parquet",
    "--family general --samples 8 --accuracy certified --out scan.csv",
)
BORDERS = (
    "--body katok:2 --vary A3=0.7:0.8",
    "--body ten --vary A1=0.578:0.7 --json",
    "--A 2,1.1,1 --r 0.94868,0,0.61623 --vary r2=0.1:0.4 --json",
    "--body katok:6 --vary A2=0.7:0.8 --json",
    "--body paper --vary A3=0.7:1 --json",
)
SEARCHES = (
    "--type k3n1 --physical",
    "--type M4 --json",
    "--signature S2+T2 --physical --json",
    "--critical-points 8 --json",
    "--type M2 --seed 5 --json --all --samples 300",
)


def surveys():
    for options in SCANS:
        out = options.split("--out ")[1].split()[0]
        yield Task("surveys", "scan", ["scan", *options.split()], files=[out, f"{out}.summary.json"])
    shards = [f"scan --family general --samples 90 --shard {k}/3 --quiet --out s{k}.csv".split() for k in (1, 2, 3)]
    merge = "scan merge s1.csv s2.csv s3.csv --out merged.csv".split()
    yield Task("surveys", "scan merge", merge, before=shards, files=["merged.csv", "merged.csv.summary.json"])
    for options in BORDERS:
        yield Task("surveys", "scan border", ["scan", "border", *options.split()])
    for options in SEARCHES:
        yield Task("surveys", "find", ["find", *options.split()])


def wrong_inputs():
    for text in (HERE / "wrong_command_lines.txt").read_text(encoding="utf-8").split("\n")[:-1]:
        yield Task("wrong inputs", "command line", shlex.split(text))
    lines = (HERE / "wrong_batch_lines.txt").read_text(encoding="utf-8").split("\n")[:-1]
    for command in ("classify", "critical", "classify --strict", "classify --body paper", "critical --body paper"):
        yield Task("wrong inputs", "batch", [*command.split(), "--batch", "-"], lines)


def all_tasks(old, seed, count):
    """Every task; `count` bodies altogether, each with two points."""
    each = max(12, count // len(strata.STRATA))
    tasks = [task for name in strata.STRATA for task in of_stratum(old, seed, name, each)]
    return tasks + [*presets(), *pages(), *parts(), *surveys(), *wrong_inputs()]


PICTURES = (
    "atlas --body paper",
    "atlas --body ten",
    "atlas --body lagrange",
    "atlas --body katok:6 --window 0:4,0:3",
    "section --body paper --h 4.45 --l 3.25 --orbits 6 --crossings 60",
    "section --body paper --h 5.3 --l 3.25 --orbits 4 --crossings 40 --projection both --color lyapunov",
)


def pictures():
    for command in PICTURES:
        yield Task("pictures", "picture", [*command.split(), "--out", "made"], files=["made/*.svg"])
