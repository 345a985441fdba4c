# SPDX-License-Identifier: BSD-3-Clause
"""Arrays share memory with what they come from, keep it, and cannot be written; other threads run."""

import gc
import os
import threading
import unittest

import numpy as np
import relievo
from case import CURVED, RELIEF, SQUARES, Case


def address(array):
    return array.__array_interface__["data"][0]


class Arrays(Case):
    def all_arrays(self):
        surface = self.surface
        window = surface.window()
        recording = surface.touch(CURVED, level=0, region_mm=SQUARES[CURVED])
        return {
            "heights": lambda: surface.depth_map.heights_mm,
            "origins": lambda: surface.depth_map.origins,
            "level 0": lambda: surface.level(0).heights_mm,
            "level 1": lambda: surface.pyramid[1].heights_mm,
            "measured": lambda: surface.level(1).measured,
            "transform": lambda: surface.view_from_file,
            "window": lambda: window.heights_mm,
            "window origins": lambda: window.origins,
            "rows": lambda: recording.rows,
            "column": lambda: recording["hip_z_mm"],
            "forces": lambda: recording.force_n,
        }

    def test_the_same_memory_each_time(self):
        for name, array in self.all_arrays().items():
            with self.subTest(name):
                first, second = array(), array()
                self.assertIsNot(first, second)
                self.assertEqual(address(first), address(second))
                self.assertFalse(first.flags.owndata)

    def test_nothing_can_be_written(self):
        for name, array in self.all_arrays().items():
            with self.subTest(name):
                shared = array()
                with self.assertRaises(ValueError):
                    shared[...] = 0
                with self.assertRaises(ValueError):
                    shared.setflags(write=True)
                if shared.dtype.names is None:  # Fields out of order are no buffer.
                    self.assertTrue(memoryview(shared).readonly)

    def test_shapes_and_types(self):
        grid = self.surface.depth_map
        self.assertEqual(grid.heights_mm.shape, grid.shape)
        self.assertEqual(grid.heights_mm.dtype, np.float32)
        self.assertEqual(grid.origins.dtype, np.uint8)
        self.assertIsNone(grid.measured)
        self.assertIsNone(self.surface.level(1).origins)
        self.assertEqual(self.surface.window().heights_mm.shape, (200, 200))
        self.assertEqual(self.surface.view_from_file.shape, (4, 4))
        np.testing.assert_array_equal(self.surface.view_from_file[3], [0, 0, 0, 1])
        left, bottom, width, height = self.surface.bounds_mm
        self.assertAlmostEqual(left + 0.5 * grid.spacing_mm, grid.first_x_mm)
        self.assertAlmostEqual(width, grid.shape[1] * grid.spacing_mm)
        self.assertAlmostEqual(height, grid.shape[0] * grid.spacing_mm)

    def test_rows_lie_at_their_coordinates(self):
        """Row 0 has the lowest y: the same place by the map, by a window and by a proxy at rest."""
        grid = self.surface.depth_map
        window = self.surface.window(level=0, region_mm=SQUARES[CURVED])
        j, i = 150, 20
        x = window.x_mm + (i + 0.5) * window.spacing_mm
        y = window.y_mm + (j + 0.5) * window.spacing_mm
        col, row = (x - grid.first_x_mm) / grid.spacing_mm, (y - grid.first_y_mm) / grid.spacing_mm
        near = grid.heights_mm[int(row) : int(row) + 2, int(col) : int(col) + 2]
        self.assertLessEqual(near.min() - 1e-4, window.heights_mm[j, i])
        self.assertGreaterEqual(near.max() + 1e-4, window.heights_mm[j, i])

    def test_arrays_keep_what_they_show(self):
        surface = relievo.open(RELIEF, cells=120)
        kept = [surface.depth_map.heights_mm, surface.window().heights_mm, surface.view_from_file,
                surface.touch([[0, 1, 1, 50], [0.05, 1, 1, 49]])["hip_z_mm"]]  # fmt: skip
        before = [array.tobytes() for array in kept]
        del surface
        gc.collect()
        for _ in range(20):  # Something else takes memory that was given back.
            np.full(1 << 20, 7.0)
        self.assertEqual([array.tobytes() for array in kept], before)

    def test_a_slice_keeps_it_too(self):
        row = relievo.open(RELIEF, cells=60).depth_map.heights_mm[3]
        gc.collect()
        self.assertEqual(row.shape, (60,))
        self.assertTrue(np.isfinite(row).all())

    def test_other_threads_run_meanwhile(self):
        """The stroke is a pipe: the thread that writes it must run while the touch waits for it."""
        pipe = self.path("stroke.csv")
        os.mkfifo(pipe)

        def write():
            with open(pipe, "w") as stroke:
                stroke.write(CURVED.read_text())

        writer = threading.Thread(target=write, daemon=True)
        writer.start()
        recording = self.surface.touch(pipe, level=0, region_mm=SQUARES[CURVED])
        writer.join()
        self.assertGreater(len(recording), 1000)

    def test_several_threads_give_the_same(self):
        results = [None] * 4

        def touch(at):
            touched = self.surface.touch(CURVED, level=0, region_mm=SQUARES[CURVED])
            results[at] = touched.force_n.tobytes()

        threads = [threading.Thread(target=touch, args=(at,)) for at in range(len(results))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(results, results[:1] * len(results))

    def test_columns_are_told(self):
        recording = self.surface.touch(CURVED, level=0, region_mm=SQUARES[CURVED])
        self.assertEqual(list(relievo.COLUMNS), list(recording.rows.dtype.names))
        self.assertEqual(relievo.COLUMNS["hip_z_mm"][0], "mm")
        force = np.sqrt(sum(recording[name] ** 2 for name in ("f_x_N", "f_y_N", "f_z_N")))
        np.testing.assert_allclose(recording.force_n, force, rtol=1e-12)


if __name__ == "__main__":
    unittest.main()
