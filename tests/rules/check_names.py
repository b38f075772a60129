#!/usr/bin/env python3
"""check_names.py [ROOT] - no two headers define a type of one name: a program that links both would mix their inline functions."""
import re
import sys

import cpp_text

FOLDERS = ["firmware", "hal", "drivers", "sim", "host"]
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.MULTILINE)
TYPE = re.compile(r"^(?:struct|union|enum class|enum struct|class|enum) (?!class\b|struct\b)(\w+)[^;{}()]*\{", re.MULTILINE)


def check(root):
    found = []
    first = {}
    for path in cpp_text.sources(root, *FOLDERS):
        if path.suffix not in {".hpp", ".h"}:
            continue
        code = cpp_text.without_comments_and_strings((root / path).read_text(encoding="utf-8"))
        spaces = [(match.start(), match.group(1)) for match in NAMESPACE.finditer(code)]
        for match in TYPE.finditer(code):
            space = max((s for s in spaces if s[0] < match.start()), default=(0, ""))[1]
            line = code.count("\n", 0, match.start()) + 1
            earlier = first.setdefault((space, match.group(1)), path)
            if earlier != path:
                found.append(f"{path}:{line}: error: {earlier} defines {space}::{match.group(1)} too; give one another name")
    return found


if __name__ == "__main__":
    sys.exit(cpp_text.run(check))
