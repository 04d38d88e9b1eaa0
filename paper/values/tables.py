"""The tables of the manuscript, made from the program and from data/."""
from collections import defaultdict
from statistics import median

from latex import many, percent, table, ten, time
from macros import four_circles, options
from recorded import ROOT, answer, document, peer, rows, total


def listed(numbers):
    return "$" + ",\\ ".join(numbers) + "$"


def four():
    body = []
    for witness in four_circles():
        found = answer("critical", *options(witness), "--l", witness["l"])["critical"]
        level = float(witness["h"])
        above = [point for point in found if point["h"] > level]
        assert len(above) == 4 and all(point["index"] == 2 for point in above)
        below = max(point["h"] for point in found if point["h"] < level)
        (component,) = answer("classify", *options(witness), "--h", witness["h"], "--l", witness["l"])["components"]
        poles = " and ".join({"+": "$\\hat r$", "-": "$-\\hat r$"}[pole] for pole in component["poles"])
        body.append([listed(witness["A"]), listed(witness["r"]), f"${witness['l']}$", f"${witness['h']}$", f"${below:.7f}$",
                     f"${min(point['h'] for point in above):.7f}$", poles, str(component["genus"])])
    return table("llcccccc", ["$A$", "$r$", "$l$", "$h$", "below", "above", "poles", "genus"], body)


def types():
    scans = [document(f"survey/{name}.summary.json") for name in ("general", "positive")]
    body = []
    for circles in range(6):
        for poles in range(3):
            counts = [scan["types"].get(f"k{circles}n{poles}", {"bodies": 0})["bodies"] for scan in scans]
            if circles in (0, 5) or (circles >= 3 and poles == 0):
                assert not any(counts) or (circles, poles) == (0, 2)
                if not any(counts):
                    continue
            genus = circles + poles - 1
            body.append([f"${circles}$", f"${poles}$", f"${genus}$", *map(many, counts)])
    return table("cccrr", ["$k$", "$p$", "genus", "bodies that exist", "all $A_i>0$"], body)


WORDS = {"1:1": "$\\omega_1=\\omega_2$", "1:2": "$\\omega_1=2\\omega_2$", "1:3": "$\\omega_1=3\\omega_2$", "D4": "$D_4=0$"}


def verdicts():
    changes = answer("atlas", "--body", "paper", "--no-drawing")["verdict_changes"]
    assert {change["curve"] for change in changes} == {"G0.1"} and all(change["proved"] for change in changes)
    places = ([f"${change[name]:.8f}$" for name in ("l", "h")] for change in changes)
    words = ([WORDS[change["kind"]], change["verdict"]] for change in changes)
    return table("cccc", ["$l$", "$h$", "fails", "verdict"], [[*at, *said] for at, said in zip(places, words)])


def largest():
    known = [kind for kind in document("classes.json")["classes"] if kind["physical"]]
    known.sort(key=lambda kind: -kind["measure"])
    body = []
    for kind in known[:7]:
        beside = len({neighbour["class"] for neighbour in kind["neighbours"]})
        body.append([f"\\texttt{{{kind['name']}}}", f"{100 * kind['measure']:.2f}\\,\\%", str(kind["regions"]), str(beside),
                     listed(kind["witness"]["A"]), listed(kind["witness"]["r"])])
    return table("lrccll", ["class", "share", "regions", "neighbours", "$A$", "$r$"], body)


def walls():
    """The events between classes, as docs/survey.md has them from the records."""
    events = reported("survey", "events")
    # What the text says about the birth of the fourth hole.
    assert all("G0" in event for _, event, _ in reported("types", "births"))
    body = [[mathematical(name), kinds, many(int(met.replace(",", "")))] for name, kinds, met, _ in events]
    return table("lrr", ["event", "kinds of borders", "walls"], body)


def reported(page, name):
    """The rows of a table that `examples/classes` writes into a page of docs."""
    text = (ROOT / "docs" / f"{page}.md").read_text(encoding="utf-8")
    block = text.split(f"<!-- classes report: {name} -->")[1].split("<!-- end -->")[0]
    lines = [line for line in block.splitlines() if line.startswith("| ")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


def mathematical(name):
    return name.replace("J_r = A2", "$J_r=a_2$")


METHODS = (("exact", "exact"), ("fast", "fast"), ("companion matrix", "companion matrix"),
           ("flood fill 32x64", "flood fill $32\\times64$"), ("flood fill 256x512", "$256\\times512$"))


def points():
    grouped = defaultdict(list)
    for row in rows("tradeoff/classify.csv"):
        grouped[row["method"], row["distance"]].append(row)
    body = []
    for distance in ("", "1e-4", "1e-8", "1e-12", "1e-15", "1e-16", "1e-60"):
        cells = []
        for method, _ in METHODS:
            group = grouped[method, distance]
            known = total(group, "points") - total(group, "untold")
            open_ = total(group, "undecided") + total(group, "failed")
            assert total(group, "right") + total(group, "wrong") + open_ == known
            shares = [100 * total(group, "right") / known, 100 * total(group, "wrong") / known, 100 * open_ / known]
            cells.append(" / ".join(f"{share:.0f}" if share in (0, 100) else f"{share:.1f}" for share in shares))
        body.append([ten(distance) if distance else "random", *cells])
    medians = (median(float(row["cpu_us_median"]) for row in grouped[method, ""]) for method, _ in METHODS)
    body.append(["time", *map(time, medians)])
    return table("lccccc", ["distance", *(name for _, name in METHODS)], body)


def atlas():
    methods = ("regions alone", "fast", "exact", "proof")
    found = {(row["stratum"], row["method"]): row for row in rows("tradeoff/atlas.csv")}
    body = []
    for stratum in dict.fromkeys(key[0] for key in found):
        cells = [found[stratum, method] for method in methods]
        assert all(int(row["wrong"]) == int(row["failed"]) == 0 for row in cells)
        body.append([stratum, *(f"{row['right']}, {time(float(row['cpu_us_median']))}" for row in cells)])
    return table("lcccc", ["stratum", "regions, fast", "document, fast", "document, exact", "proof"], body)


PEERS = (
    ("all regions of one body", "all regions of the paper's body", "flood fill at $200\\times200$ points"),
    ("its curves", "curves of the paper's body", "AUTO-07p~\\cite{AUTO07p}, start points by hand"),
    ("type of $U_{hl}$ at a point", "class of a point", "flood fill, $256\\times512$"),
    ("type of $U_{hl}$ at a point", "Betti numbers at one l", "GUDHI~\\cite{GUDHI}, $128\\times256$, Betti numbers, all $h$"),
    ("critical points at one $l$", "critical points at one l, certified", "FLINT~\\cite{FLINT}, certified roots"),
    ("critical points at one $l$", "critical points at one l, numpy", "companion matrix (numpy)"),
    ("critical points at one $l$", "critical points at one l, fsolve", "Newton's method from 100 starts"),
)


def peers():
    body = [[task, time(peer(work, "ours_us")), other, time(peer(work, "peer_us"))] for task, work, other in PEERS]
    return table("llll", ["task", "bifdiag", "other program", ""], body)


FAMILIES = {
    "l→0": "order of minimum and $P_+$ at $l=\\varepsilon$",
    "l→∞": "order of the two lowest curves at $l=1/\\varepsilon$",
    "r→axis": "all regions, $r=(1,\\varepsilon,2\\varepsilon)$",
    "A1→A2": "all regions, $A_2=A_1+\\varepsilon$",
    "near-cusp": "point between the arms at $l_c(1+\\varepsilon)$",
    "near-triple-crossing": "all regions, $\\varepsilon$ from a border of Katok's types",
}


def extremes():
    found = defaultdict(list)
    for row in rows("tradeoff/extremes.csv"):
        found[row["extreme"]].append(row)
    assert not any("wrong" in (row["fast"], row["exact"]) for table_ in found.values() for row in table_)
    body = []
    for family, name in FAMILIES.items():
        cells = []
        for level in ("fast", "exact"):
            answered = []
            for row in sorted(found[family], key=lambda row: -float(row["epsilon"])):
                if row[level] != "right":
                    break
                answered.append(row["epsilon"])
            star = "*" if len(answered) == len(found[family]) else ""
            cells.append(ten(answered[-1].replace("1e-0", "1e0")) + star)
        body.append([name, *cells])
    return table("lcc", ["question", "fast", "exact"], body)


TABLES = {"four-circles": four, "types": types, "verdicts": verdicts, "largest": largest, "walls": walls, "points": points,
          "atlas": atlas, "peers": peers, "extremes": extremes}
