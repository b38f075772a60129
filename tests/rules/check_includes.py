#!/usr/bin/env python3
"""check_includes.py [ROOT] - includes point one way, down the table of docs/architecture.md.

The core includes itself and freestanding headers of the language; nothing outside tests includes
tests, but for the report, whose errors are distances from the oracle.
"""
import sys

import cpp_text

# Folder: what its files may include, itself included. The longest folder that matches a file counts.
ALLOWED = {
    "firmware/core": ["firmware/core"],
    "firmware": ["firmware", "hal"],
    "hal": ["hal", "firmware/core/page.hpp"],
    "drivers": ["drivers", "hal", "firmware/core/page.hpp"],
    "sim": ["sim", "hal", "firmware/core/page.hpp"],
    "boards": ["boards", "firmware", "hal", "drivers"],
    "host": ["host", "firmware", "hal", "drivers", "sim"],
    "host/report": ["host", "firmware", "hal", "drivers", "sim", "tests/oracle"],
    "tests": ["tests", "host", "firmware", "hal", "drivers", "sim", "boards"],
}
# <algorithm> is not freestanding before C++26, but what allocates in it shows in the cross build.
FREESTANDING = {"algorithm", "array", "bit", "compare", "concepts", "cstddef", "cstdint", "limits", "span",
                "type_traits", "utility"}


def within(path, places):
    return any(path == place or path.startswith(place + "/") for place in places)


def folder_of(path):
    return max((f for f in ALLOWED if within(path, [f])), key=len)


def complaint(path, own, system):
    """What is wrong with one include, or None."""
    folder = folder_of(path)
    if system is not None:
        if folder == "firmware/core" and system not in FREESTANDING:
            return f"<{system}> is no freestanding header; the core has {', '.join(sorted(FREESTANDING))}"
        return None
    if not within(own, ALLOWED):
        return f'"{own}" does not start at the root of the tree'
    if not within(own, ALLOWED[folder]):
        return f'"{own}": {folder} may include {", ".join(ALLOWED[folder])} only'
    return None


def check(root):
    found = []
    for path in cpp_text.sources(root, *(f for f in ALLOWED if "/" not in f)):
        text = (root / path).read_text(encoding="utf-8")
        for line, own, system in cpp_text.includes(text):
            what = complaint(path.as_posix(), own, system)
            if what:
                found.append(f"{path}:{line}: error: {what}")
    return found


if __name__ == "__main__":
    sys.exit(cpp_text.run(check))
