# SPDX-License-Identifier: BSD-3-Clause
"""Parameters as words of a command line, which the parser of the command line then reads."""

import math
import numbers
import os
from collections.abc import Mapping, Set
from typing import Any, Callable, Iterable, List, Union

from ._errors import PARAMETERS, ArgumentError

Path = Union[str, "os.PathLike[str]", bytes]

_OPTIONS = {parameter: option for option, parameter in PARAMETERS.items()}


def option_of(parameter: str) -> str:
    """spacing_mm -> --spacing"""
    return "--" + _OPTIONS.get(parameter, parameter.replace("_", "-"))


def path(parameter: str, value: Any) -> bytes:
    """The bytes of a file's name, from the root: a working folder that changes later is no matter."""
    if not isinstance(value, (str, bytes, os.PathLike)):
        raise TypeError(f"{parameter} is a file's name or a path, not {_kind(value)}.")
    try:
        name = os.fsencode(value)
    except UnicodeEncodeError:
        raise ArgumentError(f"{parameter} has characters that no file's name has.") from None
    if not name:
        raise ArgumentError(f"{parameter} is empty. Give the name of a file.")
    if b"\0" in name:
        raise ArgumentError(f"{parameter} has a zero byte, which no file's name has.")
    return os.path.abspath(name)


def _kind(value: Any) -> str:
    return f"a {type(value).__name__}"


def number(parameter: str, value: Any) -> str:
    """A finite number, with every digit that it has."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{parameter} is a number, not {_kind(value)}.")
    try:
        exact = float(value)
    except OverflowError:
        exact = math.inf
    if not math.isfinite(exact):
        raise ArgumentError(f"{parameter} is {exact}. Give a finite number.")
    return repr(int(exact)) if exact.is_integer() and abs(exact) < 1e15 else repr(exact)


def whole(parameter: str, value: Any) -> str:
    """A whole number, 400 or numpy.int64(400); 400.0 is none."""
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise TypeError(f"{parameter} is a whole number, not {_kind(value)}.")
    number_of = int(value)
    if abs(number_of) >= 1 << 63:
        raise ArgumentError(f"{parameter} is a whole number that is far too large.")
    return str(number_of)


def text(parameter: str, value: Any) -> str:
    """A word that the command line knows."""
    if not isinstance(value, str):
        raise TypeError(f"{parameter} is a text, not {_kind(value)}.")
    if not value or "\0" in value or not _encodes(value):
        raise ArgumentError(f"{parameter} is no word that is known.")
    return value


def _encodes(value: str) -> bool:
    try:
        value.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return False
    return True


def text_or_number(parameter: str, value: Any) -> str:
    """-9999 or "none"."""
    return text(parameter, value) if isinstance(value, str) else number(parameter, value)


def several(parameter: str, values: Any, counts: Iterable[int], one: Callable[[str, Any], str]) -> str:
    """Numbers with commas between them, from anything that holds so many."""
    allowed = list(counts)
    wanted = f"{parameter} is {_counts(allowed)} numbers"
    if isinstance(values, (str, bytes, Mapping, Set)):  # A word, or without an order.
        raise TypeError(f"{wanted}, not {_kind(values)}.")
    try:
        found = list(values)
    except TypeError:
        raise TypeError(f"{wanted}, not {_kind(values)}.") from None
    if len(found) not in allowed:
        raise ArgumentError(f"{wanted}, not {len(found)}.")
    return ",".join(one(parameter, value) for value in found)


def _counts(allowed: List[int]) -> str:
    if len(allowed) == 1:
        return str(allowed[0])
    return f"{allowed[0]} to {allowed[-1]}"


class Words:
    """Words of a command line, in the order in which they are given."""

    def __init__(self, words: Iterable[bytes] = ()) -> None:
        self.words: List[bytes] = list(words)

    def add(self, parameter: str, value: Any, as_word: Callable[[str, Any], str]) -> None:
        """`--option=word`; None is left to the command line, which has the defaults."""
        if value is not None:
            word = f"{option_of(parameter)}={as_word(parameter, value)}"
            self.words.append(word.encode("utf-8", "surrogateescape"))

    def add_path(self, parameter: str, value: Any) -> None:
        if value is not None:
            self.words.append(option_of(parameter).encode() + b"=" + path(parameter, value))

    def add_flag(self, parameter: str, value: Any) -> None:
        if not isinstance(value, bool):
            raise TypeError(f"{parameter} is True or False, not {_kind(value)}.")
        if value:
            self.words.append(option_of(parameter).encode())
