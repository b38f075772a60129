#!/usr/bin/env python3
"""test_povray.py HALFSPACE - gray pictures of three scenes agree with POV-Ray's of the same scenes.

Each scene is written a second time by tools/uq_to_pov.py, and POV-Ray samples it at every dot's centre and at the eight
points 1/16 dot around it. Where these nine levels are the same, give or take one, ours is within one level of 255 of the
centre's. Elsewhere (an outline or a seam runs past) nothing is asked; how many dots that are is printed and bounded.
"""
import itertools
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHIFTS = [(0.0, 0.0)] + [s for s in itertools.product((-0.0625, 0.0, 0.0625), repeat=2) if s != (0.0, 0.0)]
LEVELS = 255  # the highest one


def read_pnm(path):
    """(width, height, highest value, samples) of a binary PGM or PPM; of a PPM only the red samples."""
    data = pathlib.Path(path).read_bytes()
    fields, at = [], 0
    while len(fields) < 4:
        end = at
        while end < len(data) and data[end:end + 1].strip():
            end += 1
        if data[at:at + 1] == b"#":
            at = data.index(b"\n", at) + 1
        elif end > at:
            fields.append(data[at:end])
            at = end + 1
        else:
            at += 1
    magic, width, height, top = fields[0], int(fields[1]), int(fields[2]), int(fields[3])
    step = {b"P5": 1, b"P6": 3}[magic]
    if top > 255:
        samples = [256 * a + b for a, b in zip(data[at::2 * step], data[at + 1::2 * step])]
    else:
        samples = list(data[at::step])
    if len(samples) != width * height:
        raise ValueError(f"{path}: {len(samples)} samples instead of {width} x {height}")
    return width, height, top, samples


def povray_levels(folder, scene, width, height, shift=(0.0, 0.0)):
    """floor(255 * intensity) of every dot, from a 16-bit linear picture; a rounding step is added before the floor."""
    pov, ppm = os.path.join(folder, "scene.pov"), os.path.join(folder, "scene.ppm")
    with open(pov, "w", encoding="utf-8") as out:
        subprocess.run([sys.executable, ROOT / "tools/uq_to_pov.py", scene, str(width), str(height), *map(str, shift)],
                       check=True, stdout=out)
    drawn = subprocess.run(["povray", f"+I{pov}", f"+O{ppm}", "+FP16", f"+W{width}", f"+H{height}", "-A", "-D", "-GA",
                            "File_Gamma=1", "Dither=off"], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if drawn.returncode != 0:
        raise RuntimeError(drawn.stderr)
    _, _, top, samples = read_pnm(ppm)
    return [int((value + 0.5) * LEVELS / top) for value in samples]


def halfspace_levels(folder, scene, width, height):
    pgm = os.path.join(folder, "ours.pgm")
    subprocess.run([HALFSPACE, "render", scene, "-d", "gray", "--size", f"{width}x{height}", "-o", pgm, "--quiet"],
                   check=True, stdin=subprocess.DEVNULL)
    got_width, got_height, top, samples = read_pnm(pgm)
    assert (got_width, got_height, top) == (width, height, LEVELS), (got_width, got_height, top)
    return samples


def compare(ours, shifted):
    """(dots that POV-Ray is sure of, dots among them where ours is more than a level off)"""
    sure, wrong = 0, []
    for dot, (own, centre, low, high) in enumerate(zip(ours, shifted[0], map(min, *shifted), map(max, *shifted))):
        if high - centre <= 1 and centre - low <= 1:
            sure += 1
            if abs(own - centre) > 1:
                wrong.append(dot)
    return sure, wrong


class PovRayItself(unittest.TestCase):
    """POV-Ray samples where we think it does and returns the level that a sphere has by its formula."""

    SCENE = "quadric s <1 1 1 0 0 0 -0.5 -0.25 0 -0.6875>; body (s); light 0.25; light 0.75 -1 2 -2; view dop 0 0 -1 whw 2 whh 1.5;"

    def intensity(self, i, j, shift, width, height):
        scale = min(width / 4, height / 3)  # dots a unit
        x = (i + 0.5 - width / 2 + shift[0]) / scale - 0.5
        y = (height / 2 - j - 0.5 - shift[1]) / scale - 0.25
        if x * x + y * y > 1:
            return 0.0
        z = -math.sqrt(1 - x * x - y * y)
        return 0.25 + 0.75 * max(0.0, (-x + 2 * y - 2 * z) / 3)

    def test_every_dot_of_a_sphere(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "sphere.uq")
            pathlib.Path(scene).write_text(self.SCENE, encoding="utf-8")
            for width, height, shift in [(120, 90, (0, 0)), (121, 60, (0.0625, -0.0625)), (90, 90, (-0.5, 0.25))]:
                got = povray_levels(folder, scene, width, height, shift)
                for j, i in itertools.product(range(height), range(width)):
                    expected = LEVELS * self.intensity(i, j, shift, width, height)
                    self.assertLess(abs(got[j * width + i] + 0.5 - expected), 0.55, (i, j, shift, expected))


class Comparison(unittest.TestCase):
    """compare() can fail, and forgives only what is unsure."""

    def test_two_levels_off_is_wrong(self):
        self.assertEqual(compare([12, 11, 9], [[10, 10, 10]] * 9), (3, [0]))

    def test_an_outline_is_not_asked(self):
        self.assertEqual(compare([200, 200], [[10, 10]] * 8 + [[10, 90]]), (1, [0]))


class Scenes(unittest.TestCase):
    def check(self, name, width, height):
        scene = ROOT / "scenes" / name
        with tempfile.TemporaryDirectory() as folder:
            shifted = [povray_levels(folder, scene, width, height, shift) for shift in SHIFTS]
            ours = halfspace_levels(folder, scene, width, height)
        sure, wrong = compare(ours, shifted)
        lit = sum(1 for level in shifted[0] if level)
        print(f"{name:22} {width} x {height}: {lit} dots show a face, {len(ours) - sure} not asked, {len(wrong)} wrong")
        self.assertGreater(lit, len(ours) // 8)
        self.assertLess(len(ours) - sure, len(ours) // 20)
        at = [(dot % width, dot // width, ours[dot], shifted[0][dot]) for dot in wrong[:10]]
        self.assertEqual(wrong, [], f"the first (x, y, ours, POV-Ray's): {at}")

    def test_stack_of_bundles(self):
        self.check("stack_of_bundles.uq", 480, 640)

    def test_clover_knot(self):
        self.check("clover_knot.uq", 640, 480)

    def test_gear(self):
        self.check("gear.uq", 640, 480)

    def test_columns_in_perspective(self):
        self.check("columns.uq", 480, 400)

    def test_section(self):
        self.check("section.uq", 480, 360)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("usage: test_povray.py HALFSPACE [unittest's options]")
    HALFSPACE = os.path.abspath(sys.argv.pop(1))
    unittest.main()
