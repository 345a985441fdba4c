# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces, and what is made of them."""

import os
import pathlib
import warnings
from typing import Any, List, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _picture, _relievo
from ._errors import ArgumentError, FileError
from ._relievo import Grid, Recording, Window
from ._words import Path, Words, number, path, several, text, text_or_number, whole

Stroke = Union[Path, npt.ArrayLike]


def open(
    file: Path,
    *,
    unit: Optional[str] = None,
    view: Optional[str] = None,
    turn_deg: Optional[Sequence[float]] = None,
    cells: Optional[int] = None,
    spacing_mm: Optional[float] = None,
    rule: Optional[str] = None,
    holes: Optional[str] = None,
    strays: Optional[str] = None,
    nodata: Union[str, float, None] = None,
    pixel_mm: Optional[float] = None,
    height_scale_mm: Optional[float] = None,
    height_zero: Optional[float] = None,
    factor: Optional[float] = None,
    load_incomplete: bool = False,
    parts: Optional[Sequence[int]] = None,
    reader: Optional[str] = None,
    keep_withheld: bool = False,
    every: Optional[int] = None,
) -> "Surface":
    """Opens a scan, a raster of heights, or a map that relievo wrote, and makes its surface.

    The file is read by a process of its own. What is None is as `relievo depthmap` has it.

    unit: of the file's coordinates: "mm", "cm", "m", "in", "ft", "us-ft"; None: as the file says
    view: "front", "back", "left", "right", "top", "bottom", "auto", "fit", "axes"
    turn_deg: (x, y, z), then turned about the view's axes
    cells: samples across the longer side; or
    spacing_mm: their distance
    rule: how points make a cell's height: "auto", "front", "second", "topmean", "median", "mean",
        "min", "splat", "quadratic"
    holes: "base", "interpolate:MAX_MM2", "membrane", "membrane:MAX_MM2", "none"
    strays: few points far from all others: "drop", "keep", "drop-groups"
    nodata: a height of the file that stands for none; "none": every height is one
    pixel_mm: of a raster, distance of its samples, whatever the file says
    height_scale_mm: of a raster, what a step of 1 of its values is; below 0: larger lie deeper
    height_zero: of a raster, the value that lies on the base plane; None: the lowest
    factor: the paper's M between levels, 1.1 to 8
    load_incomplete: take the complete records of a cut file (E101)
    parts: which scans of an E57 or PTX file, from 1
    reader: whose code reads points: "auto", "pcl", "own"
    keep_withheld: of LAS, also points that are marked as not to be used
    every: of clouds, one point in so many
    """
    words = Words([path("file", file)])
    words.add("unit", unit, text)
    words.add("view", view, text)
    words.add("turn_deg", turn_deg, lambda name, v: several(name, v, [3], number))
    words.add("cells", cells, whole)
    words.add("spacing_mm", spacing_mm, number)
    words.add("rule", rule, text)
    words.add("holes", holes, text)
    words.add("strays", strays, text)
    words.add("nodata", nodata, text_or_number)
    words.add("pixel_mm", pixel_mm, number)
    words.add("height_scale_mm", height_scale_mm, number)
    words.add("height_zero", height_zero, number)
    words.add("factor", factor, number)
    words.add_flag("load_incomplete", load_incomplete)
    words.add("parts", parts, lambda name, v: several(name, v, range(1, 10_000), whole))
    words.add("reader", reader, text)
    words.add_flag("keep_withheld", keep_withheld)
    words.add("every", every, whole)
    opened = _relievo.open(words.words)
    for sentence in opened.not_done:
        warnings.warn(sentence, RuntimeWarning, stacklevel=2)
    return Surface(opened, words.words)


def read_recording(file: Path) -> Recording:
    """Reads a recording of a touch, CSV or HDF5, as `relievo` and its window write them."""
    return _relievo.read_recording(path("file", file))


def example(name: str) -> pathlib.Path:
    """A file that comes with the package: "relief_f.ply", a scan of this project's generator, the
    strokes "flat.csv" and "curved.csv", and the notebook "python.ipynb".
    """
    found = pathlib.Path(__file__).parent / "examples" / text("name", name)
    if not found.is_file():
        raise FileError(f"There is no example '{name}'.")
    return found


def _region(words: Words, level: Any, region_mm: Any, gain: Any) -> Words:
    words.add("level", level, whole)
    words.add("region_mm", region_mm, lambda name, v: several(name, v, [4], number))
    words.add("gain", gain, number)
    return words


def _points(stroke: Any) -> "npt.NDArray[np.float64]":
    """Rows of t_s, x_mm, y_mm, z_mm."""
    if isinstance(stroke, np.ma.MaskedArray) and np.any(np.asarray(stroke.mask)):
        raise ArgumentError("stroke has values that are masked.")
    try:
        given = np.asarray(stroke)
        if given.dtype.kind == "c":  # Their other half would be dropped.
            raise TypeError
        points = np.ascontiguousarray(given, dtype=np.float64)
    except (TypeError, ValueError):
        raise TypeError("stroke is a file or an array of numbers, shape (n, 4).") from None
    except OverflowError:
        raise ArgumentError("stroke has values that are not finite.") from None
    if points.ndim != 2 or points.shape[1] != 4 or not len(points):
        raise ArgumentError(
            f"stroke has the shape {points.shape}; t_s, x_mm, y_mm, z_mm in each row are (n, 4)."
        )
    if not np.isfinite(points).all():
        raise ArgumentError("stroke has values that are not finite.")
    if not (np.diff(points[:, 0]) > 0).all():
        raise ArgumentError("The times of stroke, its first column, must increase.")
    return points


class Surface:
    """A scan made touchable: depth map and pyramid. Made by relievo.open; it never changes."""

    def __init__(self, opened: _relievo.OpenedSurface, words: List[bytes]) -> None:
        if not isinstance(opened, _relievo.OpenedSurface):
            raise TypeError("Surfaces are made by relievo.open(file).")
        self._opened = opened
        self._words = list(words)
        self._state = self._file_state()

    def __repr__(self) -> str:
        _, _, width_mm, height_mm = self.bounds_mm
        size = f"{width_mm:.5g} x {height_mm:.5g} mm"
        return f"<relievo.Surface of {self.file.name}: {size}, {self.levels} levels>"

    @property
    def file(self) -> pathlib.Path:
        """What was opened."""
        return pathlib.Path(os.fsdecode(self._opened.file))

    @property
    def depth_map(self) -> Grid:
        """The depth map z = f(x, y), with origins: what `relievo depthmap` writes, but for cells
        outside of the object, which are 0 here and NaN in files."""
        return self._opened.depth_map

    @property
    def levels(self) -> int:
        """How many levels the pyramid has."""
        return self._opened.levels

    @property
    def pyramid(self) -> Tuple[Grid, ...]:
        """The levels of the Gaussian pyramid, the finest first: what `relievo pyramid` writes."""
        return tuple(self._opened.level(level) for level in range(self.levels))

    def level(self, level: int) -> Grid:
        """One level of the pyramid; 0 is the finest."""
        index = int(whole("level", level))
        if not 0 <= index < self.levels:
            raise ArgumentError(f"There is no level {index}.")
        return self._opened.level(index)

    @property
    def factor(self) -> float:
        """The paper's M between levels."""
        return self._opened.factor

    @property
    def bounds_mm(self) -> Tuple[float, float, float, float]:
        """(left, bottom, width, height) of the map in the view."""
        return self._opened.bounds_mm

    @property
    def unit(self) -> str:
        """Of the file's coordinates, given or found."""
        return self._opened.unit

    @property
    def view(self) -> str:
        """From which side it is seen, given or found."""
        return self._opened.view

    @property
    def rule(self) -> str:
        """How points made heights, and why."""
        return self._opened.rule

    @property
    def by_tiles(self) -> bool:
        """A map by tiles: depth_map and pyramid are read from its files each time."""
        return self._opened.by_tiles

    @property
    def messages(self) -> Tuple[str, ...]:
        """What was chosen or assumed unasked, as sentences."""
        return tuple(self._opened.messages)

    @property
    def not_done(self) -> Tuple[str, ...]:
        """What was asked for and could not be done; relievo.open warned of it."""
        return tuple(self._opened.not_done)

    @property
    def view_from_file(self) -> "npt.NDArray[np.float64]":
        """float64, shape (4, 4): from a point of the file, in its unit, to mm of the view."""
        return self._opened.view_from_file

    def window(
        self,
        *,
        region_mm: Optional[Sequence[float]] = None,
        level: Optional[int] = None,
        gain: Optional[float] = None,
    ) -> Window:
        """200 x 200 heights of a square, as they lie under the hand.

        region_mm: (x, y, width, height) of the view, x and y of its lower left corner; None: all
        level: of the pyramid; None: the finest that 200 samples across the region can carry
        gain: factor on heights
        """
        words = _region(Words(), level, region_mm, gain).words
        self._warn_of_window(words)
        return self._opened.window(words)

    def touch(
        self,
        stroke: Stroke,
        *,
        region_mm: Optional[Sequence[float]] = None,
        level: Optional[int] = None,
        gain: Optional[float] = None,
        preset: Optional[str] = None,
        surface: Optional[str] = None,
        proxy: Optional[str] = None,
        stiffness_n_per_mm: Optional[float] = None,
        level_stiffness_n_per_mm: Optional[Sequence[float]] = None,
        friction: Union[float, Sequence[float], None] = None,
        damping_n_s_per_mm: Optional[float] = None,
        soft: Optional[float] = None,
        firmness: Optional[Path] = None,
        tick_n: Optional[float] = None,
        texture_mm: Optional[float] = None,
        knock_n: Optional[float] = None,
        magnet_n: Optional[float] = None,
        magnet_reach_mm: Optional[float] = None,
        safety: Optional[str] = None,
        frame: Optional[str] = None,
        log: Optional[Path] = None,
    ) -> Recording:
        """Runs a stroke over a window at 1 kHz: what `relievo touch` computes.

        stroke: a CSV file with the columns t_s, x_mm, y_mm, z_mm, or an array of shape (n, 4)
        region_mm, level, gain: as of window()
        preset: "smooth", "exact", "paper", "soft_stone", "bronze"; None: a spring alone
        surface: "auto", "exact", "spline"
        proxy: "converged", "equation" (the paper's eq. 2), "successive"
        stiffness_n_per_mm, damping_n_s_per_mm: per mm of hand
        level_stiffness_n_per_mm: of Detail 1, 2, 3 and all finer ones
        friction: Coulomb's, one number, or (static, dynamic)
        soft: part of the stiffness that ground keeps which was not measured, 0.25 to 1
        firmness: a raster that says where the ground is firm
        tick_n, texture_mm, knock_n, magnet_n, magnet_reach_mm: as the options of `relievo touch`
        safety: "on": limits as at a device; "off"
        frame: of the stroke: "view" or "device"
        log: a .csv or .h5 file to write, the bytes that `relievo touch` writes; needs a stroke that
            is a file, which the log names
        """
        is_file = isinstance(stroke, (str, bytes, os.PathLike))
        if log is not None and not is_file:
            raise ArgumentError("A log names its stroke's file. Write the stroke to a file first.")
        words = _region(Words(self._words), level, region_mm, gain)
        words.add("preset", preset, text)
        words.add("surface", surface, text)
        words.add("proxy", proxy, text)
        words.add("stiffness_n_per_mm", stiffness_n_per_mm, number)
        words.add(
            "level_stiffness_n_per_mm",
            level_stiffness_n_per_mm,
            lambda name, v: several(name, v, range(1, 5), number),
        )
        words.add("friction", friction, _one_or_two)
        words.add("damping_n_s_per_mm", damping_n_s_per_mm, number)
        words.add("soft", soft, number)
        words.add_path("firmness", firmness)
        words.add("tick_n", tick_n, number)
        words.add("texture_mm", texture_mm, number)
        words.add("knock_n", knock_n, number)
        words.add("magnet_n", magnet_n, number)
        words.add("magnet_reach_mm", magnet_reach_mm, number)
        words.add("safety", safety, text)
        words.add("frame", frame, text)
        if is_file:
            words.add_path("stroke", stroke)
            words.add_path("log", log)
            if log is not None:
                self._require_same_file()
            recording = _relievo.touch(self._opened, words.words, None)
        else:
            recording = _relievo.touch(self._opened, words.words, _points(stroke))
        self._warn_of_window(_region(Words(), level, region_mm, gain).words)
        return recording

    def render(
        self,
        *,
        region_mm: Optional[Sequence[float]] = None,
        level: Optional[int] = None,
        gain: Optional[float] = None,
        pixels: Optional[int] = None,
        stereo: Optional[str] = None,
        swap_eyes: bool = False,
        eye_angle_deg: Optional[float] = None,
        zero_plane_mm: Optional[float] = None,
        relief: Optional[str] = None,
        colours: Optional[str] = None,
        light_deg: Optional[Sequence[float]] = None,
        radius_mm: Optional[float] = None,
        range_mm: Optional[Sequence[float]] = None,
        shading: Optional[float] = None,
        scale_bar: bool = False,
    ) -> "npt.NDArray[np.uint8]":
        """Draws a window: the pixels that `relievo render` writes, shape (height, width, 3), row 0
        at the top; with transparency (height, width, 4).

        It is drawn from the file by relievo's own program, on a screen in memory where there is none.

        region_mm, level, gain: as of window()
        pixels: width and height, 16 to 16384
        stereo: "off", "anaglyph", "half", "dubois", "sidebyside", "overunder"
        swap_eyes: left and right eye change places
        eye_angle_deg: between the eyes' directions
        zero_plane_mm: height of zero parallax
        relief: how heights are painted: "lit", "height", "hillshade", "multi", "slope", "local",
            "skyview", "openness", "multiscale", "curvature", "occlusion", "natural", "intensity"
        colours: a name that `relievo render --colours` takes, as "cividis"
        light_deg: (azimuth, elevation)
        radius_mm: of reliefs that look around
        range_mm: (low, high) of the colours
        shading: 0 to 1
        scale_bar: draw one
        """
        words = _region(Words(self._words), level, region_mm, gain)
        words.add("pixels", pixels, whole)
        words.add("stereo", stereo, text)
        words.add_flag("swap_eyes", swap_eyes)
        words.add("eye_angle_deg", eye_angle_deg, number)
        words.add("zero_plane_mm", zero_plane_mm, number)
        words.add("relief", relief, text)
        words.add("colours", colours, text)
        words.add("light_deg", light_deg, lambda name, v: several(name, v, [2], number))
        words.add("radius_mm", radius_mm, number)
        words.add("range_mm", range_mm, lambda name, v: several(name, v, [2], number))
        words.add("shading", shading, number)
        words.add_flag("scale_bar", scale_bar)
        self._require_same_file()
        return _picture.draw(words.words, self.messages + self.not_done)

    def _warn_of_window(self, words: List[bytes]) -> None:
        note = self._opened.note_of_window(words)
        if note:
            warnings.warn(note, RuntimeWarning, stacklevel=3)

    def _file_state(self) -> Tuple[int, int, int]:
        try:
            found = os.stat(self._opened.file)
        except OSError:
            return (0, 0, 0)
        return (found.st_ino, found.st_size, found.st_mtime_ns)

    def _require_same_file(self) -> None:
        """Pictures and logs say which file they are from."""
        if self._file_state() != self._state:
            raise FileError(f"{self.file.name} has changed since it was opened. Open it again.")


def _one_or_two(parameter: str, value: Any) -> str:
    if np.ndim(value) == 0:
        return number(parameter, value)
    return several(parameter, value, range(1, 3), number)
