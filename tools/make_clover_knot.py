#!/usr/bin/env python3
"""make_clover_knot.py - print scenes/clover_knot.uq: a trefoil knot of 24 round tubes, mitred at every joint.

The axis is a closed polygon with corners on a trefoil. Each joint has one plane, through the corner and at right angles
to the sum of the two directions that meet there; the tube before it uses the plane and the tube after it its complement,
so that the seam is one surface. Two planes end a tube: 48 uses in all (Ressler's table 7.1 counts 72 for his).
"""
import math

TUBES = 24
RADIUS = 0.62
HEADER = """\
{ clover_knot.uq - a trefoil knot of 24 round tubes, mitred at every joint. Printed by tools/make_clover_knot.py:
  joint j<k> is the plane between tubes <k-1> and <k>, used by the one and complemented by the other. }
"""
FOOTER = """\

light glow 0.2;
light sun 0.8 -0.6 0.8 -1;
view front vrp 0 0.5 0 dop 0 0 -1 whw 3.5 whh 3.5;
"""


def corner(k):
    t = 2 * math.pi * (k + 0.5) / TUBES
    return [-math.sin(t) - 2 * math.sin(2 * t), 2 * math.cos(2 * t) - math.cos(t), -1.1 * math.sin(3 * t)]


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def direction(k):
    return unit([b - a for a, b in zip(corner(k), corner(k + 1))])


def cylinder(p, u):
    """|x - p|^2 - ((x - p).u)^2 - RADIUS^2 as A..K."""
    along = dot(p, u)
    squares = [1 - x * x for x in u]
    products = [-u[0] * u[1], -u[1] * u[2], -u[0] * u[2]]
    linear = [along * x - q for x, q in zip(u, p)]
    return squares + products + linear + [dot(p, p) - along * along - RADIUS * RADIUS]


def coefficients(values):
    return "<" + " ".join(f"{x:.15g}" for x in values) + ">"


def main():
    print(HEADER)
    for k in range(TUBES):
        n = unit([a + b for a, b in zip(direction(k - 1), direction(k))])
        print(f"plane j{k:02} {coefficients(n + [-dot(n, corner(k))])};")
    print()
    for k in range(TUBES):
        print(f"quadric c{k:02} {coefficients(cylinder(corner(k), direction(k)))};")
    print()
    for k in range(TUBES):
        print(f"body tube{k:02} (c{k:02} !j{k:02} j{(k + 1) % TUBES:02});")
    print(FOOTER, end="")


if __name__ == "__main__":
    main()
