"""Writes regions2.jsonl: the number of regions and every event of about sixty bodies.

    venv/bin/python regions2.py > regions2.jsonl

Method, independent of the crate: cusps are the certified roots of the degree-10 polynomial 4Q'P = 3P'Q and of the pair's
closed form; pitchforks are known; so all births and deaths of critical points are known exactly. Between two of them *all*
critical points at any rational x = l^2/2 come from the certified roots of l^4 p^3 D^2 = q^4 and of the pair's quartic
(exact.py), so each curve is followed by its rank in mu. In x the curves have slope dh/dx = 1/J. On an interval of x the
slope of a curve lies between those at its ends and at the extrema of J between them; two curves are then proved not to cross, or to cross once, by their values and slopes at the ends. Crossings are
then narrowed by the Illinois method. Crossings with the pole lines are counted a second time by the roots of the polynomial
((Q/2-R)P - Q^2/(2 J_r))^2 = r^2 P^3, and both counts must agree.
The range of x that is swept reaches from 1e-9 of the first to 1e9 times the last cusp, pitchfork or polynomial crossing, and from
1e-9 to 1e9 of the body's own scale at least.
Beside a cusp or pitchfork the sweep starts at a relative distance 1e-13; between these and the event the two curves
that are born there cannot cross (J is monotone through a cusp unless it is stationary there, which is checked).
Faces from Euler's formula on the graph of curves: regions = E - V + C - 1 with the half-plane closed by a frame.
Coincident curves (double curves, a pole line on a critical line) are one curve.
"""

import json
import random
import sys
from functools import reduce

from flint import arb, ctx, fmpq, fmpq_poly, fmpz

from exact import Body, digits, real_roots

ctx.dps = 55
rng = random.Random(1894)


def to_rational(ball, bits=120):
    """A rational near a ball."""
    man, exp = ball.mid().man_exp()
    man, exp = int(man), int(exp)
    drop = max(0, abs(man).bit_length() - bits)
    man, exp = man >> drop, exp + drop
    return fmpq(fmpz(man * 2**exp)) if exp >= 0 else fmpq(fmpz(man), fmpz(2 ** (-exp)))


class Sweep:
    """All curves of one body."""

    def __init__(self, body):
        self.body = body
        self.cache = {}
        self.cusps_mu = body.cusp_roots()
        self.straight = len(body.active) == 1
        if self.straight:
            self.cusps_mu = []
        self.stations = []  # (x, mu or s, what)
        for mu in self.cusps_mu:
            self.stations.append((body.generic(mu)[0] / 2, mu, ("cusp",)))
        for a in body.passive:
            p_hat, r_hat = body.hats(a)
            s = arb(p_hat).sqrt()
            self.stations.append((s * (a - r_hat / s**2) ** 2 / 2, a, ("pitchfork", a)))
            s = body.pair_cusp(a)
            if s is not None:
                self.stations.append((body.pair(a, s)[0] / 2, s, ("pair cusp", a)))
        self.stations.sort(key=lambda t: float(t[0]))
        # Where the generic family is cut into curves: active moments, cusps, pitchforks.
        self.cuts = sorted([arb(a) for a in body.active + body.passive] + self.cusps_mu, key=float)
        self.j_extrema = body.j_extrema() if not self.straight else []
        self.j_r = sum((a * w for a, w in body.weights.items()), fmpq(0)) / body.r2
        self.r = arb(body.r2).sqrt()
        self.poles = [] if self.straight else ["P-", "P+"]

    def at(self, x):
        """name -> (h, slope 1/J, place) of all curves at rational x."""
        if x in self.cache:
            return self.cache[x]
        found = {}
        for mu in self.body.generic_roots(2 * x):
            rank = sum(1 for c in self.cuts if c < mu)
            assert all((c < mu) or (c > mu) for c in self.cuts)
            _, h, _, j, _ = self.body.generic(mu)
            assert ("G", rank) not in found, "two points on one curve"
            # Consecutive curves of one branch may share a rank only on both sides of nothing: ranks are unique.
            found[("G", rank)] = (h, 1 / j, mu)
        for a in self.body.passive:
            cusp = self.body.pair_cusp(a)
            for s in self.body.pair_roots(a, 2 * x):
                rank = 0 if cusp is None or s < cusp else 1
                _, h, _, j, _ = self.body.pair(a, s)
                assert (str(a), rank) not in found
                found[(str(a), rank)] = (h, 1 / j, s)
        for name in self.poles:
            found[(name, 0)] = (x / self.j_r + (self.r if name == "P-" else -self.r), 1 / arb(self.j_r), None)
        self.cache[x] = found
        return found

    def slopes(self, name, p, q):
        """Enclosing pair of slopes of a curve between two of its points: those at the ends and at extrema of J between."""
        slopes = [p[1], q[1]]
        if name[0] == "G" and not self.straight:
            low, high = (p[2], q[2]) if p[2] < q[2] else (q[2], p[2])
            slopes += [1 / self.body.generic(m)[3] for m in self.j_extrema if not (m < low or m > high)]
        return reduce(arb.min, slopes), reduce(arb.max, slopes)

    def crossings(self, x1, x2, depth=0, names=None):
        """(x, name, name) of all crossings in (x1, x2)."""
        f, g = self.at(x1), self.at(x2)
        assert set(f) == set(g), (set(f) ^ set(g), float(arb(x1)), float(arb(x2)))
        if names is None:
            order = sorted(f)
            names = [(a, b) for n, a in enumerate(order) for b in order[:n]]
        open_pairs, found = [], []
        width = arb(x2 - x1)
        for a, b in names:
            d1, d2 = f[a][0] - f[b][0], g[a][0] - g[b][0]
            sa, sb = self.slopes(a, f[a], g[a]), self.slopes(b, f[b], g[b])
            assert (d1 > 0 or d1 < 0) and (d2 > 0 or d2 < 0)
            same = (d1 > 0) == (d2 > 0)
            low, high = sa[0] - sb[1], sa[1] - sb[0]
            if same:
                if not (d1 > 0):
                    d1, d2, low, high = -d1, -d2, -high, -low
                # d >= max(d1 + low t, d2 - high (w - t)): positive everywhere iff it is where these lines meet.
                if low >= 0 or high <= 0 or d1 + low * width > 0 or d2 - high * width > 0:
                    continue
                if d1 + low * ((d2 - d1 - high * width) / (low - high)) > 0:
                    continue
            elif low > 0 or high < 0:
                found.append((self.refine(x1, x2, d1, d2, a, b), a, b))
                continue
            if depth > 160:
                raise ArithmeticError(f"undecided {a} {b}")
            open_pairs.append((a, b))
        if not open_pairs:
            return found
        if x2 > 2 * x1:
            middle = to_rational(arb(x1 * x2).sqrt())
        else:
            middle = (x1 + x2) / 2
        return found + self.crossings(x1, middle, depth + 1, open_pairs) + self.crossings(middle, x2, depth + 1, open_pairs)

    def refine(self, x1, x2, d1, d2, a, b):
        """The only zero of h_a - h_b in (x1, x2), by the Illinois method; brackets it at every step."""
        side = 0
        for _ in range(60):
            x = to_rational(arb(x1) + arb(x2 - x1) * d1 / (d1 - d2))
            if not x1 < x < x2 or x2 - x1 < x1 * fmpq(1, 10**18):
                break
            here = self.at(x)
            d = here[a][0] - here[b][0]
            if abs(float(d)) < 1e-22 * (abs(float(here[a][0])) + float(self.r)):
                return x
            if (d > 0) == (d1 > 0):
                x1, d1 = x, d
                d2 = d2 / 2 if side == 1 else d2
                side = 1
            else:
                x2, d2 = x, d
                d1 = d1 / 2 if side == 2 else d1
                side = 2
        assert x2 - x1 < x1 * fmpq(1, 10**15)
        return (x1 + x2) / 2

    def pole_polynomial_roots(self):
        """x of all crossings of the generic family with the pole lines, by a polynomial."""
        b = self.body
        if self.straight:
            return []
        d2 = b.d * b.d
        big_r = fmpq_poly([0])
        mu = fmpq_poly([0, 1])
        for a in b.active:
            rest = fmpq_poly([1])
            for c in b.active:
                if c != a:
                    rest *= mu - c
            big_r += rest * b.weights[a]
        big_r = big_r * b.d  # R D^2
        left = (b.q / 2 - big_r) * b.p - b.q * b.q / (2 * self.j_r)  # times D^4
        polynomial = left * left - b.p**3 * d2 * b.r2  # times D^8
        return [b.generic(root)[0] / 2 for root in real_roots(polynomial)]

    def events(self):
        known = self.pole_polynomial_roots()
        scale = self.r * arb(max(map(float, self.body.a))) / 2
        marks = [t[0] for t in self.stations] + known + [scale]
        low, high = min(marks, key=float) / 10**9, max(marks, key=float) * 10**9
        small = arb(10) ** -13
        edges = [low]
        for x, _, _ in self.stations:
            edges += [x * (1 - small), x * (1 + small)]
        edges.append(high)
        found = []
        for n in range(0, len(edges), 2):
            self.cache.clear()
            found += self.crossings(to_rational(edges[n]), to_rational(edges[n + 1]))
        with_poles = sum(1 for _, a, b in found if (a[0] in ("P-", "P+") and b[0] == "G") or (b[0] in ("P-", "P+") and a[0] == "G"))
        assert with_poles == len(known), (with_poles, len(known))
        events = [("crossing", arb(x), [a, b]) for x, a, b in found]
        # The graph: curves on both sides of a station.
        for x, place, what in self.stations:
            before, after = self.at(to_rational(x * (1 - small))), self.at(to_rational(x * (1 + small)))
            events.append(("pitchfork" if what[0] == "pitchfork" else "cusp", x, (sorted(before), sorted(after))))
        return sorted(events, key=lambda e: float(e[1])), found, low, high

    def regions(self, events, found, low, high):
        """Euler's formula. Curves are pieces between stations, named by (name, number of the slab in which they start)."""
        stations = [e for e in events if e[0] != "crossing"]
        # Follow names through the slabs: a name is one curve for as long as it lives; ranks are fixed to branches and do
        # not shift, since cuts do not depend on x.
        slabs = []
        edges = [low] + [e[1] for e in stations] + [high]
        for n in range(len(edges) - 1):
            slabs.append(set(self.at(to_rational((edges[n] * edges[n + 1]).sqrt()))))
        names = sorted(set().union(*slabs))
        parent = {name: name for name in names}
        parent["frame"] = "frame"

        def root(c):
            while parent[c] != c:
                c = parent[c]
            return c

        def unite(a, b):
            parent[root(a)] = root(b)

        ends = 0
        for side in (slabs[0], slabs[-1]):
            for name in side:
                ends += 1
                unite(name, "frame")
        edges_count = len(names)
        for number, event in enumerate(stations):
            change = slabs[number] ^ slabs[number + 1]
            assert len(change) == (2 if event[0] == "cusp" else 3), (event, change)
            change = sorted(change)
            for name in change[1:]:
                unite(name, change[0])
        for _, a, b in found:
            edges_count += 2
            unite(a, b)
        vertices = len(events) + ends
        edges_count += ends
        components = sum(1 for c in parent if root(c) == c)
        return edges_count - vertices + components - 1


def decimal(x, places=4):
    return f"{x:.{places}e}"


def body_of(kind):
    a = [decimal(rng.uniform(0.5, 1.9)) for _ in range(3)]
    r = [decimal(rng.gauss(0, 1)) for _ in range(3)]
    order = [0, 1, 2]
    rng.shuffle(order)
    i, j, k = order
    if kind == "plane":
        r[i] = "0"
    elif kind == "near_plane":
        r[i] = decimal(rng.choice([1e-2, 1e-3, 1e-5]) * float(r[i]))
    elif kind == "near_axis":
        r[i] = decimal(float(r[i]) * 10 ** rng.uniform(-4, -1.5))
        r[j] = decimal(float(r[j]) * 10 ** rng.uniform(-4, -1.5))
    elif kind == "axis":
        r[i] = r[j] = "0"
    elif kind == "near_symmetric":
        a[i] = decimal(float(a[j]) * (1 + rng.choice([1e-2, -1e-3, 1e-4])), 9)
    elif kind == "symmetric":
        a[i] = a[j]
    elif kind == "equatorial":
        a[i] = a[j]
        r[k] = "0"
    elif kind == "rod":
        a[i] = decimal(10 ** rng.uniform(-4, -1.5))
    elif kind == "near_lagrange":
        a[i] = decimal(float(a[j]) * (1 + rng.choice([1e-1, -5e-2, 1e-2])), 9)
        r[i] = decimal(float(r[i]) * 10 ** rng.uniform(-3, -0.5))
        r[j] = decimal(float(r[j]) * 10 ** rng.uniform(-3, -0.5))
    elif kind == "lagrange":
        a[i] = a[j]
        r[i] = r[j] = "0"
    return a, r


def main():
    plan = [("generic", 12), ("plane", 10), ("near_plane", 6), ("near_axis", 8), ("axis", 6), ("near_symmetric", 6),
            ("symmetric", 4), ("equatorial", 4), ("rod", 6), ("near_lagrange", 8), ("lagrange", 4)]
    bodies = [("paper", ["2", "1.1", "1"], ["0.94868", "0", "0.61623"]), ("kovalevskaya", ["2", "2", "1"], ["1", "0", "0"]),
              ("ten points", ["0.57847392", "0.53739099", "1"], ["0.00595273", "0.00176367", "-0.99998073"])]
    for kind, count in plan:
        bodies += [(kind, *body_of(kind)) for _ in range(count)]
    for kind, a, r in bodies:
        try:
            sweep = Sweep(Body(a, r))
            events, found, low, high = sweep.events()
            regions = sweep.regions(events, found, low, high)
        except (AssertionError, ArithmeticError) as error:
            print("left out:", kind, a, r, repr(error), file=sys.stderr)
            continue
        listed = [dict(kind=e[0], l=digits((2 * e[1]).sqrt(), 15)) for e in events]
        print(json.dumps(dict(kind=kind, A=a, r=r, regions=regions, events=listed)), flush=True)


main()
