"""Periodic orbits of γ and l by SciPy: DOP853, variational equations, least squares. Writes periodic_orbits.jsonl.

From each imaginary pair of each relative equilibrium an orbit is followed over rising amplitudes at fixed l, without the
program: equilibria are roots of the field itself, found from random starts; the orbit is that at which (x(T) - x, |γ|² - 1,
⟨γ,l⟩ - l, H - h, a phase) vanishes in the sense of least squares. The sum of the nontrivial multipliers is tr M - 4.
"""

import json
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import null_space
from scipy.optimize import least_squares

BODIES = [
    (["2", "1.1", "1"], ["0.94868", "0", "0.61623"]),
    (["3", "2.2", "1.7"], ["0.3", "-0.5", "0.8"]),
    (["2", "2", "1"], ["1", "0", "0"]),
    (["1", "1.5", "2.2"], ["0", "0", "1"]),
]
MOMENTA = ["0.6", "1.9"]
AMPLITUDES = [0.02, 0.1, 0.25]


def top(moments, center):
    a = np.array([float(x) for x in moments])
    r = np.array([float(x) for x in center])

    def field(x):
        omega = x[3:] / a
        return np.concatenate([np.cross(x[:3], omega), np.cross(x[3:], omega) - np.cross(x[:3], r)])

    def hat(v):
        return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])

    def jacobian(x):
        omega, inverse = x[3:] / a, np.diag(1 / a)
        return np.block([
            [-hat(omega), hat(x[:3]) @ inverse],
            [hat(r), hat(x[3:]) @ inverse - hat(omega)],
        ])

    def energy(x):
        return 0.5 * np.dot(x[3:], x[3:] / a) - np.dot(x[:3], r)

    return a, r, field, jacobian, energy


def flow(field, jacobian, x, time):
    def right(_, y):
        return np.concatenate([field(y[:6]), (jacobian(y[:6]) @ y[6:].reshape(6, 6)).ravel()])

    start = np.concatenate([x, np.eye(6).ravel()])
    end = solve_ivp(right, (0, time), start, method="DOP853", rtol=1e-13, atol=1e-14).y[:, -1]
    return end[:6], end[6:].reshape(6, 6)


def closed(system, x, period, l, direction, amplitude, base):
    """The orbit through the plane at this amplitude along the direction."""
    _, _, field, jacobian, _ = system

    def equations(y):
        end, _ = flow(field, jacobian, y[:6], y[6])
        along = field(x)
        along /= np.linalg.norm(along)
        return np.concatenate([
            end - y[:6],
            [y[:3] @ y[:3] - 1, y[:3] @ y[3:6] - l, direction @ (y[:6] - base) - amplitude, along @ (y[:6] - x)],
        ])

    def derivative(y):
        end, tangent = flow(field, jacobian, y[:6], y[6])
        along = field(x)
        along /= np.linalg.norm(along)
        rows = np.zeros((10, 7))
        rows[:6, :6], rows[:6, 6] = tangent - np.eye(6), field(end)
        rows[6, :3] = 2 * y[:3]
        rows[7, :3], rows[7, 3:6] = y[3:6], y[:3]
        rows[8, :6], rows[9, :6] = direction, along
        return rows

    start = np.concatenate([x, [period]])
    found = least_squares(equations, start, derivative, xtol=1e-15, ftol=1e-15, gtol=1e-15, max_nfev=30)
    return found.x, np.abs(found.fun).max()


def equilibria(system, l):
    """Roots of the field with |γ| = 1 and ⟨γ,l⟩ = l: l = l Aγ/⟨γ,Aγ⟩, the gradient of U_l across γ vanishes."""
    a, r, *_ = system
    rng = np.random.default_rng(43)
    found = []

    def equations(g):
        n = g / np.linalg.norm(g)
        j = n @ (a * n)
        gradient = -(l**2) * a * n / j**2 - r
        return gradient - n * (n @ gradient) + (g @ g - 1) * n

    for _ in range(200):
        result = least_squares(equations, rng.normal(size=3), xtol=1e-15, ftol=1e-15, gtol=1e-15)
        g = result.x / np.linalg.norm(result.x)
        if np.abs(equations(g)).max() < 1e-12 and all(np.linalg.norm(g - other) > 1e-6 for other in found):
            found.append(g)
    return found


def main():
    lines = []
    for moments, center in BODIES:
        system = top(moments, center)
        a, _, field, jacobian, energy = system
        for momentum in MOMENTA:
            l = float(momentum)
            for gamma in equilibria(system, l):
                base = np.concatenate([gamma, l * a * gamma / (gamma @ (a * gamma))])
                linear = jacobian(base)
                frequencies = sorted({round(x.imag, 9) for x in np.linalg.eigvals(linear)
                                      if abs(x.real) < 1e-7 and x.imag > 1e-3})
                for frequency in frequencies:
                    exact = min((x.imag for x in np.linalg.eigvals(linear)), key=lambda x: abs(x - frequency))
                    plane = null_space(linear @ linear + exact**2 * np.eye(6), rcond=1e-7)
                    if plane.shape[1] != 2:
                        continue
                    direction, before = plane[:, 0], 0.0
                    x, period = base + 0.005 * direction, 2 * np.pi / exact
                    for amplitude in AMPLITUDES:
                        steps = np.linspace(before, amplitude, 4)[1:]
                        good = True
                        for step in steps:
                            y, residual = closed(system, x, period, l, direction, step, base)
                            # A period of nothing closes too.
                            good = residual < 1e-11 and y[6] > 0.5 * period
                            if not good:
                                break
                            x, period = y[:6] + direction * (amplitude - before) / 3, y[6]
                        if not good:
                            break
                        before = amplitude
                        _, tangent = flow(field, jacobian, y[:6], y[6])
                        lines.append({
                            "A": moments, "r": center, "l": momentum, "h": energy(y[:6]),
                            "equilibrium": list(gamma), "frequency": exact, "period": y[6],
                            "trace": np.trace(tangent) - 4, "gamma": list(y[:3]), "momentum": list(y[3:6]),
                        })
                        print(len(lines), moments, momentum, amplitude, y[6], residual, flush=True)
    target = Path(__file__).with_suffix(".jsonl")
    target.write_text("".join(json.dumps(line) + "\n" for line in lines))


if __name__ == "__main__":
    main()
