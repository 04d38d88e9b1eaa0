"""A toy engine with twenty planted mistakes, which diagnose.py names.

    python3 toy.py

prints what was planted and what was found; exit status 1 if one passes as right or fewer than fifteen are named rightly.
"""
import struct
import sys

from diagnose import diagnose

PLANTED = [
    "sign of the gyroscopic term", "gyroscopic term missing", "sign of gravity", "gravity not turned into the body's frame",
    "gravity turned by the inverse rotation", "gravity along y", "inertia about the centre of mass", "parallel axes twice",
    "moments permuted", "moments averaged", "g = 9.8", "omega of the world in place of the body's", "the half in q' missing",
    "a method of first order", "the quaternion is not renormalised", "damping", "single precision",
    "order of the quaternion's components", "omega told in the world's frame", "one step late",
]


def single(values):
    return [struct.unpack("f", struct.pack("f", x))[0] for x in values]


def matrix(q):
    """Columns are the body's axes in the world."""
    w, x, y, z = q
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def apply(rows, v):
    return [sum(a * b for a, b in zip(row, v)) for row in rows]


def moments(model, mistake):
    """About the fixed point, from those about the centre of mass by the parallel-axis theorem."""
    times = {"inertia about the centre of mass": 0, "parallel axes twice": 2}.get(mistake, 1)
    square = sum(x * x for x in model["com"])
    found = [model["inertia_com"][i][i] + times * model["mass"] * (square - model["com"][i] ** 2) for i in range(3)]
    if mistake == "moments permuted":
        found = [found[1], found[2], found[0]]
    return [sum(found) / 3] * 3 if mistake == "moments averaged" else found


def acceleration(model, q, omega, mistake):
    """I^-1 (com x weight - omega x I omega) in the body's axes."""
    inertia, turn = moments(model, mistake), matrix(q)
    back = [list(row) for row in zip(*turn)]
    g = 9.8 if mistake == "g = 9.8" else model["gravity"]
    down = [0.0, -model["mass"] * g, 0.0] if mistake == "gravity along y" else [0.0, 0.0, -model["mass"] * g]
    if mistake == "sign of gravity":
        down = [-x for x in down]
    if mistake == "gravity turned by the inverse rotation":
        down = apply(turn, down)
    elif mistake != "gravity not turned into the body's frame":
        down = apply(back, down)
    gyro = cross(omega, [a * w for a, w in zip(inertia, omega)])
    factor = {"sign of the gyroscopic term": -1, "gyroscopic term missing": 0}.get(mistake, 1)
    return [(t - factor * x) / a for t, x, a in zip(cross(model["com"], down), gyro, inertia)]


def turning(q, omega, mistake):
    """q' = q omega / 2."""
    w, v = q[0], q[1:]
    sign = -1 if mistake == "omega of the world in place of the body's" else 1
    factor = 1 if mistake == "the half in q' missing" else 0.5
    return [-factor * sum(a * b for a, b in zip(v, omega)),
            *(factor * (w * o + sign * c) for o, c in zip(omega, cross(v, omega)))]


def toy(mistake=None):
    """An engine: Runge and Kutta's method with the quaternion normalised, and one mistake. It shares no code with the diagnosis."""
    damping = 1e-2 if mistake == "damping" else 0.0

    def run(model, q0, omega0, times, step):
        def field(y):
            q, omega = y[:4], y[4:]
            rate = acceleration(model, q, omega, mistake)
            return turning(q, omega, mistake) + [x - damping * w for x, w in zip(rate, omega)]

        if mistake == "order of the quaternion's components":
            q0 = [q0[3], *q0[:3]]
        y, steps, found = [*q0, *omega0], 0, []
        for time in times:
            wanted = round(time / step) - (mistake == "one step late" and time > 0)
            for _ in range(wanted - steps):
                k1 = field(y)
                if mistake in ("a method of first order", "the quaternion is not renormalised"):
                    y = [v + step * k for v, k in zip(y, k1)]
                else:
                    k2 = field([v + step / 2 * k for v, k in zip(y, k1)])
                    k3 = field([v + step / 2 * k for v, k in zip(y, k2)])
                    k4 = field([v + step * k for v, k in zip(y, k3)])
                    y = [v + step / 6 * (p + 2 * q + 2 * r + s) for v, p, q, r, s in zip(y, k1, k2, k3, k4)]
                if mistake != "the quaternion is not renormalised":
                    length = sum(v * v for v in y[:4]) ** 0.5
                    y[:4] = [v / length for v in y[:4]]
                if mistake == "single precision":
                    y = single(y)
            steps = max(steps, wanted)
            q, omega = y[:4], y[4:]
            if mistake == "omega told in the world's frame":
                omega = apply(matrix(q), omega)
            found.append((q, omega))
        return found
    return run


def main():
    named = flagged = 0
    for mistake in [None, *PLANTED]:
        found, reason = diagnose(toy(mistake))
        expected = mistake or "nothing"
        print(f"{'named' if found == expected else 'flagged' if found != 'nothing' else 'MISSED':8} planted: {expected}; found: {found} ({reason})")
        if mistake:
            named += found == mistake
            flagged += found != "nothing"
        elif found != "nothing":
            return 1
    print(f"{named} of {len(PLANTED)} named, {flagged} flagged")
    return 0 if flagged == len(PLANTED) and named >= 15 else 1


if __name__ == "__main__":
    sys.exit(main())
