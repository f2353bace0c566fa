# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The style checks find what they are for: each gets a small tree with a mistake, and without."""

import pathlib
import sys
import tempfile
import unittest

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "tools")]
import check_dependencies  # noqa: E402
import check_sources  # noqa: E402

HEADER = (
    f"// {check_sources.LICENCE}\n// Copyright (C) 2026 {check_sources.COPYRIGHT}\n\n"
    "#ifndef signorini_time_state_h\n#define signorini_time_state_h\n%s\n#endif\n"
)


class StyleChecks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def write(self, text, name="include/signorini/time/state.h"):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def findings(self, check):
        return len(list(check(self.root)))

    def expect_in_order(self):
        for check in (*check_sources.CHECKS.values(), check_dependencies.violations):
            self.assertEqual(self.findings(check), 0)

    def test_a_file_in_order(self):
        self.write(HEADER % "#include <signorini/base/types.h>")
        self.expect_in_order()

    def test_length(self):
        self.write(HEADER % ("\n" * check_sources.MAXIMUM_LINES))
        self.assertEqual(self.findings(check_sources.length), 1)

    def expect_limit(self, code, name="source/time/state.cc"):
        """A function is found with one line too many, and not without; `%s`: its statements."""
        others = len((code % "x").splitlines()) - 1
        for too_many in (0, 1):
            n_statements = check_sources.MAXIMUM_FUNCTION_LINES - others + too_many
            self.write(code % "\n".join(["    x = 1;"] * n_statements), name)
            self.assertEqual(self.findings(check_sources.functions), too_many, code)

    def test_functions(self):
        self.expect_limit("template <int dim>\nvoid State<dim>::f(const int a) const\n{\n%s\n}")
        self.expect_limit("State::State(int x)\n  : a(x)\n{\nif (x) { f({1}); }\n%s\n}")
        self.expect_limit("TEST(Suite, Name)\n{\n// }\nf('}', \"}\");\n#define x }\n%s\n}")

    def test_functions_of_python(self):
        self.expect_limit("def f(x):\n    def g():\n        return x\n%s", name="tools/f.py")

    def test_long_classes_and_tables_are_no_functions(self):
        lines = "\n" * check_sources.MAXIMUM_FUNCTION_LINES
        self.write(
            f"namespace a\n{{\nclass B : public C<int (*)()>\n{{\nvoid f() {{}}{lines}}};\n"
            f"const D d[] = {{ {lines} e() }};\nenum class F {{ g, {lines} h }};\n}}\n",
            name="source/time/state.cc",
        )
        self.assertEqual(self.findings(check_sources.functions), 0)

    def test_columns(self):
        names = ("doc/page.md", "dev", "tools/check.sh", ".ci/run", "a.prm", "a.ini", "a.bib")
        for number, name in enumerate(names, 1):
            self.write("x" * (check_sources.MAXIMUM_COLUMNS + 1), name=name)
            self.assertEqual(self.findings(check_sources.columns), number, name)

    def test_columns_of_tables_and_addresses(self):
        for exception in ("| a table |", "https://example.org/"):
            self.write(exception + "x" * check_sources.MAXIMUM_COLUMNS, name="doc/page.md")
            self.assertEqual(self.findings(check_sources.columns), 0)

    def test_folders(self):
        for number in range(check_sources.MAXIMUM_FILES + 1):
            self.assertEqual(self.findings(check_sources.folders), 0)
            self.write("x\n", name=f"doc/{number}.md")
            self.write("x\n", name=f"{number}.md")  # the top level may have more
            self.write("x\n", name=f"doc/pictures/{number % 2}.md")
        self.assertEqual(self.findings(check_sources.folders), 1)

    def test_guard_of_another_file(self):
        self.write(HEADER % "", name="include/signorini/time/newmark.h")
        self.assertEqual(self.findings(check_sources.guard), 1)

    def test_code_behind_the_guard(self):
        self.write(HEADER % "" + "int x;\n")
        self.assertEqual(self.findings(check_sources.guard), 1)

    def test_licence(self):
        self.write("int x;\n", name="source/time/state.cc")
        self.assertEqual(self.findings(check_sources.licence), 1)

    def test_names_of_schemes(self):
        self.write('info.name = "contact-implicit";\n', name="source/schemes/scheme_table.cc")
        self.write('// "contact-implicit" in a comment\nint x;\n', name="source/time/state.cc")
        self.assertEqual(self.findings(check_sources.schemes), 0)
        self.write('if (scheme == "contact-implicit")\n', name="source/time/state.cc")
        self.assertEqual(self.findings(check_sources.schemes), 1)

    def test_kinds_of_checks(self):
        self.write("usage\n  --debug [ARGS]  tests\n  --no-fma  others\n", name="tools/check.sh")
        self.write("    ./dev check --no-fma    # tests\n", name="CONTRIBUTING.md")
        self.assertEqual(self.findings(check_sources.kinds), 1)
        self.write("    ./dev check --debug\n    ./dev check --no-fma\n", name="CONTRIBUTING.md")
        self.assertEqual(self.findings(check_sources.kinds), 0)

    def test_outdated_documents(self):
        marks = "<!-- modules: by a program -->\n%s\n<!-- end of modules -->\n"
        self.write(marks % ("\n" + check_dependencies.table() + "\n"), name="CONTRIBUTING.md")
        self.assertEqual(list(check_dependencies.outdated(self.root, write=False)), [])
        self.write(marks % "an older table", name="CONTRIBUTING.md")
        self.assertEqual(len(list(check_dependencies.outdated(self.root, write=False))), 1)
        list(check_dependencies.outdated(self.root, write=True))
        self.assertEqual(list(check_dependencies.outdated(self.root, write=False)), [])

    def test_module_above(self):
        self.write(HEADER % "#include <signorini/contact/obstacle.h>")
        self.assertEqual(self.findings(check_dependencies.violations), 1)

    def test_source_of_a_module(self):
        self.write("#include <signorini/time/state.h>\n", name="source/contact/obstacle.cc")
        self.assertEqual(self.findings(check_dependencies.violations), 1)

    def test_unknown_module(self):
        self.write("int x;\n", name="source/utilities/tools.cc")
        self.assertEqual(self.findings(check_dependencies.violations), 1)

    def test_order_has_no_cycle(self):
        for module, used in check_dependencies.MAY_USE.items():
            for below in used:
                self.assertNotIn(module, check_dependencies.MAY_USE[below])


if __name__ == "__main__":
    unittest.main()
