"""Adapters: each runs one engine from PyPI, with its own settings, on a model of the benchmark.

Each has the signature that heavytop.py describes. Engines that are not installed are left out.
"""
import importlib.metadata
import os

from heavytop import HERE, product, up


def torque(model, q, omega):
    """Euler's equations, A omega' = A omega x omega + m g (c x down), with down = -up: omega'."""
    a, c = model["inertia"], model["com"]
    u, pull = up(q), model["mass"] * model["gravity"]
    return [((a[i - 2] - a[i - 1]) * omega[i - 2] * omega[i - 1] - pull * (c[i - 2] * u[i - 1] - c[i - 1] * u[i - 2])) / a[i]
            for i in range(3)]


def right_hand_side(model):
    """y = (q, omega)."""
    def field(_time, y):
        w, x, y_, z, a, b, c = y
        return [-(x * a + y_ * b + z * c) / 2, (w * a + y_ * c - z * b) / 2, (w * b + z * a - x * c) / 2,
                (w * c + x * b - y_ * a) / 2, *torque(model, (w, x, y_, z), (a, b, c))]
    return field


def scipy(method):
    """scipy.integrate.solve_ivp on Euler's equations; `step` is its relative tolerance."""
    from scipy.integrate import solve_ivp

    def run(model, q0, omega0, times, step):
        done = solve_ivp(right_hand_side(model), (times[0], times[-1]), [*q0, *omega0], method=method, t_eval=times,
                         rtol=max(step, 2.3e-14), atol=step * 1e-2)
        return [(list(column[:4]), list(column[4:])) for column in done.y.T]
    return run


def heyoka():
    """heyoka's Taylor series on Euler's equations; `step` is its tolerance."""
    import heyoka as hy

    def run(model, q0, omega0, times, step):
        names = hy.make_vars("w", "x", "y", "z", "a", "b", "c")
        rates = right_hand_side(model)(0.0, names)
        integrator = hy.taylor_adaptive(list(zip(names, rates)), [*q0, *omega0], tol=step)
        *_, states = integrator.propagate_grid([float(t) for t in times])
        return [(list(row[:4]), list(row[4:])) for row in states]
    return run


def mujoco(integrator):
    """MuJoCo with a ball joint, read from MJCF; `step` is its time step."""
    import mujoco as mj

    def run(model, q0, omega0, times, step):
        engine = mj.MjModel.from_xml_path(os.path.join(HERE, "models", model["name"] + ".xml"))
        engine.opt.timestep = step
        engine.opt.integrator = getattr(mj.mjtIntegrator, "mjINT_" + integrator)
        data = mj.MjData(engine)
        data.qpos[:], data.qvel[:] = q0, omega0
        found, steps = [], 0
        for time in times:
            wanted = round(time / step)
            if wanted > steps:
                mj.mj_step(engine, data, nstep=wanted - steps)
            steps = max(steps, wanted)
            found.append((list(data.qpos), list(data.qvel)))
        return found
    return run


def pybullet():
    """Bullet's Featherstone multibody with a spherical joint, read from URDF, motor and damping off; `step`: its time step."""
    import pybullet as pb

    def run(model, q0, omega0, times, step):
        client = pb.connect(pb.DIRECT)
        try:
            pb.setGravity(0, 0, -model["gravity"])
            pb.setTimeStep(step)
            body = pb.loadURDF(os.path.join(HERE, "models", model["name"] + ".urdf"), useFixedBase=True,
                               flags=pb.URDF_USE_INERTIA_FROM_FILE)
            pb.setJointMotorControlMultiDof(body, 0, pb.POSITION_CONTROL, targetPosition=[0, 0, 0, 1], positionGain=0,
                                            velocityGain=0, force=[0, 0, 0])
            for link in (-1, 0):
                pb.changeDynamics(body, link, linearDamping=0, angularDamping=0, jointDamping=0, maxJointVelocity=1e9)
            # The joint's variables are in the principal axes of the inertia about the centre of mass.
            x, y, z, w = pb.getDynamicsInfo(body, 0)[4]
            axes, back = [w, x, y, z], [w, -x, -y, -z]
            w, x, y, z = product(product(back, q0), axes)
            pb.resetJointStateMultiDof(body, 0, [x, y, z, w], product(product(back, [0, *omega0]), axes)[1:])
            found, steps = [], 0
            for time in times:
                wanted = round(time / step)
                for _ in range(wanted - steps):
                    pb.stepSimulation()
                steps = max(steps, wanted)
                (x, y, z, w), omega = pb.getJointStateMultiDof(body, 0)[:2]
                found.append((product(product(axes, [w, x, y, z]), back), product(product(axes, [0, *omega]), back)[1:]))
            return found
        finally:
            pb.disconnect(client)
    return run


def classical():
    """Runge and Kutta's method of order 4 on Euler's equations in plain Python, the quaternion normalised; `step`: its step."""
    def run(model, q0, omega0, times, step):
        field = right_hand_side(model)
        y, steps, found = [*q0, *omega0], 0, []
        for time in times:
            wanted = round(time / step)
            for _ in range(wanted - steps):
                k1 = field(0, y)
                k2 = field(0, [v + step / 2 * k for v, k in zip(y, k1)])
                k3 = field(0, [v + step / 2 * k for v, k in zip(y, k2)])
                k4 = field(0, [v + step * k for v, k in zip(y, k3)])
                y = [v + step / 6 * (p + 2 * q + 2 * r + s) for v, p, q, r, s in zip(y, k1, k2, k3, k4)]
                length = sum(v * v for v in y[:4]) ** 0.5
                y[:4] = [v / length for v in y[:4]]
            steps = max(steps, wanted)
            found.append((y[:4], y[4:]))
        return found
    return run


FIXED = [0.004, 0.002, 0.001, 0.0005]
TOLERANCES = [1e-4, 1e-7, 1e-10, 1e-13]

#: Label, package, adapter, its arguments, steps or tolerances.
ALL = [
    ("MuJoCo Euler", "mujoco", mujoco, ("EULER",), FIXED),
    ("MuJoCo implicitfast", "mujoco", mujoco, ("IMPLICITFAST",), FIXED),
    ("MuJoCo RK4", "mujoco", mujoco, ("RK4",), FIXED),
    ("PyBullet", "pybullet", pybullet, (), FIXED),
    ("SciPy RK45", "scipy", scipy, ("RK45",), TOLERANCES[:3]),
    ("SciPy DOP853", "scipy", scipy, ("DOP853",), TOLERANCES),
    ("heyoka", "heyoka", heyoka, (), [1e-4, 1e-8, 1e-12, 1e-16]),
]


def installed():
    """Label with version, engine and its settings, of what is there."""
    for label, package, adapter, arguments, settings in ALL:
        try:
            version = importlib.metadata.version(package)
            yield f"{label} ({package} {version})", adapter(*arguments), settings
        except ImportError:
            continue
