#!/usr/bin/env python3
"""check_tokens.py [ROOT] - no floating point, heap, exception or RTTI in the text of firmware, hal, drivers and boards."""
import re
import sys

import cpp_text

FOLDERS = ["firmware", "hal", "drivers", "boards"]
WORDS = ("float double float_t double_t _Float16 _Float32 _Float64 __float128 new delete malloc calloc realloc free "
         "throw try catch dynamic_cast typeid")
FORBIDDEN = re.compile(r"\b(?:" + "|".join(WORDS.split()) + r")\b"
                       r"|(?<![\w.])(?:\d[\d']*\.[\d']*(?:[eE][-+]?\d+)?|\.\d[\d']*(?:[eE][-+]?\d+)?|\d[\d']*[eE][-+]?\d+)")
DELETED = re.compile(r"=\s*(delete)\s*;")  # a deleted function frees nothing


def check(root):
    found = []
    for path in cpp_text.sources(root, *FOLDERS):
        if path.suffix not in {".cpp", ".hpp", ".h", ".c"}:
            continue
        code = cpp_text.without_comments_and_strings((root / path).read_text(encoding="utf-8"))
        code = cpp_text.INCLUDE.sub("", code)
        code = DELETED.sub(lambda m: m.group().replace("delete", "      "), code)
        for match in FORBIDDEN.finditer(code):
            line = code.count("\n", 0, match.start()) + 1
            found.append(f"{path}:{line}: error: '{match.group()}' has no place on a device; the host may use it")
    return found


if __name__ == "__main__":
    sys.exit(cpp_text.run(check))
