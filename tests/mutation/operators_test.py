#!/usr/bin/python3
"""Each operator on made-up code: the places it takes and those it must leave alone."""
import re
import unittest

import operators
from cpp_source import Source


def in_function(body):
    return f"void f() {{\n{body}\n}}\n"


class Operators(unittest.TestCase):
    """What an operator makes of the lines of a function, with 7 for every number."""

    def made(self, operator, code):
        found = []
        for place in operator(Source(code)):
            new = code[:place.begin] + place.replacement(7) + code[place.end:]
            found.append(next(line for a, line in zip(code.split("\n") + [""], new.split("\n"))
                              if a != line).strip())
        return found

    def makes(self, operator, line, *expected):
        self.assertEqual(list(expected), self.made(operator, in_function(line)))

    def leaves(self, operator, code, alone=False):
        self.assertEqual([], self.made(operator, code if alone else in_function(code)))

    def test_a_comparison_is_flipped_as_a_whole(self):
        flipped = operators.comparison_flipped
        self.makes(flipped, "if (a < b) g();", "if (((a < b) != remeshd_mutant(7))) g();")
        self.makes(flipped, "return x.y(1, 2) == z[i - 1];",
                   "return ((x.y(1, 2) == z[i - 1]) != remeshd_mutant(7));")
        self.makes(flipped, "ok = p && a + 1 >= b;", "ok = p && ((a + 1 >= b) != remeshd_mutant(7));")
        self.makes(flipped, "x = a != b ? c : d;", "x = ((a != b) != remeshd_mutant(7)) ? c : d;")
        self.makes(flipped, "g(a, b < c, d);", "g(a, ((b < c) != remeshd_mutant(7)), d);")

    def test_a_comparison_of_comparisons_is_taken_by_precedence(self):
        self.makes(operators.comparison_flipped, "x = a < b == c;",
                   "x = ((a < b) != remeshd_mutant(7)) == c;",
                   "x = ((a < b == c) != remeshd_mutant(7));")

    def test_a_comparison_in_a_lambda_is_one(self):
        self.makes(operators.comparison_flipped, "sort(v, [](A a, A b) { return a.x < b.x; });",
                   "sort(v, [](A a, A b) { return ((a.x < b.x) != remeshd_mutant(7)); });")

    def test_what_is_no_comparison_is_left(self):
        for line in ("std::vector<int> v;", "auto x = static_cast<int>(y);", "std::cout << a;",
                     "// a < b", "const char* s = \"a < b\";", "const char* s = R\"(a < b)\";",
                     "return a <=> b;", "x = a & b;", "std::map<int, std::vector<int>> m;"):
            self.leaves(operators.comparison_flipped, line)
        self.leaves(operators.comparison_flipped, "#if A < B\n#endif")

    def test_an_extent_that_is_not_sure_is_left(self):
        self.leaves(operators.comparison_flipped, "x = a & b == c;")
        self.leaves(operators.comparison_flipped, "x = a <=> b == c;")

    def test_what_the_compiler_evaluates_is_left(self):
        for line in ("static_assert(a < b);", "constexpr bool x = a < b;", "if constexpr (a < b) g();",
                     "g<(a < b)>();", "assert(a < b);", "using A = decltype(a < b);"):
            self.leaves(operators.comparison_flipped, line)
        self.leaves(operators.comparison_flipped, "template <int n, bool = (n < 3)>\nvoid f();", True)
        self.leaves(operators.comparison_flipped, "consteval bool f(int a) { return a < 3; }", True)
        self.leaves(operators.comparison_flipped, "static const bool kX = a < b;", True)

    def test_a_constexpr_function_has_a_mutant_that_the_compiler_evaluates(self):
        code = "constexpr bool f(int a) { return a < 3; }"
        self.assertEqual(
            ["constexpr bool f(int a) { return ((a < 3) != remeshd_constexpr_mutant(7)); }"],
            self.made(operators.comparison_flipped, code))

    def test_default_arguments_and_members_are_left(self):
        self.leaves(operators.comparison_flipped, "void f(bool x = a < b);", True)
        self.leaves(operators.comparison_flipped, "void f(bool x = a < b) { g(); }", True)
        self.leaves(operators.comparison_flipped, "struct A { bool x = a < b; };", True)
        self.leaves(operators.comparison_flipped, "auto g = [](bool x = a < b) { return x; };")
        self.leaves(operators.truth_flipped, "class A { void f(bool x = true); };", True)

    def test_bodies_of_all_kinds_are_taken(self):
        for code in ("A::A(int a) : a_(a), b_{a} { x = a < b; }",
                     "struct A { bool f() const noexcept { return a < b; } };",
                     "template <class T>\nbool f(T a) { return a < b; }",
                     "namespace n { namespace { bool f() { return a < b; } } }",
                     "auto f() -> bool { return a < b; }",
                     "void f() { switch (a) { case 1: { x = a < b; } } }",
                     "void f() { try { x = a < b; } catch (...) {} }",
                     "void f() { g([&] { return a < b; }); }",
                     "void f() { g([=]() mutable -> bool { return a < b; }); }",
                     "A f() { return {a < b, 1}; }"):
            self.assertEqual(1, len(self.made(operators.comparison_flipped, code)), code)

    def test_a_bound_takes_in_or_leaves_out_what_equals_it(self):
        moved = operators.bound_moved
        self.makes(moved, "for (int k = 0; k < n; ++k) g();",
                   "for (int k = 0; (remeshd_mutant(7) ? (k <= n) : (k < n)); ++k) g();")
        self.makes(moved, "return a >= b;", "return (remeshd_mutant(7) ? (a > b) : (a >= b));")
        self.leaves(moved, "return a == b;")

    def test_one_is_left_out(self):
        off = operators.off_by_one
        self.makes(off, "x = a + 1;", "x = a + (remeshd_mutant(7) ? 0 : 1);")
        self.makes(off, "g(v[n - 1]);", "g(v[n - (remeshd_mutant(7) ? 0 : 1)]);")
        for line in ("x = a + 10;", "x = a + 1.0;", "x = -1;", "x += 1;", "g(a, -1);",
                     "std::array<int, n + 1> a;", "constexpr int kX = n + 1;"):
            self.leaves(off, line)
        self.makes(off, "switch (x) { case n + 1: return a - 1; }",
                   "switch (x) { case n + 1: return a - (remeshd_mutant(7) ? 0 : 1); }")

    def test_a_loop_begins_one_early_or_late(self):
        off = operators.off_by_one
        self.makes(off, "for (int k = 1; k < n; ++k) g();",
                   "for (int k = (remeshd_mutant(7) ? 0 : 1); k < n; ++k) g();")
        self.makes(off, "for (int k = 0, m = 5; k < n; ++k) g();",
                   "for (int k = (remeshd_mutant(7) ? 1 : 0), m = 5; k < n; ++k) g();")
        self.leaves(off, "int k = 1;")

    def test_a_branch_is_always_or_never_taken(self):
        self.makes(operators.branch_taken, "if (a || b) g();",
                   "if (remeshd_mutant(7) || (a || b)) g();")
        self.makes(operators.branch_skipped, "if (p) g();", "if (!remeshd_mutant(7) && (p)) g();")
        self.makes(operators.branch_taken, "if (int n = g(); n > 0) h(n);",
                   "if (int n = g(); remeshd_mutant(7) || (n > 0)) h(n);")
        self.makes(operators.branch_skipped, "do g(); while (a);",
                   "do g(); while (!remeshd_mutant(7) && (a));")
        self.leaves(operators.branch_taken, "while (a) g();")

    def test_a_condition_that_declares_is_left(self):
        for operator in (operators.branch_taken, operators.branch_skipped):
            self.leaves(operator, "if (const int* p = g()) h(p);")
            self.leaves(operator, "if (auto [a, b] = g(); auto c = a) h(p);")
            self.leaves(operator, "if constexpr (a) g();")

    def test_one_of_two_conditions_is_dropped(self):
        dropped = operators.condition_dropped
        self.makes(dropped, "if (a && b) g();",
                   "if (((remeshd_mutant(7) || (a)) && b)) g();",
                   "if ((a && (remeshd_mutant(7) || (b)))) g();")
        self.makes(dropped, "x = a || b && c;",
                   "x = ((!remeshd_mutant(7) && (a)) || b && c);",
                   "x = (a || (!remeshd_mutant(7) && (b && c)));",
                   "x = a || ((remeshd_mutant(7) || (b)) && c);",
                   "x = a || (b && (remeshd_mutant(7) || (c)));")
        self.assertEqual(3, len(self.made(dropped, in_function("x = a && b && c;"))))

    def test_a_reference_is_no_condition(self):
        for line in ("for (auto&& a : v) g(a);", "const auto g = [](A&& a, B&& b) { h(a); };",
                     "A&& a = g();"):
            self.leaves(operators.condition_dropped, line)

    def test_neighbours_of_one_form_are_swapped(self):
        swapped = operators.arguments_swapped
        self.makes(swapped, "g(a, b);", "g(remeshd_either(remeshd_mutant(7), a, b), "
                   "remeshd_either(remeshd_mutant(7), b, a));")
        self.assertEqual(2, len(self.made(swapped, in_function("x = g(a, b, c);"))))
        self.assertEqual(1, len(self.made(swapped, in_function("g(a.x, b.y);"))))
        self.assertEqual(1, len(self.made(swapped, in_function("Link l(v[i], v[j]);"))))
        for line in ("g(a, a);", "g(a, 1);", "g(a, b.x);", "g(a + b, c + d);", "std::min(a, b);",
                     "g(a, this);", "g(int a, int b);", "for (a; b; c) h(a);", "g([a, b] { h(); });"):
            self.leaves(swapped, line)
        self.leaves(swapped, "void f(A, B);", True)

    def test_neighbours_that_are_declared_of_other_types_are_left(self):
        for line, count in (("double a = 1; int b = 2; g(a, b);", 0),
                            ("const A& a = x; const A b = y; g(a, b);", 1),
                            ("std::vector<int> a; const std::vector<A>& b = x; g(a, b);", 0),
                            ("double a = 1; auto b = x; g(a, b);", 1)):
            self.assertEqual(count, len(self.made(operators.arguments_swapped, in_function(line))),
                             line)

    def test_a_call_is_left_out(self):
        out = operators.call_left_out
        self.makes(out, "g(x);", "{ if (!remeshd_mutant(7)) g(x); }")
        self.makes(out, "a.b->c(x).d();", "{ if (!remeshd_mutant(7)) a.b->c(x).d(); }")
        self.makes(out, "std::sort(v.begin(), v.end());",
                   "{ if (!remeshd_mutant(7)) std::sort(v.begin(), v.end()); }")
        self.makes(out, "if (a) g(); else h = 1;",
                   "if (a) { if (!remeshd_mutant(7)) g(); } else h = 1;")
        for line in ("return g(x);", "y = g(x);", "A a(x);", "const A a(x);", "x++;", "throw g(x);",
                     "assert(x);", "v.reserve(n);", "delete g(x);", "A g();"):
            self.leaves(out, line)
        self.leaves(out, "struct A {\n  A(int n);\n  void g();\n};", True)
        self.leaves(out, "A::A() : a_(1) {}", True)

    def test_a_truth_is_flipped(self):
        flipped = operators.truth_flipped
        self.makes(flipped, "return true;", "return !remeshd_mutant(7);")
        self.makes(flipped, "g(a, false);", "g(a, remeshd_mutant(7));")
        self.leaves(flipped, "std::conditional_t<true, A, B> x;")

    def test_an_extreme_is_swapped_for_the_other(self):
        swapped = operators.extreme_swapped
        self.makes(swapped, "x = std::min(a, b);",
                   "x = (remeshd_mutant(7) ? std::max(a, b) : std::min(a, b));")
        self.makes(swapped, "x = std::ranges::max(v);",
                   "x = (remeshd_mutant(7) ? std::ranges::min(v) : std::ranges::max(v));")
        self.makes(swapped, "x = std::max<double>(a, b);",
                   "x = (remeshd_mutant(7) ? std::min<double>(a, b) : std::max<double>(a, b));")
        self.leaves(swapped, "x = std::numeric_limits<int>::max();")
        self.leaves(swapped, "x = min(a, b);")


class Places(unittest.TestCase):
    def test_a_place_tells_its_line_and_the_line_before_and_after(self):
        place, = operators.off_by_one(Source("\n\nint f(int a) {\n  return a  + 1;  // next\n}\n"))
        self.assertEqual((4, "return a + 1; // next", "return a + 0; // next"),
                         (place.line, place.before, place.after))

    def test_a_comment_or_string_hides_no_code(self):
        code = 'void f() {\n  g("\\"}{");  // }\n  /* { */ x = \'{\' + 1;\n  y = 1\'000 + 1;\n}\n'
        self.assertEqual([3, 4], [p.line for p in operators.off_by_one(Source(code))])

    def test_every_operator_says_what_it_does(self):
        for operator in operators.OPERATORS:
            self.assertTrue(re.search(r"->", operator.__doc__), operator.__name__)


if __name__ == "__main__":
    unittest.main()
