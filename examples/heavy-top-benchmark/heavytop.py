"""Reads the benchmark and scores an engine; plain Python, nothing beyond the standard library.

An engine is a function `engine(model, q0, omega0, times, step)` that gives a list of (q, omega) at the times:

- `model`: a dictionary as in models/NAME.json (SI units; inertia about the fixed point and about the centre of mass),
- `q0`: the quaternion (w, x, y, z) at time 0, which takes vectors of the body to the world, z up,
- `omega0`: the angular velocity in the body's axes, rad/s,
- `step`: the time step in s, or a tolerance where an engine has no fixed step.
"""
import json
import math
import os
import time

HERE = os.path.dirname(os.path.abspath(__file__))


def names():
    """The names of the tops."""
    return sorted(name[:-5] for name in os.listdir(os.path.join(HERE, "truth")) if name.endswith(".json"))


def load(name):
    """Model and truth of a top; the truth's numbers as doubles."""
    with open(os.path.join(HERE, "models", name + ".json")) as file:
        model = json.load(file)
    with open(os.path.join(HERE, "truth", name + ".json")) as file:
        truth = json.load(file)
    for key in ("q", "omega"):
        truth[key] = [[float(x) for x in row] for row in truth[key]]
    return model, truth


def product(p, q):
    """p q of quaternions."""
    (a, b, c, d), (w, x, y, z) = p, q
    return [a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w]


def angle(p, q):
    """The angle between two attitudes in rad, well conditioned for small ones."""
    turn = product([p[0], -p[1], -p[2], -p[3]], q)
    return 2 * math.atan2(math.hypot(*turn[1:]), abs(turn[0]))


def up(q):
    """The world's z axis in the body's axes."""
    w, x, y, z = q
    return [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]


def energy(model, q, omega):
    """Kinetic energy and that in the field of gravity, J."""
    kinetic = sum(a * w * w for a, w in zip(model["inertia"], omega)) / 2
    return kinetic + model["mass"] * model["gravity"] * sum(c * u for c, u in zip(model["com"], up(q)))


def momentum(model, q, omega):
    """Angular momentum about the vertical through the fixed point, N m s."""
    return sum(a * w * u for a, w, u in zip(model["inertia"], omega, up(q)))


class Score(dict):
    """What an engine did on a top: `angle` (rad, the largest over the times), `omega` (relative to the largest), `energy` and
    `momentum` (the largest drift, relative to the size of the motion), `length` (of the quaternion, from 1), `seconds`."""


def score(engine, name, step, most=None):
    """Runs an engine on one top; `most`: only so many of the times."""
    model, truth = load(name)
    times = truth["times"][: most and most + 1]
    start = time.process_time()
    found = engine(model, truth["q"][0], truth["omega"][0], times, step)
    seconds = time.process_time() - start
    size = max(math.hypot(*omega) for omega in truth["omega"]) or 1.0
    a = max(model["inertia"])
    joule = a * size * size / 2 + model["mass"] * model["gravity"] * math.hypot(*model["com"])
    first = truth["q"][0], truth["omega"][0]
    result = Score(name=name, step=step, seconds=seconds, angle=0.0, omega=0.0, energy=0.0, momentum=0.0, length=0.0)
    for k, (q, omega) in enumerate(found):
        if not all(map(math.isfinite, [*q, *omega])):
            result.update(angle=math.pi, omega=math.inf, energy=math.inf, momentum=math.inf)
            break
        size_q = math.hypot(*q) or 1.0
        unit = [x / size_q for x in q]
        change = {
            "angle": angle(unit, truth["q"][k]),
            "omega": math.dist(omega, truth["omega"][k]) / size,
            "energy": abs(energy(model, unit, omega) - energy(model, *first)) / joule,
            "momentum": abs(momentum(model, unit, omega) - momentum(model, *first)) / (a * size),
            "length": abs(size_q - 1),
        }
        for key, value in change.items():
            result[key] = max(result[key], value)
    return result


def order(engine, name, step, most=None):
    """The order of convergence from a step to half of it; None where an error is at the level of roundings or not small."""
    coarse, fine = (score(engine, name, h, most)["angle"] for h in (step, step / 2))
    if not (1e-12 < fine and 0 < coarse < 0.3):
        return None
    return math.log2(coarse / fine)


def table(engine, step, tops=None):
    """The scores of an engine on all tops."""
    return [score(engine, name, step) for name in tops or names()]
