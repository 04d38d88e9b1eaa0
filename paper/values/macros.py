"""The numbers of the manuscript that are computed or measured, one LaTeX macro each."""
import re
from fractions import Fraction
from statistics import median

from latex import many, percent, power, time
from recorded import ROOT, answer, criterion, document, rows, run, text, total, verified


def paper():
    body = answer("atlas", "--body", "paper", "--no-drawing")
    yield "PaperMiddle", body["body"]["A"][1]
    yield "PaperX", body["body"]["r"][0]
    yield "PaperZ", body["body"]["r"][2]
    yield "PaperRegions", {9: "nine"}[body["summary"]["regions"]]
    regions, events, pairs = verified("--body", "paper")
    yield "VerifiedRegions", {"9": "nine"}[regions]
    yield "VerifiedEvents", {"5": "five"}[events]
    yield "VerifiedPairs", {"8": "eight"}[pairs]
    yield "ProgramVersion", run("--version").split()[1]


def four_circles():
    """The bodies that exist with four boundary circles, one pole first."""
    existing = [witness for witness in document("witnesses.json") if exists(witness["A"])]
    return [next(witness for witness in existing if witness["type"] == kind) for kind in ("k4n1", "k4n2")]


def exists(moments):
    least, middle, largest = sorted(map(Fraction, moments))
    return least + middle > largest


def options(witness):
    return "--A", ",".join(witness["A"]), "--r", ",".join(witness["r"])


def regions():
    for name, witness in zip(("VerifiedFourA", "VerifiedFourB"), four_circles(), strict=True):
        yield name, verified(*options(witness))[0]
    for name, kind in (("RoomFourOne", "k4n1"), ("RoomFourTwo", "k4n2")):
        found = re.search(rf"^{kind} plates: room (\S+),", text("survey/four_circles.txt"), re.M)
        yield name, power(float(found[1]))
    folds = text("survey/five_circles.txt").splitlines()
    yield "FoldRuns", re.match(r"(\d+) runs", folds[0])[1]
    seen = {line.split(" folds")[0]: int(re.search(r"(\d+) runs show", line)[1]) for line in folds[1:]}
    assert all(runs == 0 for pattern, runs in seen.items() if ", 6 " in pattern)
    yield "FoldFourRuns", str(seen["bodies that exist, 4 and 1"])


def scans():
    scan, positive = (document(f"survey/{name}.summary.json") for name in ("general", "positive"))
    assert not any(kind.startswith("k4") for kind in scan["types"])
    assert scan["undecided"] == scan["failed"] == 0
    yield "ScanBodies", many(scan["rows"])
    yield "ScanAllBodies", many(positive["rows"])
    points = {int(number): found["bodies"] for number, found in scan["critical_points"].items()}
    assert max(points) == 10 == max(map(int, positive["critical_points"]))
    yield "ScanSix", percent(sum(bodies for number, bodies in points.items() if number <= 6), scan["rows"], 2)
    yield "ScanTenBodies", {7: "seven"}[points[10]]
    yield "ScanClasses", str(len(scan["classes"]))
    largest, held = sorted((found["bodies"] for found in scan["classes"]), reverse=True), 0
    for count, bodies in enumerate(largest, 1):
        held += bodies
        if held >= 0.9 * scan["rows"]:
            break
    yield "ClassesNinety", {7: "seven"}[count]


def walks():
    graph = document("survey/graph.json")
    rounds = [walk for walk in graph["rounds"] if walk["domain"] == "existing"]
    known = [kind for kind in document("classes.json")["classes"] if kind["physical"]]
    assert len(known) == len(graph["classes"])
    yield "ClassesPhysical", str(len(known))
    yield "WalkRounds", str(len(rounds))
    yield "WalkLines", many(total(rounds, "lines"))
    yield "WalkWalls", many(total(rounds, "walls"))
    yield "WalkLost", many(total(rounds, "lost"))
    quiet = 0
    for walk in rounds:
        quiet = walk["walls"] - max(walk["new_at"]) if walk["new_at"] else quiet + walk["walls"]
    yield "WalkQuiet", many(quiet)
    depths = sorted(kind["distance"] for kind in known)
    yield "DepthLargest", f"{depths[-1]:.2f}"
    yield "DepthLeast", power(depths[0], 0)
    yield "DepthThin", str(sum(depth < 1e-6 for depth in depths))
    yield "FourClasses", str(sum(any(name.startswith("k4") for name in kind["types"]) for kind in known))


def tradeoff():
    table = rows("tradeoff/classify.csv")
    exact = [row for row in table if row["method"] == "exact"]
    assert total(exact, "wrong") == total(exact, "undecided") == total(exact, "failed") == 0
    yield "TradeStrata", str(len({row["stratum"] for row in exact}))
    yield "TradeDistances", str(len({row["distance"] for row in exact}) - 1)
    yield "TradePoints", many(total(exact, "points"))
    yield "TradeUntold", many(total(exact, "untold"))
    curves = rows("tradeoff/curves.csv")
    assert total(curves, "wrong") == total(curves, "failed") == 0
    yield "CurvePoints", many(total(curves, "points"))
    yield "CurveUntold", many(total(curves, "untold"))

    def at(method, distance):
        return [row for row in table if row["method"] == method and row["distance"] == distance]

    def middle(method, distance):
        return time(median(float(row["cpu_us_median"]) for row in at(method, distance)))

    yield "ExactEasy", middle("exact", "")
    yield "ExactHard", middle("exact", "1e-16")
    peers = {"Flood": "flood fill 256x512", "Companion": "companion matrix", "Loose": "companion matrix 1e-4"}
    for name, method in peers.items():
        random = at(method, "")
        yield f"{name}Wrong", percent(total(random, "wrong"), total(random, "points") - total(random, "untold"), 0)
        if name == "Flood":
            assert {row["stratum"] for row in random if int(row["wrong"])} == {"rod"}
            yield "FloodTime", middle(method, "")
    (bodies,) = {row["bodies"] for row in rows("tradeoff/atlas.csv") if not row["method"].startswith("flood fill")}
    yield "AtlasBodies", bodies
    yield "AtlasGeneric", time(criterion("atlas/generic"))


def trims():
    """How much of two figures is left out below: tables that other tables here replace. In big points."""
    for name, figure, head in (
        ("TrimNine", "bifurcation-nine-regions", "curve"),
        ("TrimFour", "sphere-four-circles", "relative equilibrium"),
    ):
        picture = (ROOT / "figures" / f"{figure}.svg").read_text(encoding="utf-8")
        millimetres, height = re.search(r'height="([\d.]+)mm" viewBox="0 0 \d+ (\d+)"', picture).groups()
        found = re.search(rf'<text [^>]*y="(\d+)" font-size="(\d+)"[^>]*>{head}<', picture)
        below = int(height) - int(found[1]) + int(found[2]) if found else 0
        yield name, f"{below * float(millimetres) / int(height) * 72 / 25.4:.0f}"


def macros():
    for part in (paper, regions, scans, walks, tradeoff, trims):
        yield from part()
