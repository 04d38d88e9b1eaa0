"""The section and its variational equations: section 12."""
import sympy as sp
from sympy import Matrix

from common import A, a1, a2, a3, check, dot, t, vector, zero


@check("Proposition 12.1")
def _():
    g, l, r = [vector("g")], [vector("l")], vector("r")
    for k in range(3):
        om = [A.inv() * y for y in l]
        g.append(sum((g[j].cross(om[k - j]) for j in range(k + 1)), sp.zeros(3, 1)) / (k + 1))
        l.append((sum((l[j].cross(om[k - j]) for j in range(k + 1)), sp.zeros(3, 1)) - g[k].cross(r)) / (k + 1))
    gamma, L = (sum((y * t**k for k, y in enumerate(c)), sp.zeros(3, 1)) for c in (g, l))
    om = A.inv() * L
    residual = list(gamma.diff(t) - gamma.cross(om)) + list(L.diff(t) - L.cross(om) + gamma.cross(r))
    for F in residual:
        for k in range(3):
            zero(sp.diff(F, t, k).subs(t, 0))
    zero(l[0].cross(A.inv() * l[0])[0] - (a2 - a3) * (l[0][1] / a2) * (l[0][2] / a3))


@check("Proposition 12.2")
def _():
    g, l, r, dg, dl = (vector(c) for c in ("g", "l", "r", "c", "d"))
    om, dom = A.inv() * l, A.inv() * dl
    field = {}
    for name, rate in ((g, g.cross(om)), (l, l.cross(om) - g.cross(r)), (dg, dg.cross(om) + g.cross(dom)),
                       (dl, dl.cross(om) + l.cross(dom) - dg.cross(r))):
        field.update(zip(name, rate))
    rate = lambda F: sum(sp.diff(F, y) * f for y, f in field.items())
    for F in (dot(g, dg), dot(dg, l) + dot(g, dl), dot(om, dl) - dot(dg, r)):
        zero(rate(F))


@check("Proposition 12.3")
def _():
    g, l, r = vector("g"), vector("l"), vector("r")
    bracket = lambda H: (g.cross(Matrix([sp.diff(H, y) for y in l])),
                         g.cross(Matrix([sp.diff(H, y) for y in g])) + l.cross(Matrix([sp.diff(H, y) for y in l])))
    f, b = bracket(l[0] ** 2 / (2 * a1))
    e = Matrix([1, 0, 0])
    assert all(sp.expand(c) == 0 for c in f - g.cross(e) * l[0] / a1) and all(sp.expand(c) == 0 for c in b - l.cross(e) * l[0] / a1)
    f, b = bracket(-dot(g, r))
    assert f == sp.zeros(3, 1) and all(sp.expand(c) == 0 for c in b + g.cross(r))


@check("Proposition 12.4")
def _():
    hamilton = lambda p, q: (p[0] * q[0] - dot(p[1], q[1]), p[0] * q[1] + q[0] * p[1] + p[1].cross(q[1]))
    om, y = vector("o"), vector("y")
    one, two = hamilton((0, om), (0, y)), hamilton((0, y), (0, om))
    zero(one[0] - two[0])
    for i in range(3):
        zero((one[1] - two[1])[i] / 2 - om.cross(y)[i])


@check("Proposition 12.5")
def _():
    f, th, ps = (sp.Function(n)(t) for n in ("f", "th", "ps"))
    turn_z = lambda c: Matrix([[sp.cos(c), -sp.sin(c), 0], [sp.sin(c), sp.cos(c), 0], [0, 0, 1]])
    turn_x = lambda c: Matrix([[1, 0, 0], [0, sp.cos(c), -sp.sin(c)], [0, sp.sin(c), sp.cos(c)]])
    turn = turn_z(f) * turn_x(th) * turn_z(ps)
    spin = sp.simplify(turn.T * turn.diff(t))
    om = Matrix([spin[2, 1], spin[0, 2], spin[1, 0]])
    gamma = turn.T * Matrix([0, 0, 1])
    expected = Matrix([sp.sin(ps) * sp.sin(th), sp.cos(ps) * sp.sin(th), sp.cos(th)])
    assert sp.simplify(gamma - expected) == sp.zeros(3, 1)
    top = sp.simplify(om[0] * gamma[0] + om[1] * gamma[1])
    assert sp.simplify(top - f.diff(t) * sp.sin(th) ** 2) == 0
    assert sp.simplify((om[2] + top / (1 + gamma[2]) - (f + ps).diff(t)) * (1 + sp.cos(th))) == 0
    assert sp.simplify((-om[2] + top / (1 - gamma[2]) - (f - ps).diff(t)) * (1 - sp.cos(th))) == 0


@check("Proposition 12.6")
def _():
    B = sp.diag(2, 2, 1)
    g, o = vector("g"), vector("o")
    do = B.inv() * ((B * o).cross(o) - g.cross(Matrix([1, 0, 0])))
    dg = g.cross(o)
    K = (o[0] ** 2 - o[1] ** 2 + g[0]) ** 2 + (2 * o[0] * o[1] + g[1]) ** 2
    zero(sum(sp.diff(K, y) * f for y, f in zip(list(o) + list(g), list(do) + list(dg))))


@check("Proposition 12.7")
def _():
    g, l = vector("g"), vector("l")
    F = sp.Function("F")(*g, *l)
    dg, dl = (Matrix([sp.diff(F, y) for y in v]) for v in (g, l))
    field = list(zip(list(g) + list(l), list(g.cross(dl)) + list(g.cross(dg) + l.cross(dl))))
    assert sp.simplify(sum(sp.diff(f, y) for y, f in field)) == 0
    # |e×f|² for any e ⊥ γ and f = γ×A⁻¹e, normalised in A⁻¹, is det A/J.
    u = vector("u")
    square = lambda v: dot(v, A.inv() * v)
    e = g.cross(u)
    f = g.cross(A.inv() * e)
    zero(dot(e, A.inv() * f))
    across = e.cross(f)
    # |γ|² = 1 is left out of both sides: e×f is along γ.
    zero(dot(across, across) * dot(g, A * g) - a1 * a2 * a3 * square(e) * square(f) * dot(g, g))
