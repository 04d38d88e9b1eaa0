"""The truth: positions at 200 times with proved bounds, by `bifdiag orbit --proved`.

    python3 make.py [--program bifdiag] [--tops NAME,NAME]

writes truth/NAME.json: `times`, `q` (w, x, y, z; takes vectors of the body to the world, z up), `omega` (in the body's axes,
rad/s), and `bound`: no number is farther than that from the exact one. The decimals are strings where there are more digits
than a double has.
"""
import argparse
import json
import os
import subprocess
from fractions import Fraction as F

from tops import G, HERE, TOPS

TIMES = 200


def rounded(ends, places):
    """The middle of an interval to some decimal places, and how far the exact value may be from it."""
    lo, hi = (F(x) for x in ends)
    unit = F(10) ** places
    middle = round((lo + hi) / 2 * unit)
    return F(middle) / unit, middle, max(hi - F(middle) / unit, F(middle) / unit - lo)


def decimal(middle, places):
    digits = str(abs(middle)).rjust(places + 1, "0")
    return ("-" if middle < 0 else "") + digits[:-places] + "." + digits[-places:]


def truth(t, program):
    r = [t["mass"] * G * x for x in t["com"]]
    many = t["digits"] > 16
    def listed(values):
        return ",".join(map(str, values))
    command = [program, "orbit", "--A", listed(t["inertia"]), "--r=" + listed(r), "--gamma=" + listed(t["down"]),
               "--omega=" + listed(t["omega"]), "--times", f"0:{float(t['end'])!r}:{TIMES + 1}", "--proved",
               "--bound", "1e-101" if many else "2e-14", "--json"]
    document = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    places, worst = (101, F(0)) if many else (15, F(0))
    rows = {"q": [], "omega": []}
    for q, omega in zip(document["enclosures"]["quaternion"], document["enclosures"]["omega"]):
        # The program's third axis of space points down: a half turn about x makes it up, and (w, x, y, z) becomes
        # (0, 1, 0, 0)(w, x, y, z) = (-x, w, -z, y).
        def negated(ends):
            return [str(-F(ends[1])), str(-F(ends[0]))]
        w, x, y, z = q
        for key, values in (("q", [negated(x), w, negated(z), y]), ("omega", omega)):
            row = []
            for ends in values:
                _, middle, error = rounded(ends, places)
                worst = max(worst, error)
                row.append(decimal(middle, places) if many else float(decimal(middle, places)))
                if not many:
                    worst = max(worst, abs(F(row[-1]) - (F(ends[0]) + F(ends[1])) / 2) + (F(ends[1]) - F(ends[0])) / 2)
            rows[key].append(row)
    bound = float("%.2g" % (float(worst) * 1.06))
    assert F(bound) >= worst and bound <= (1e-100 if many else 1e-12), (t["name"], bound)
    return {"name": t["name"], "times": document["times"], "bound": bound, "bits": document["bits"],
            "command": document["command"], **rows}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", default="bifdiag")
    parser.add_argument("--tops", default="", help="NAME,NAME: only these")
    options = parser.parse_args()
    os.makedirs(os.path.join(HERE, "truth"), exist_ok=True)
    for t in (t for t in TOPS if not options.tops or t["name"] in options.tops.split(",")):
        found = truth(t, options.program)
        with open(os.path.join(HERE, "truth", t["name"] + ".json"), "w") as file:
            json.dump(found, file)
            file.write("\n")
        print(f"{t['name']:20} bound {found['bound']:.1e}  {found['bits']} bits")


if __name__ == "__main__":
    main()
