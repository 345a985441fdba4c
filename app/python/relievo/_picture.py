# SPDX-License-Identifier: BSD-3-Clause
"""Pictures: drawn by relievo's own program, which loads the libraries of graphics; no other does."""

import os
import re
import subprocess
import tempfile
import warnings
from typing import List, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from . import _errors, _relievo

_ERRORS = {
    1: _errors.ArgumentError,
    2: _errors.FileError,
    3: _errors.WriteError,
    5: _errors.FileError,
    6: _errors.DeviceError,
    7: _errors.GraphicsError,
    130: _errors.Cancelled,
}
_NOT_ALL_DONE = 4


def _sentences(said: bytes) -> List[str]:
    lines = said.decode("utf-8", "backslashreplace").splitlines()
    return [line[len("relievo: ") :] for line in lines if line.startswith("relievo: ")]


def _run(words: Sequence[bytes]) -> Tuple[bytes, List[str]]:
    """What the program that draws writes, and what it has to say. Ctrl+C ends it."""
    program = _relievo.drawing_program()
    done = subprocess.run(
        [program, *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    said = _sentences(done.stderr)
    if done.returncode in (0, _NOT_ALL_DONE):
        return done.stdout, said
    sentence = said[-1] if said else f"The program that draws ended with {done.returncode}."
    code = re.match(r"(E\d{3}): ", sentence)
    raise _errors_of(done.returncode)(sentence[code.end() :] if code else sentence, code[1] if code else "")


def _errors_of(exit_code: int) -> "type[_errors.Error]":
    return _ERRORS.get(exit_code, _errors.Error)


def _pixels(file: bytes) -> "npt.NDArray[np.uint8]":
    """A picture's pixels as the program that drew it reads them: nothing is parsed here."""
    handed, _ = _run([b"pixels-" + _relievo.__version__.encode(), file])
    head, _, values = handed.partition(b"\n")
    width, height, channels = (int(word) for word in head.split())
    return np.frombuffer(values, np.uint8).reshape(height, width, channels)


def draw(words: Sequence[bytes], known: Sequence[str]) -> "npt.NDArray[np.uint8]":
    """What `relievo render` of these words draws; it warns of what is not `known` yet."""
    with tempfile.TemporaryDirectory(prefix="relievo-") as folder:
        file = os.fsencode(os.path.join(folder, "picture.png"))
        _, said = _run([b"render", *words, b"--output=" + file])
        for sentence in said:
            if sentence not in known:
                warnings.warn(sentence, RuntimeWarning, stacklevel=3)
        return _pixels(file)
