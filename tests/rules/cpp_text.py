"""cpp_text.py - C++ text without its comments and strings, for the checks of house rules."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = {".cpp", ".hpp", ".c", ".h", ".S", ".s"}

# A raw string ends at its own delimiter; a digit separator (1'000) is no character literal.
LEXEME = re.compile(
    r'R"(?P<mark>[^()\\ ]{0,16})\(.*?\)(?P=mark)"'
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9a-zA-Z_])'(?:\\.|[^'\\\n])+'"
    r"|//(?:\\\n|[^\n])*"
    r"|/\*.*?\*/",
    re.DOTALL)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"\n]*)"|<([^>\n]*)>)', re.MULTILINE)


def without_comments_and_strings(text):
    """The same text, blanked: line numbers stay."""
    return LEXEME.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)


def includes(text):
    """(line, own file or None, system header or None) of each include that is no comment."""
    code = LEXEME.sub(lambda m: m.group() if m.group()[0] == '"' else re.sub(r"[^\n]", " ", m.group()), text)
    for match in INCLUDE.finditer(code):
        yield code.count("\n", 0, match.end()) + 1, match.group(1), match.group(2)


def sources(root, *folders):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in SOURCES and path.is_file():
                yield path.relative_to(root)


def run(check):
    """The program of a check: `check(ROOT)` lists what it finds wrong, a line each; 1 if anything."""
    found = check(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT)
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0
