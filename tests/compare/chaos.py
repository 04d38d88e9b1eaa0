"""Compares chaotic shares with another method by other software: pip install heyoka numpy; python3 chaos.py PROGRAM [POINTS] [ORBITS] [TIME] [STEPS]

At points (h, l) of the paper's body that are chosen at random, states are drawn in Liouville measure from random numbers, and
heyoka follows each with its variational equations until TIME (10,000), longer than `bifdiag chaos --steps STEPS` (20480) does. Where
ln|δ| has grown by more than 40 an orbit is chaotic, by less than 20 regular, else open. The shares must agree within three standard
errors of both, the open ones as a bracket; one in a hundred points may be beyond, none beyond five; at most 5 % may be open.
"""
import json
import resource
import subprocess
import sys
import time

import heyoka as hy
import numpy as np

A = np.array([2.0, 1.1, 1.0])
R = np.array([0.94868, 0.0, 0.61623])
RESCALED_EVERY = 50.0


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def children_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def integrator(lanes):
    names = [f"{kind}{i}" for kind in ("g", "l", "dg", "dl") for i in range(3)]
    variables = hy.make_vars(*names)
    g, l, dg, dl = (variables[3 * k:3 * k + 3] for k in range(4))
    w, dw = [x / a for x, a in zip(l, A)], [x / a for x, a in zip(dl, A)]
    add = lambda *terms: [sum(parts) for parts in zip(*terms)]
    minus = lambda u: [-x for x in u]
    rates = (
        cross(g, w)
        + add(cross(l, w), minus(cross(g, R)))
        + add(cross(dg, w), cross(g, dw))
        + add(cross(dl, w), cross(l, dw), minus(cross(dg, R)))
    )
    state = np.zeros((12, lanes))
    state[2] = 1.0
    return hy.taylor_adaptive_batch(list(zip(variables, rates)), state, tol=1e-15)


def states(h, l, count, random):
    """States in Liouville measure, by rejection: γ with the density J^(-1/2) on U < h, the direction uniform."""
    found = []
    while len(found) < count:
        g = random.normal(size=3)
        g /= np.linalg.norm(g)
        j = g @ (A * g)
        kinetic = h - l * l / (2 * j) + g @ R
        if kinetic < 0 or random.random() > np.sqrt(A.min() / j):
            continue
        # A basis of the plane across γ, made orthonormal in A^-1 by Cholesky.
        e = np.cross(g, [1.0, 0, 0] if abs(g[0]) < 0.7 else [0, 1.0, 0])
        basis = np.stack([e, np.cross(g, e)], axis=1)
        gram = basis.T @ (basis / A[:, None])
        basis = basis @ np.linalg.inv(np.linalg.cholesky(gram)).T
        angle = 2 * np.pi * random.random()
        m = np.sqrt(2 * kinetic) * basis @ [np.cos(angle), np.sin(angle)]
        momentum = l * A * g / j + m
        # A tangent vector along the surface: a random one, made orthogonal to the three gradients.
        normals = np.stack([np.r_[g, 0, 0, 0], np.r_[momentum, g], np.r_[-R, momentum / A]], axis=1)
        vector = random.normal(size=6)
        q, _ = np.linalg.qr(normals)
        vector -= q @ (q.T @ vector)
        found.append(np.r_[g, momentum, vector / np.linalg.norm(vector)])
    return np.array(found)


def growths(taylor, starts, time_to):
    lanes = taylor.state.shape[1]
    logs = []
    for begin in range(0, len(starts), lanes):
        batch = starts[begin:begin + lanes]
        taylor.set_time(np.zeros(lanes))
        taylor.state[:] = np.resize(batch, (lanes, 12)).T
        log = np.zeros(lanes)
        for end in np.arange(RESCALED_EVERY, time_to + 1, RESCALED_EVERY):
            taylor.propagate_until(np.full(lanes, end))
            size = np.linalg.norm(taylor.state[6:], axis=0)
            log += np.log(size)
            taylor.state[6:] /= size
            if (log > 60).all():
                break
        logs.extend(log[:len(batch)])
    return np.array(logs)


def main():
    program, *numbers = sys.argv[1:]
    points, orbits, time_to, steps = (int(x) for x in [*numbers, *(500, 64, 10_000, 20_480)[len(numbers):]])
    random = np.random.default_rng(41)
    taylor = integrator(hy.recommended_simd_size())
    beyond = [0, 0]
    compared, ours, theirs, opened, judged = 0, 0.0, 0.0, 0.0, 0
    while compared < points:
        h, l = round(random.uniform(-1, 9), 3), round(random.uniform(0, 5), 3)
        line = [program, "chaos", "--A", "2,1.1,1", "--r", "0.94868,0,0.61623", f"--h={h}", f"--l={l}", "--steps", str(steps), "--json", "--threads", "1"]
        begin = children_time()
        answer = subprocess.run(line, capture_output=True, text=True)
        if answer.returncode == 2:
            continue
        found = json.loads(answer.stdout)["components"]
        if len(found) > 1:
            # Here a state would have to be sorted into its component.
            continue
        ours += children_time() - begin
        begin = time.process_time()
        logs = growths(taylor, states(h, l, orbits, random), time_to)
        theirs += time.process_time() - begin
        compared += 1
        share = found[0]
        opened, judged = opened + share["open"], judged + share["orbits"]
        low, high = (logs > 40).mean(), (logs > 20).mean()
        p = (low * orbits + 1) / (orbits + 2)
        error = np.hypot(share["error"], np.sqrt(p * (1 - p) / (orbits + 3)))
        distance = max(share["fraction"] - high, low - share["fraction"] - share["open"], 0.0) / error
        beyond = [beyond[0] + (distance > 3), beyond[1] + (distance > 5)]
        print(f"({h}, {l}): {share['fraction']:.3f} + {share['open']:.3f} open, heyoka {low:.3f} to {high:.3f}: {distance:.1f} sigma", flush=True)
    print(f"{compared} points, beyond 3 sigma {beyond[0]}, beyond 5 sigma {beyond[1]}, open {100 * opened / compared:.1f} % in the mean")
    print(f"seconds of processor time: {ours:.1f} for {judged} orbits, heyoka {theirs:.1f} for {compared * orbits}")
    sys.exit(int(beyond[1] > 0 or 100 * beyond[0] > max(compared, 100) or opened > 0.05 * compared))


if __name__ == "__main__":
    main()
