#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The Python package against numpy, against the command line, and against who misuses it.

Usage: package_test.py PROGRAM; PYTHONPATH names the folder of the package.
"""
import concurrent.futures
import doctest
import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings

import numpy as np

PROGRAM = os.path.abspath(sys.argv.pop(1))
os.environ["AXIOMETRY_PROGRAM"] = PROGRAM

import axiometry  # noqa: E402
from clause_3 import by_numpy  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TABLE_2 = ROOT / "examples/iso230-2-table2.json"


def ticks_during(call):
    """How often another thread of Python came to its turn meanwhile; once or not at all where the call holds it."""
    ticks, ended = [0], threading.Event()

    def tick():
        while not ended.is_set():
            ticks[0] += 1
            time.sleep(0.0005)

    other = threading.Thread(target=tick)
    other.start()
    before = ticks[0]
    try:
        call()
        return ticks[0] - before
    finally:
        ended.set()
        other.join()


class Package(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refused(self, words, call, *arguments, **named):
        with self.assertRaises(axiometry.Error) as caught:
            call(*arguments, **named)
        self.assertIn(words, str(caught.exception))


class Parameters(Package):
    def test_are_those_of_the_standard_for_any_number_of_tests(self):
        rng = np.random.default_rng(5)
        for shape in ((11, 5), (2, 2), (1, 7, 3), (3, 4, 5, 2), (700, 11, 5), (0, 5, 5)):
            up, down = rng.normal(3, 2, shape), rng.normal(-1, 2, shape)
            found = axiometry.parameters(up, down)
            self.assertEqual(list(found), list(by_numpy(np.zeros((2, 2)), np.zeros((2, 2)))))
            for key, expected in by_numpy(up, down).items():
                self.assertEqual(np.shape(found[key]), shape[:-2])
                np.testing.assert_allclose(found[key], expected, rtol=0, atol=1e-12)

    def test_of_one_direction_or_run_are_those_that_exist(self):
        up = [[0.0, 1.0], [2.0, 4.0]]
        self.assertEqual(set(axiometry.parameters(up)), {"A_up", "E_up", "R_up"})
        self.assertEqual(axiometry.parameters(up)["E_up"], 2.5)
        self.assertEqual(set(axiometry.parameters([[0.0], [2.0]], [[1.0], [2.0]])), {"E", "E_up", "E_down", "M", "B", "B_mean"})

    def test_take_any_layout_of_memory_and_leave_it_as_it_is(self):
        rng = np.random.default_rng(6)
        up, down = rng.normal(size=(5, 4, 6)), rng.normal(size=(5, 4, 6))
        kept = up.copy()
        strided = axiometry.parameters(up.transpose(2, 1, 0)[::2], down.transpose(2, 1, 0)[::2])
        whole = axiometry.parameters(np.ascontiguousarray(up.transpose(2, 1, 0)[::2]), down.transpose(2, 1, 0)[::2].copy())
        np.testing.assert_array_equal(strided["A"], whole["A"])
        np.testing.assert_array_equal(up, kept)
        whole_numbers = axiometry.parameters(np.arange(6).reshape(3, 2), np.zeros((3, 2), int))
        self.assertEqual(whole_numbers["E_up"], 4.0)

    def test_with_a_missing_reading_are_refused_or_lower_bounds(self):
        up, down = np.random.default_rng(7).normal(size=(2, 300, 5, 3))
        up[299, 1] = down[299, 1] = up[7, 2] = np.nan
        self.refused("found no reading in up[7, 2, 0]", axiometry.parameters, up.reshape(300, 5, 3), down)
        self.refused("up[1, 3, 2, 0]", axiometry.parameters, up.reshape(75, 4, 5, 3), down.reshape(75, 4, 5, 3))
        self.refused("'omit'", axiometry.parameters, up, down, missing="ignore")

    def test_of_missing_readings_are_those_of_the_command_line(self):
        up, down = np.random.default_rng(8).normal(size=(2, 5, 3))
        up[1, 0] = down[3] = np.nan
        found = axiometry.parameters(np.array([up, up]), np.array([down, down]), missing="omit")
        gone = up.copy()
        gone[2] = np.nan
        none = axiometry.parameters(np.array([gone, up * np.nan]), missing="omit")
        np.testing.assert_array_equal(none["E_up"], [axiometry.parameters(np.delete(up, 2, 0), missing="omit")["E_up"], np.nan])
        file = self.folder / "gaps.csv"
        axiometry.Test(range(5), up, down).write(file)
        told = axiometry.run("evaluate", file)["parameters"]
        for key, value in told.items():
            self.assertEqual(found[key].tolist(), [value] * 2, key)

    def test_refuse_what_is_no_table_of_readings(self):
        self.refused("expected (..., targets, runs)", axiometry.parameters, [1.0, 2.0])
        self.refused("expected the same", axiometry.parameters, np.zeros((2, 2)), np.zeros((2, 3)))
        self.refused("could not convert", axiometry.parameters, [["a"]])
        self.refused("found 1 target", axiometry.parameters, np.zeros((1, 5)), np.zeros((1, 5)))
        self.refused("no reading", axiometry.parameters, np.zeros((2, 0)), np.zeros((2, 0)))
        self.refused("complex", axiometry.parameters, np.zeros((2, 2), complex))
        for wrong in (np.inf, -2e9):
            readings = np.zeros((600, 3, 2))
            readings[599, 2, 1] = wrong
            self.refused("test [599]", axiometry.parameters, readings, readings)

    def test_take_what_a_mask_hides_for_missing(self):
        masked = np.ma.masked_greater([[0.0, 1.0], [999.0, 4.0]], 100)
        self.refused("up[1, 0]", axiometry.parameters, masked)
        self.assertEqual(axiometry.parameters(masked, missing="omit")["E_up"], 3.5)
        test = axiometry.Test([0, 100], masked)
        self.assertTrue(np.isnan(test.up[1, 0]))

    def test_let_others_run_meanwhile(self):
        readings = np.random.default_rng(1).normal(size=(200_000, 11, 5))
        self.assertGreater(ticks_during(lambda: axiometry.parameters(readings, readings)), 5)

    def test_cost_in_proportion_to_the_readings(self):
        def seconds(tests):
            readings = np.random.default_rng(1).normal(size=(tests, 11, 5))
            least = math.inf
            for _ in range(5):
                begun = time.process_time()
                axiometry.parameters(readings, readings)
                least = min(least, time.process_time() - begun)
            return least

        self.assertLess(seconds(40_000), 30 * seconds(4_000))


class Tests(Package):
    def test_have_the_result_of_the_command_line_to_the_last_member(self):
        for file in ("iso230-2-table2.json", "iso230-2-table2.csv", "rotary-table.csv", "simulated-backlash.json"):
            path = ROOT / "examples" / file
            here = axiometry.evaluate(path, methods="gum,monte-carlo", trials=2000, seed=3)
            there = axiometry.run("evaluate", path, uncertainty="gum,monte-carlo", trials=2000, seed=3)
            self.assertEqual(dict(here), dict(there), file)

    def test_of_arrays_have_the_figures_of_their_file(self):
        read = axiometry.read(TABLE_2)
        made = axiometry.Test(read.targets, read.up, read.down)
        np.testing.assert_array_equal(made.up, read.up)
        self.assertEqual(axiometry.evaluate(made)["parameters"], axiometry.evaluate(read)["parameters"])
        self.assertIsNone(axiometry.evaluate(made)["source"]["sha256"])
        self.assertEqual(axiometry.evaluate(read)["source"]["file"], str(TABLE_2))

    def test_tell_what_python_states_as_entered(self):
        test = axiometry.Test([0, 100, 200], np.zeros((3, 2)), np.ones((3, 2)), stating={"axis.name": "X"})
        stated = test.stating({"uncertainty.device_error_range_um_per_m": np.float64(0.6), "machine.name": "Mill 5"})
        self.assertNotIn("machine", test.metadata)
        self.assertEqual(stated.metadata["machine"]["name"], "Mill 5")
        inputs = axiometry.evaluate(stated)["uncertainty"]["inputs"]
        origin = {row["key"]: row["origin"] for row in inputs}["uncertainty.device_error_range_um_per_m"]
        self.assertEqual(origin, "entered")
        self.assertNotIn("machine", stated.stating({"machine.name": None}).metadata)
        self.refused("machine.nam", test.stating, {"machine.nam": "x"})
        self.refused("axis.kind", test.stating, {"axis.kind": "rotary"})

    def test_are_written_without_loss_and_never_over_what_was_read(self):
        file = self.folder / "kept.json"
        file.write_bytes(TABLE_2.read_bytes())
        test = axiometry.read(file).stating({"machine.name": "Mill 5"})
        self.refused("found an output that is also an input", test.write, file)
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        relative = axiometry.read("kept.json")
        os.chdir(here)
        self.refused("found an output that is also an input", relative.write, file)
        self.assertEqual(file.read_bytes(), TABLE_2.read_bytes())
        for name in ("again.json", "again.csv"):
            test.write(self.folder / name)
            again = axiometry.read(self.folder / name)
            np.testing.assert_array_equal(again.up, test.up)
            self.assertEqual(again.metadata, test.metadata)
        self.refused("expected a file ending in", test.write, self.folder / "again.txt")

    def test_of_a_file_of_many_come_with_their_names(self):
        file = self.folder / "many.csv"
        rows = [f"{name},{target},{direction},{run},{run + target / 100}" for name in "ab" for run in (1, 2)
                for direction in ("up", "down") for target in (0, 100)]
        file.write_text("test,target_mm,direction,run,deviation_um\n" + "\n".join(rows) + "\n")
        tests = axiometry.read_all(file)
        self.assertEqual([t.name for t in tests], ["a", "b"])
        self.refused("many.csv", axiometry.read, file)
        self.assertEqual(len(axiometry.read_all(TABLE_2)), 1)

    def test_get_verdicts_reports_and_a_second_opinion(self):
        result = axiometry.evaluate(TABLE_2, tolerances={"A": 10, "B": "0.006mm"}, rule="iso14253-1", verify=True)
        self.assertEqual([row["verdict"] for row in result["tolerances"]], ["undecided", "conforms"])
        self.assertEqual(result["verification"]["differences"], 0)
        told = axiometry.run("evaluate", TABLE_2, tolerance=["A=10um", "B=0.006mm"], rule="iso14253-1")
        self.assertEqual(told["tolerances"], result["tolerances"])
        self.assertEqual(told.exit_code, 4)
        for name, begin in (("r.pdf", b"%PDF"), ("r.html", b"<!"), ("r.png", b"\x89PNG"), ("r.svg", b"<?xml")):
            result.report(self.folder / name, language="de")
            self.assertTrue((self.folder / name).read_bytes().startswith(begin), name)
        self.assertIn("Unsicherheit", (self.folder / "r.html").read_text())
        self.refused("expected", result.report, self.folder / "r.docx")
        self.refused("expected one of en, de, fr", result.report, self.folder / "s.html", language="xx")
        self.assertFalse((self.folder / "s.html").exists())

    def test_choose_the_method_of_record(self):
        result = axiometry.evaluate(TABLE_2, method="gum")
        self.assertEqual(result["uncertainty"]["record"]["method"], "gum")

    def test_refuse_what_the_command_line_refuses(self):
        evaluate = axiometry.evaluate
        self.refused("expected some of annex-a,gum,monte-carlo", evaluate, TABLE_2, methods=["mc"])
        self.refused("found trials=3", evaluate, TABLE_2, methods="monte-carlo", trials=3)
        self.refused("parameters A", evaluate, TABLE_2, tolerances={"Q": 1})
        self.refused("cannot open", axiometry.read, self.folder / "none.csv")
        self.refused("ascending", axiometry.Test, [0, 0], np.zeros((2, 2)))
        self.refused("one for each", axiometry.Test, [0, 1, 2], np.zeros((2, 2)))
        self.refused("no readings", axiometry.Test, [0, 1])
        self.refused("'linear' or 'rotary'", axiometry.Test, [0, 1], np.zeros((2, 2)), kind="turning")

    def test_are_evaluated_side_by_side(self):
        readings = np.random.default_rng(2).normal(size=(16, 2, 8, 5))
        tests = [axiometry.Test(np.arange(8), up, down) for up, down in readings]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            together = list(pool.map(axiometry.evaluate, tests))
        self.assertEqual([dict(r) for r in together], [dict(axiometry.evaluate(t)) for t in tests])

    def test_end_at_ctrl_c(self):
        begun = time.process_time()
        axiometry.evaluate(TABLE_2, methods="monte-carlo", trials=100_000)
        hundredth = time.process_time() - begun
        threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        begun = time.process_time()
        with self.assertRaises(KeyboardInterrupt):
            axiometry.evaluate(TABLE_2, methods="monte-carlo", trials=10_000_000)
        self.assertLess(time.process_time() - begun, 50 * hundredth)

    def test_refuse_options_that_would_have_no_effect(self):
        for option in ({"trials": 1000}, {"seed": 3}, {"coverage": 0.99}):
            self.refused("without the method it belongs to", axiometry.evaluate, TABLE_2, **option)
        self.refused("whole number", axiometry.evaluate, TABLE_2, methods="monte-carlo", trials=1e6)
        self.refused("found {'a': 1} as axis.name", axiometry.Test, [0, 1], np.zeros((2, 2)), stating={"axis.name": {"a": 1}})
        self.refused("found {'role': 'laser'} as equipment", axiometry.Test, [0, 1], np.zeros((2, 2)), stating={"equipment": [{"role": "laser"}]})
        self.refused("NUL", axiometry.read, str(TABLE_2) + "\0.csv")
        points = axiometry.Test([0, 1], np.zeros((2, 2)), stating={"axis.compensation_points": np.arange(3)})
        self.assertEqual(points.metadata["axis"]["compensation_points"], [0, 1, 2])
        result = axiometry.evaluate(TABLE_2, methods="monte-carlo", trials=np.int64(1000), seed=np.uint64(2**63))
        self.assertEqual(result["uncertainty"]["monte_carlo_run"]["seed"], str(2**63))
        self.refused("0 to 6", result.report, self.folder / "r.html", decimals=10**9)


class Threads(Package):
    def test_of_the_background_let_a_program_end(self):
        script = ("import axiometry, sys, threading, time\n"
                  "def work():\n    while True: axiometry.evaluate(sys.argv[1])\n"
                  "for _ in range(3): threading.Thread(target=work, daemon=True).start()\ntime.sleep(0.3)\n")
        for _ in range(3):
            ended = subprocess.run([sys.executable, "-c", script, str(TABLE_2)], capture_output=True, timeout=120)
            self.assertEqual((ended.returncode, ended.stderr), (0, b""))


class Propagation(Package):
    def test_agrees_with_what_is_known_in_closed_form(self):
        sums = axiometry.propagate(lambda a, b: a + b, {"a": "uniform -1 1", "b": "uniform -1 1"}, trials=400_000)
        self.assertAlmostEqual(sums.gum["u"], math.sqrt(2 / 3), 12)
        self.assertAlmostEqual(sums.monte_carlo["u"], math.sqrt(2 / 3), 2)
        self.assertAlmostEqual(sums.monte_carlo["symmetric"][1], 2 - math.sqrt(0.05 * 4), 2)  # triangular, 97.5 %
        tied = axiometry.propagate(lambda a, b: a - b, {"a": (5, 3), "b": (1, 4)}, correlation={("b", "a"): 0.5},
                                   trials=200_000)
        self.assertAlmostEqual(tied.gum["u"], math.sqrt(13), 12)
        self.assertAlmostEqual(tied.monte_carlo["u"], math.sqrt(13), 1)
        self.assertEqual(tied.gum["sensitivities"]["b"], -1.0)
        welch = axiometry.propagate(lambda a: a, {"a": "t 4 10 2"}, trials=1000)
        self.assertEqual(welch.gum["nu_eff"], 4.0)
        self.assertAlmostEqual(welch.gum["k"], 2.776445, 5)

    def test_takes_several_outputs_and_constants(self):
        both = axiometry.propagate(lambda a, b: (a * b, 7.0), {"a": (2, 0.1), "b": (3, 0.1)}, trials=10_000)
        self.assertEqual([p.gum["value"] for p in both], [6.0, 7.0])
        self.assertEqual(both[1].monte_carlo["u"], 0.0)

    def test_gives_the_same_bits_for_the_same_seed(self):
        run = lambda seed: axiometry.propagate(np.sin, {"x": (1, 0.2)}, trials=50_000, seed=seed)  # noqa: E731
        self.assertEqual(run(3).monte_carlo, run(3).monte_carlo)
        self.assertNotEqual(run(3).monte_carlo, run(4).monte_carlo)

    def test_hands_on_what_the_model_raises_and_refuses_the_rest(self):
        propagate = axiometry.propagate
        with self.assertRaises(ZeroDivisionError):
            propagate(lambda x: 1 // 0, {"x": (1, 1)})
        self.refused("x: found", propagate, lambda x: x, {"x": "uniform 2 1"})
        self.refused("expected at least one", propagate, lambda: 1, {})
        self.refused("correlation of 'z'", propagate, lambda x: x, {"x": (0, 1)}, correlation={("x", "z"): 1})
        self.refused("-1 to 1", propagate, lambda x, y: x + y, {"x": (0, 1), "y": (0, 1)}, correlation={("x", "y"): 2})
        self.refused("two correlations", propagate, lambda x, y: x, {"x": (0, 1), "y": (0, 1)},
                     correlation={("x", "y"): 0.9, ("y", "x"): -0.9})
        self.refused("no output", propagate, lambda x: (), {"x": (0, 1)})
        self.refused("coverage", propagate, lambda x: x, {"x": (0, 1)}, coverage=1 - 1e-16)
        self.refused("of shape (1, 1)", propagate, lambda x: x.reshape(1, -1), {"x": (0, 1)})
        self.refused("expected (value, u)", propagate, lambda x: x, {"x": 5})
        self.refused("trials=-1", propagate, lambda x: x, {"x": (0, 1)}, trials=-1)
        self.refused("found the value nan", propagate, lambda x: np.full_like(x, np.nan), {"x": (0, 1)}, trials=1000)
        calls = []
        self.refused("2 outputs", propagate, lambda x: calls.append(1) or ((x, x) if len(calls) > 1 else x),
                     {"x": (0, 1)}, trials=1000)

    def test_ends_at_ctrl_c(self):
        blocks = []
        threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            axiometry.propagate(lambda x: (blocks.append(x.size), x)[1], {"x": (0, 1)}, trials=2_000_000_000)
        self.assertLess(sum(blocks), 1_000_000_000)


class Volume(Package):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.where = pathlib.Path(folder.name)
        machine = {"chain": "XFYZ", "travel_mm": {"X": [0, 600], "Y": [0, 400], "Z": [-300, 0]},
                   "tools_mm": {"T1": [0, 0, -150], "T2": [80, 0, -120], "T3": [0, 80, -200]}}
        (cls.where / "machine.json").write_text(json.dumps(machine))
        run = axiometry.run
        run("volumetric plan", machine=cls.where / "machine.json", stations="auto", out=cls.where / "plan.json", json=False)
        run("volumetric simulate", plan=cls.where / "plan.json", lengths=cls.where / "l.csv", truth=cls.where / "t.json")
        cls.result = cls.where / "result.json"
        cls.identified = run("volumetric identify", cls.where / "l.csv", plan=cls.where / "plan.json", out=cls.result)

    def test_has_the_field_of_the_command_line(self):
        model = axiometry.ErrorModel(self.result)
        self.assertEqual(list(model.tools), ["T1", "T2", "T3"])
        points = np.random.default_rng(1).uniform([0, 0, -300], [600, 400, 0], (20, 3))
        (self.where / "p.csv").write_text("tool,x_mm,y_mm,z_mm\n" + "".join(f"T2,{x!r},{y!r},{z!r}\n" for x, y, z in points.tolist()))
        told = axiometry.run("volumetric field", self.result, at=self.where / "p.csv")["points"]
        errors, covariances = model.displacement(points, tool="T2")
        self.assertEqual(errors.tolist(), [row["error_um"] for row in told])
        self.assertEqual(covariances.reshape(20, 9).tolist(), [row["covariance_um2"] for row in told])
        grid = model.displacement(points.reshape(4, 5, 3), tool="T2")
        self.assertEqual([g.shape for g in grid], [(4, 5, 3), (4, 5, 3, 3)])
        np.testing.assert_array_equal(grid[0].reshape(20, 3), errors)

    def test_has_single_errors_and_those_of_a_result_at_hand(self):
        model = axiometry.ErrorModel(json.loads(self.result.read_text()))
        values, u = model.motion("EXX", [0.0, 300.0, 600.0])
        self.assertEqual(values.shape, (3,))
        self.assertTrue((u >= 0).all())
        self.assertEqual(len(model.squareness("C0Y")), 2)
        self.refused("EXX, EYX or EAX", model.motion, "QXX", [0.0])
        self.refused("C0Y, B0Z or A0Z", model.squareness, "C0X")
        self.refused("where the errors are known", model.motion, "EXX", [601.0])

    def test_refuses_places_that_nobody_measured(self):
        model = axiometry.ErrorModel(self.result)
        self.refused("point 1: found Z at 5 mm", model.displacement, [[0, 0, 0], [0, 0, 5]], tool="T1")
        self.refused("found no tool", model.displacement, [0, 0, 0])
        self.refused("T1, T2, T3", model.displacement, [0, 0, 0], tool="T9")
        self.refused("expected (..., 3)", model.displacement, [0, 0], tool="T1")
        self.refused("-1, 0 or 1", model.displacement, [0, 0, 0], tool="T1", approach=(2, 0, 0))
        self.refused("model", axiometry.ErrorModel, {})

    def test_lets_others_run_meanwhile(self):
        model = axiometry.ErrorModel(self.result)
        self.assertGreater(ticks_during(lambda: model.displacement(np.zeros((20_000, 3)), tool="T1")), 5)

    def test_warns_of_serious_findings(self):
        result = json.loads(self.result.read_text())
        result["findings"].append({"id": "volumetric-residuals", "severity": "serious", "message": "nothing explains them"})
        with self.assertWarnsRegex(axiometry.SeriousFinding, "nothing explains them"):
            axiometry.ErrorModel(result)
        with warnings.catch_warnings():
            warnings.simplefilter("error", axiometry.SeriousFinding)
            self.assertIn("volumetric-simulated", [f["id"] for f in axiometry.ErrorModel(self.result).findings])


class Verbs(Package):
    def test_run_with_their_flags_and_say_what_is_wrong(self):
        plan = self.folder / "plan.json"
        axiometry.run("plan", axis="X", travel="0:500", seed=7, out=plan)
        program = axiometry.run("nc", plan, dialect="linuxcnc")
        self.assertIn("ISO 230-2", program.text)
        self.assertEqual(dict(program), {})
        self.refused("none.csv: cannot open", axiometry.run, "evaluate", "none.csv")
        self.refused("--colour", axiometry.run, "evaluate", TABLE_2, colour="red")
        self.refused("goes into no file", axiometry.run, "evaluate", TABLE_2, json="out.json")
        self.refused("--out", axiometry.run, "plan", axis="X", travel="0:500", out=True)
        self.assertIn("Usage", axiometry.run("evaluate", help=True).text)
        kept = axiometry.run("evaluate", TABLE_2, "none.csv", keep_going=True)
        self.assertEqual((kept.exit_code, "error" in kept.json[1]), (2, True))
        self.refused("writes none", axiometry.run, "nc", plan, dialect="linuxcnc", json=True)

    def test_read_json_of_either_kind_and_keep_bytes(self):
        store = self.folder / "s.db"
        axiometry.run("store add", TABLE_2, store=store, json=False)
        self.assertEqual(axiometry.run("store info", store=store)["counts"]["tests"], 1)
        plan = self.folder / "plan.json"
        axiometry.run("plan", axis="X", travel="0:500", seed=7, out=plan, json=False)
        self.assertIn("\r\n", axiometry.run("nc", plan, dialect="heidenhain").text)
        many = axiometry.run("evaluate", TABLE_2, ROOT / "examples/rotary-table.csv")
        self.assertEqual([one["unit"] for one in many.json], ["um", "arcsec"])

    def test_are_refused_in_english_whatever_the_language_of_the_house(self):
        os.environ["AXIOMETRY_LANGUAGE"] = "de"
        self.addCleanup(os.environ.pop, "AXIOMETRY_LANGUAGE")
        self.refused("cannot open", axiometry.run, "evaluate", "none.csv")

    def test_want_a_program_of_the_same_version(self):
        axiometry.program._program.cache_clear()
        self.addCleanup(axiometry.program._program.cache_clear)
        old = self.folder / "axiometry"
        old.write_text("#!/bin/sh\necho axiometry 0.0.9\n")
        old.chmod(0o755)
        os.environ["AXIOMETRY_PROGRAM"] = str(old)
        self.addCleanup(os.environ.__setitem__, "AXIOMETRY_PROGRAM", PROGRAM)
        self.refused("another version", axiometry.run, "air", temperature=20)


class Documentation(unittest.TestCase):
    def test_shows_what_happens(self):
        os.chdir(ROOT)
        with tempfile.TemporaryDirectory() as folder:
            for document in ("docs/howto/python.md", "README.md"):
                found = doctest.testfile(str(ROOT / document), module_relative=False, globs={"folder": pathlib.Path(folder)},
                                         optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
                self.assertEqual(found.failed, 0)
                self.assertGreater(found.attempted, 0, document)
        self.assertEqual(doctest.testmod(axiometry.uncertainty).failed, 0)


if __name__ == "__main__":
    unittest.main()
