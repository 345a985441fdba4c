# SPDX-License-Identifier: BSD-3-Clause
"""The pages as a site: site_test.py SOURCE HTML CHROMIUM [PICTURES]. All is read as files, without a network."""
import filecmp
import os
import re
import subprocess
import sys
import tempfile
import unittest
import urllib.parse
from html.parser import HTMLParser
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
from browser import Browser, luminances  # noqa: E402

SOURCE, HTML, CHROMIUM = (Path(a).resolve() for a in sys.argv[1:4])
PICTURES = Path(sys.argv[4]) if len(sys.argv) > 4 else None


class Page(HTMLParser):
    """What a page points to, what can be pointed to in it, and its pictures."""

    def __init__(self, text):
        super().__init__()
        self.links, self.parts, self.places, self.pictures = [], [], set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        known = dict(attributes)
        if "id" in known:
            self.places.add(known["id"])
        if tag == "a" and "href" in known:
            self.links.append(known["href"])
        if tag == "link" and known.get("rel") == "stylesheet":
            self.parts.append(known["href"])
        if tag in ("img", "script") and known.get("src"):
            self.parts.append(known["src"])
        if tag == "img":
            self.pictures.append((known.get("src", ""), known.get("alt")))


def target_of(page, link):
    """The file that a link names and the place in it; nothing for an address elsewhere."""
    parts = urllib.parse.urlsplit(link)
    if parts.scheme or parts.netloc:
        return None
    path = urllib.parse.unquote(parts.path)
    return ((page.parent / path).resolve() if path else page), urllib.parse.unquote(parts.fragment)


def broken_links(pages, html):
    broken = []
    for file, page in pages.items():
        for link in page.links + page.parts:
            target = target_of(file, link)
            if target is None:
                if link in page.parts or not link.startswith(("https:", "mailto:")):
                    broken.append(f"{file}: {link} is elsewhere")
                continue
            there, place = target
            if not there.is_file() or html not in there.parents:
                broken.append(f"{file}: {link} is not there")
            elif place and there in pages and place not in pages[there].places:
                broken.append(f"{file}: {link} has no such place")
    return broken


def nameless_pictures(pages):
    """A word alone, or a file's name, says too little."""
    return [f"{file}: {source}" for file, page in pages.items() for source, alt in page.pictures
            if len((alt or "").split()) < 2 or Path(source).suffix in alt]


def pages_of(html):
    return {file: Page(file.read_text(encoding="utf-8")) for file in sorted(html.rglob("*.html"))}


def differences(one, other):
    def files(folder):
        return {file.relative_to(folder) for file in folder.rglob("*") if file.is_file()}
    different = sorted(files(one) ^ files(other))
    return different + [f for f in sorted(files(one) & files(other)) if not filecmp.cmp(one / f, other / f, False)]


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not (HTML / "index.html").is_file():
            raise AssertionError("The pages are not made: .ci/packages.txt names what the target 'site' needs.")
        cls.pages = pages_of(HTML)

    def test_every_page_of_the_sources_is_there_and_reached_from_the_first(self):
        sources = [p for p in (SOURCE / "docs").rglob("*.md") if SOURCE / "docs/site" not in p.parents]
        for page in sources + list(SOURCE.glob("*.md")):
            self.assertIn((HTML / page.relative_to(SOURCE)).with_suffix(".html"), self.pages)
        reached, waiting = set(), [HTML / "index.html"]
        while waiting:
            file = waiting.pop()
            if file in reached:
                continue
            reached.add(file)
            for link in self.pages[file].links:
                target = target_of(file, link)
                if target and target[0] in self.pages:
                    waiting.append(target[0])
        # The search is reached by its field.
        self.assertEqual(set(self.pages) - reached, {HTML / "search.html"})

    def test_the_menu_has_every_page_for_users(self):
        first = HTML / "index.html"
        named = {target_of(first, link)[0] for link in self.pages[first].links if target_of(first, link)}
        for page in (SOURCE / "docs/user").glob("*.md"):
            self.assertIn(HTML / "docs/user" / (page.stem + ".html"), named)

    def test_every_link_and_every_place_in_a_page_is_there(self):
        self.assertGreater(sum(len(page.links) for page in self.pages.values()), 5000)
        self.assertEqual(broken_links(self.pages, HTML), [])

    def test_every_picture_says_in_words_what_it_shows(self):
        self.assertGreater(sum(len(page.pictures) for page in self.pages.values()), 40)
        self.assertEqual(nameless_pictures(self.pages), [])

    def test_planted_faults_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            html = Path(folder).resolve()
            (html / "index.html").write_text(
                '<h1 id="here"></h1><a href="#here">1</a><a href="#gone">2</a><a href="gone.html">3</a>'
                '<a href="../up.html">4</a><script src="https://a.invalid/b.js"></script><img src="index.html" alt="">'
                '<img src="index.html" alt="the index.html">', encoding="utf-8")
            pages = pages_of(html)
            self.assertEqual(len(broken_links(pages, html)), 4)
            self.assertEqual(len(nameless_pictures(pages)), 2)

    def test_two_builds_have_the_same_bytes(self):
        with tempfile.TemporaryDirectory() as folder:
            # Another place, hour and order of sets; what is in the build folder is the other build.
            subprocess.run([sys.executable, SOURCE / "docs/site/build", folder], check=True, cwd="/",
                           env=dict(os.environ, SOURCE_DATE_EPOCH="86400", TZ="Asia/Kolkata", PYTHONHASHSEED="7"))
            self.assertEqual(differences(HTML, Path(folder).resolve() / "html"), [])


class InTheBrowser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(str(CHROMIUM))
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        self.browser.complaints.clear()
        self.browser.prefer("light")
        self.browser.size(1280, 800)

    @staticmethod
    def address(page):
        path, _, query = page.partition("?")
        return (HTML / path).as_uri() + ("?" + query if query else "")

    def test_every_page_loads_without_a_complaint_and_fits_both_windows(self):
        for file in sorted(HTML.rglob("*.html")):
            self.browser.go(file.as_uri())
            for width in (400, 1280):
                self.browser.size(width, 800)
                # What is wide scrolls by itself, the page does not; words stay in the window.
                self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width, file)
                text = self.browser.value("document.querySelector('#content').getBoundingClientRect().toJSON()")
                self.assertGreaterEqual(text["left"], 0, file)
                self.assertLessEqual(text["right"], width, file)
                self.assertGreater(text["width"], 300, file)
            # Which pictures came, and which did not.
            self.assertEqual(self.browser.value(
                "[...document.images].filter(i => !i.complete || !i.naturalWidth).map(i => i.src)"), [], file)
            self.assertEqual(self.browser.complaints, [], file)

    def results(self):
        """The pages that the search lists, once it has finished: until then points follow its first word."""
        while True:
            found = self.browser.value(
                "document.querySelector('.search-summary')"
                " && !document.querySelector('#search-results h2').textContent.startsWith('Searching')"
                " ? [...document.querySelectorAll('ul.search li a')].map(a => a.href) : null")
            if found is not None:
                return found

    def test_the_search_finds_words_in_pages_that_are_files(self):
        self.browser.go(self.address("search.html?q=anaglyph"))
        found = self.results()
        self.assertTrue(any("docs/user/stereo.html" in page for page in found), found)
        # A page that is found opens, with the word marked.
        self.browser.go(next(page for page in found if "docs/user/stereo.html" in page))
        self.assertTrue(self.browser.value("document.querySelector('h1').textContent").startswith("Seeing in stereo"))
        self.browser.go(self.address("search.html?q=zzyzx"))
        self.assertEqual(self.results(), [])
        self.assertEqual(self.browser.complaints, [])

    def test_the_field_of_every_page_leads_to_the_search(self):
        self.browser.go(self.address("docs/user/touch.html"))
        form = self.browser.value("document.querySelector('.top form').action")
        self.assertEqual(form, self.address("search.html"))

    def colours(self):
        return self.browser.value("['backgroundColor', 'color'].map(c => getComputedStyle(document.body)[c])")

    def test_light_and_dark_follow_the_system_and_the_button(self):
        self.browser.go(self.address("index.html"))
        self.browser.value("localStorage.clear()")
        self.browser.go(self.address("docs/user/stereo.html"))
        light = self.colours()
        self.browser.prefer("dark")
        dark = self.colours()
        self.assertNotEqual(light[0], dark[0])
        self.assertNotEqual(light[1], dark[1])
        press = "document.getElementById('colours').click()"
        self.browser.value(press)
        self.assertEqual(self.colours(), light)
        # The choice holds on the next page.
        self.browser.go(self.address("docs/user/touch.html"))
        self.assertEqual(self.colours(), light)
        self.browser.value(press)
        self.browser.prefer("light")
        self.assertEqual(self.colours(), dark)
        self.browser.value(press)
        self.assertEqual(self.colours(), light)
        self.assertEqual(self.browser.complaints, [])

    def test_texts_have_enough_contrast_in_both(self):
        # Of all words that are seen, with the ground that is behind them (WCAG 2.1, 1.4.3).
        script = """(() => {
          const channel = c => (c /= 255) <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
          const bright = c => { const [r, g, b] = c.match(/[0-9.]+/g).map(Number);
            return 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b); };
          const ground = e => { for (; e; e = e.parentElement) {
            const c = getComputedStyle(e).backgroundColor; if (!c.startsWith('rgba(0, 0, 0, 0')) return c; }
            return 'rgb(255, 255, 255)'; };
          let least = [99, ''];
          for (const e of document.body.querySelectorAll('*')) {
            if (![...e.childNodes].some(n => n.nodeType == 3 && n.data.trim()) || !e.getClientRects().length) continue;
            const [a, b] = [bright(getComputedStyle(e).color), bright(ground(e))];
            const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
            if (ratio < least[0]) least = [ratio, e.outerHTML.slice(0, 120)];
          }
          return least; })()"""
        for page in ("index.html", "docs/user/reference.html", "docs/user/stereo.html", "search.html?q=anaglyph"):
            for scheme in ("light", "dark"):
                self.browser.prefer(scheme)
                self.browser.go(self.address(page))
                ratio, where = self.browser.value(script)
                self.assertGreaterEqual(ratio, 4.5, f"{page}, {scheme}: {where}")

    def test_pictures_of_three_pages_show_text_on_their_ground(self):
        self.browser.go(self.address("index.html"))
        self.browser.value("localStorage.clear()")
        for name, page, width, scheme in (("tutorial", "docs/user/tutorial.html", 1280, "light"),
                                          ("reference", "docs/user/reference.html", 400, "light"),
                                          ("stereo", "docs/user/stereo.html", 1280, "dark")):
            self.browser.size(width, 800)
            self.browser.prefer(scheme)
            self.browser.go(self.address(page))
            png = self.browser.picture()
            if PICTURES:
                PICTURES.mkdir(parents=True, exist_ok=True)
                (PICTURES / (name + ".png")).write_bytes(png)
            seen = [value for row in luminances(png) for value in row]
            self.assertEqual(len(seen), width * 800)
            dark = sum(value < 96 for value in seen) / len(seen)
            light = sum(value > 160 for value in seen) / len(seen)
            ground, ink = (light, dark) if scheme == "light" else (dark, light)
            self.assertGreater(ground, 0.5, name)
            self.assertGreater(ink, 0.01, name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
