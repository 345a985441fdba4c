# SPDX-License-Identifier: BSD-3-Clause
"""The paper's force figure by the installed package, compared with the installed command line."""

import re
import subprocess

import relievo

surface = relievo.open(relievo.example("relief_f.ply"))
for name, square in (("flat", (240, 60, 50, 50)), ("curved", (65, 75, 50, 50))):
    stroke = relievo.example(name + ".csv")
    touched = surface.touch(stroke, level=0, region_mm=square)
    region = ",".join(map(str, square))
    subprocess.run(
        ["relievo", "touch", surface.file, "--level=0", "--region=" + region, "--stroke", stroke,
         "-o", name + ".csv", "--plot", name + ".svg"],
        check=True,
    )  # fmt: skip
    with open(name + ".svg") as figure:
        drawn = re.sub(r"\n<metadata>.*</metadata>", "", figure.read(), flags=re.S)
    assert touched.plot_svg() == drawn, "the figure differs from the command line's"
    logged = relievo.read_recording(name + ".csv")
    assert all((touched[column] == logged[column]).all() for column in relievo.COLUMNS)
    assert touched.force_n.max() > 0.5
    print(f"{name}: {len(touched)} ms, largest force {touched.force_n.max():.3f} N, as the command line")
