# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the Python package have in common."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import relievo

SOURCE = pathlib.Path(os.environ["RELIEVO_SOURCE_DIR"])
DRAWS = os.environ["RELIEVO_UI"] not in ("OFF", "0", "FALSE")
RELIEF = SOURCE / "data" / "samples" / "relief_f.ply"
FLAT = SOURCE / "data" / "strokes" / "flat.csv"
CURVED = SOURCE / "data" / "strokes" / "curved.csv"
SQUARES = {FLAT: (240, 60, 50, 50), CURVED: (65, 75, 50, 50)}


def command(*words):
    """What the command line writes to standard output."""
    done = subprocess.run(
        [os.environ["RELIEVO"], *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    if done.returncode != 0:
        raise AssertionError(f"{words}: {done.returncode}: {done.stderr.decode()}")
    return done.stdout


class Case(unittest.TestCase):
    """Has a folder of its own, and one surface for all of its tests."""

    @classmethod
    def setUpClass(cls):
        cls._folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls._folder.cleanup)
        cls.surface = relievo.open(RELIEF)

    def path(self, name):
        return pathlib.Path(self._folder.name) / name

    def assertSameBits(self, ours, theirs):
        self.assertEqual(ours.dtype, theirs.dtype)
        self.assertEqual(ours.shape, theirs.shape)
        self.assertEqual(ours.tobytes(), theirs.tobytes())
