"""Points (h, l) for bodies: in the gaps between curves, and planted on and near curves, pole lines and events.

The old program says where curves and events are; both programs are then asked the same questions.
"""

import json
import re
import subprocess
from decimal import Decimal, getcontext
from fractions import Fraction
from math import isqrt, sqrt

from strata import log_uniform, text

getcontext().prec = 40
NUMBER = re.compile(r"-?(0|[1-9]\d*)(\.\d+)?([eE][+-]?\d+)?$")


def line(rng, moments, center, **point):
    """A line of a batch; numbers stand bare or in quotes."""

    def value(number):
        return number if NUMBER.match(number) and rng.random() < 0.5 else json.dumps(number)

    fields = [f'"A":[{",".join(map(value, moments))}]', f'"r":[{",".join(map(value, center))}]']
    return "{" + ",".join(fields + [f'"{name}":{value(number)}' for name, number in point.items()]) + "}"


def ask(program, arguments, lines, timeout=120):
    """The answers of a batch, as documents."""
    done = subprocess.run(
        [program, *arguments, "--threads", "1", "--batch", "-", "--quiet"],
        input="\n".join(lines).encode(),
        capture_output=True,
        timeout=timeout,
        check=False,
    )
    return [json.loads(answer) for answer in done.stdout.splitlines()]


def floats(body):
    return [[float(Fraction(t)) for t in part] for part in body]


def length(values):
    """|r|, also where the squares leave the range of doubles."""
    largest = max(map(abs, values))
    return largest * sqrt(sum((v / largest) ** 2 for v in values)) if largest > 0 else 0.0


def momentum(rng, body):
    """l as text: of the size at which things happen, sometimes 0, negative, tiny or huge."""
    moments, center = floats(body)
    unit = sqrt(max(moments)) * sqrt(length(center) or max(moments))
    chance = rng.random()
    if chance < 0.03:
        return rng.choice(["0", "-0", "0.0"])
    value = unit * (log_uniform(rng, 1e-8, 1e8) if chance < 0.08 else log_uniform(rng, 0.15, 6))
    return text(rng, -value if rng.random() < 0.05 else value)


def beside(rng, value, unit):
    """A decimal at relative distance 1e-3 ... 1e-16 from a computed value, or the value itself."""
    power = rng.choice([None, *range(3, 17)])
    if power is None:
        return repr(value)
    step = Decimal(rng.choice([-1, 1])) * Decimal(10) ** -power
    return str(Decimal(value) + step * Decimal(abs(value) or unit))


def energies(rng, body, l, answer):
    """Two energies at l: somewhere among the curves, and planted near one."""
    moments, center = floats(body)
    r = length(center)
    if "critical" not in answer or not answer["critical"]:
        return [text(rng, rng.uniform(-2, 2)), "0"]
    heights = [entry["h"] for entry in answer["critical"]]
    low, high = min(heights), max(heights)
    span = (high - low) or abs(high) or 1.0
    planted = list(heights)
    if r > 0:
        pole = sum(a * (c / r) ** 2 for a, c in zip(moments, center))
        straight = float(Fraction(l)) ** 2 / (2 * pole)
        planted += [straight - r, straight + r]
    chance = rng.random()
    if chance < 0.06:
        somewhere = low - span * rng.random()  # forbidden
    else:
        somewhere = low + span * rng.uniform(0, 1.4)
    return [text(rng, somewhere), beside(rng, rng.choice(planted), span)]


def on_a_pole_line(rng, body, l):
    """The energy of a pole line where |r| is rational, exactly; `None` where it is not."""
    moments, center = ([Fraction(t) for t in part] for part in body)
    square = sum(c * c for c in center)
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    if square == 0 or root * root != square:
        return None
    pole = sum(a * c * c for a, c in zip(moments, center)) / square
    h = Fraction(l) ** 2 / (2 * pole) + rng.choice([-1, 1]) * root
    if rng.random() < 0.5:
        h += rng.choice([-1, 1]) * root / 10 ** rng.randint(3, 18)
    return str(h)


def near_events(rng, program, body):
    """Points at and near the cusps, pitchforks and crossings of a body."""
    (moments, center), found = body, []
    command = [program, f"--A={','.join(moments)}", f"--r={','.join(center)}", "--json", "--quiet"]
    done = subprocess.run(command, capture_output=True, timeout=120, check=False)
    if done.returncode != 0:
        return []
    events = json.loads(done.stdout)["events"]
    for event in rng.sample(events, min(3, len(events))):
        found.append((beside(rng, event["h"], 1), beside(rng, event["l"], 1)))
    return found
