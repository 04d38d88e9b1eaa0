"""The measured numbers of joss.md, each as that text words it."""
from recorded import criterion, document, peer, rounded, rows, total


def facts():
    exact = [row for row in rows("tradeoff/classify.csv") if row["method"] == "exact"]
    counts = {key: total(exact, key) for key in ("points", "wrong", "undecided", "untold")}
    assert counts["wrong"] == counts["undecided"] == 0
    yield f"Of {counts['points']:,} points"
    yield f"for {counts['untold']:,} of them"
    yield f"{len({row['stratum'] for row in exact})} strata"
    yield f"{sum(int(row['points']) for row in exact if not row['distance']):,} bodies"
    nearest = min((row["distance"] for row in exact if row["distance"]), key=float)
    yield f"$10^{{{nearest.removeprefix('1e')}}}$"
    curves = rows("tradeoff/curves.csv")
    assert total(curves, "wrong") == 0
    yield f"On {total(curves, 'points'):,} points exactly on curves"
    yield f"| {rounded(criterion('atlas/generic'))} | – |"
    flood = "all regions of the paper's body"
    yield f"| {rounded(peer(flood, 'ours_us'))} | flood fill on 200×200 points: {rounded(peer(flood, 'peer_us'))} |"
    auto = "curves of the paper's body"
    yield f"| {rounded(peer(auto, 'ours_us'))} | AUTO-07p: {rounded(peer(auto, 'peer_us'))} |"
    point = "class of a point"
    yield f"| {rounded(peer(point, 'ours_us'))} | flood fill: {rounded(peer(point, 'peer_us'))} |"
    flint = "critical points at one l, certified"
    yield f"| {rounded(peer(flint, 'ours_us'))} | FLINT, certified: {rounded(peer(flint, 'peer_us'))} |"
    section = {row["work"]: row for row in rows("benchmarks/section_peers.csv")}
    ours = float(section["bifdiag, states, to T"]["median_per_cpu_second"])
    yield f"{ours / 1e6:.2g} million crossings per second"
    yield f"{float(section['heyoka, batch 8, states, to T']['ratio']):.2g} times as many as heyoka"
    yield f"{sum(c['physical'] for c in document('classes.json')['classes'])} classes"
    scan = document("survey/general.summary.json")
    assert scan["rows"] == 1_000_000 and not any("k4" in str(kind) for kind in scan["types"])
    yield f"a million random bodies show {len(scan['classes'])}"
