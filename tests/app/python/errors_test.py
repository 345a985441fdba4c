# SPDX-License-Identifier: BSD-3-Clause
"""Whatever is given, there is one clear sentence, and never a crash."""

import inspect
import os
import pickle
import signal
import threading
import unittest
import warnings

import numpy as np
import relievo
from case import CURVED, DRAWS, RELIEF, Case, command

NAN, INFINITE = float("nan"), float("inf")
WRONG_NUMBERS = ["x", b"x", [], {}, object(), 1j, True]


class Errors(Case):
    def assert_sentence(self, raised):
        text = str(raised.exception)
        self.assertRegex(text, r"^(E\d{3}: )?[A-Z0-9a-z'_\"].*[.?]$")
        self.assertNotIn("\n", text)
        self.assertNotRegex(text, r"(?<![\w-])--[a-z]", "parameters, not options")
        self.assertNotIn("incompatible function arguments", text)

    def refused(self, error, function, *given, **named):
        with self.subTest(f"{function.__name__} {given} {named}"):
            with self.assertRaises(error) as raised:
                function(*given, **named)
            self.assert_sentence(raised)
            return raised.exception

    def test_one_class_for_each_exit_code(self):
        for name in ("Argument", "File", "Write", "Device", "Graphics"):
            self.assertTrue(issubclass(getattr(relievo, name + "Error"), relievo.Error))
        self.assertTrue(issubclass(relievo.ArgumentError, ValueError))

    def test_files(self):
        missing = self.refused(relievo.FileError, relievo.open, self.path("missing.ply"))
        self.assertIn("missing.ply", str(missing))
        self.refused(relievo.FileError, relievo.open, self.path(""))
        self.path("text.ply").write_text("no scan\n")
        self.refused(relievo.FileError, relievo.open, self.path("text.ply"))
        self.refused(relievo.FileError, relievo.read_recording, self.path("text.ply"))
        self.refused(relievo.FileError, relievo.read_recording, self.path("missing.csv"))
        self.refused(relievo.FileError, self.surface.touch, self.path("missing.csv"))
        self.refused(relievo.FileError, relievo.example, "none")
        for wrong in (None, 5, 1.5, [], {}, object()):
            self.refused(TypeError, relievo.open, wrong)
            self.refused(TypeError, relievo.read_recording, wrong)
        self.refused(relievo.ArgumentError, relievo.open, "")
        self.refused(relievo.ArgumentError, relievo.open, "a\0b")

    def test_a_cut_file_has_its_code(self):
        cut = RELIEF.with_name("relief_f_truncated.ply")
        error = self.refused(relievo.FileError, relievo.open, cut)
        self.assertEqual(error.code, "E101")
        self.assertEqual(pickle.loads(pickle.dumps(error)).code, "E101")
        self.assertGreater(relievo.open(cut, load_incomplete=True).levels, 0)

    def test_the_sentence_is_that_of_the_command_line(self):
        error = self.refused(relievo.FileError, relievo.open, self.path("missing.ply"))
        with self.assertRaises(AssertionError) as said:
            command("info", self.path("missing.ply"))
        self.assertIn(error.sentence, str(said.exception))

    def test_bytes_in_names(self):
        name = os.fsencode(self.path("")) + b"/\xff scan.ply"
        os.symlink(RELIEF, name)
        self.assertEqual(relievo.open(name, cells=50).levels, 1)
        self.assertEqual(os.fsencode(relievo.open(name, cells=50).file), name)
        self.refused(relievo.FileError, relievo.open, name + b"x")
        dash = self.path("-x.ply")
        os.symlink(RELIEF, dash)
        here = os.getcwd()
        try:
            os.chdir(self.path(""))
            self.assertEqual(relievo.open("-x.ply", cells=50).levels, 1)
        finally:
            os.chdir(here)

    def test_every_number_refuses_what_is_none(self):
        """Parameters are found by their types, so that a new one is tried, too."""
        calls = {
            relievo.open: ("open", (RELIEF,)),
            self.surface.window: ("window", ()),
            self.surface.touch: ("touch", (CURVED,)),
            self.surface.render: ("render", ()),
        }
        seen = 0
        for function, (_, given) in calls.items():
            for name, parameter in inspect.signature(function).parameters.items():
                kind = str(parameter.annotation)
                if parameter.kind != parameter.KEYWORD_ONLY:
                    continue
                for wrong in [object(), 1j, {1: 2, 3: 4}, [object()] * 4]:
                    self.refused((TypeError, relievo.ArgumentError), function, *given, **{name: wrong})
                if "float" in kind or "int" in kind:
                    seen += 1
                    for wrong in (NAN, INFINITE, -INFINITE, [NAN] * 4, [1, 2, 3, INFINITE]):
                        self.refused((TypeError, relievo.ArgumentError), function, *given, **{name: wrong})
                elif "bool" in kind:
                    self.refused(TypeError, function, *given, **{name: 1})
                else:
                    self.refused((TypeError, relievo.Error), function, *given, **{name: ""})
                    if name != "log":
                        self.refused((TypeError, relievo.Error), function, *given, **{name: "odd word"})
        self.assertGreater(seen, 20)

    def test_values_out_of_range(self):
        for wrong in ({"cells": 1}, {"cells": 0}, {"cells": -5}, {"cells": 10**30}, {"spacing_mm": 0},
                      {"spacing_mm": -1}, {"factor": 1}, {"factor": 9}, {"cells": 100, "spacing_mm": 1},
                      {"unit": "furlong"}, {"view": "inside"}, {"rule": "best"}, {"holes": "big"},
                      {"turn_deg": (1, 2)}, {"turn_deg": (1, 2, 400)}, {"parts": [0]}, {"parts": []},
                      {"reader": "mine"}, {"nodata": "some"}):  # fmt: skip
            self.refused(relievo.ArgumentError, relievo.open, RELIEF, **wrong)
        for wrong in ({"level": -1}, {"level": 63}, {"level": 10**20}, {"region_mm": (0, 0, 0, 0)},
                      {"region_mm": (0, 0, 1)}, {"region_mm": (0, 0, -1, -1)}, {"gain": 0},
                      {"gain": -1}, {"gain": 1e9}, {"region_mm": (1e300, 0, 1, 1)}):  # fmt: skip
            self.refused(relievo.ArgumentError, self.surface.window, **wrong)
        for wrong in (-1, 63, 2**31, -(2**63)):
            self.refused((relievo.ArgumentError, TypeError), self.surface.level, wrong)
        self.refused(TypeError, self.surface.level, 1.0)

    def test_strokes(self):
        touch = self.surface.touch
        for wrong in (np.zeros((0, 4)), np.zeros(4), np.zeros((3, 3)), np.zeros((2, 2, 4)), [[]], [], 5,
                      [[0, 1, 2, NAN]], [[0, 1, 2, INFINITE]], [[0, 1, 1, 1], [0, 1, 1, 1]],
                      [[1, 1, 1, 1], [0, 1, 1, 1]], [[NAN, 1, 1, 1]]):  # fmt: skip
            self.refused(relievo.ArgumentError, touch, wrong)
        for wrong in (None, object(), [["a", "b", "c", "d"]], {}, [[1j, 1, 1, 1]], [[1, 2, 3, 4], [1]]):
            self.refused((TypeError, relievo.ArgumentError), touch, wrong)
        self.refused(relievo.ArgumentError, touch, [[0, 1, 1, 1]], log=self.path("x.csv"))
        self.refused(relievo.ArgumentError, touch, [[0, 1, 1, 1], [1e300, 1, 1, 1]])
        self.refused(relievo.ArgumentError, touch, CURVED, magnet_reach_mm=1)
        self.assertFalse(self.path("x.csv").exists())

    def test_strokes_of_other_types_and_layouts(self):
        points = np.loadtxt(CURVED, delimiter=",", skiprows=1)
        want = self.surface.touch(points)["f_z_N"].tobytes()
        wide = np.zeros((len(points), 8))
        wide[:, ::2] = points
        for same in (np.asfortranarray(points), wide[:, ::2], points[::-1][::-1], points.astype(">f8")):
            self.assertEqual(self.surface.touch(same)["f_z_N"].tobytes(), want)

    def test_a_log_replaces_no_input(self):
        stroke = self.path("stroke.csv")
        stroke.write_bytes(CURVED.read_bytes())
        self.refused(relievo.ArgumentError, self.surface.touch, stroke, log=stroke)
        self.assertEqual(stroke.read_bytes(), CURVED.read_bytes())
        self.refused(relievo.WriteError, self.surface.touch, stroke, log=self.path("none/x.csv"))

    def test_columns(self):
        recording = self.surface.touch([[0, 1, 1, 50], [0.01, 1, 1, 50]])
        with self.assertRaises(KeyError):
            recording["none"]
        for wrong in (0, None, slice(2), ["hip_z_mm"]):
            with self.assertRaises(TypeError):
                recording[wrong]

    def test_classes_are_not_made_by_hand(self):
        for made in (relievo.Grid, relievo.Window, relievo.Recording):
            with self.assertRaises(TypeError):
                made()
        for wrong in (None, 5, "x"):
            with self.assertRaises(TypeError):
                relievo.Surface(wrong, [])

    def test_a_file_that_changed_is_not_drawn_for_it(self):
        copy = self.path("copy.ply")
        copy.write_bytes(RELIEF.read_bytes())
        surface = relievo.open(copy, cells=60)
        copy.unlink()
        copy.write_bytes(RELIEF.read_bytes()[:100])
        self.refused(relievo.FileError, surface.render)
        self.refused(relievo.FileError, surface.touch, CURVED, log=self.path("y.csv"))

    @unittest.skipUnless(DRAWS, "nothing draws in this build")
    def test_a_picture_warns_of_what_is_new_alone(self):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            self.surface.render(pixels=32)
            self.assertEqual([str(one.message) for one in told], [])
            self.surface.render(pixels=32, level=0)
            self.assertRegex(str(told[0].message), "finer than 200 samples")

    @unittest.skipUnless(DRAWS, "nothing draws in this build")
    def test_pictures(self):
        render = self.surface.render
        for wrong in ({"pixels": 15}, {"pixels": 10**6}, {"stereo": "3d"}, {"relief": "best"},
                      {"colours": "none"}, {"light_deg": (1,)}, {"eye_angle_deg": 5},
                      {"shading": 2}, {"level": 50}):  # fmt: skip
            self.refused(relievo.ArgumentError, render, **wrong)

    def test_ctrl_c_stops_the_work(self):
        """A stroke of an hour of the hand's time, through a pipe, so that the signal comes after the
        work has begun and long before it ends."""
        pipe = self.path("long.csv")
        os.mkfifo(pipe)

        def write_and_interrupt():
            with open(pipe, "w") as stroke:
                stroke.write("t_s,x_mm,y_mm,z_mm\n0,1,1,50\n3600,1,1,50\n")
            os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            threading.Thread(target=write_and_interrupt, daemon=True).start()
            self.surface.touch(pipe)
        self.assertGreater(len(self.surface.touch([[0, 1, 1, 50], [0.01, 1, 1, 50]])), 1)

    def test_strokes_too_long_for_memory_are_refused(self):
        with self.assertRaisesRegex(relievo.ArgumentError, "E102.*in seconds"):
            self.surface.touch([[0, 1, 1, 50], [9_000_000, 1, 1, 50]])

    def test_numbers_and_texts_that_nothing_holds(self):
        for wrong in (
            lambda: self.surface.window(gain=10**400),
            lambda: self.surface.level(10**5000),
            lambda: relievo.open(RELIEF, cells=10**5000),
            lambda: relievo.open(RELIEF, unit="\ud800"),
            lambda: relievo.open("\ud800.ply"),
            lambda: self.surface.touch([[0, 1, 1, 10**400], [1, 1, 1, 1]]),
            lambda: self.surface.touch(np.ma.masked_less(np.array([[0.0, 1, 1, 1], [1, 1, 1, 1]]), 0.5)),
        ):
            with self.assertRaises(relievo.ArgumentError):
                wrong()
        with self.assertRaises(TypeError):
            self.surface.touch(np.ones((2, 4), dtype=complex))

    def test_a_level_finer_than_the_samples_is_warned_of(self):
        with self.assertWarnsRegex(RuntimeWarning, "finer than 200 samples"):
            self.surface.window(level=0)
        with self.assertWarnsRegex(RuntimeWarning, "finer than 200 samples"):
            self.surface.touch([[0, 1, 1, 50], [0.01, 1, 1, 50]], level=0)


if __name__ == "__main__":
    unittest.main()
