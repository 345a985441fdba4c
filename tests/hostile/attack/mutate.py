# SPDX-License-Identifier: BSD-3-Clause
"""Files bent at random: bits, bytes, pieces and numbers."""
import re
import struct

NUMBERS = [b"nan", b"inf", b"-inf", b"-1", b"0", b"1e308", b"-1e308", b"1e-320", b"4294967296",
           b"18446744073709551616", b"99999999999999999999999999", b"1,5", b"0x10", b"", b"--1",
           b"1e", b"2147483647", b"-2147483649"]
WORDS = [b"", b"\0", b"\n", b"\r\n", b" " * 5000, b"\xff\xfe", "\u00e4".encode(), b"../../x", b"%s%n",
         b'"', b"\\", b"{" * 3000, b"[" * 3000, b"<", b"&amp;"]


def flip_bits(data, chance):
    bent = bytearray(data)
    for _ in range(chance.choice((1, 1, 2, 8, 64))):
        bent[chance.randrange(len(bent))] ^= 1 << chance.randrange(8)
    return bytes(bent)


def overwrite(data, chance):
    """A number of 1, 2, 4 or 8 bytes at a place, with a value that readers trip over."""
    bent = bytearray(data)
    size = chance.choice((1, 2, 4, 8))
    values = [0, 1, 0x7F, 0x80, 0xFF, 0x7FFF, 0x8000, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF,
              (1 << 63) - 1, 1 << 63, (1 << 64) - 1, struct.unpack("<Q", struct.pack("<d", 1e308))[0]]
    value = chance.choice(values) & ((1 << (8 * size)) - 1)
    # Headers decide more than what follows them.
    most = len(bent) if chance.random() < 0.4 else min(len(bent), 400)
    at = chance.randrange(max(1, most - size))
    bent[at:at + size] = value.to_bytes(size, chance.choice(("little", "big")))[:len(bent) - at]
    return bytes(bent)


def cut(data, chance):
    return data[:chance.randrange(len(data))]


def take_out(data, chance):
    at = chance.randrange(len(data))
    return data[:at] + data[at + chance.choice((1, 2, 4, 16, 256, 4096)):]


def put_in(data, chance):
    at = chance.randrange(len(data) + 1)
    return data[:at] + chance.choice(WORDS + NUMBERS) + data[at:]


def double(data, chance):
    begin = chance.randrange(len(data))
    size = chance.choice((1, 4, 64, 1024))
    piece = data[begin:begin + size] * chance.choice((1, 1, 50))
    at = chance.randrange(len(data) + 1)
    return data[:at] + piece + data[at:]


def shuffle(data, chance):
    a, b = sorted((chance.randrange(len(data)), chance.randrange(len(data))))
    size = chance.choice((1, 4, 32, 512))
    first, second = data[a:a + size], data[b:b + size]
    bent = bytearray(data)
    bent[b:b + len(second)] = first[:len(second)]
    bent[a:a + len(first)] = second[:len(first)]
    return bytes(bent)


def renumber(data, chance):
    """A number that is written in letters becomes another."""
    places = [match.span() for match in re.finditer(rb"-?\d+(\.\d+)?(e[+-]?\d+)?", data[:65536])]
    if not places:
        return overwrite(data, chance)
    begin, end = chance.choice(places)
    return data[:begin] + chance.choice(NUMBERS) + data[end:]


WAYS = (flip_bits, overwrite, cut, take_out, put_in, double, shuffle, renumber)


def bent(data, chance):
    """The bytes, changed in one to three ways; never the bytes themselves."""
    while True:
        result = data
        for _ in range(chance.choice((1, 1, 1, 2, 3))):
            if result:
                result = chance.choice(WAYS)(result, chance)
        if result != data:
            return result
