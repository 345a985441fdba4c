# SPDX-License-Identifier: BSD-3-Clause
"""Python and the command line give the same numbers, to the last bit."""

import locale
import re
import struct
import unittest
import zlib

import numpy as np
import relievo
from case import CURVED, DRAWS, FLAT, RELIEF, SQUARES, Case, command


def pixels_of_png(data):
    """RGB or RGBA of 8 bits, by the rules of the format and none of this project's code."""
    at, head, packed = 8, None, b""
    while at < len(data):
        (size,), kind = struct.unpack(">I", data[at : at + 4]), data[at + 4 : at + 8]
        body = data[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            head = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    width, height, bits, colours, _, _, interlaced = head
    assert (bits, interlaced) == (8, 0) and colours in (2, 6), head
    step = 3 if colours == 2 else 4
    raw = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + step * width)
    rows = np.zeros((height + 1, step * (width + 1)), np.int64)
    for y in range(height):
        kind, line = int(raw[y, 0]), raw[y, 1:].astype(np.int64)
        above, here = rows[y], rows[y + 1]
        if kind in (0, 2):
            here[step:] = (line + (above[step:] if kind == 2 else 0)) & 255
            continue
        for x in range(step * width):
            a, b, c = here[x], above[x + step], above[x]
            if kind == 1:
                guess = a
            elif kind == 3:
                guess = (a + b) // 2
            else:
                far = [abs(b - c), abs(a - c), abs(a + b - 2 * c)]
                guess = (a, b, c)[far.index(min(far))]
            here[x + step] = (line[x] + guess) & 255
    return rows[1:, step:].astype(np.uint8).reshape(height, width, step)


def columns_of_csv(text):
    """The rows of a log: name -> column, as text."""
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    names = lines[0].split(",")
    rows = [line.split(",", len(names) - 1) for line in lines[1:]]
    return {name: [row[i] for row in rows] for i, name in enumerate(names)}


class SameBits(Case):
    def test_depth_map(self):
        options = ["--cells", "300", "--holes", "interpolate:1000", "--rule", "median"]
        command("depthmap", RELIEF, *options, "-o", self.path("map.tif"))
        ours = relievo.open(RELIEF, cells=300, holes="interpolate:1000", rule="median").depth_map
        theirs = relievo.open(self.path("map.tif")).depth_map
        self.assertSameBits(ours.heights_mm, theirs.heights_mm)
        self.assertSameBits(ours.origins, theirs.origins)
        self.assertEqual(ours.spacing_mm, theirs.spacing_mm)

    def test_depth_map_without_options(self):
        command("depthmap", RELIEF, "-o", self.path("plain.tif"))
        theirs = relievo.open(self.path("plain.tif")).depth_map
        self.assertSameBits(self.surface.depth_map.heights_mm, theirs.heights_mm)
        self.assertSameBits(self.surface.depth_map.origins, theirs.origins)

    def test_levels(self):
        command("pyramid", RELIEF, "-o", self.path("level.tif"))
        files = sorted(self.path("").glob("level.L?.tif"))
        self.assertEqual(len(files), self.surface.levels)
        self.assertGreater(len(files), 1)
        for level, (grid, file) in enumerate(zip(self.surface.pyramid, files)):
            self.assertEqual(grid.level, level)
            self.assertSameBits(grid.heights_mm, relievo.open(file).depth_map.heights_mm)

    def test_map_by_tiles(self):
        command("pyramid", RELIEF, "--memory", "200", "-o", self.path("tiles.tif"))
        tiled = relievo.open(self.path("tiles.L0.tif"))
        self.assertTrue(tiled.by_tiles)
        self.assertEqual(tiled.levels, self.surface.levels)
        region = {"level": 1, "region_mm": (65, 75, 90, 90)}
        self.assertSameBits(tiled.window(**region).heights_mm, self.surface.window(**region).heights_mm)
        self.assertSameBits(tiled.depth_map.heights_mm, self.surface.depth_map.heights_mm)
        self.assertSameBits(tiled.level(2).heights_mm, self.surface.level(2).heights_mm)
        touched = tiled.touch(CURVED, level=0, region_mm=SQUARES[CURVED])
        same = self.surface.touch(CURVED, level=0, region_mm=SQUARES[CURVED])
        self.assertSameBits(touched.force_n, same.force_n)

    def test_window(self):
        command("touch", RELIEF, "--level=0", "--region=65,75,50,50", "--gain=1.5", f"--stroke={CURVED}",
                "-o", self.path("w.csv"), "--window-out", self.path("window.tif"))  # fmt: skip
        ours = self.surface.window(level=0, region_mm=(65, 75, 50, 50), gain=1.5)
        self.assertSameBits(ours.heights_mm, relievo.open(self.path("window.tif")).depth_map.heights_mm)
        self.assertEqual((ours.x_mm, ours.y_mm, ours.side_mm, ours.level), (65, 75, 50, 0))

    def test_touch(self):
        for stroke, square in SQUARES.items():
            words = ["--level=0", "--region=" + ",".join(map(str, square))]
            command("touch", RELIEF, *words, f"--stroke={stroke}", "-o", self.path("log.csv"))
            ours = self.surface.touch(stroke, level=0, region_mm=square)
            self.assert_as_logged(ours, self.path("log.csv").read_text())
            self.assertGreater(ours.force_n.max(), 0.5)

    def assert_as_logged(self, ours, text):
        theirs = columns_of_csv(text)
        self.assertEqual(len(ours), len(theirs["t_s"]))
        self.assertEqual(set(theirs) - {"event"}, set(ours.rows.dtype.names))
        for name in ours.rows.dtype.names:
            given = np.array([float(value) for value in theirs[name]])
            self.assertSameBits(np.asarray(ours[name], np.float64) + 0, given + 0)

    def test_touch_with_everything(self):
        feel = ["--preset=bronze", f"--stiffness={1 / 3!r}", "--friction=0.5,0.25", "--damping=0.001",
                "--texture=0.05", "--knock=0.25", "--magnet=0.125", "--magnet-reach=1"]  # fmt: skip
        words = ["--level=0", "--region=65,75,50,50", *feel]
        command("touch", RELIEF, *words, f"--stroke={CURVED}", "-o", self.path("feel.csv"))
        ours = self.surface.touch(
            CURVED, level=0, region_mm=[65, 75, 50, 50], preset="bronze", stiffness_n_per_mm=1 / 3,
            friction=(0.5, 0.25), damping_n_s_per_mm=0.001, texture_mm=0.05, knock_n=0.25,
            magnet_n=0.125, magnet_reach_mm=1,
        )  # fmt: skip
        self.assert_as_logged(ours, self.path("feel.csv").read_text())

    def test_log_and_plot_have_the_same_bytes(self):
        log, plot = self.path("same.csv"), self.path("same.svg")
        words = ["--level=0", "--region=65,75,50,50", f"--stroke={CURVED}", f"--output={log}"]
        command("touch", RELIEF, *words, f"--plot={plot}")
        drawn = plot.read_text()
        command("touch", RELIEF, *words)
        theirs = log.read_bytes()
        log.unlink()
        ours = self.surface.touch(CURVED, level=0, region_mm=(65, 75, 50, 50), log=log)
        self.assertEqual(log.read_bytes(), theirs)
        self.assertEqual(ours.plot_svg(), re.sub(r"\n<metadata>.*</metadata>", "", drawn, flags=re.S))
        command("replay", log, "--verify")

    def test_another_language_changes_no_number(self):
        """Under a locale that writes numbers with a comma; ./test makes it."""
        here = locale.setlocale(locale.LC_ALL)
        try:
            locale.setlocale(locale.LC_ALL, "de_DE.UTF-8")
        except locale.Error:
            self.skipTest("There is no German locale.")
        self.addCleanup(locale.setlocale, locale.LC_ALL, here)
        how = {"level": 0, "region_mm": (65.5, 75.25, 50, 50), "stiffness_n_per_mm": 0.75}
        logs = []
        for name in ("de_DE.UTF-8", "C"):
            locale.setlocale(locale.LC_ALL, name)
            log = self.path("language.csv")
            surface = relievo.open(RELIEF, spacing_mm=0.75)
            touched = surface.touch(CURVED, **how, log=log)
            logs.append((log.read_bytes(), touched.plot_svg(), surface.messages))
        self.assertEqual(logs[0], logs[1])

    def test_recordings(self):
        for ending in ("csv", "h5"):
            file = self.path("read." + ending)
            touched = self.surface.touch(FLAT, level=0, region_mm=SQUARES[FLAT], log=file)
            read = relievo.read_recording(file)
            for name in touched.rows.dtype.names:
                self.assertSameBits(np.array(read[name]), np.array(touched[name]))
            self.assertSameBits(read.force_n, touched.force_n)
            self.assertEqual(read.events, touched.events)
            self.assertIn("relievo log", read.header)

    def test_array_strokes_are_those_of_files(self):
        points = np.loadtxt(CURVED, delimiter=",", skiprows=1)
        square = {"level": 0, "region_mm": SQUARES[CURVED]}
        of_file = self.surface.touch(CURVED, **square)
        of_array = self.surface.touch(points, **square)
        of_list = self.surface.touch(points.tolist(), **square)
        self.assertSameBits(np.array(of_array["proxy_z_mm"]), np.array(of_file["proxy_z_mm"]))
        self.assertSameBits(np.array(of_list["f_z_N"]), np.array(of_file["f_z_N"]))

    @unittest.skipUnless(DRAWS, "nothing draws in this build")
    def test_picture(self):
        for words, how in (
            (["--pixels=160"], {"pixels": 160}),
            (
                ["--region=65,75,50,50", "--pixels=96", "--stereo=dubois", "--relief=slope", "--scale-bar"],
                {"region_mm": (65, 75, 50, 50), "pixels": 96, "stereo": "dubois", "relief": "slope",
                 "scale_bar": True},
            ),
        ):  # fmt: skip
            command("render", RELIEF, *words, "-o", self.path("picture.png"))
            ours = self.surface.render(**how)
            self.assertSameBits(ours, pixels_of_png(self.path("picture.png").read_bytes()))
            self.assertGreater(len(np.unique(ours)), 10)


if __name__ == "__main__":
    unittest.main()
