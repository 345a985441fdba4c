#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Gives texts that another class says now the translation they had: keep_moved.py BEFORE AFTER.

AFTER is a file of translations as lupdate leaves it. A text of it that is unfinished and had one translation in BEFORE, in
whatever context, gets that one.
"""
import re
import sys
import xml.etree.ElementTree as ElementTree
from collections import defaultdict

MESSAGE = re.compile(r"    <message>\n.*?    </message>\n", re.S)
SOURCE = re.compile(r"<source>(.*?)</source>", re.S)
UNFINISHED = re.compile(r'<translation type="unfinished">.*?</translation>|<translation type="unfinished"/>', re.S)


def translations(text):
    """By source: every finished translation, as it stands in the file."""
    found = defaultdict(set)
    for message in MESSAGE.findall(text):
        if UNFINISHED.search(message) or "numerus" in message:
            continue
        translation = re.search(r"<translation>(.*?)</translation>", message, re.S)
        if translation:
            found[SOURCE.search(message).group(1)].add(translation.group(1))
    return found


def main():
    before = translations(open(sys.argv[1], encoding="utf-8").read())
    text = open(sys.argv[2], encoding="utf-8").read()

    def kept(message):
        known = before.get(SOURCE.search(message.group()).group(1), set())
        if len(known) != 1 or "numerus" in message.group():
            return message.group()
        return UNFINISHED.sub(lambda _: f"<translation>{next(iter(known))}</translation>", message.group())

    text = MESSAGE.sub(kept, text)
    ElementTree.fromstring(text)  # Still well formed.
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
