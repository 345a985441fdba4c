# SPDX-License-Identifier: BSD-3-Clause
"""The extension's stub says what the extension has, and the package is typed throughout."""

import inspect
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import relievo
from relievo import _relievo

# What every class of the binding library has: its own kind of class, and a way of being made that is
# refused.
ALLOWED = pathlib.Path(__file__).parent / "stub_differences.txt"
STUBTEST = ["mypy.stubtest", "relievo._relievo", "--ignore-missing-stub", "--allowlist", str(ALLOWED)]
PACKAGE = pathlib.Path(relievo.__file__).parent


def mypy(*words):
    """In the folder of the package, with a cache that is thrown away."""
    with tempfile.TemporaryDirectory() as cache:
        environment = {**os.environ, "MYPY_CACHE_DIR": cache}
        return subprocess.run(
            [sys.executable, "-m", *words], cwd=PACKAGE.parent, env=environment,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        )  # fmt: skip


class Stubs(unittest.TestCase):
    def test_stub_and_extension_agree(self):
        done = mypy(*STUBTEST)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_stub_that_says_more_is_found(self):
        self.assertTrue(hasattr(_relievo.Grid, "heights_mm"))
        with tempfile.TemporaryDirectory() as folder:
            package = pathlib.Path(folder) / "relievo"
            package.mkdir()
            for file in PACKAGE.iterdir():
                if file.is_file():
                    (package / file.name).symlink_to(file.resolve())
            stub = package / "_relievo.pyi"
            stub.unlink()
            text = (PACKAGE / "_relievo.pyi").read_text()
            stub.write_text(text + "\ndef not_there() -> int: ...\n")
            environment = {**os.environ, "PYTHONPATH": folder, "MYPY_CACHE_DIR": folder + "/cache"}
            done = subprocess.run(
                [sys.executable, "-m", *STUBTEST],
                cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            )  # fmt: skip
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("not_there", done.stdout)

    def test_the_package_is_typed(self):
        self.assertTrue((PACKAGE / "py.typed").exists())
        done = mypy("mypy", "--strict", "-p", "relievo")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_everything_public_says_what_it_is(self):
        for name in relievo.__all__:
            one = getattr(relievo, name)
            if not (inspect.isclass(one) or inspect.isroutine(one)):
                continue
            with self.subTest(name):
                self.assertTrue(inspect.getdoc(one))
                for member, value in vars(one).items() if inspect.isclass(one) else ():
                    if not member.startswith("_"):
                        self.assertTrue(inspect.getdoc(value), member)

    def test_arrays_say_shape_and_unit(self):
        for owner, names in (
            (relievo.Grid, ("heights_mm", "origins", "measured")),
            (relievo.Window, ("heights_mm", "origins")),
            (relievo.Recording, ("rows", "force_n")),
            (relievo.Surface, ("view_from_file", "render")),
        ):
            for name in names:
                self.assertRegex(inspect.getdoc(getattr(owner, name)), r"shape \(", name)
        self.assertIn("mm", inspect.getdoc(relievo.Grid.heights_mm))
        self.assertIn(" N", inspect.getdoc(relievo.Recording.force_n))


if __name__ == "__main__":
    unittest.main()
