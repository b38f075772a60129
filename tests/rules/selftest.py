#!/usr/bin/env python3
"""selftest.py - each house rule's check fails on a planted violation, and lets its near miss pass."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import check_cross_build  # noqa: E402
import check_includes  # noqa: E402
import check_names  # noqa: E402
import check_tokens  # noqa: E402


def complaints(check, path, text):
    with tempfile.TemporaryDirectory() as folder:
        planted = pathlib.Path(folder, path)
        planted.parent.mkdir(parents=True)
        planted.write_text(text, encoding="utf-8")
        return check(pathlib.Path(folder))


class Includes(unittest.TestCase):
    def complaints(self, path, include):
        return complaints(check_includes.check, path, f"#include {include}\n")

    def test_pointing_back_is_found(self):
        for path, include in [("firmware/core/a.cpp", '"hal/a.hpp"'), ("firmware/core/a.cpp", '"host/a.hpp"'),
                              ("hal/a.hpp", '"firmware/core/engine.hpp"'), ("hal/a.hpp", '"drivers/a.hpp"'),
                              ("drivers/a.cpp", '"sim/a.hpp"'), ("sim/a.cpp", '"drivers/a.hpp"'),
                              ("boards/x/a.cpp", '"host/a.hpp"'), ("host/cli/a.cpp", '"tests/a.hpp"'),
                              ("host/cli/a.cpp", '"a.hpp"'), ("host/cli/a.cpp", '"tests/oracle/a.hpp"'),
                              ("host/report/a.cpp", '"tests/core/a.hpp"'), ("firmware/app/a.cpp", '"drivers/a.hpp"')]:
            with self.subTest(path=path, include=include):
                self.assertEqual(len(self.complaints(path, include)), 1)

    def test_pointing_down_passes(self):
        for path, include in [("firmware/core/a.cpp", '"firmware/core/b.hpp"'), ("hal/a.hpp", '"firmware/core/page.hpp"'),
                              ("drivers/a.cpp", '"hal/a.hpp"'), ("tests/core/a.cpp", '"tests/oracle/a.hpp"'),
                              ("host/cli/a.cpp", "<iostream>"), ("host/report/a.cpp", '"tests/oracle/a.hpp"'), ("firmware/core/a.cpp", "<cstdint>")]:
            with self.subTest(path=path, include=include):
                self.assertEqual(self.complaints(path, include), [])

    def test_hosted_headers_in_the_core_are_found(self):
        for header in ["<cmath>", "<vector>", "<string>", "<memory>", "<cstdio>", "<stdint.h>"]:
            self.assertEqual(len(self.complaints("firmware/core/a.hpp", header)), 1, header)

    def test_a_comment_includes_nothing(self):
        text = '// #include "host/a.hpp"\n/*\n#include <cmath>\n*/\n'
        self.assertEqual(complaints(check_includes.check, "firmware/core/a.hpp", text), [])


class Tokens(unittest.TestCase):
    def complaints(self, text, path="firmware/core/a.cpp"):
        return complaints(check_tokens.check, path, text)

    def test_each_word_is_found(self):
        for text in ["float a;", "long double a;", "auto p = new int;", "delete p;", "free(p);", "try {", "throw 1;",
                     "auto x = 1.5;", "auto x = 1e3;", "auto x = .5;", "typeid(x);", "dynamic_cast<A*>(p);"]:
            with self.subTest(text=text):
                self.assertGreaterEqual(len(self.complaints(text)), 1)

    def test_each_folder_is_read(self):
        for folder in ["firmware/app", "hal", "drivers/versatec", "boards/x"]:
            self.assertEqual(len(self.complaints("double a;", f"{folder}/a.hpp")), 1, folder)

    def test_comments_strings_and_deleted_functions_pass(self):
        for text in ["// a float\n", "/* new\ndouble */", 'auto s = "float \\" double";', "auto s = R\"x(new \")x\";",
                     "auto n = 1'000'000; // it's a try", "A(const A&) = delete;", "auto h = 0x1e3;", "int newest;",
                     "auto c = '\"'; int x; // double\n"]:
            with self.subTest(text=text):
                self.assertEqual(self.complaints(text), [])

    def test_code_after_a_separator_is_read(self):
        self.assertEqual(len(self.complaints("int a = 1'000; double b; char c = 'x';")), 1)


class Names(unittest.TestCase):
    def complaints(self, *texts):
        with tempfile.TemporaryDirectory() as folder:
            for number, text in enumerate(texts):
                planted = pathlib.Path(folder, ["firmware/core", "host/flatten", "sim"][number], "a.hpp")
                planted.parent.mkdir(parents=True)
                planted.write_text(f"namespace halfspace {{\n{text}\n}}\n", encoding="utf-8")
            return check_names.check(pathlib.Path(folder))

    def test_one_name_for_two_types_is_found(self):
        for text in ["class Real {\n};", "struct Real final : Base {\n};", "enum class Real { a };"]:
            with self.subTest(text=text):
                self.assertEqual(len(self.complaints("struct Real {\n};", "struct Ball {\n};", text)), 1)

    def test_declarations_comments_and_other_namespaces_pass(self):
        for text in ["struct Real;", "// struct Real {", "}\nnamespace halfspace::oracle {\nstruct Real {\n};", "class RealRow {\n};",
                     "struct Row {\n  struct Real {\n  };\n};"]:
            with self.subTest(text=text):
                self.assertEqual(self.complaints("struct Real {\n};", text), [])


class CrossBuild(unittest.TestCase):
    def complaints(self, text):
        return complaints(check_cross_build.check, "firmware/core/a.cpp", text)

    def test_floating_point_is_found(self):
        for text in ["float f(float a, float b) { return a * b; }", "double f(double a, double b) { return a / b; }",
                     "int f(double a) { return int(a); }", "float f(long long a) { return float(a); }",
                     "bool f(float a, float b) { return a < b; }"]:
            with self.subTest(text=text):
                self.assertNotEqual(self.complaints(text), [])

    def test_heap_and_runtime_are_found(self):
        for text in ["int* f() { return new int[4]; }", "void f(int* p) { delete p; }",
                     'extern "C" void* malloc(unsigned); void* f() { return malloc(3); }',
                     "struct A { A(); ~A(); int a; }; A a;", "struct A { virtual int f() = 0; A(); }; A::A() {}",
                     "#include <cmath>\n#error stop\n"]:
            with self.subTest(text=text):
                self.assertNotEqual(self.complaints(text), [])

    def test_wide_integers_pass(self):
        text = ("long long f(long long a, long long b) { return a / b + a * b + (a >> (b & 31)); }\n"
                "int g(int a, int b) { return a / b; }\n")
        self.assertEqual(self.complaints(text), [])

    def test_an_empty_core_is_found(self):
        self.assertNotEqual(complaints(check_cross_build.check, "firmware/core/a.hpp", "\n"), [])


if __name__ == "__main__":
    unittest.main()
