# SPDX-License-Identifier: BSD-3-Clause
"""The notebook runs from top to bottom, shows the paper's force figure, and keeps nothing of a run."""

import os
import re
import tempfile
import unittest

import jupyter_client
import nbclient
import nbformat
from case import CURVED, DRAWS, FLAT, RELIEF, SOURCE, SQUARES, command

NOTEBOOK = SOURCE / "docs" / "user" / "python.ipynb"


def read():
    return nbformat.read(NOTEBOOK, as_version=4)


class Notebook(unittest.TestCase):
    def test_nothing_of_a_run_is_kept(self):
        notebook = read()
        nbformat.validate(notebook)
        self.assertEqual(len(notebook.cells), 10)
        for cell in notebook.cells:
            self.assertNotRegex(cell.source, r"(^|[\s\"'])/[a-z]", "no place on any machine")
            self.assertEqual(cell.get("outputs", []), [])
            self.assertIsNone(cell.get("execution_count"))

    @unittest.skipUnless(DRAWS, "nothing draws in this build")
    def test_it_runs_and_shows_the_force_figure(self):
        notebook = read()
        with tempfile.TemporaryDirectory() as folder:
            # Nothing of the set-up of whoever runs the test.
            for name in ("HOME", "IPYTHONDIR", "JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR"):
                os.environ[name] = folder
            manager = jupyter_client.AsyncKernelManager(kernel_name="python3")
            client = nbclient.NotebookClient(notebook, km=manager, timeout=None, startup_timeout=600)
            client.execute(cwd=folder)
            shown = self.plots(notebook)
            for cell, stroke in (("flat", FLAT), ("curved", CURVED)):
                file = os.path.join(folder, cell + ".svg")
                square = ",".join(map(str, SQUARES[stroke]))
                command("touch", RELIEF, "--level=0", "--region=" + square, "--stroke", stroke,
                        "-o", file + ".csv", "--plot", file)  # fmt: skip
                with open(file) as drawn:
                    plain = re.sub(r"\n<metadata>.*</metadata>", "", drawn.read(), flags=re.S)
                self.assertEqual(shown[cell], plain)
        self.assertIn("image/png", self.output(notebook, "picture").data)
        steps = re.findall(r"at most ([\d.]+) N", self.output(notebook, "proxies").text)
        self.assertGreater(float(steps[0]), 10 * float(steps[1]), "equation (2) is felt as noise")

    @staticmethod
    def output(notebook, name):
        return next(cell for cell in notebook.cells if cell.id == name).outputs[0]

    def plots(self, notebook):
        return {name: self.output(notebook, name).data["image/svg+xml"] for name in ("flat", "curved")}


if __name__ == "__main__":
    unittest.main()
