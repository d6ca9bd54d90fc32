"""The site's own parts, by hand: values, symbols, links, the glossary. Usage: test_site.py docs/site"""
import html
import re
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

SITE = Path(sys.argv.pop())
sys.path.insert(0, str(SITE))
import check_site
import gallery
import glossary
import highlight
import pages
import paper
import reference
import symbols
import values


class Values(unittest.TestCase):
    PAGE = "```gdb\n(gdb) print n\n$1 = (0, 1, 0)\n(gdb) info locals\nn_dot_l = 0.5\n```\n0.25 <!-- number: half = 0.25 -->\n"

    def test_session_gives_vectors_and_locals(self):
        self.assertEqual(values.from_session(self.PAGE, "print n"), [0.0, 1.0, 0.0])
        self.assertEqual(values.from_session(self.PAGE, "n_dot_l"), 0.5)
        with self.assertRaises(values.NoValue):
            values.from_session(self.PAGE, "print l")

    def test_marks_and_sums(self):
        self.assertEqual(values.from_mark(self.PAGE, "half"), 0.25)
        self.assertEqual(values.calculated("2*{a_{1}}+{b}[1]", {"a_{1}": 3.0, "b": [0.0, 4.0]}.__getitem__), 10.0)
        with self.assertRaises(values.NoValue):
            values.calculated("open('x')", {}.__getitem__)

    def test_six_digits_are_shown(self):
        self.assertEqual(values.shown([1 / 3, 2.0]), "(0.333333, 2)")


class Symbols(unittest.TestCase):
    def test_longest_symbol_is_found_and_the_rest_is_free(self):
        table = symbols.Symbols.__new__(symbols.Symbols)

        def keys(text):
            return symbols.keys_of(ElementTree.fromstring(text))
        table.keys = {"k": keys("<mi>k</mi>"), "k_d": keys("<msub><mi>k</mi><mi>d</mi></msub>"),
                      "dt": keys("<mrow><mi>Δ</mi><mi>t</mi></mrow>")}
        formula = ElementTree.fromstring("<mrow><msub><mi>k</mi><mi>d</mi></msub><mi>Δ</mi><mi>t</mi><mi>x</mi><mi>π</mi></mrow>")
        found, free = {}, []
        table.find_in(formula, table.keys, found, free, set())
        self.assertEqual(list(found), ["k_d", "dt"])
        self.assertEqual(free, ["x"])  # π needs no explanation, x does


class Code(unittest.TestCase):
    SOURCE = '/* one\n   two */\n#include <cmath>\n\nconst char* kName = "a & <b>";  // x\n'

    def test_colours_change_no_letter_and_no_line(self):
        for language in ("cpp", "", "no such language"):
            plain = [html.unescape(re.sub("<[^>]+>", "", line)) for line in highlight.lines(self.SOURCE, language)]
            self.assertEqual("\n".join(plain), self.SOURCE)

    @unittest.skipUnless(highlight.pygments, "there is no Pygments")
    def test_a_comment_of_two_lines_is_one_span_in_each(self):
        self.assertEqual(highlight.lines(self.SOURCE, "cpp")[:2], ['<span class="co">/* one</span>', '<span class="co">   two */</span>'])

    def test_lines_of_a_file_have_numbers(self):
        self.assertIn('<span id="L-5"><a href="#L-5"', highlight.numbered(self.SOURCE, "cpp"))

    def test_code_of_a_page_keeps_its_frame(self):
        body = '<p>a</p><pre class="sh"><code>ls &lt; x</code></pre>'
        self.assertEqual(re.sub("</?span[^>]*>", "", highlight.blocks(body)), body)


class Reference(unittest.TestCase):
    def test_words_behind_several_members_are_those_of_each(self):
        self.assertEqual(reference.spread("    float u = 0.0f, v[kSize];  ///< texels\n"),
                         "    float u = 0.0f; /**< texels */ float v[kSize]; /**< texels */\n")
        one = "    float u = 0.0f;  ///< texels\n    glm::vec3 color{1, 2, 3};  ///< linear RGB\n"
        self.assertEqual(reference.spread(one), one)


class Gallery(unittest.TestCase):
    def shown(self, *pictures, output=""):
        """The gallery of lesson 24, whose example drew these."""
        with tempfile.TemporaryDirectory() as folder:
            drawn = Path(folder) / "24_shading"
            drawn.mkdir()
            for name, width in pictures:
                (drawn / name).write_bytes(b"\x89PNG\r\n\x1a\n" + b"\0\0\0\rIHDR" + width.to_bytes(4, "big") + (9).to_bytes(4, "big"))
            if output:
                (drawn / "output.txt").write_text(output)
            lesson = pages.Page("docs/24_shading.md", "24_shading.html", "Flat & smooth", number="24", goal="See *why* `a < b`.")
            return gallery.body([lesson], Path(folder), Path(folder), lambda p: p.file, lambda p, picture: f"24/{picture.name}")

    def test_pictures_stand_under_their_lesson_and_lead_to_it(self):
        text = self.shown(("two_balls.png", 640), ("dot.png", 20), output="n.l = 0.5 < 1\n")
        self.assertIn('<h2 id="family-2"><b>2x</b> Local illumination</h2>', text)
        self.assertIn('<a href="24_shading.html"><b>24</b> Flat &amp; smooth</a>', text)
        self.assertIn("<p>See why a &lt; b.</p>", text)
        self.assertIn('<img src="24/two_balls.png" alt="two balls" width="640" height="9" loading="lazy">', text)
        self.assertRegex(text, 'src="24/dot.png"[^>]* class="small"')
        self.assertIn("n.l = 0.5 &lt; 1", text)
        self.assertNotIn("Fog", text)

    def test_without_pictures_it_says_so(self):
        self.assertIn("no pictures yet", self.shown())


class Paper(unittest.TestCase):
    PAGE = pages.Page("docs/24_shading.md", "24_shading.html", "Shading", number="24")
    OTHER = pages.Page("docs/22_phong_terms.md", "22_phong_terms.html", "Phong", number="22")

    def chapter(self, body):
        return paper.on_paper(self.PAGE, body, {p.file: p for p in (self.PAGE, self.OTHER)})

    def test_links_lead_to_chapters_or_are_words(self):
        self.assertEqual(self.chapter('<h2 id="goal">Goal</h2><a class="x" href="#goal">up</a>'),
                         '<h3 id="24_shading--goal">Goal</h3><a class="x" href="#24_shading--goal">up</a>')
        self.assertEqual(self.chapter('<a class="x" href="22_phong_terms.html#eq-1">(1)</a>'), '<a class="x" href="#22_phong_terms--eq-1">(1)</a>')
        self.assertEqual(self.chapter('<a class="x" href="source/a.html#L-3"><code>a</code></a>'), "<code>a</code>")
        self.assertIn("https://example.org", self.chapter('<a class="x" href="https://example.org">w</a>'))

    def test_answers_are_open_and_boxes_of_symbols_stay_away(self):
        body = '<div class="tips"><div class="tip">n</div></div><details class="symbols"><dl>n</dl></details><details><summary>Answer</summary>2</details>'
        self.assertEqual(self.chapter(body), "<details open><summary>Answer</summary>2</details>")

    def test_pages_of_a_pdf(self):
        pdf = (b"1 0 obj\n<</Type /Catalog /Pages 2 0 R /Dests 6 0 R>>\nendobj\n2 0 obj\n<</Type /Pages /Kids [3 0 R 5 0 R]>>\nendobj\n"
               b"3 0 obj\n<</Type /Pages /Parent 2 0 R /Kids [4 0 R]>>\nendobj\n4 0 obj\n<</Type /Page>>\nendobj\n5 0 obj\n<</Type /Page>>\nendobj\n"
               b"6 0 obj\n<</a#2db [5 0 R /XYZ 0 700 0] /c [4 0 R /XYZ 0 1 0]>>\nendobj\n")
        self.assertEqual(paper.pages_of(pdf), {"a-b": 2, "c": 1})


class Links(unittest.TestCase):
    def faults_of(self, **files):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                (Path(folder) / f"{name}.html").write_text(text)
            return check_site.check(Path(folder).resolve())[2]

    def test_a_whole_page_has_no_fault(self):
        self.assertEqual(self.faults_of(a='<a href="b.html#x">b</a> <a href="https://example.org">w</a>', b='<p id="x">'), [])

    def test_each_fault_is_found(self):
        for text in ('<a href="c.html">', '<a href="b.html#y">', '<img src="p.png" alt="">', '<p id="x"><p id="x">',
                     '<script src="https://example.org/a.js"></script>', "<h1>a</h1><h3>b</h3>", '<a href="#z">'):
            self.assertEqual(len(self.faults_of(a=text, b='<p id="x">')), 1, text)


class Terms(unittest.TestCase):
    def test_first_use_in_words_is_linked_once_and_code_is_not(self):
        terms = glossary.Glossary(Path("/nowhere"))
        terms.terms = {"fog": ("fog", ["magla", "–", "mlha"])}
        page = pages.Page("docs/30_fog.md", "30_fog.html", "Fog", "30")
        body = terms.link(page, "<h2>Fog</h2><p><code>fog</code> Fog and fog, foggy</p>")
        self.assertEqual(body.count("<a "), 1)
        self.assertIn('title="magla · mlha">Fog</a> and fog', body)


class Skeleton(unittest.TestCase):
    def test_a_new_lesson_has_what_every_lesson_has(self):
        page = (SITE / "lesson_page.md").read_text()
        lesson = (SITE.parent / "21_lambert.md").read_text()
        self.assertEqual(re.findall("^## .*", page, re.M), re.findall("^## .*", lesson, re.M))
        card = (SITE / "lesson_main.cpp").read_text().splitlines()
        self.assertTrue(card[0].startswith("// NN_name: "))
        self.assertTrue(card[1].startswith("// Page docs/NN_name.md | After ") and "| New: " in card[1])
        function = re.match(r"// Break at: (\w+) \| Look at: .* \| Try: ", card[2]).group(1)
        self.assertIn(f"break {function}", page)


if __name__ == "__main__":
    unittest.main()
