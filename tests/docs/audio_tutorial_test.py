#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does the audio tutorial say what the program says, and name keys that it has?"""
import re
import sys
import unittest
import xml.etree.ElementTree
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PAGE = SOURCE / "docs/user/audio_tutorial.md"
TEXTS = SOURCE / "ui/translations/relievo_de.ts"


def sentences(text):
    return [part for part in re.split(r"(?<=[.!?])\s+", text.strip()) if part]


def known_sentences():
    """What the program can say, each a pattern: all that is translated of it, the catalogue among it."""
    patterns = set()
    for entry in xml.etree.ElementTree.parse(TEXTS).iter("source"):
        for sentence in sentences(entry.text or ""):
            pattern = re.sub(r"\\\{.*?\\\}", ".+", re.escape(sentence))
            patterns.add(re.sub(r"%(\d|n)", ".+", pattern))
    return patterns - {".+"}


def spoken():
    return [line.split("*relievo:*", 1)[1].strip() for line in PAGE.read_text(encoding="utf-8").splitlines()
            if line.startswith("*relievo:*")]


class AudioTutorial(unittest.TestCase):
    def test_the_program_says_so(self):
        patterns = known_sentences()
        self.assertGreater(len(patterns), 500)
        said = [sentence for line in spoken() for sentence in sentences(line)]
        self.assertGreater(len(said), 25)
        for sentence in said:
            with self.subTest(sentence):
                self.assertTrue(any(re.fullmatch(pattern, sentence) for pattern in patterns),
                                "no sentence of the program")

    def test_it_has_the_keys(self):
        """Written as one says them: Control, Alt and U."""
        keys = {"+".join(re.split(r", | and ", found)).replace("Control", "Ctrl")
                for found in re.findall(r"Control(?:, Alt)? and \w+", PAGE.read_text(encoding="utf-8"))}
        self.assertGreater(len(keys), 3)
        sources = "".join(file.read_text(encoding="utf-8") for folder in ("ui/window", "plugins/haptics")
                          for file in (SOURCE / folder).rglob("*.cpp"))
        for key in keys:
            with self.subTest(key):
                written = "Ctrl++|" if key == "Ctrl+Plus" else key + '"'
                self.assertTrue('"' + written in sources, "no key of the program")

    def test_no_sentence_asks_for_a_look(self):
        text = " ".join(PAGE.read_text(encoding="utf-8").split("## Chapter", 1)[1].split()).lower()
        for word in ("look at", "you see", "on the screen", "picture", "click on", "colour"):
            with self.subTest(word):
                self.assertNotIn(word, text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
