# SPDX-License-Identifier: BSD-3-Clause
"""release_test.py SOURCE: .ci/release finds what does not agree; in copies of the files, with planted faults."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(sys.argv[1]).resolve()
FILES = ["CMakeLists.txt", "CHANGELOG.md", "CITATION.cff", ".zenodo.json", "app/desktop/relievo.metainfo.xml",
         "cmake/packages.cmake", "docs/user/clusters.md", "plugins/example/CMakeLists.txt"]


class Release(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = Path(folder.name)
        for name in FILES:
            (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(SOURCE / name, self.tree / name)
        listed = (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8")
        self.version = listed.split("project(relievo VERSION ")[1].split()[0]

    def change(self, name, old, new):
        text = (self.tree / name).read_text(encoding="utf-8")
        self.assertIn(old, text, name)
        (self.tree / name).write_text(text.replace(old, new, 1), encoding="utf-8")

    def release(self, *words):
        done = subprocess.run([SOURCE / ".ci/release", *words], env=dict(os.environ, RELIEVO_TREE=str(self.tree)),
                              capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def git(self, *words):
        who = ["-c", "user.name=nobody", "-c", "user.email=nobody@relievo.invalid", "-c", "commit.gpgsign=false"]
        subprocess.run(["git", "-C", self.tree, *who, *words], check=True, capture_output=True)

    def test_the_sources_agree(self):
        status, said = self.release("--check")
        self.assertEqual(status, 0, said)
        self.assertIn(self.version, said)

    def test_every_disagreement_is_named_with_its_file(self):
        for name, old, new in (
                ("CITATION.cff", "version: " + self.version, "version: 9.9.9"),
                ("CITATION.cff", "date-released: 20", "date-released: 19"),
                (".zenodo.json", '"version": "' + self.version, '"version": "9.9.9'),
                ("app/desktop/relievo.metainfo.xml", 'version="' + self.version + '" date', 'version="9.9.9" date'),
                ("app/desktop/relievo.metainfo.xml", 'date="20', 'date="19'),
                ("cmake/packages.cmake", "CPACK_PACKAGE_VERSION ${PROJECT_VERSION}", "CPACK_PACKAGE_VERSION 9.9.9"),
                ("plugins/example/CMakeLists.txt", "find_package(relievo 0", "find_package(relievo 9"),
                ("docs/user/clusters.md", "relievo-cli_" + self.version, "relievo-cli_9.9.9"),
                ("CHANGELOG.md", "## " + self.version + " - ", "## 9.9.9 - "),
                ("CHANGELOG.md", "## Unreleased", "## 9.9.10")):
            with self.subTest(name, new=new):
                before = (self.tree / name).read_text(encoding="utf-8")
                self.change(name, old, new)
                status, said = self.release("--check")
                self.assertEqual(status, 1, said)
                self.assertIn(name, said)
                (self.tree / name).write_text(before, encoding="utf-8")

    def test_the_version_of_the_build_is_the_one_that_counts(self):
        self.change("CMakeLists.txt", "VERSION " + self.version, "VERSION 9.9.9")
        status, said = self.release("--check")
        self.assertEqual(status, 1)
        for name in ("CITATION.cff", ".zenodo.json", "CHANGELOG.md", "metainfo.xml", "clusters.md", "example"):
            self.assertIn(name, said)

    def test_a_release_wants_all_committed_and_nothing_unreleased(self):
        # As the changelog is when a version is cut.
        (self.tree / "CHANGELOG.md").write_text(
            f"# Changelog\n\n## Unreleased\n\n## {self.version} - 2026-11-21\n\n- A line.\n", encoding="utf-8")
        for name, word in (("CITATION.cff", "date-released: "), ("app/desktop/relievo.metainfo.xml", 'date="')):
            text = (self.tree / name).read_text(encoding="utf-8")
            at = text.index(word) + len(word)
            (self.tree / name).write_text(text[:at] + "2026-11-21" + text[at + 10:], encoding="utf-8")
        self.git("init", "-q")
        self.git("add", ".")
        self.git("commit", "-q", "-m", "All")
        status, said = self.release(self.version, "--check")
        self.assertEqual(status, 0, said)
        status, said = self.release("9.9.9", "--check")
        self.assertEqual(status, 1)
        self.assertIn(f"CMakeLists.txt says '{self.version}' and not '9.9.9'.", said)
        self.change("CHANGELOG.md", "## Unreleased\n", "## Unreleased\n\n### Added\n\n- Not in a version.\n")
        status, said = self.release(self.version, "--check")
        self.assertEqual(status, 1)
        self.assertIn("still has lines under Unreleased", said)
        self.assertIn("Not committed", said)

    def test_the_archive_of_a_commit_has_the_same_bytes_every_time(self):
        self.git("init", "-q")
        self.git("add", ".")
        self.git("commit", "-q", "-m", "All")
        script = (SOURCE / ".ci/release").read_text(encoding="utf-8")
        pack = script[script.index("make_archive() {"):].split("\n}\n")[0] + "\n}\n"
        made = []
        for mask in ("022", "077"):
            out = self.tree / ("out" + mask)
            out.mkdir()
            subprocess.run(["bash", "-c", f"umask {mask}; {pack} make_archive 1.2.3 '{out}'"], cwd=self.tree, check=True)
            made.append((out / "relievo-1.2.3.tar.gz").read_bytes())
        self.assertEqual(made[0], made[1])
        self.assertGreater(len(made[0]), 1000)

    def test_without_a_version_it_says_how_it_is_called_and_makes_nothing(self):
        for words in ((), ("--chekc",)):
            status, said = self.release(*words)
            self.assertEqual(status, 1)
            self.assertIn(".ci/release VERSION", said)
        self.assertFalse((self.tree / "build").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
