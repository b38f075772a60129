#!/usr/bin/env python3
"""uq_to_pov.py - write a UniQuadrix scene as a POV-Ray scene that shows the same picture.

    tools/uq_to_pov.py [--bound] SCENE.uq WIDTH HEIGHT [SHIFT_X SHIFT_Y] > scene.pov

It stands in for a person who models the scene a second time: it has its own reader, transforms and view, and shares
nothing with host/. It reads only what the committed scenes use (no `read`, no synonyms) and stops at anything else.

Window   The view must give whw and whh: fitting a picture's extent would need a resolver.
Dots     Dot (i, j) of the WIDTH x HEIGHT page is POV-Ray's pixel (i, j), each sampled at its centre; SHIFT_X and
         SHIFT_Y (dots, right and down) move the page under the samples.
Level    The pixel is the intensity itself, linear, 0 to 1: ambient plus parallel light times cosine, no shadows.
--bound  Adds a bounding box to every body, for timing: POV-Ray finds none by itself for a tilted cylinder.
"""
import itertools
import math
import re
import sys

TOKEN = re.compile(r"[A-Za-z_#][\w#]*|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|=[a-z0-9]+|[<>()!]")
NUMBER = re.compile(r"[-+]?[.\d]")
VIEW_KEYS = ("vrp", "vpn", "vup", "dop", "cop", "whh", "whw", "fbp")


# --- 4 x 4 matrices and vectors; row vectors, as Ressler's (3.3) ---

def multiply(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def identity():
    return [[float(i == j) for j in range(4)] for i in range(4)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def scaled(a, factor):
    return [x * factor for x in a]


def added(a, b):
    return [x + y for x, y in zip(a, b)]


def unit(a):
    return scaled(a, 1 / math.sqrt(dot(a, a)))


def elementary_inverse(name, value):
    """The inverse of one transform: planes and quadrics need nothing else, (3.4) and (3.7)."""
    m = identity()
    axes = [("xyz".index(c)) for c in name[2:] if c in "xyz"]
    if name == "=ta":
        m[3][:3] = [-value] * 3
    elif name[:2] == "=t":
        m[3][axes[0]] = -value
    elif name == "=sa":
        m[0][0] = m[1][1] = m[2][2] = 1 / value
    elif name[:2] == "=s":
        m[axes[0]][axes[0]] = 1 / value
    elif name[:2] == "=r":
        a, b = (axes[0] + 1) % 3, (axes[0] + 2) % 3
        c, s = math.cos(math.radians(-value)), math.sin(math.radians(-value))
        m[a][a], m[a][b], m[b][a], m[b][b] = c, s, -s, c
    elif name[:2] == "=v":
        m[axes[0]][axes[1]] = -value
    else:
        sys.exit(f"uq_to_pov: unknown transform {name}")
    return m


# --- reading ---

def statements(text):
    depth, plain = 0, []
    for character in text:
        if character == "{":
            depth += 1
        plain.append(" " if depth else character)
        if character == "}":
            depth -= 1
    for statement in "".join(plain).split(";"):
        tokens = TOKEN.findall(statement)
        if tokens:
            yield tokens


def numbers(tokens):
    return [float(t) for t in tokens if NUMBER.match(t)]


def take_id(tokens):
    """The optional id after a keyword; removes it."""
    return tokens.pop(0) if tokens and re.match(r"[A-Za-z_#]", tokens[0]) else None


def inverse_of(tokens):
    """The inverse of a row of transforms: the last one undone first."""
    m = identity()
    for name, value in zip(tokens[0::2], tokens[1::2]):
        m = multiply(elementary_inverse(name, float(value)), m)
    return m


def read_scene(path):
    scene = {"groups": {None: []}, "half_spaces": {}, "lights": [], "view": None}
    group = None
    for keyword, *rest in statements(open(path, encoding="utf-8").read()):
        if keyword == "definition":
            group = rest[0]
            scene["groups"][group] = []
        elif keyword == "enddef":
            group = None
        elif keyword in ("plane", "quadric"):
            name = take_id(rest)
            inside = rest[rest.index("<") + 1:rest.index(">")]
            scene["half_spaces"][group, name] = (keyword, numbers(inside), "=t" in rest)
        elif keyword == "light":
            take_id(rest)
            scene["lights"].append(numbers(rest))
        elif keyword == "view":
            if rest[0] not in VIEW_KEYS:
                take_id(rest)
            scene["view"] = read_view(rest)
        elif keyword in ("body", "instance", "array"):
            take_id(rest)
            scene["groups"][group].append((keyword, group, rest))
        else:
            sys.exit(f"uq_to_pov: {path}: unknown statement {keyword}")
    return scene


def read_view(tokens):
    view, options = {}, {}
    for token in tokens:
        if token.startswith("="):
            options[key] = token
        elif NUMBER.match(token):
            view[key].append(float(token))
        else:
            key = token
            view[key] = []
    origin = view.get("vrp", [0, 0, 0])
    for key, option in options.items():
        if key == "cop" and option == "=r":
            view[key] = added(origin, view[key])
        elif option == "=p":
            view[key] = added(view[key], scaled(origin, -1))
    return view


# --- flattening ---

def as_matrix(c):
    a, b, cc, d, e, f, g, h, j, k = c
    return [[a, d, f, g], [d, b, e, h], [f, e, cc, j], [g, h, j, k]]


def transformed(half_space, inverse):
    kind, c, transparent = half_space
    if kind == "plane":
        return kind, [dot(row, c) for row in inverse], transparent
    transpose = [list(column) for column in zip(*inverse)]
    return kind, multiply(multiply(inverse, as_matrix(c)), transpose), transparent


def bodies(scene, group, inverse):
    """Every body of the flattened scene: a list of (half-space in world coordinates, complement)."""
    for keyword, owner, tokens in scene["groups"][group]:
        if keyword == "body":
            yield body(scene, owner, tokens[1:-1], inverse)
            continue
        close = tokens.index(")")
        definition, initial = tokens[1], inverse_of(tokens[2:close])
        count = int(tokens[close + 1]) if keyword == "array" else 1
        delta = inverse_of(tokens[close + 2:])
        for _ in range(count):
            yield from bodies(scene, definition, multiply(inverse, initial))
            initial = multiply(delta, initial)


def body(scene, owner, tokens, inverse):
    result, complement = [], False
    for token in tokens:
        if token == "!":
            complement = True
        else:
            result.append((transformed(scene["half_spaces"][owner, token], inverse), complement))
            complement = False
    return result


# --- writing ---

def vector(v):
    return "<" + ", ".join(f"{x:.17g}" for x in v) + ">"


def pov_half_space(half_space, complement, clear):
    kind, c, transparent = half_space
    paint = " pigment { rgbt 1 }" if transparent and clear else ""
    inverse = " inverse" if complement else ""
    if kind == "plane":
        length = math.sqrt(dot(c[:3], c[:3]))
        return f"plane {{ {vector(scaled(c[:3], 1 / length))}, {-c[3] / length:.17g}{inverse}{paint} }}"
    squares = vector([c[0][0], c[1][1], c[2][2]])
    products = vector([2 * c[0][1], 2 * c[0][2], 2 * c[1][2]])
    linear = vector([2 * c[0][3], 2 * c[1][3], 2 * c[2][3]])
    return f"quadric {{ {squares}, {products}, {linear}, {c[3][3]:.17g}{inverse}{paint} }}"


def view_frame(view):
    vrp = view.get("vrp", [0.0, 0.0, 0.0])
    to_eye = added(view["cop"], scaled(vrp, -1)) if "cop" in view else view.get("dop", [0.3, 0.3, -1.0])
    vpn = unit(view.get("vpn", scaled(to_eye, -1)))
    right = unit(cross(view.get("vup", [0.0, 1.0, 0.0]), vpn))
    return vrp, to_eye, vpn, right, cross(vpn, right)


def camera(view, width, height, shift):
    vrp, to_eye, vpn, right, up = view_frame(view)
    if "whw" not in view or "whh" not in view:
        sys.exit("uq_to_pov: the view needs whw and whh")
    dots = min(width / (2 * view["whw"][0]), height / (2 * view["whh"][0]))  # per unit of length
    centre = added(vrp, added(scaled(right, shift[0] / dots), scaled(up, -shift[1] / dots)))
    if "cop" in view:
        kind, location = "perspective", view["cop"]
        ahead = added(centre, scaled(location, -1))
    else:
        back = 100 * max(width, height) / dots
        ahead = scaled(to_eye, 1 / dot(to_eye, vpn))
        kind, location = "orthographic", added(centre, scaled(ahead, -back))
    return (f"camera {{ {kind} location {vector(location)} direction {vector(ahead)}\n"
            f"  right {vector(scaled(right, width / dots))} up {vector(scaled(up, height / dots))} }}")


def clipping_planes(view):
    if "fbp" not in view:
        return []
    vrp, _, vpn, _, _ = view_frame(view)
    near, far = (dot(vpn, vrp) + d for d in view["fbp"])
    return [(("plane", scaled(vpn, -1) + [near], False), False), (("plane", vpn + [-far], False), False)]


def least_value(half_space, complement, centre, half):
    """A lower bound of the half-space's value (as used) over the box centre +- half."""
    kind, c, _ = half_space
    sign = -1 if complement else 1
    p = centre + [1.0]
    if kind == "plane":
        return sign * dot(c, p) - sum(abs(c[i]) * half for i in range(3))
    gradient = [dot(row, p) for row in c]
    slope = 2 * sum(abs(gradient[i]) * half for i in range(3))
    bend = sum(abs(c[i][j]) for i in range(3) for j in range(3)) * half * half
    return sign * dot(gradient, p) - slope - bend


def bounding_box(half_spaces, centre, half, depth):
    """A box around what may lie in the body: halve the cube, drop the octants that one half-space excludes."""
    if any(least_value(h, complement, centre, half) > 0 for h, complement in half_spaces):
        return None
    if depth == 0:
        return [x - half for x in centre], [x + half for x in centre]
    quarter = half / 2
    low, high = None, None
    for signs in itertools.product((-1, 1), repeat=3):
        part = bounding_box(half_spaces, [x + s * quarter for x, s in zip(centre, signs)], quarter, depth - 1)
        if part:
            low = part[0] if low is None else [min(a, b) for a, b in zip(low, part[0])]
            high = part[1] if high is None else [max(a, b) for a, b in zip(high, part[1])]
    return low and (low, high)


def write(scene, width, height, shift, bound, out):
    view = scene["view"]
    ambient = sum(light[0] for light in scene["lights"] if len(light) == 1)
    intensity, *direction = next((l for l in reversed(scene["lights"]) if len(l) == 4), [1.0, 0.0, 0.0, -1.0])
    out.write("#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb 0 }\n")
    out.write(camera(view, width, height, shift) + "\n")
    out.write(f"light_source {{ {vector(scaled(unit(direction), 1e5))} rgb 1 parallel point_at 0 shadowless }}\n")
    out.write(f"#default {{ pigment {{ rgb 1 }} finish {{ ambient {ambient!r} diffuse {intensity!r} }} }}\n")
    clip = clipping_planes(view)
    reach = 4 * max(view["whw"][0], view["whh"][0])
    for half_spaces in bodies(scene, None, identity()):
        half_spaces = half_spaces + clip
        clear = any(h[2] for h, _ in half_spaces)
        parts = "\n  ".join(pov_half_space(h, complement, clear) for h, complement in half_spaces)
        out.write("intersection {\n  " + parts)
        box = bound and bounding_box(half_spaces, view.get("vrp", [0.0, 0.0, 0.0]), reach, 7)
        out.write(f"\n  bounded_by {{ box {{ {vector(box[0])}, {vector(box[1])} }} }}" if box else "")
        out.write("\n}\n")


def main():
    arguments = sys.argv[1:]
    bound = "--bound" in arguments
    if bound:
        arguments.remove("--bound")
    if len(arguments) not in (3, 5):
        sys.exit("usage: uq_to_pov.py [--bound] SCENE.uq WIDTH HEIGHT [SHIFT_X SHIFT_Y]")
    path, width, height, *shift = arguments
    write(read_scene(path), int(width), int(height), [float(s) for s in shift] or [0.0, 0.0], bound, sys.stdout)


if __name__ == "__main__":
    main()
