#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Points and colours as relievo reads them, against readers that share no line with it.

independent_scans.py RELIEVO. Reads the coloured scans of the shared data (docs/dev/testing.md) with
the parsers below, written from the formats' descriptions, and the same files after `relievo prepare`
without steps. Coordinates, colours and intensities must agree point by point. Exit 77: no such data.
"""
import math
import os
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

# What is compared: file, and which of "colour" and "intensity" it has.
SCANS = [
    ("las/1.2-with-color.las", "ci"), ("las/autzen_trim.las", "ci"), ("las/autzen_trim.laz", "ci"),
    ("e57/ColouredCubeFloat.e57", "c"), ("pcd/table_scene_mug_stereo_textured.pcd", "c"),
    ("pcd/cturtle.pcd", "i"), ("ply/ankylosaurus_mesh.ply", "c"), ("ply/bun_zipper.ply", "i"),
    ("text/1.2-with-color.ptx", "ci"), ("text/points_cloudcompare.xyz", "c"),
]
PLY_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
             "float": "f", "double": "d", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H",
             "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}


def read_ply(data):
    head, body = data.split(b"end_header\n", 1)
    lines = [line.split() for line in head.decode("latin1").splitlines()]
    form = next(line[1] for line in lines if line[0] == "format")
    names, types, count, inside = [], [], 0, False
    for line in lines:
        if line[0] == "element":
            inside = line[1] == "vertex"
            count = int(line[2]) if inside else count
        elif line[0] == "property" and inside:
            types.append(PLY_TYPES[line[1]])
            names.append(line[2])
    if form == "ascii":
        rows = [[float(word) for word in line.split()] for line in body.split(b"\n")[:count]]
    else:
        layout = struct.Struct(("<" if "little" in form else ">") + "".join(types))
        rows = list(layout.iter_unpack(body[:count * layout.size]))
    return [dict(zip(names, row)) for row in rows]


def read_las(data):
    offset, = struct.unpack_from("<I", data, 96)
    form, size, count = struct.unpack_from("<BHI", data, 104)
    scale = struct.unpack_from("<3d", data, 131)
    shift = struct.unpack_from("<3d", data, 155)
    colour = {2: 20, 3: 28}.get(form & 0x3F)
    points = []
    for i in range(count):
        at = offset + i * size
        raw = struct.unpack_from("<3iH", data, at)
        point = {name: raw[k] * scale[k] + shift[k] for k, name in enumerate("xyz")}
        point["intensity"] = raw[3]
        point["red"], point["green"], point["blue"] = struct.unpack_from("<3H", data, at + colour)
        points.append(point)
    most = max(max(p["red"], p["green"], p["blue"]) for p in points)
    for p in points:
        for name in ("red", "green", "blue"):
            p[name] = p[name] >> 8 if most > 255 else p[name]
    return points


def unpack_lzf(packed, size):
    out = bytearray()
    at = 0
    while at < len(packed):
        control = packed[at]
        at += 1
        if control < 32:
            out += packed[at:at + control + 1]
            at += control + 1
            continue
        length = control >> 5
        if length == 7:
            length += packed[at]
            at += 1
        start = len(out) - ((control & 31) << 8) - packed[at] - 1
        at += 1
        for k in range(length + 2):
            out.append(out[start + k])
    assert len(out) == size
    return bytes(out)


def read_pcd(data):
    end = data.index(b"\n", data.index(b"\nDATA") + 1) + 1
    head = {line.split()[0]: line.split()[1:] for line in data[:end].decode().splitlines()
            if line and not line.startswith("#")}
    sizes = [int(n) for n in head["SIZE"]]
    counts = [int(n) for n in head.get("COUNT", ["1"] * len(sizes))]
    kinds = {("F", 4): "f", ("F", 8): "d", ("U", 4): "I", ("U", 2): "H", ("U", 1): "B",
             ("I", 4): "i", ("I", 2): "h", ("I", 1): "b"}
    total = int(head["POINTS"][0])
    packed, size = struct.unpack_from("<II", data, end)
    body = unpack_lzf(data[end + 8:end + 8 + packed], size)
    columns, at = {}, 0
    for name, kind, width, count in zip(head["FIELDS"], head["TYPE"], sizes, counts):
        layout = "I" if name in ("rgb", "rgba") else kinds[kind, width]
        if count == 1 and name != "_":
            columns[name] = struct.unpack_from("<%d%s" % (total, layout), body, at)
        at += width * count * total
    points = []
    for i in range(total):
        point = {name: column[i] for name, column in columns.items()}
        for name in ("rgb", "rgba"):
            if name in point:
                bits = point.pop(name)
                point.update(red=bits >> 16 & 255, green=bits >> 8 & 255, blue=bits & 255)
        points.append(point)
    return points


def read_e57(data):
    """One scan, numbers as whole bytes or as bits; pages lose their checksums first."""
    page = struct.unpack_from("<Q", data, 40)[0]
    logical = b"".join(data[i:i + page - 4] for i in range(0, len(data), page))

    def place(physical):
        return physical // page * (page - 4) + physical % page

    xml_at, xml_length = struct.unpack_from("<QQ", data, 24)
    start = place(xml_at)
    root = ElementTree.fromstring(logical[start:start + xml_length])
    space = root.tag[:root.tag.index("}") + 1]
    points = []
    for cloud in root.iter(space + "points"):
        section = place(int(cloud.get("fileOffset")))
        at = place(struct.unpack_from("<Q", logical, section + 16)[0])
        fields = list(cloud.find(space + "prototype"))
        streams = [bytearray() for _ in fields]
        count = int(cloud.get("recordCount"))
        end = section + struct.unpack_from("<Q", logical, section + 8)[0]
        while at < end:
            kind, length, number = logical[at], *struct.unpack_from("<HH", logical, at + 2)
            if kind == 1:
                lengths = struct.unpack_from("<%dH" % number, logical, at + 6)
                from_byte = at + 6 + 2 * number
                for stream, size in zip(streams, lengths):
                    stream += logical[from_byte:from_byte + size]
                    from_byte += size
            at += length + 1
        columns = {}
        for field, stream in zip(fields, streams):
            name = field.tag[len(space):]
            if field.get("type") == "Float":
                layout = "f" if field.get("precision") == "single" else "d"
                columns[name] = struct.unpack_from("<%d%s" % (count, layout), stream)
            else:
                low, high = int(field.get("minimum")), int(field.get("maximum"))
                bits = (high - low).bit_length()
                whole = int.from_bytes(stream, "little")
                step = (1 << bits) - 1
                columns[name] = [(whole >> bits * i & step) + low for i in range(count)]
        for i in range(count):
            point = {a: columns["cartesian" + a.upper()][i] for a in "xyz"}
            for colour in ("Red", "Green", "Blue"):
                point[colour.lower()] = columns["color" + colour][i]
            points.append(point)
    return points


def read_ptx(data):
    lines = data.decode().split("\n")
    cols, rows = int(lines[0]), int(lines[1])
    matrix = [[float(word) for word in line.split()] for line in lines[6:10]]
    points = []
    for line in lines[10:10 + cols * rows]:
        n = [float(word) for word in line.split()]
        if n[:3] == [0, 0, 0]:
            continue  # A ray that met nothing.
        p = {name: sum(n[k] * matrix[k][axis] for k in range(3)) + matrix[3][axis]
             for axis, name in enumerate("xyz")}
        p.update(intensity=n[3], red=n[4], green=n[5], blue=n[6])
        points.append(p)
    return points


def read_xyz(data):
    points = []
    for line in data.decode().splitlines():
        words = line.replace(",", " ").replace(";", " ").split()
        try:
            n = [float(word) for word in words]
        except ValueError:
            continue
        if len(n) >= 6:
            points.append(dict(x=n[0], y=n[1], z=n[2], red=n[3], green=n[4], blue=n[5]))
    return points


READERS = {".ply": read_ply, ".las": read_las, ".pcd": read_pcd, ".e57": read_e57,
           ".ptx": read_ptx, ".xyz": read_xyz}


def finite(points):
    return [p for p in points if all(math.isfinite(p[name]) for name in "xyz")]


def compare(name, kinds, ours, theirs):
    """Sentences of what differs; none is right."""
    if len(ours) != len(theirs):
        return ["%d points, not %d" % (len(ours), len(theirs))]
    wrong = []
    size = max(max(abs(p[a]) for a in "xyz") for p in theirs)
    for i, (a, b) in enumerate(zip(ours, theirs)):
        if any(abs(a[axis] - b[axis]) > 1e-6 * size for axis in "xyz"):
            wrong.append("point %d lies elsewhere" % i)
        if "c" in kinds and any(a[c] != round(b[c]) for c in ("red", "green", "blue")):
            wrong.append("point %d has another colour: %s, not %s" % (
                i, [a[c] for c in ("red", "green", "blue")],
                [b[c] for c in ("red", "green", "blue")]))
        if len(wrong) > 3:
            break
    if "i" in kinds and not wrong:
        low = min(p["intensity"] for p in theirs)
        high = max(p["intensity"] for p in theirs)
        # Kept in 16 bits of the range without one in a thousand at either end.
        away = sum(abs(a["intensity"] - b["intensity"]) > (high - low) / 30000
                   for a, b in zip(ours, theirs))
        if away > 0.003 * len(theirs):
            wrong.append("%d intensities are others" % away)
    return wrong


def main():
    relievo = sys.argv[1]
    here = os.path.dirname(os.path.abspath(__file__))
    shared = os.environ.get("RELIEVO_SHARED_DATA", os.path.join(here, "../../../shared/data"))
    if not os.path.isdir(shared):
        print("skipped: no shared scans (RELIEVO_SHARED_DATA)")
        return 77
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.ply")
        for name, kinds in SCANS:
            file = os.path.join(shared, name)
            subprocess.run([relievo, "prepare", file, "--unit", "mm", "-o", out], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            source = file[:-3] + "las" if file.endswith(".laz") else file  # Its twin.
            with open(source, "rb") as data, open(out, "rb") as ours:
                theirs = finite(READERS[os.path.splitext(source)[1]](data.read()))
                wrong = compare(name, kinds, read_ply(ours.read()), theirs)
            print("%-42s %7d points  %s" % (name, len(theirs), "; ".join(wrong) or "the same"))
            failed += 1 if wrong else 0
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
