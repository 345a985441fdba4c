# SPDX-License-Identifier: BSD-3-Clause
"""Feel and see scanned heritage at every scale, from Python.

Opens scans as depth maps, makes levels and windows of them, touches them along strokes, reads
recordings and draws pictures: the same functions, defaults and numbers as the command line
`relievo`, to the last bit. Lengths are mm, forces N, times s, angles degrees; names of parameters
say so. Arrays share memory with what they come from, which they keep; none can be written.

    surface = relievo.open("relief.ply", unit="mm")
    heights_mm = surface.depth_map.heights_mm
    recording = surface.touch("stroke.csv", level=0, region_mm=(65, 75, 50, 50))
    picture = surface.render(stereo="anaglyph")
"""

from ._errors import (
    ArgumentError,
    Cancelled,
    DeviceError,
    Error,
    FileError,
    GraphicsError,
    WriteError,
)
from ._relievo import COLUMNS, ORIGINS, Grid, Recording, Window, __version__
from ._surface import Surface, example, open, read_recording

__all__ = [
    "COLUMNS",
    "ORIGINS",
    "ArgumentError",
    "Cancelled",
    "DeviceError",
    "Error",
    "FileError",
    "GraphicsError",
    "Grid",
    "Recording",
    "Surface",
    "Window",
    "WriteError",
    "__version__",
    "example",
    "open",
    "read_recording",
]
