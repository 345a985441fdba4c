# SPDX-License-Identifier: BSD-3-Clause
"""Good files to begin from: one of every format that is read, and all that relievo writes."""
import math
import os
import subprocess

SIZE_MM = 60


def height_mm(x, y, phase):
    """A wave on a slope: nothing of it is flat, and no two cells are alike."""
    return 3 * math.sin(0.31 * x + phase) * math.cos(0.23 * y) + 0.05 * x


def cloud(samples, phase=0.0):
    """A coloured cloud of samples x samples points as ASCII PLY."""
    rows = []
    for j in range(samples):
        for i in range(samples):
            x, y = SIZE_MM * i / (samples - 1), SIZE_MM * j / (samples - 1)
            rows.append(f"{x:.4f} {y:.4f} {height_mm(x, y, phase):.4f} "
                        f"{(4 * i) % 256} {(4 * j) % 256} 90")
    header = ["ply", "format ascii 1.0", f"element vertex {len(rows)}", "property float x",
              "property float y", "property float z", "property uchar red",
              "property uchar green", "property uchar blue", "end_header"]
    return "\n".join(header + rows) + "\n"


def stroke(seconds=0.4):
    """A press and a way along the surface, in the hand's frame."""
    rows = ["t_s,x_mm,y_mm,z_mm"]
    for n in range(int(seconds * 100) + 1):
        t = n / 100
        rows.append(f"{t:.2f},{-20 + 60 * t:.3f},{5 * t:.3f},{8 - 40 * min(t, 0.2):.3f}")
    return "\n".join(rows) + "\n"


def write(folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
        stream.write(text)


def base(folder, samples=40):
    """What the commands of the other attacks start from."""
    write(folder, "scan.ply", cloud(samples))
    write(folder, "other.ply", cloud(samples, 1.0))
    write(folder, "stroke.csv", stroke())


# Made one by one in the folder of `base`; each may use what those before it made.
MADE = [
    ["depthmap", "scan.ply", "-o", "map.tif", "--quality"],
    ["depthmap", "other.ply", "-o", "othermap.tif", "--quality"],
    ["touch", "scan.ply", "--stroke", "stroke.csv", "--frame", "device", "-o", "log.csv"],
    ["touch", "scan.ply", "--stroke", "stroke.csv", "--frame", "device", "-o", "log.h5"],
    ["project", "new", "log.csv", "-o", "work.relievo.json"],
    ["project", "package", "work.relievo.json", "-o", "cite.zip"],
    ["convert", "map.tif", "grid.asc"],
    ["convert", "map.tif", "cloud.ply"],
    ["convert", "map.tif", "points.xyz"],
    ["convert", "map.tif", "solid.stl"],
    ["prepare", "scan.ply", "-o", "ready.ply", "--thin", "2", "--write-recipe", "recipe.json"],
    ["render", "scan.ply", "-o", "picture.png", "--pixels", "64"],
]


def made(bed, folder):
    """Runs MADE. @return faults: none of them may fail"""
    base(folder)
    faults = []
    for command in MADE:
        run = bed.run(command, folder)
        if run.code != 0:
            faults.append("A good file could not be made: " + run.text())
    return faults


def good_files(program, folder):
    """One small file of every format, by the program built beside the hostile test."""
    subprocess.run([program, folder], check=True)
    return sorted(os.listdir(folder))
