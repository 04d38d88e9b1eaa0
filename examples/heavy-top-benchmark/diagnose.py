"""What is wrong with an engine, from the pattern of its errors.

`diagnose(engine)` gives a name and the reason: it starts the engine at many attitudes for a moment, compares the rates of change
with those of the right equations and of wrong ones that are often written, and then looks at how errors depend on the step.
"""
import math
import random

from engines import torque
from heavytop import load, product, score, up

#: Tops that show it: different moments, a centre of mass off every axis.
PROBES = ["chaotic", "upright", "plate-corner"]
MOMENT = 1e-3
STEP = 1e-4


def gyroscopic(model, omega, a=None):
    a = a or model["inertia"]
    return [(a[i - 2] - a[i - 1]) * omega[i - 2] * omega[i - 1] for i in range(3)]


def weight(model, direction):
    """m g c x down for a direction `up`."""
    c, pull = model["com"], model["mass"] * model["gravity"]
    return [-pull * (c[i - 2] * direction[i - 1] - c[i - 1] * direction[i - 2]) for i in range(3)]


def rates(model, omega, direction, gyro=1.0, pull=1.0, a=None):
    a = a or model["inertia"]
    return [(gyro * x + pull * y) / m for x, y, m in zip(gyroscopic(model, omega, a), weight(model, direction), a)]


def steiner(model, times):
    """Moments with the parallel-axis theorem applied so many times more."""
    square = sum(x * x for x in model["com"])
    return [m + times * model["mass"] * (square - x * x) for m, x in zip(model["inertia"], model["com"])]


def turned_inversely(q):
    """R e_z in place of its transpose."""
    return up([q[0], -q[1], -q[2], -q[3]])


def along_y(q):
    w, x, y, z = q
    return [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)]


#: Wrong equations of omega' by their names.
EQUATIONS = {
    "right": lambda m, q, w: torque(m, q, w),
    "sign of the gyroscopic term": lambda m, q, w: rates(m, w, up(q), gyro=-1),
    "gyroscopic term missing": lambda m, q, w: rates(m, w, up(q), gyro=0),
    "gyroscopic term twice": lambda m, q, w: rates(m, w, up(q), gyro=2),
    "sign of gravity": lambda m, q, w: rates(m, w, up(q), pull=-1),
    "gravity missing": lambda m, q, w: rates(m, w, up(q), pull=0),
    "gravity not turned into the body's frame": lambda m, q, w: rates(m, w, [0, 0, 1]),
    "gravity turned by the inverse rotation": lambda m, q, w: rates(m, w, turned_inversely(q)),
    "gravity along y": lambda m, q, w: rates(m, w, along_y(q)),
    "inertia about the centre of mass": lambda m, q, w: rates(m, w, up(q), a=steiner(m, -1)),
    "parallel axes twice": lambda m, q, w: rates(m, w, up(q), a=steiner(m, 1)),
    "moments permuted": lambda m, q, w: rates(m, w, up(q), a=m["inertia"][1:] + m["inertia"][:1]),
    "moments averaged": lambda m, q, w: rates(m, w, up(q), a=[sum(m["inertia"]) / 3] * 3),
    "g = 9.8": lambda m, q, w: rates(m, w, up(q), pull=9.8 / m["gravity"]),
}

#: Wrong equations of q'.
TURNS = {
    "right": lambda q, w: [x / 2 for x in product(q, [0, *w])],
    "omega of the world in place of the body's": lambda q, w: [x / 2 for x in product([0, *w], q)],
    "the half in q' missing": lambda q, w: product(q, [0, *w]),
    "the body turns backwards": lambda q, w: [-x / 2 for x in product(q, [0, *w])],
}


def derivative(rows):
    """At the first of five equidistant rows."""
    weights = [-25 / 12, 4, -3, 4 / 3, -1 / 4]
    return [sum(w * x for w, x in zip(weights, column)) / MOMENT for column in zip(*rows)]


def nearest(measured, candidates):
    """The candidate whose rates are nearest to those measured, over all probes, and how near."""
    def gap(name):
        pairs = [(found, candidates[name](*at)) for at, found in measured]
        return math.sqrt(sum(math.dist(a, b) ** 2 for a, b in pairs) / sum(math.hypot(*b) ** 2 + 1e-30 for _, b in pairs))
    best = min(candidates, key=gap)
    return best, gap(best)


def diagnose(engine):
    """(name, reason); the name is "nothing" where no mistake shows."""
    rng = random.Random(1)
    turning, moving = [], []
    for name in PROBES * 4:
        model, _ = load(name)
        raw = [rng.gauss(0, 1) for _ in range(4)]
        q0 = [x / math.hypot(*raw) for x in raw]
        omega0 = [rng.uniform(-4, 4) for _ in range(3)]
        rows = engine(model, q0, omega0, [MOMENT * k for k in range(5)], STEP)
        if math.dist(rows[0][0], q0) > 1e-6:
            for words, other in (("order of the quaternion's components", [q0[3], *q0[:3]]), ("order of the quaternion's components", [*q0[1:], q0[0]]),
                                 ("the inverse attitude", [q0[0], *(-x for x in q0[1:])])):
                if math.dist(rows[0][0], other) < 1e-6:
                    return words, "the attitude at time 0 is not the one that was given"
            return "attitude at the start", "the attitude at time 0 is not the one that was given"
        if math.dist(rows[0][1], omega0) > 1e-5:
            turned = product(product(q0, [0, *omega0]), [q0[0], *(-x for x in q0[1:])])[1:]
            if math.dist(rows[0][1], turned) < 1e-5:
                return "omega told in the world's frame", "omega at time 0 is R omega0"
            return "omega at the start", "omega at time 0 is not the one that was given"
        turning.append(((q0, omega0), derivative([row[0] for row in rows])))
        moving.append(((model, q0, omega0), derivative([row[1] for row in rows])))
    turn, turn_gap = nearest(turning, TURNS)
    if turn != "right" and turn_gap < 0.05:
        return turn, f"q' is that of this mistake within {turn_gap:.1e}"
    equation, gap = nearest(moving, EQUATIONS)
    if equation != "right" and gap < 0.05:
        return equation, f"omega' is that of this mistake within {gap:.1e}"
    return numerical(engine, gap)


def numerical(engine, gap):
    """The equations are right at a moment: how do errors depend on the step?"""
    coarse, fine = (score(engine, "chaotic", h, most=40) for h in (2e-3, 1e-3))
    free = score(engine, "euler-tumble", 1e-3, most=40)
    order = math.log2(max(coarse["angle"], 1e-16) / max(fine["angle"], 1e-16))
    if fine["angle"] < 1e-6 and fine["energy"] < 1e-7 and gap < 1e-3:
        return "nothing", f"errors are {fine['angle']:.1e} rad and {fine['energy']:.1e} of the energy"
    if fine["length"] > 1e-5:
        return "the quaternion is not renormalised", f"its length is off by {fine['length']:.1e}"
    if order > 0.7 and fine["energy"] < 1e-3 * fine["angle"]:
        return "one step late", f"the error falls with order {order:.1f}, energy is kept to {fine['energy']:.1e}"
    if order > 0.7:
        return "a method of first order", f"the error falls with order {order:.1f}, energy drifts by {fine['energy']:.1e}"
    if max(fine["angle"], coarse["angle"]) < 1e-2 and free["momentum"] < 1e-4:
        return "single precision", f"the error, {fine['angle']:.1e}, does not fall with the step"
    return "damping", f"energy falls by {fine['energy']:.1e} and momentum by {free['momentum']:.1e} at any step"
