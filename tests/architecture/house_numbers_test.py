#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""No class and no function of the program is larger than one takes in: tests/architecture/house_numbers_test.py.

Records, which are structs without methods, may have as many fields as what they describe has.
"""
import unittest
from pathlib import Path

from house_numbers import MOST_LINES, PRODUCT, classes_of, long_functions, sources

MOST_MEMBERS, MOST_METHODS = 25, 60


def too_large(text):
    """(name, members, methods) of the classes of a source that are above the bar."""
    return [one for one in classes_of(text)
            if one[2] > 0 and (one[1] > MOST_MEMBERS or one[2] > MOST_METHODS)]


def a_class(members, methods):
    return ("class Large {\n public:\n" + "".join(f"  void method{i}();\n" for i in range(methods)) + " private:\n" +
            "".join(f"  int member{i}_ = 0;\n" for i in range(members)) + "};\n")


def a_function(lines):
    return "void work(int with) {\n" + "  work(with);\n" * (lines - 1) + "}\n"


class HouseNumbers(unittest.TestCase):
    def setUp(self):
        root = Path(__file__).resolve().parents[2]
        self.texts = {str(file.relative_to(root)): file.read_text(encoding="utf-8")
                      for file in sources(root, PRODUCT)}

    def test_the_tree_is_read(self):
        classes = [one for text in self.texts.values() for one in classes_of(text)]
        self.assertGreater(len(self.texts), 1000)
        self.assertGreater(len(classes), 1000)

    def test_what_is_too_large_is_found(self):
        self.assertEqual(too_large(a_class(25, 60)), [])
        self.assertEqual(too_large(a_class(26, 1)), [("Large", 26, 1)])
        self.assertEqual(too_large(a_class(1, 61)), [("Large", 1, 61)])
        self.assertEqual(too_large(a_class(26, 0)), [], "a record")
        self.assertEqual(list(long_functions(a_function(MOST_LINES))), [])
        self.assertEqual(len(list(long_functions(a_function(MOST_LINES + 1)))), 1)

    def test_no_class_has_more_than_one_keeps_in_mind(self):
        found = [f"{name} of {file}: {members} members, {methods} methods"
                 for file, text in self.texts.items() for name, members, methods in too_large(text)]
        self.assertEqual(found, [], f"At most {MOST_MEMBERS} members and {MOST_METHODS} methods: make parts with one "
                                    "duty each (docs/adr/0202).")

    def test_no_function_is_longer_than_a_screen(self):
        found = [f"{first} of {file}: {lines} lines" for file, text in self.texts.items() if file.endswith(".cpp")
                 for lines, first in long_functions(text)]
        self.assertEqual(found, [], f"At most {MOST_LINES} lines: name its parts.")


if __name__ == "__main__":
    unittest.main()
