"""The 24 tops of the benchmark in SI units, exact decimals, and their files for engines.

    python3 tops.py

writes models/NAME.json, NAME.urdf and NAME.xml (MJCF). README.md says in which frames everything is.
"""
import json
import os
from fractions import Fraction as F

HERE = os.path.dirname(os.path.abspath(__file__))
G = F("9.81")


def top(name, about, mass, com, inertia, down, omega, end, digits=16):
    """`inertia` about the fixed point, in principal axes; `down`: the direction of gravity at the start, in the body's axes."""
    return {"name": name, "about": about, "mass": F(mass), "com": [F(x) for x in com.split(",")],
            "inertia": [F(x) for x in inertia.split(",")], "down": [F(x) for x in down.split(",")],
            "omega": [F(x) for x in omega.split(",")], "end": F(end), "digits": digits}


TOPS = [
    top("euler-flip", "Euler: free, about the middle axis, which flips", "1", "0,0,0", "0.002,0.003,0.004", "0,0,-1", "0.002,3,0.001", "40"),
    top("euler-tumble", "Euler: free, far from every axis", "1", "0,0,0", "0.02,0.035,0.05", "0,0.6,-0.8", "4,1,3", "10", 100),
    top("lagrange-asleep", "Lagrange: upright and fast, a hair off", "0.5", "0,0,0.05", "0.003,0.003,0.001", "0.001,0,-1", "0,0,60", "10"),
    top("lagrange-nodding", "Lagrange: nutation without loops", "0.5", "0,0,0.05", "0.003,0.003,0.001", "0.6,0,-0.8", "2,0,40", "10"),
    top("lagrange-looping", "Lagrange: nutation with loops", "0.5", "0,0,0.05", "0.003,0.003,0.001", "0.6,0,-0.8", "-6,0,40", "10", 100),
    top("lagrange-cusps", "Lagrange: released with its axis at rest", "0.5", "0,0,0.05", "0.003,0.003,0.001", "0.6,0,-0.8", "0,0,40", "10"),
    top("lagrange-hanging", "Lagrange: spinning below the pivot", "0.5", "0,0,0.05", "0.003,0.003,0.001", "0.28,0,0.96", "1,2,10", "10"),
    top("kovalevskaya-1", "Kovalevskaya: A1 = A2 = 2 A3, r on the first axis", "1", "0.1,0,0", "0.06,0.06,0.03", "0.6,0,-0.8", "1,3,4", "10", 100),
    top("kovalevskaya-2", "Kovalevskaya, slower", "1", "0.1,0,0", "0.06,0.06,0.03", "0.28,0.96,0", "0.5,-2,1", "10"),
    top("goryachev-chaplygin", "Goryachev and Chaplygin: A1 = A2 = 4 A3, l = 0", "1", "0.09,0,0", "0.08,0.08,0.02", "0.8,0,-0.6", "1.5,2,8", "10"),
    top("paper-regular", "The paper's body, scaled: a fast regular motion", "1", "0.047434,0,0.0308115", "0.1,0.055,0.05", "0.6,0,0.8", "6,2,6", "10", 100),
    top("paper-chaotic", "The paper's body: a chaotic motion", "1", "0.047434,0,0.0308115", "0.1,0.055,0.05", "0.6,0.2,-0.8", "0.5,1,0.5", "10", 100),
    top("rod", "A thin rod, its end held", "0.3", "0,0,0.25", "0.025,0.025,0.00005", "0.6,0,0.8", "1,2,30", "10"),
    top("rod-still", "A thin rod as a spherical pendulum", "0.3", "0,0,0.25", "0.025,0.025,0.00001", "0.28,0,0.96", "3,1,0", "10"),
    top("plate", "A thin plate, pivot at its edge", "0.8", "0.1,0,0", "0.004,0.012,0.0159", "0.6,0.64,0.48", "2,1,3", "10"),
    top("plate-corner", "A thin plate, pivot at its corner, in principal axes", "0.8", "0.06,0.03,0", "0.004,0.012,0.0159", "0.36,0.48,-0.8", "1,2,4", "10"),
    top("nearly-equal", "Three moments within a thousandth", "1", "0.02,0.01,0.03", "0.01,0.01001,0.01002", "0.6,0,-0.8", "1,2,5", "10"),
    top("ball", "Three equal moments", "1", "0,0,0.03", "0.01,0.01,0.01", "0.6,0,-0.8", "1,2,5", "10"),
    top("large-spin", "A rotor at 6,000 rpm", "2", "0,0,0.08", "0.016,0.016,0.003", "0.6,0,-0.8", "0,0.1,628", "4"),
    top("slow-precession", "A gyroscope's wheel on an arm: a turn a minute", "1.5", "0,0,0.004", "0.006,0.006,0.009", "1,0,0", "0,0,60", "40"),
    top("upright", "Released a little off its unstable rest", "1", "0.02,0.01,0.1", "0.03,0.02,0.018", "-0.19611,-0.098,-0.98", "0,0.001,0", "10"),
    top("chaotic", "Three different moments, nothing special", "1.2", "0.05,-0.04,0.09", "0.05,0.04,0.03", "0.48,0.6,-0.64", "1,-2,3", "10", 100),
    top("hanging-small", "Small oscillations about the rest below", "1.2", "0.05,-0.04,0.09", "0.05,0.04,0.03", "0.46,-0.36,0.81", "0.1,-0.1,0.1", "20"),
    top("bracket", "A real part: a milled bracket of 180 g, pivot 40 mm below its centre of mass", "0.18", "0,0,0.04",
        "0.000317625,0.000319,0.00005625", "0.6,0,-0.8", "1,2,50", "10"),
]


def central(t):
    """The tensor about the centre of mass; a body with it exists."""
    c, m = t["com"], t["mass"]
    square = sum(x * x for x in c)
    tensor = [[(t["inertia"][i] if i == j else 0) - m * ((square if i == j else 0) - c[i] * c[j]) for j in range(3)] for i in range(3)]
    # The covariance of the mass, trace/2 - I, is positive semidefinite.
    half = sum(tensor[i][i] for i in range(3)) / 2
    s = [[(half if i == j else 0) - tensor[i][j] for j in range(3)] for i in range(3)]
    minors = [s[i][i] for i in range(3)] + [s[i][i] * s[j][j] - s[i][j] ** 2 for i, j in ((0, 1), (0, 2), (1, 2))]
    minors.append(s[0][0] * minors[5] - s[0][1] * (s[0][1] * s[2][2] - s[0][2] * s[1][2]) + s[0][2] * (s[0][1] * s[1][2] - s[0][2] * s[1][1]))
    assert min(minors) >= 0, (t["name"], [float(x) for x in minors])
    return tensor


def text(x):
    """The decimal, which is exact for these numbers."""
    value = repr(float(x))
    assert F(value) == x or len(value) > 15, x
    return value


URDF = """<?xml version="1.0"?>
<!-- {about}. The link's frame has its origin at the fixed point; z of the world is up. -->
<robot name="{name}">
  <link name="world"/>
  <joint name="pivot" type="spherical"><parent link="world"/><child link="top"/></joint>
  <link name="top">
    <inertial>
      <origin xyz="{com}"/>
      <mass value="{mass}"/>
      <inertia ixx="{xx}" iyy="{yy}" izz="{zz}" ixy="{xy}" ixz="{xz}" iyz="{yz}"/>
    </inertial>
  </link>
</robot>
"""

MJCF = """<!-- {about}. The body's frame has its origin at the fixed point; z of the world is up. -->
<mujoco model="{name}">
  <option gravity="0 0 -9.81"/>
  <worldbody>
    <body name="top">
      <joint name="pivot" type="ball"/>
      <inertial pos="{com}" mass="{mass}" fullinertia="{xx} {yy} {zz} {xy} {xz} {yz}"/>
    </body>
  </worldbody>
</mujoco>
"""


def main():
    for t in TOPS:
        tensor = central(t)
        entries = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
        words = {key: repr(float(tensor[i][j])) for key, (i, j) in entries.items()}
        words.update(name=t["name"], about=t["about"], mass=text(t["mass"]), com=" ".join(text(x) for x in t["com"]))
        model = {"name": t["name"], "about": t["about"], "gravity": 9.81, "mass": float(t["mass"]), "com": [float(x) for x in t["com"]],
                 "inertia": [float(x) for x in t["inertia"]], "inertia_com": [[float(x) for x in row] for row in tensor],
                 "omega0": [float(x) for x in t["omega"]], "end": float(t["end"])}
        base = os.path.join(HERE, "models", t["name"])
        with open(base + ".json", "w") as file:
            json.dump(model, file, indent=1)
            file.write("\n")
        for ending, form in ((".urdf", URDF), (".xml", MJCF)):
            with open(base + ending, "w") as file:
                file.write(form.format(**words))


if __name__ == "__main__":
    main()
