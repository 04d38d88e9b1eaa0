#!/usr/bin/env python3
"""The critical circles of Kovalevskaya's integral: kovalevskaya.py [H,L ...] > kovalevskaya.jsonl

A = (2, 2, 1), r = (1, 0, 0). On the energy surface E of (h, l) her integral K = (w1^2 - w2^2 + g1)^2 + (2 w1 w2 + g2)^2 is
critical along isolated periodic orbits, the circles of Fomenko's graphs. Each of them has a point where g1 = <g,r> is largest. So
they are found as critical points of K on the section P, S = <w, r x g> = 0: Newton's method for the multipliers of H, <g,Aw>,
|g|^2 and S, from random points of P, the set closed under the symmetries (g2,w2) -> -(g2,w2) and (g3,w3) -> -(g3,w3).

Three checks say that none is missing, and what they are:
- Of all critical points of K on P, those included where P only touches the flow, the indices sum to chi(P) = 2 chi(U) - 2 per pole
  of U; chi(U) is counted on a triangulated sphere.
- The value of K at each circle is one of those at which M. P. Kharlamov found the rank to drop (Appelrot's classes): 0 (I),
  (h - l^2/2)^2 (II and III), and 3s^2 - 4hs + h^2 + 1 (IV), where 4s^2(h - s) = l^2.
- A circle on which the second differential of K is definite is elliptic, else it is hyperbolic: the trace of its monodromy, by the
  variational equations, has to say the same.

Points are grouped into circles, and periods and traces found, by SciPy's DOP853. With points on the command line these are taken
instead of POINTS.
"""

import json
import sys

import numpy as np
from scipy.integrate import solve_ivp

# One point in each of the ten regions, and two at l = 0.
POINTS = [(1.62, 2.4), (0.5, 0.5), (0.7, 0.1), (1.5, 0.5), (2, 1.2), (1.635, 1.6), (1.767, 1.717), (1.822, 1.825), (2.158, 2.048),
          (2.628, 2.305), (0.5, 0), (2, 0)]
A = np.array([2.0, 2.0, 1.0])
FLIPS = [np.array(s, float) for s in ([1, 1, 1, 1, 1, 1], [1, -1, 1, 1, -1, 1], [1, 1, -1, 1, 1, -1], [1, -1, -1, 1, -1, -1])]


def field(_, z):
    g, w = z[:3], z[3:6]
    rate = np.concatenate([np.cross(g, w), np.array([w[1] * w[2] / 2, (-w[0] * w[2] - g[2]) / 2, g[1]])])
    if z.size == 6:
        return rate
    d = np.zeros((6, 6))
    d[:3, :3] = [[0, w[2], -w[1]], [-w[2], 0, w[0]], [w[1], -w[0], 0]]
    d[:3, 3:] = [[0, -g[2], g[1]], [g[2], 0, -g[0]], [-g[1], g[0], 0]]
    d[3, 4], d[3, 5] = w[2] / 2, w[1] / 2
    d[4, 3], d[4, 5], d[4, 2] = -w[2] / 2, -w[0] / 2, -0.5
    d[5, 1] = 1
    return np.concatenate([rate, (d @ z[6:].reshape(6, 6)).ravel()])


def values(z):
    """H, <g,Aw>, |g|^2, S and K."""
    g1, g2, g3, w1, w2, w3 = z
    a, b = w1 * w1 - w2 * w2 + g1, 2 * w1 * w2 + g2
    energy = w1 * w1 + w2 * w2 + w3 * w3 / 2 - g1
    return np.array([energy, 2 * (w1 * g1 + w2 * g2) + w3 * g3, z[:3] @ z[:3], g2 * w3 - g3 * w2, a * a + b * b])


def derivatives(z):
    """Their gradients and second derivatives."""
    g1, g2, g3, w1, w2, w3 = z
    a, b = w1 * w1 - w2 * w2 + g1, 2 * w1 * w2 + g2
    da, db = np.array([1, 0, 0, 2 * w1, -2 * w2, 0]), np.array([0, 1, 0, 2 * w2, 2 * w1, 0])
    first = np.array([
        [-1, 0, 0, 2 * w1, 2 * w2, w3],
        [2 * w1, 2 * w2, w3, 2 * g1, 2 * g2, g3],
        [2 * g1, 2 * g2, 2 * g3, 0, 0, 0],
        [0, w3, -w2, 0, -g3, g2],
        2 * a * da + 2 * b * db,
    ])
    second = np.zeros((5, 6, 6))
    second[0] = np.diag([0, 0, 0, 2, 2, 1])
    for i in range(3):
        second[1, i, i + 3] = second[1, i + 3, i] = A[i]
    second[2] = np.diag([2, 2, 2, 0, 0, 0])
    second[3, 1, 5] = second[3, 5, 1] = 1
    second[3, 2, 4] = second[3, 4, 2] = -1
    dda, ddb = np.diag([0.0, 0, 0, 2, -2, 0]), np.zeros((6, 6))
    ddb[3, 4] = ddb[4, 3] = 2
    second[4] = 2 * (np.outer(da, da) + np.outer(db, db) + a * dda + b * ddb)
    return first, second


def start(random, h, l):
    """A random point of P."""
    while True:
        g = random.normal(size=3)
        g /= np.linalg.norm(g)
        j = g @ (A * g)
        left = h - (0.5 * l * l / j - g[0])
        if left >= 0:
            v = np.cross(np.cross([1, 0, 0], g) / A, g)
            return np.concatenate([g, l * g / j + random.choice([-1, 1]) * np.sqrt(2 * left / (v @ (v / A))) * v / A])


def critical(z, h, l):
    """Newton's method for critical points of K on P: the point, its multipliers, and its index; else None."""
    first, _ = derivatives(z)
    m = np.linalg.lstsq(first[:4].T, first[4], rcond=None)[0]
    for _ in range(60):
        first, second = derivatives(z)
        residual = np.concatenate([first[4] - m @ first[:4], values(z)[:4] - [h, l, 1, 0]])
        jacobian = np.zeros((10, 10))
        jacobian[:6, :6] = second[4] - np.tensordot(m, second[:4], 1)
        jacobian[:6, 6:], jacobian[6:, :6] = -first[:4].T, first[:4]
        if np.linalg.norm(residual) < 1e-13:
            break
        try:
            step = np.linalg.solve(jacobian, residual)
        except np.linalg.LinAlgError:
            return None
        step *= min(1, 0.3 / max(np.linalg.norm(step), 1e-300))
        z, m = z - step[:6], m - step[6:]
        if np.abs(z).max() > 50:
            return None
    if np.linalg.norm(residual) > 1e-11:
        return None
    along = np.linalg.svd(first[:4])[2][4:]
    index = np.sign(np.linalg.det(along @ jacobian[:6, :6] @ along.T))
    return z, m, int(index)


def euler(h, l, n=96):
    """chi(P), from chi(U) on a triangulated octahedron and the poles +-r in U."""
    def effective(g):
        g = g / np.linalg.norm(g)
        return 0.5 * l * l / (g @ (A * g)) - g[0] <= h

    inside = {}
    for x in range(-n, n + 1):
        for y in range(abs(x) - n, n - abs(x) + 1):
            for z in {n - abs(x) - abs(y), abs(x) + abs(y) - n}:
                inside[x, y, z] = effective(np.array([x + 1e-4, y + 2e-4, z + 3e-4], float))
    total = sum(inside.values())
    edges, faces = set(), 0
    for sx in (1, -1):
        for sy in (1, -1):
            for sz in (1, -1):
                def at(i, j):
                    return sx * i, sy * j, sz * (n - i - j)

                for i in range(n):
                    for j in range(n - i):
                        triangles = [(at(i, j), at(i + 1, j), at(i, j + 1))]
                        if i + j < n - 1:
                            triangles.append((at(i + 1, j + 1), at(i + 1, j), at(i, j + 1)))
                        for triangle in triangles:
                            faces += all(inside[p] for p in triangle)
                            edges |= {frozenset(pair) for k in range(3) for pair in [(triangle[k], triangle[k - 1])] if all(inside[p] for p in pair)}
    poles = sum(effective(np.array([s, 0.0, 0.0])) for s in (1, -1))
    return int(2 * (total - len(edges) + faces) - 2 * poles)


def turning(z):
    """The derivative of S along the motion: negative where g1 is largest."""
    return derivatives(z)[0][3] @ field(0, z)


def circle(z):
    """The maxima of g1 on the circle through one of them, its period and the trace across it."""
    def crossing(_, y):
        return values(y[:6])[3]

    crossing.direction = -1
    y, now, maxima = np.concatenate([z, np.eye(6).ravel()]), 0.0, [z]
    while True:
        # A little further, so that the point itself is no crossing.
        ahead = solve_ivp(field, (0, 1e-3), y, "DOP853", rtol=1e-13, atol=1e-14).y[:, -1]
        crossing.terminal = True
        way = solve_ivp(field, (0, 200), ahead, "DOP853", rtol=1e-13, atol=1e-14, events=crossing)
        now += 1e-3 + way.t[-1]
        y = way.y[:, -1]
        if np.abs(y[:6] - z).max() < 1e-6:
            return maxima, now, np.trace(y[6:].reshape(6, 6)) - 4
        maxima.append(y[:6])
        assert len(maxima) < 20, z


def classes(h, l):
    yield 0.0, "I"
    yield (h - l * l / 2) ** 2, "II/III"
    for s in np.roots([-4, 4 * h, 0, -l * l]):
        if abs(s.imag) < 1e-9:
            yield 3 * s.real**2 - 4 * h * s.real + h * h + 1, "IV"


def circles(h, l, random):
    found, chi, rounds = [], euler(h, l), 0
    while rounds == 0 or (sum(index for _, _, index in found) != chi and rounds < 12):
        rounds += 1
        for _ in range(400):
            answer = critical(start(random, h, l), h, l)
            if answer is None:
                continue
            z, m, index = answer
            for flip in FLIPS:
                if all(np.abs(z * flip - other).max() > 1e-6 for other, _, _ in found):
                    found.append((z * flip, m, index))
    assert sum(index for _, _, index in found) == chi, (h, l, chi, [index for _, _, index in found])
    # Where the multiplier of S is 0, K is critical on E.
    points = [(z, index) for z, m, index in found if abs(m[3]) < 1e-7 and turning(z) < 0]
    answer = []
    while points:
        z, index = points[0]
        maxima, period, trace = circle(z)
        here = [k for k, (p, _) in enumerate(points) if any(np.abs(p - q).max() < 1e-5 for q in maxima)]
        assert len(here) == len(maxima), (h, l, z, maxima)
        assert {points[k][1] for k in here} == {index}
        points = [point for k, point in enumerate(points) if k not in here]
        value = values(z)[4]
        named = {name for k, name in classes(h, l) if abs(k - value) < 1e-8 * (1 + value)}
        assert len(named) == 1, (h, l, value, list(classes(h, l)))
        assert (index > 0) == (abs(trace) < 2), (h, l, z, trace)
        kind = "elliptic" if index > 0 else "hyperbolic" if trace > 2 else "inverse-hyperbolic"
        answer.append({"class": named.pop(), "k": float(value), "stability": kind, "period": float(period), "trace": float(trace),
                       "crossings": 2 * len(maxima), "gamma": z[:3].tolist(), "omega": z[3:].tolist()})
    answer.sort(key=lambda c: (c["crossings"], round(c["period"], 6)))
    return chi, answer


def main():
    points = [tuple(map(float, text.split(","))) for text in sys.argv[1:]] or POINTS
    for h, l in points:
        chi, found = circles(h, l, np.random.default_rng(0))
        print(json.dumps({"h": h, "l": l, "euler": chi, "circles": found}), flush=True)


if __name__ == "__main__":
    main()
