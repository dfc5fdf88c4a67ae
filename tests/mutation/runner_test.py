#!/usr/bin/python3
"""Picking places, writing them, running a made-up test program, and the tables."""
import io
import json
import tempfile
import unittest
from contextlib import redirect_stderr
from pathlib import Path

import mutate
import operators
import run
import score
from compile_check import mutated
from cpp_source import Source

# Five faults: 0 fails a cheap test, 1 crashes a dear one, 2 hangs, 3 is reached and seen by nothing,
# 4 is not reached.
PROGRAM = """\
#!/usr/bin/python3
import os, pathlib, sys, time
TESTS = {"A.Cheap": [0, 3], "A.Dear": [1, 3], "B.Hangs/0": [2]}
if sys.argv[1] == "--gtest_list_tests":
    sys.exit(print("A.\\n  Cheap\\n  Dear\\n  DISABLED_Old\\nB.\\n  Hangs/0  # GetParam() = 1"))
names = next(a for a in sys.argv if a.startswith("--gtest_filter=")).split("=")[1].split(":")
fault = int(os.environ.get("MUTANT", -1))
for name in names:
    print("[ RUN      ] " + name, flush=True)
    if "MUTANTS_REACHED" in os.environ:
        with open(os.environ["MUTANTS_REACHED"], "r+b") as file:
            for n in TESTS[name]:
                file.seek(n), file.write(b"\\1")
    if fault in TESTS[name]:
        if fault == 0:
            print("[  FAILED  ] " + name + " (1 ms)")
            sys.exit(1)
        if fault == 1:
            os.abort()
        if fault == 2:
            time.sleep(60)
"""


def mutant(number, file="engine/base/a.cpp", before="a < b", after="a <= b", operator="bound_moved"):
    return score.Row(number, file, 10 + number, operator, before, after)


class Picking(unittest.TestCase):
    def test_folders_have_their_share_by_lines(self):
        self.assertEqual({"a": 5, "b": 3, "c": 2}, mutate.shares(10, {"a": 50, "b": 30, "c": 20}))
        self.assertEqual(7, sum(mutate.shares(7, {"a": 1, "b": 1, "c": 1}).values()))

    def test_the_same_seed_picks_the_same_places_and_none_overlap(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            text = "void f() {\n" + "  if (a < b && c) g(a, b);\n" * 20 + "}\n"
            for file in ("engine/base/a.cpp", "engine/mesh/b.cpp"):
                (root / file).parent.mkdir(parents=True)
                (root / file).write_text(text)
            places = mutate.all_places(root, ["engine/base/a.cpp", "engine/mesh/b.cpp"])
            picked = mutate.pick(root, places, 20, 1)
            self.assertEqual(picked, mutate.pick(root, places, 20, 1))
            self.assertNotEqual(picked, mutate.pick(root, places, 20, 2))
            self.assertEqual(10, sum(1 for f, _ in picked if f == "engine/base/a.cpp"))
            for k, (file, place) in enumerate(picked):
                for other, p in picked[:k]:
                    self.assertFalse(file == other and place.begin < p.end and p.begin < place.end)
            self.assertFalse(set(picked[:3]) & set(mutate.pick(root, places, 20, 1, set(picked[:3]))))

    def test_a_file_keeps_its_lines_and_all_other_text(self):
        text = "int f(int a) {\n  return a + 1;\n}\n"
        place, = operators.off_by_one(Source(text))
        self.assertEqual('#include "tests/mutation/mutant.h"\n#line 1\nint f(int a) {\n'
                         "  return a + (remeshd_mutant(5) ? 0 : 1);\n}\n",
                         mutated(text, [mutate.Mutant(5, "a.cpp", place)]))
        self.assertEqual(text, mutated(text, []))


class Running(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        program = self.folder / "test_fake"
        program.write_text(PROGRAM)
        program.chmod(0o755)
        self.bench = run.Bench(self.folder, 8)
        self.record = run.Record(self.folder / "record", {"mutants": "x"})
        limits = (run.GRACE, run.TIMES_NORMAL)
        run.GRACE, run.TIMES_NORMAL = 2, 10
        self.addCleanup(lambda: setattr(run, "GRACE", limits[0]))
        self.addCleanup(lambda: setattr(run, "TIMES_NORMAL", limits[1]))

    def measured(self):
        with redirect_stderr(io.StringIO()):
            return run.measure_tests(self.bench, ["test_fake"], self.record, 5, 1)

    def test_each_test_runs_alone_and_tells_what_it_reaches(self):
        self.assertEqual([("A.Cheap", {0, 3}), ("A.Dear", {1, 3}), ("B.Hangs/0", {2})],
                         [(t.name, t.reached) for t in self.measured()])

    def test_a_fault_is_seen_by_a_failure_a_crash_or_a_hang(self):
        tests = self.measured()
        made = [run.run_mutant(self.bench, mutant(n), tests, set()) for n in range(5)]
        self.assertEqual([("seen", "failed", "test_fake A.Cheap"),
                          ("seen", "crashed", "test_fake A.Dear"),
                          ("seen", "hung", "test_fake B.Hangs/0"),
                          ("unseen", "", ""), ("unreached", "", "")], made)

    def test_a_test_that_fails_without_the_fault_too_sees_nothing(self):
        tests = self.measured()
        program = self.folder / "test_fake"
        program.write_text(PROGRAM.replace("fault in TESTS[name]", "name == 'A.Cheap'")
                           .replace("if fault == 0", "if True"))
        unsteady = set()
        with redirect_stderr(io.StringIO()):
            self.assertEqual(("unseen", "", ""),
                             run.run_mutant(self.bench, mutant(3), tests, unsteady))
        self.assertEqual({("test_fake", "A.Cheap")}, unsteady)

    def test_a_fault_that_was_slow_once_is_not_seen(self):
        tests = self.measured()
        program = self.folder / "test_fake"
        program.write_text(PROGRAM.replace("if fault == 2", "if fault == 3 and "
                                           "not (once := pathlib.Path(sys.argv[0] + 'once')).exists()")
                           .replace("time.sleep", "once.touch(), time.sleep"))
        self.assertEqual(("unseen", "", ""), run.run_mutant(self.bench, mutant(3), tests, set()))
        self.assertTrue((self.folder / "test_fakeonce").exists())

    def test_a_tree_whose_tests_fail_is_not_measured(self):
        program = self.folder / "test_fake"
        program.write_text(PROGRAM.replace("fault in TESTS[name]", "name == 'A.Dear'")
                           .replace("if fault == 1", "if True"))
        with self.assertRaisesRegex(SystemExit, "test_fake A.Dear"):
            self.measured()

    def test_a_record_goes_on_where_it_was_cut_off(self):
        self.record.add({"mutant": 3, "outcome": "seen"})
        with self.record.path.open("a") as file:
            file.write('{"mutant": 4, "outc')
        again = run.Record(self.record.path, {"mutants": "x"})
        self.assertEqual({3: "seen"}, again.outcomes())
        again.add({"mutant": 4, "outcome": "unseen"})
        self.assertEqual(3, len([json.loads(x) for x in self.record.path.read_text().splitlines()]))
        with self.assertRaisesRegex(SystemExit, "other mutants"):
            run.Record(self.record.path, {"mutants": "y"})

    def test_cheap_tests_run_first_then_near_ones(self):
        tests = [run.Test("test_remesh", "Slow", 5), run.Test("test_remesh", "Fast", 0.02),
                 run.Test("test_remesh", "Faster", 0.01), run.Test("test_improve", "Mid", 0.5),
                 run.Test("test_cellular", "Fast", 0.03), run.Test("remesh-campaign", "campaign", 1)]
        self.assertEqual([["Faster", "Fast"], ["Fast"], ["Mid"], ["Slow"], ["campaign"]],
                         [[t.name for t in b] for b in run.batches(tests, "engine/remesh")])
        self.assertEqual("test_cellular", next(run.batches(tests, "engine/kernel"))[0].program)


class Tables(unittest.TestCase):
    MUTANTS = [mutant(0), mutant(1, after="a > b"), mutant(2, file="engine/mesh/b.cpp"),
               mutant(3, file="engine/mesh/b.cpp", after="a | b"), mutant(4)]
    OUTCOMES = {0: "seen", 1: "unseen", 2: "unreached", 3: "unseen"}
    EQUIVALENT = {("engine/mesh/b.cpp", "a < b", "a | b"): "b is 0 there"}

    def test_a_folder_s_score_leaves_out_what_is_equivalent(self):
        text = score.report(self.MUTANTS, self.OUTCOMES, self.EQUIVALENT)
        self.assertIn("| engine/base | 1 | 1 | 0 | 0 | 2 | 50 % |", text)
        self.assertIn("| engine/mesh | 0 | 0 | 1 | 1 | 2 | 0 % |", text)
        self.assertIn("| all | 1 | 1 | 1 | 1 | 4 | 33 % |", text)

    def test_survivors_are_listed_with_their_place(self):
        text = score.survivors(self.MUTANTS, self.OUTCOMES, self.EQUIVALENT)
        self.assertEqual(["| engine/base/a.cpp:11 (mutant 1) | bound_moved | `a < b` | `a > b` | yes |",
                          "| engine/mesh/b.cpp:12 (mutant 2) | bound_moved | `a < b` | `a <= b` | no |"],
                         text.splitlines()[2:])

    def test_a_long_line_is_shown_round_its_difference(self):
        begin, end = "word " * 30, " tail" * 30
        before, after = score.difference(begin + "a < b" + end, begin + "a <= b" + end)
        self.assertIn("a < b", before)
        self.assertIn("a <= b", after)
        self.assertLess(len(before), 91)

    def test_rows_are_read_as_they_were_written(self):
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder) / "mutants.tsv"
            table.write_text("number\tfile\tline\toperator\tbefore\tafter\n"
                             '7\tengine/a.cpp\t3\ttruth_flipped\tg("a", true);\tg("a", false);\n'
                             "8\tserver/b/c/d.cpp\t4\tcall_left_out\tg();\t\n")
            rows = score.read_mutants(table)
        self.assertEqual([(7, "engine", 'g("a", false);'), (8, "server/b", "")],
                         [(r.number, r.folder, r.after) for r in rows])

    def test_equivalents_are_argued(self):
        table = Path(__file__).with_name("equivalent.tsv")
        for place, reason in score.read_equivalents(table).items():
            self.assertTrue(reason, place)


if __name__ == "__main__":
    unittest.main()
