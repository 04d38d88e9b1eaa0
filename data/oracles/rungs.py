"""Which rung of the ladder of numbers decides how many questions: each point of some files asked of the command.

    python rungs.py BIFDIAG 56 points.jsonl curves.jsonl > ../tradeoff/rungs.csv          (three minutes of a core)

BIFDIAG is the program, the files come from campaign_points.py and curve_points.py; 56 bodies of each stratum, or points of
each kind, are asked. `bifdiag classify --timings` tells what decided each question: a point by f64, or further by the signs
of h against every height over l, each in intervals of so many bits or by algebra. One row for each stratum or kind, distance
(empty: random; 0: on a curve), question and rung.
"""

import json
import re
import subprocess
import sys
from collections import Counter


def work(program, body, point):
    """(question, rung) -> how many, for one point."""
    given = [f"--{name}=" + ",".join(body[name]) for name in ("A", "r")]
    command = [program, "classify", *given, f"--h={point['h']}", f"--l={body['l']}", "--json", "--timings"]
    told = subprocess.run(command, capture_output=True, text=True, check=True).stderr
    lines = re.findall(r"^work: (.+?) +(f64|\d+ bits|algebra|further|open) +(\d+)$", told, re.MULTILINE)
    assert len(lines) == told.count("work: "), told
    counts = Counter()
    for question, rung, count in lines:
        counts[question, rung] += int(count)
    return counts


def asked(paths, bodies):
    """(stratum, distance, body, point) of so many lines of each stratum."""
    lines = Counter()
    for path in paths:
        for line in open(path):
            body = json.loads(line)
            stratum = body.get("stratum") or "curve: " + body["kind"]
            lines[stratum] += 1
            if lines[stratum] <= bodies:
                for point in body.get("points") or [{"distance": "0", "h": body["h"]}]:
                    yield stratum, point["distance"] or "", body, point


def main():
    program, bodies, paths = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
    points, found = Counter(), {}
    for stratum, distance, body, point in asked(paths, bodies):
        points[stratum, distance] += 1
        found.setdefault((stratum, distance), Counter()).update(work(program, body, point))
    print("stratum,distance,points,question,rung,count")
    for (stratum, distance), counts in found.items():
        for (question, rung), count in sorted(counts.items()):
            print(f"{stratum},{distance},{points[stratum, distance]},{question},{rung},{count}")


main()
