#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers that say how easily the tree is taken in: tests/architecture/house_numbers.py [ROOT].

Classes are read by their form, not by a compiler: data members end in "_" or are fields of a struct
that has methods; a method is a declaration with parentheses.
"""
import re
import sys
from collections import Counter
from pathlib import Path

TOPS = ["core", "haptics", "plugins", "ui", "app", "data", "tests"]
PRODUCT = TOPS[:-1]
KEYWORDS = {"if", "for", "while", "switch", "return", "sizeof", "alignas", "decltype", "noexcept",
            "static_assert", "explicit", "Q_DECLARE_TR_FUNCTIONS", "friend", "using", "typedef"}


def sources(root, tops, endings=(".h", ".cpp")):
    for top in tops:
        for file in sorted((root / top).rglob("*")):
            if file.suffix in endings:
                yield file


def without_comments(text):
    text = re.sub(r'R"\((?:.|\n)*?\)"', '""', text)
    text = re.sub(r'"(?:\\.|[^"\\\n])*"', '""', text)
    text = re.sub(r"//[^\n]*", "", text)
    return re.sub(r"/\*(?:.|\n)*?\*/", "", text)


def closing(text, start):
    """The place behind the brace that closes the one at `start`."""
    depth = 0
    for at in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return at + 1
    return len(text)


def statements(body):
    """Declarations of a class, without what stands in their braces."""
    flat, at = "", 0
    while at < len(body):
        if body[at] == "{":
            end = closing(body, at)
            behind = body[end:].lstrip()[:1]
            flat += "{}" + ("" if behind in (";", ",") else ";")
            at = end
        else:
            flat += body[at]
            at += 1
    flat = re.sub(r"\b(?:public|private|protected|Q_SIGNALS|Q_OBJECT)\b(?: Q_SLOTS)?\s*:?", "", flat)
    return [" ".join(s.split()) for s in flat.split(";") if s.strip()]


def declared(statement):
    """How many names one declaration of data has, by the commas outside of brackets."""
    depth, names = 0, 1
    for sign in statement:
        depth += {"<": 1, "(": 1, ">": -1, ")": -1}.get(sign, 0)
        names += sign == "," and depth == 0
    return names


def classes_of(text):
    """(name, members, methods) of every class, also of those within others."""
    text = without_comments(text)
    for found in re.finditer(r"\b(?:class|struct)\s+(?:\w+\s+)?([\w:]+?)(?:\s+final)?\s*(?::(?!:)[^;{]*)?\{",
                             text):
        if re.search(r"enum\s*$", text[:found.start()]):
            continue
        start = found.end() - 1
        members = methods = 0
        for one in statements(text[start + 1:closing(text, start) - 1]):
            first = re.match(r"\w+", one)
            if not first or first.group() in ("class", "struct", "enum", "union", "using", "friend", "template",
                                              "static_assert", "typedef"):
                methods += bool(first and first.group() == "template" and "(" in one)
                continue
            head = re.split(r"=(?!=)|\{\}", one)[0]
            call = re.search(r"([~\w]+)\s*\(", re.sub(r"<[^<>]*(?:<[^<>]*>[^<>]*)*>", "", head))
            if call and call.group(1) not in KEYWORDS:
                methods += 1
            elif not one.startswith("static constexpr"):
                members += declared(one)
        yield found.group(1), members, methods


MOST_LINES = 60  # Of a function: about a screen.


def long_functions(text):
    """(lines, first line) of functions outside of classes that are longer than a screen."""
    lines, start = text.split("\n"), None
    for at, line in enumerate(lines):
        begins = re.match(r"\S.*\{$", line) and "(" in lines[at - 1] + line
        if begins and not re.match(r"namespace|struct|class|enum|constexpr|const |static const|inline constexpr", line):
            start = at
        if line == "}" and start is not None:
            if at - start > MOST_LINES:
                yield at - start, lines[start]
            start = None


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])
    texts = {file: file.read_text(encoding="utf-8") for file in sources(root, TOPS)}
    shown = {file: str(file.relative_to(root)) for file in texts}
    product = {f: t for f, t in texts.items() if shown[f].split("/")[0] in PRODUCT}

    print("Source files of the fullest folders:")
    folders = Counter(str(Path(name).parent) for name in shown.values())
    for folder, count in folders.most_common(10):
        print(f"  {count:4} {folder}")

    print("Largest classes, members and methods:")
    found = [(members, methods, name, shown[f])
             for f, text in product.items() for name, members, methods in classes_of(text)]
    largest = sorted(found, key=lambda c: max(c[0] / 25, c[1] / 60), reverse=True)[:10]
    for members, methods, name, file in largest:
        print(f"  {members:4} {methods:4} {name} ({file})")

    long = sorted(((lines, first, shown[f]) for f, text in product.items() if f.suffix == ".cpp"
                   for lines, first in long_functions(text)), reverse=True)
    print(f"Functions of more than {MOST_LINES} lines: {len(long)}")
    for lines, first, file in long[:5]:
        print(f"  {lines:4} {first[:60]} ({file})")

    print("Lines of ui/window/main_window.*:")
    for f, text in product.items():
        if re.match(r"ui/window/main_window\.(h|cpp)$", shown[f]):
            print(f"  {text.count(chr(10)):4} {shown[f]}")
    parts = [t.count("\n") for f, t in product.items() if shown[f].startswith("ui/window/main_window")]
    print(f"  {sum(parts):4} in all {len(parts)} files main_window*")

    print("Regular expressions:")
    patterns = [(shown[f], len(re.findall(r"std::regex\b|QRegularExpression\b(?!Match|>)", without_comments(t))))
                for f, t in product.items()]
    for file, count in patterns:
        if count:
            print(f"  {count:4} {file}")

    print("Callers of what says which kind of file it is:")
    for function in ("findFormat", "inputFactsHere", "inputFacts", "TiledMap::isOne", "isReadableRaster"):
        calls = Counter()
        for f, text in product.items():
            if shown[f].endswith(".cpp"):
                calls[shown[f]] += len(re.findall(rf"(?<![\w\"]){function}\(", without_comments(text)))
        files = [file for file, count in calls.items() if count]
        print(f"  {len(files):4} {function}: {', '.join(files)}")

    print("Virtual functions of the host's interfaces:")
    host = without_comments((root / "plugins/api/host.h").read_text(encoding="utf-8"))
    for one in re.finditer(r"class\s+(\w+)\s*(?::[^;{]*)?\{", host):
        body = host[one.end():closing(host, one.end() - 1)]
        print(f"  {len(re.findall(r'virtual (?!~)', body)):4} {one.group(1)}")

    print("Lines of sources:")
    lines = Counter()
    for f, text in texts.items():
        lines[shown[f].split("/")[0]] += text.count("\n")
    for top in TOPS:
        print(f"  {lines[top]:7} {top}")
    print(f"  {sum(lines.values()):7} all")


if __name__ == "__main__":
    main()
