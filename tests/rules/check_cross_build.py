#!/usr/bin/env python3
"""check_cross_build.py [ROOT] - the core built for a Cortex-M0 asks for no floating point, heap or C++ runtime.

Every source of firmware/core is compiled as a board compiles it, and every symbol that an object leaves undefined is
looked at. Integer helpers of libgcc (division, wide multiplication and shifts) may be asked for.
"""
import concurrent.futures
import os
import re
import subprocess
import sys
import tempfile

import cpp_text

COMPILER = ["arm-none-eabi-g++", "-std=c++20", "-Os", "-mcpu=cortex-m0", "-mthumb", "-mfloat-abi=soft", "-ffreestanding",
            "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror"]
FORBIDDEN = re.compile(
    r"__aeabi_([fd]|c[fd]|u?[il]2[fd]|[fd]2)\w*"  # EABI: arithmetic, comparison, conversion
    r"|__(add|sub|neg|mul|div|cmp|eq|ne|lt|le|gt|ge|unord|pow|trunc|extend|fix|fixuns|float|floatun)(si|di|ti|sf|df|tf|xf|hf)+\d?"
    r"|(m|c|re)alloc|free|_sbrk"
    r"|_Zn[wa]\w*|_Zd[la]\w*"  # operator new, operator delete
    r"|(__aeabi_|__cxa_)?atexit"  # a static object with a destructor
    r"|__cxa_\w*|__gxx_\w*|_Unwind_\w*|_ZTI\w*|_ZSt\w*throw\w*")
INTEGER_HELPER = re.compile(r"__(mul|div|cmp|neg)(si|di|ti)\d?")


def forbidden_symbols(object_file):
    listed = subprocess.run(["arm-none-eabi-nm", "--undefined-only", "--format=posix", object_file],
                            check=True, capture_output=True, text=True).stdout
    symbols = [line.split()[0] for line in listed.splitlines()]
    return [s for s in symbols if FORBIDDEN.fullmatch(s) and not INTEGER_HELPER.fullmatch(s)]


def check_source(root, path):
    with tempfile.TemporaryDirectory() as folder:
        object_file = os.path.join(folder, "source.o")
        built = subprocess.run(COMPILER + ["-I", root, "-c", root / path, "-o", object_file],
                               capture_output=True, text=True)
        if built.returncode != 0:
            return [f"{path}: error: does not build for a Cortex-M0\n{built.stderr}"]
        return [f"{path}: error: the Cortex-M0 build asks for {s}" for s in forbidden_symbols(object_file)]


def check(root):
    paths = [p for p in cpp_text.sources(root, "firmware/core") if p.suffix == ".cpp"]
    if not paths:
        return ["firmware/core: error: no source found"]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return [line for lines in pool.map(lambda p: check_source(root, p), paths) for line in lines]


if __name__ == "__main__":
    sys.exit(cpp_text.run(check))
