#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""make_reference.py [--check]: points of the flanks and fillets of the 27/79 pair, computed independently of the library.

Writes flank_reference.csv and fillet_reference.csv beside this script; with --check compares them with what it would write
and ends with 1 where they differ. Needs numpy with long doubles of more than 16 digits (x86); takes some seconds.

Nothing of source/gear is used, and other formulas (Litvin and Fuentes, Gear Geometry and Applied Theory, 2nd ed. 2004):
 - a point of the cutter has three parameters, the angle t about the cutter axis, the distance s along the blade (of a fillet: the
   angle lambda along the rounded edge) and the angle phi of the cradle. A chain of rotations and shifts takes it into the blank, X(t, s, phi);
 - it generates where it moves along the surface: (dX/dt x dX/ds) . dX/dphi = 0. The library has the relative velocity and normals by
   formulas of their own; here derivatives are complex steps, exact to round-off, and the normal is the cross product;
 - a pinion flank's ratio of roll is the one with which it touches the gear conjugately where phi = 0: both points generate, positions
   and tangent planes coincide, and the velocity between both members at the ratio of their teeth has no component along the normal.

Columns: flank; place in the grid (i along the face width, j from root to tip); L, h: along and above the pitch cone [mm];
t, phi [rad], s [mm] or lambda [rad]; position [mm] and unit normal into the metal in the blank's frame (z: axis, from apex to back).
"""

import sys
from pathlib import Path

try:
    import numpy as np
except ImportError:
    print("skipped: needs numpy")
    sys.exit(77)

REAL, COMPLEX = np.longdouble, np.clongdouble
PI = 4 * np.arctan(REAL(1))
DEGREE = PI / 180
STEP = REAL("1e-200")  # of complex steps: there is no difference that could lose digits
TEETH = {"pinion": 27, "gear": 79}
FACE = {"pinion": REAL("20.56"), "gear": REAL("72.10")}  # [deg]
ROOT = {"pinion": REAL("17.90"), "gear": REAL("69.44")}
ADDENDUM = {"pinion": REAL("3.34"), "gear": REAL("1.32")}  # at the mean cone distance [mm]
DEDENDUM = {"pinion": REAL("1.91"), "gear": REAL("3.94")}
DEPTH = {"pinion": REAL("0.5"), "gear": REAL("0.75")}  # parts of the dedendum down to which there are points
MEAN_CONE = REAL("116.49")
BLADE_ANGLE = 20 * DEGREE
CUTTER_DIAMETER = REAL("190.5")  # of the gear: between both blades, which spread by as much to either side
PITCH = {"pinion": np.arctan(REAL(27) / 79), "gear": np.arctan(REAL(79) / 27)}


class Flank:
    """Cutter and machine of one flank; tables of the paper with its contradictions settled (doc/theory/gear.md)."""

    def __init__(self, member, side, radius, radial, cradle, offset, base, back, edge):
        self.name = f"{member} {side}"
        self.member, self.sign = member, 1 if side == "concave" else -1  # outside blades cut concave flanks
        self.radius, self.radial, self.edge = REAL(radius), REAL(radial), REAL(edge)
        self.cradle = REAL(cradle) * DEGREE
        self.root = ROOT[member] * DEGREE
        self.offset, self.base, self.back = REAL(offset), REAL(base), REAL(back)
        # The cradle's and the blank's surfaces roll on each other along the pitch generatrix; of the pinion a first guess.
        self.ratio = np.cos(PITCH[member] - self.root) / np.sin(PITCH[member])

    def on_blade(self, s):
        """Distance from the cutter's axis and height above the tip plane of the straight blade."""
        return self.radius + self.sign * s * np.sin(BLADE_ANGLE), s * np.cos(BLADE_ANGLE)

    def on_edge(self, angle):
        """The same of the circle that touches the tip plane (angle 0) and the blade."""
        centre = self.radius - self.sign * self.edge * np.tan((PI / 2 - BLADE_ANGLE) / 2)
        return centre + self.sign * self.edge * np.sin(angle), self.edge * (1 - np.cos(angle))

    def place(self, profile, t, s, phi):
        """Of a point of the cutter in the blank."""
        radius, height = profile(s)
        # On the cradle: the cutter's centre stands at the cradle angle, z is the cradle's axis.
        x = self.radial * np.cos(self.cradle + phi) + radius * np.cos(t)
        y = self.radial * np.sin(self.cradle + phi) + radius * np.sin(t)
        z = height
        # From the blank's apex: sliding base along the cradle's axis, machine centre to back along the blank's.
        c, d = np.cos(self.root), np.sin(self.root)
        x, y, z = x - self.back * c, y - self.offset, z + self.base + self.back * d
        # Into the blank's frame, which has turned with the roll.
        along_x, along_y, along_z = d * x + c * z, -y, c * x - d * z
        turn = self.ratio * phi
        return np.array(
            [
                np.cos(turn) * along_x - np.sin(turn) * along_y,
                np.sin(turn) * along_x + np.cos(turn) * along_y,
                along_z,
            ]
        )

    def generate(self, profile, t, s, phi):
        """Position, unit normal into the metal, and the speed across the surface, which vanishes where it generates."""
        parameters = [t, s, phi]
        position = self.place(profile, *parameters)
        rates = []
        for k in range(3):
            moved = [COMPLEX(p) for p in parameters]
            moved[k] += 1j * STEP
            rates.append(self.place(profile, *moved).imag / STEP)
        normal = np.cross(rates[0], rates[1])
        normal = self.sign * normal / np.sqrt(normal @ normal)
        return position, normal, normal @ rates[2]

    def guess(self, cone_distance):
        """The cutter's angle where its tips pass the pitch generatrix, cradle in the middle."""
        x = cone_distance - self.radial * np.cos(self.cradle)
        return np.arctan2(-self.radial * np.sin(self.cradle), x)


def newton(equations, start):
    """Root of as many equations as unknowns: Jacobian by differences, residual in all digits."""
    x = np.array(start, dtype=REAL)
    for _ in range(60):
        residual = equations(x)
        jacobian = np.empty((len(x), len(x)))
        for k in range(len(x)):
            h = REAL("1e-7")
            up, down = x.copy(), x.copy()
            up[k] += h
            down[k] -= h
            jacobian[:, k] = (equations(up) - equations(down)) / (2 * h)
        step = np.linalg.solve(jacobian, residual.astype(float)).astype(REAL)
        x -= step * REAL("0.5") / max(REAL("0.5"), np.max(np.abs(step)))
        if np.max(np.abs(step)) < 1e-13:  # the next one would be smaller by the error of the Jacobian, 1e-8
            return x
    raise ArithmeticError("no convergence")


def cone_coordinates(member, position):
    """Along the pitch cone from the apex, and above it."""
    r = np.sqrt(position[0] ** 2 + position[1] ** 2)
    c, s = np.cos(PITCH[member]), np.sin(PITCH[member])
    return position[2] * c + r * s, r * c - position[2] * s


def about_z(angle, v):
    return np.array([np.cos(angle) * v[0] - np.sin(angle) * v[1], np.sin(angle) * v[0] + np.cos(angle) * v[1], v[2]])


def find_ratio(pinion, gear):
    """Ratio of roll with which the pinion's flank is conjugate to the gear's where its cradle stands in the middle."""
    # Axes meet at 90 degrees: the gear's is z, the pinion's x.
    axis_p, axis_g = np.array([REAL(1), 0, 0]), np.array([REAL(0), 0, 1])
    frame_p = np.array([[REAL(0), 0, 1], [0, -1, 0], [1, 0, 0]])
    speed = REAL(TEETH["pinion"]) / TEETH["gear"]

    def both(x):
        t1, s1, turn1, t2, s2, phi2, turn2, ratio = x
        pinion.ratio = ratio
        p1, n1, f1 = pinion.generate(pinion.on_blade, t1, s1, REAL(0))
        p2, n2, f2 = gear.generate(gear.on_blade, t2, s2, phi2)
        p1, n1 = frame_p @ about_z(turn1, p1), frame_p @ about_z(turn1, n1)
        return p1, n1, f1, about_z(turn2, p2), about_z(turn2, n2), f2

    def equations(x):
        p1, n1, f1, p2, n2, f2 = both(x)
        velocity = np.cross(axis_p, p2) + speed * np.cross(axis_g, p2)
        return np.array([*(p1 - p2), n1[1] + n2[1], n1[2] + n2[2], f1, f2, n2 @ velocity])

    # The start: the gear's point in the middle of its working depth, turned until the relative motion is along its flank; the
    # pinion's with the same normal and the same height.
    high = ADDENDUM["gear"]
    low = -ADDENDUM["pinion"]
    t2, s2, phi2 = point_at(gear, MEAN_CONE, (high + low) / 2)
    p, n, _ = gear.generate(gear.on_blade, t2, s2, phi2)

    def across(turn):
        q, m = about_z(turn, p), about_z(turn, n)
        return m @ (np.cross(axis_p, q) + speed * np.cross(axis_g, q))

    turns = np.linspace(-PI, PI, 721)
    values = [across(a) for a in turns]
    found = None
    for a, b, u, v in zip(turns[:-1], turns[1:], values[:-1], values[1:]):
        middle = (a + b) / 2
        if u * v < 0 and about_z(middle, p)[0] > 0:  # on the pinion's side
            while b - a > 1e-15:
                middle = (a + b) / 2
                a, b = (a, middle) if across(middle) * u < 0 else (middle, b)
            q, m = about_z(a, p), about_z(a, n)
            start = follow(pinion, frame_p.T @ q, -frame_p.T @ m, t2, s2, phi2, a)
            if start is None:
                continue
            try:
                x = newton(equations, start)
            except (ArithmeticError, np.linalg.LinAlgError):
                continue
            # On both flanks and near the middle; other solutions are none of gears.
            L, _ = cone_coordinates("gear", both(x)[3])
            if abs(L - MEAN_CONE) < 5 and 0 < x[1] < 10:
                found = x
    pinion.ratio = found[7]


def follow(pinion, position, normal, t2, s2, phi2, turn2):
    """Where the pinion's blade, cradle in the middle, has that axial component of the normal and that place."""
    best = None
    for t in np.linspace(-PI, PI, 2881):
        p, n, _ = pinion.generate(pinion.on_blade, t, REAL(3), REAL(0))
        # Two angles have that normal; the other one's point lies far from the blank's axis.
        away = np.hypot(p[0], p[1]) - np.hypot(position[0], position[1])
        miss = abs(n[2] - normal[2]) + abs(away) / 100
        if best is None or miss < best[0]:
            best = (miss, t, p)
    _, t1, p = best
    s1 = REAL(3)
    turn1 = np.arctan2(position[1], position[0]) - np.arctan2(p[1], p[0])
    # Linear in the ratio: two trials.
    trials = []
    for ratio in (REAL(2), REAL(4)):
        pinion.ratio = ratio
        trials.append(pinion.generate(pinion.on_blade, t1, s1, REAL(0))[2])
    ratio = 2 - 2 * trials[0] / (trials[1] - trials[0])
    return [t1, s1, turn1, t2, s2, phi2, turn2, ratio]


def point_at(flank, L, h):
    """t, s, phi of the point of the flank at these cone coordinates."""

    def equations(x):
        position, _, across = flank.generate(flank.on_blade, *x)
        here = cone_coordinates(flank.member, position)
        return np.array([here[0] - L, here[1] - h, across])

    return newton(equations, [flank.guess(L), DEDENDUM[flank.member] + h, REAL(0)])


def fillet_at(flank, L, angle):
    """t, phi of the point that the edge generates at this angle and cone distance."""

    def equations(x):
        position, _, across = flank.generate(flank.on_edge, x[0], angle, x[1])
        return np.array([cone_coordinates(flank.member, position)[0] - L, across])

    return newton(equations, [flank.guess(L), REAL(0)])


def number(value, digits):
    return np.format_float_positional(value, precision=digits, unique=False, trim="k")


def row(name, head, angles, more, position, normal):
    return ",".join(
        [name, *head]
        + [number(a, 12) for a in angles]
        + more
        + [number(x, 9) for x in position]
        + [number(n, 12) for n in normal]
    )


def make_tables():
    """Texts of both files."""
    spread = CUTTER_DIAMETER / 2 - REAL("94.26")
    outside = CUTTER_DIAMETER / 2 + spread
    flanks = [
        Flank("gear", "convex", "94.26", "107.42", "50.16", "0", "-0.50", "0", "0.8"),
        Flank("gear", "concave", outside, "107.42", "50.16", "0", "-0.50", "0", "0.8"),
        Flank("pinion", "concave", "94.01", "104.53", "-50.44", "1.41", "0.41", "-1.16", "0.5"),
        Flank("pinion", "convex", "96.18", "108.77", "-48.81", "-0.62", "0.10", "-0.13", "0.5"),
    ]
    find_ratio(flanks[2], flanks[0])
    find_ratio(flanks[3], flanks[1])

    flank_rows = ["flank,i,j,L,h,t_rad,phi_rad,s_mm,x,y,z,nx,ny,nz"]
    fillet_rows = ["flank,L,lambda_rad,t_rad,phi_rad,x,y,z,nx,ny,nz"]
    for flank in flanks:
        # From above the fillet to the tip, over the face width.
        above = np.tan(FACE[flank.member] * DEGREE - PITCH[flank.member])
        below = np.tan(PITCH[flank.member] - ROOT[flank.member] * DEGREE)
        for i in range(9):
            L = MEAN_CONE + (i - 4) * REAL("3.75")
            low = -DEPTH[flank.member] * (DEDENDUM[flank.member] + (L - MEAN_CONE) * below)
            high = ADDENDUM[flank.member] + (L - MEAN_CONE) * above
            for j in range(5):
                h = low + (high - low) * j / 4
                t, s, phi = point_at(flank, L, h)
                position, normal, _ = flank.generate(flank.on_blade, t, s, phi)
                head = [str(i), str(j), number(L, 6), number(h, 9)]
                flank_rows.append(row(flank.name, head, (t, phi), [number(s, 9)], position, normal))
        for L in (REAL("101.49"), MEAN_CONE, REAL("131.49")):
            # From the start of the straight blade to the root, which is left out: there the edge is a plane.
            for angle in (70 * DEGREE, 50 * DEGREE, 30 * DEGREE, 10 * DEGREE, REAL("1e-9")):
                t, phi = fillet_at(flank, L, angle)
                position, normal, _ = flank.generate(flank.on_edge, t, angle, phi)
                head = [number(L, 6), number(angle, 12)]
                fillet_rows.append(row(flank.name, head, (t, phi), [], position, normal))
    return {"flank_reference.csv": flank_rows, "fillet_reference.csv": fillet_rows}


def main():
    if np.finfo(REAL).eps > 1e-18:
        print("skipped: long doubles have no more digits than others here")
        return 77
    differ = False
    for name, rows in make_tables().items():
        path = Path(__file__).with_name(name)
        text = "\n".join(rows) + "\n"
        if sys.argv[1:] == ["--check"]:
            same = path.read_text() == text
            print(f"{name}: {'ok' if same else 'FAILED: differs from what make_reference.py writes'}")
            differ = differ or not same
        else:
            path.write_text(text)
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
