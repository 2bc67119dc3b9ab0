"""References from headers and from the stub: nothing public is missing, nothing private is there."""

import re
import unittest
from pathlib import Path

from headers import declarations, escaped, reference

ROOT = Path(__file__).resolve().parents[3]
HEADER = '''#pragma once

#include <vector>

namespace microslip {

class Later;

/// A value [m].
struct Value {
  double x; ///< along x
};

/// Two ways: `of_a` and of b_c.
int way(int a);
int way(double b,
        int c = {});

/// A template.
template <class Real> Real twice(Real a) {
  return 2 * a;
}

/// A class.
class Solver {
public:
  void solve() const { run(); }

private:
  void run();
  int hidden_ = 0;
};

enum class Kind { one, two };
using Function = int (*)(int);

} // namespace microslip
'''
C_HEADER = '''#ifndef X_H
#define X_H

#define X_VERSION 1

/* Some words
 * on two lines. */
typedef struct x_options {
  int a;                   /* [m] */
  int (*progress)(void*);  /* may be null */
} x_options;

/* Opaque. */
typedef struct x_solver x_solver;

/* Does it. */
X_API int x_solve(const x_options* options, double* results);

#endif
'''


class DeclarationsTest(unittest.TestCase):
    def test_cpp(self):
        found = declarations(HEADER)
        self.assertEqual([name for name, _, _ in found], ["Value", "way", "way", "twice", "Solver", "Kind", "Function"])
        prose = {name: text for name, text, _ in reversed(found)}
        self.assertEqual((prose["Value"], prose["way"]), ("A value [m].", "Two ways: `of_a` and of b_c."))
        code = {name: "\n".join(lines) for name, _, lines in found}
        self.assertEqual(code["twice"], "template <class Real> Real twice(Real a);")
        self.assertEqual(code["way"], "int way(double b,\n        int c = {});")
        self.assertIn("void solve() const", code["Solver"])
        self.assertNotIn("hidden_", code["Solver"])
        self.assertTrue(code["Solver"].endswith("};"))

    def test_c(self):
        found = declarations(C_HEADER)
        self.assertEqual([name for name, _, _ in found], ["x_options", "x_solver", "x_solve"])
        self.assertEqual(found[0][1], "Some words\non two lines.")

    def test_a_header_that_does_not_end_is_an_error(self):
        with self.assertRaisesRegex(ValueError, "struct A"):
            declarations("struct A {\n")

    def test_overloads_share_a_heading(self):
        made = reference(HEADER, "x.hpp", "cpp")
        self.assertEqual(made.count("### way"), 1)
        self.assertTrue(made.startswith("## x.hpp\n\n### Value\n\nA value \\[m\\].\n\n```cpp\nstruct Value {"))

    def test_prose_is_not_taken_for_markdown(self):
        self.assertEqual(escaped("a_b *c* [m] `d_e` x < y"), r"a\_b \*c\* \[m\] `d_e` x \< y")

    def test_every_declaration_of_the_library_has_a_name(self):
        count = 0
        for path in (ROOT / "microslip").rglob("*.hpp"):
            for name, _, code in declarations(path.read_text()):
                self.assertTrue(name or not code, f"{path}: {code}")
                count += 1
        self.assertGreater(count, 250)

    def test_every_function_of_the_c_header_is_there(self):
        text = (ROOT / "c" / "include" / "microslip.h").read_text()
        exported = set(re.findall(r"MICROSLIP_API [\w ]+?\*?\s*(microslip_\w+)\(", text))
        self.assertGreater(len(exported), 15)
        self.assertLessEqual(exported, {name for name, _, _ in declarations(text)})


if __name__ == "__main__":
    unittest.main()
