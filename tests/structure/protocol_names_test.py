#!/usr/bin/python3
"""The sources name what the protocol has, and each rule finds what is not so."""
import tempfile
import unittest
from pathlib import Path

import protocol_names

ROOT = Path(__file__).resolve().parents[2]

PROTO = """
message Error {
  enum Code {
    CODE_NOT_FOUND = 5;  // no such thing
  }
  enum Reason {
    REASON_UNSPECIFIED = 0;
    // [NOT_FOUND] Cause.
    DESIGN_EMPTY = 106;
    BUSY = 600;
  }
}
"""


class TheTree(unittest.TestCase):
    def test_has_names_to_check(self):
        self.assertGreater(len(protocol_names.enumerators(ROOT, within="Reason")), 80)
        self.assertGreater(sum(1 for _ in protocol_names.texts(ROOT)), 80)

    def test_keeps_every_rule(self):
        for rule in protocol_names.RULES:
            with self.subTest(rule=rule.__name__):
                self.assertEqual([], list(rule(ROOT)))


class Rule(unittest.TestCase):
    def violations(self, rule, source):
        with tempfile.TemporaryDirectory() as root:
            for path, text in (("proto/remesh/v1/error.proto", PROTO), ("server/a.cpp", source)):
                file = Path(root) / path
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            return list(rule(root))

    def test_a_text_like_a_reason_is_one(self):
        rule = protocol_names.texts_like_enumerators_are_enumerators
        for good in ('f("DESIGN_EMPTY");', 'f("NOT_FOUND");', 'f("BUSY", "FORMAT");',
                     '// "DESIGN_FULL"', 'getenv("REMESH_ADDRESS");', 'f("DESIGN_EMPTY: ");'):
            self.assertEqual([], self.violations(rule, good), good)
        self.assertEqual(["server/a.cpp:2: DESIGN_FULL is no name of the protocol"],
                         self.violations(rule, '\nf("BUSY", "DESIGN_FULL");'))

    def test_a_reason_is_given_by_some_source(self):
        rule = protocol_names.reasons_are_given
        self.assertEqual([], self.violations(rule, 'f("BUSY");\ng(x ? "DESIGN_EMPTY" : "");'))
        found = self.violations(rule, 'f("BUSY");  // "DESIGN_EMPTY"')
        self.assertEqual(1, len(found), found)
        self.assertIn("DESIGN_EMPTY", found[0])

    def test_a_reason_listed_as_given_by_no_source_is_given_by_none(self):
        self.assertEqual(["server/a.cpp:2: STARTING is listed as given by no source"],
                         self.violations(protocol_names.reasons_are_given,
                                         'f("BUSY", "DESIGN_EMPTY");\ng("STARTING");'))


if __name__ == "__main__":
    unittest.main()
