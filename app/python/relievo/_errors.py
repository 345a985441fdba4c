# SPDX-License-Identifier: BSD-3-Clause
"""What the package raises: one class for each exit code of the command line."""

import re


class Error(Exception):
    """Something could not be done: what happened, what was done about it, what you can do.

    `code` names the sentence in the manual ("E101") or is empty.
    """

    def __init__(self, sentence: str, code: str = "") -> None:
        self.sentence = in_parameters(sentence)
        self.code = code
        super().__init__(self.sentence)

    def __str__(self) -> str:
        known = not self.code or self.code in self.sentence
        return self.sentence if known else f"{self.code}: {self.sentence}"

    def __reduce__(self) -> "tuple[type[Error], tuple[str, str]]":
        return type(self), (self.sentence, self.code)


class ArgumentError(Error, ValueError):
    """A value that a parameter does not take. Exit code 1 of the command line."""


class FileError(Error):
    """A file that is missing, unreadable or damaged. Exit code 2."""


class WriteError(Error):
    """A result that cannot be written. Exit code 3."""


class DeviceError(Error):
    """A device that is absent, busy or misbehaves. Exit code 6."""


class GraphicsError(Error):
    """There are no graphics to draw with. Exit code 7."""


class Cancelled(Error):
    """It was told to stop. Exit code 130."""


# Parameters that are not called as the option of the command line, with its dashes below the line.
PARAMETERS = {
    "turn": "turn_deg",
    "spacing": "spacing_mm",
    "pixel-size": "pixel_mm",
    "height-scale": "height_scale_mm",
    "region": "region_mm",
    "stiffness": "stiffness_n_per_mm",
    "level-stiffness": "level_stiffness_n_per_mm",
    "damping": "damping_n_s_per_mm",
    "tick": "tick_n",
    "texture": "texture_mm",
    "knock": "knock_n",
    "magnet": "magnet_n",
    "magnet-reach": "magnet_reach_mm",
    "output": "log",
    "light": "light_deg",
    "radius": "radius_mm",
    "range": "range_mm",
    "eye-angle": "eye_angle_deg",
    "zero-plane": "zero_plane_mm",
}


def in_parameters(sentence: str) -> str:
    """A sentence that names options of the command line, with the names of parameters."""
    return re.sub(
        r"(?<![\w-])--([a-z]+(?:-[a-z]+)*)",
        lambda option: PARAMETERS.get(option[1], option[1].replace("-", "_")),
        sentence,
    )
