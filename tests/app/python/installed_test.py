# SPDX-License-Identifier: BSD-3-Clause
"""The package where `cmake --install` puts it needs nothing of the folder where it was built."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

BUILD = os.environ["RELIEVO_BINARY_DIR"]
WORK = """
import sys
import relievo
surface = relievo.open(relievo.example("relief_f.ply"), cells=100)
touched = surface.touch(relievo.example("flat.csv"), level=0, region_mm=(240, 60, 50, 50))
assert touched.force_n.max() > 0.5
if sys.argv[1] == "draws":
    assert surface.render(pixels=64).shape == (64, 64, 3)
print(relievo.__file__)
print(open("/proc/self/maps").read())
"""


class Installed(unittest.TestCase):
    def test_it_needs_nothing_of_the_build(self):
        with tempfile.TemporaryDirectory() as folder:
            for component in ("cli", "draw", "python"):
                subprocess.run(
                    [os.environ["CMAKE_PROGRAM"], "--install", BUILD, "--prefix", folder,
                     "--component", component],
                    check=True, stdout=subprocess.DEVNULL,
                )  # fmt: skip
            package = pathlib.Path(folder) / "lib" / "python3" / "dist-packages"
            draws = os.environ["RELIEVO_UI"] not in ("OFF", "0", "FALSE")
            done = subprocess.run(
                [sys.executable, "-B", "-c", WORK, "draws" if draws else ""], cwd=folder, text=True,
                env={**os.environ, "PYTHONPATH": str(package)}, stdout=subprocess.PIPE, check=True,
            )  # fmt: skip
            self.assertTrue(done.stdout.startswith(str(package)))
            self.assertIn("librelievo_haptics.so", done.stdout)
            self.assertNotIn(BUILD, done.stdout)


if __name__ == "__main__":
    unittest.main()
