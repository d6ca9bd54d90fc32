#!/usr/bin/env python3
"""The course as a site: docs/*.md to out/site/*.html with Pandoc. Usage: build_site.py [-o FOLDER] [--kreda PROGRAM]"""
import argparse
import html
import json
import re
import shutil
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import gallery
import glossary
import live
import live_code
import pages
import pandoc
import paper
import reference
import search_index
import symbols
import template

SITE = Path(__file__).resolve().parent
ROOT = SITE.parent.parent
LANGUAGES = {".cpp": "cpp", ".hpp": "cpp", ".py": "python", ".toml": "toml", ".cmake": "cmake", ".json": "json",
             ".sh": "bash"}
LICENCE = pages.Page("docs/LICENSE.md", "license-docs.html", "Licence of text and pictures")


def link(page, here=None, words=None):
    """An entry of a menu."""
    current = ' aria-current="page"' if here is page else ""
    number = f"<b>{page.number}</b> " if page.number else ""
    return f'<a href="{page.file}"{current}>{number}{html.escape(words or page.title)}</a>'


def menu(lessons, guides, here):
    """Lessons by family, then the other pages."""
    text = []
    for digit, family in pages.FAMILIES.items():
        items = [link(p, here) for p in lessons if p.number.startswith(digit)]
        if items:
            text.append(f'<h2><b>{digit}x</b> {family}</h2><ul>{"".join(f"<li>{i}</li>" for i in items)}</ul>')
    for group, found in guides.items():
        items = [link(p, here) for p in found]
        if group == "To build on" and reference.shutil.which("doxygen"):
            items.append('<a href="api/index.html">Reference of the code</a>')
        text.append(f'<h2>{group}</h2><ul>{"".join(f"<li>{i}</li>" for i in items)}</ul>')
    return "\n".join(text)


def picture_file(path, out_examples):
    """The file of a picture of the repository: what the example drew, larger, if it was run; else the page's own."""
    if re.match(r"docs/images/\d\d_", path):
        drawn = out_examples / path.removeprefix("docs/images/")
        if drawn.exists():
            return drawn
    return ROOT / path


def copy_pictures(found, site, out_examples):
    for page in found:
        folder = Path(page.source).parent
        for target in re.findall(r"\]\(([^):]+\.png)\)", page.markdown):
            path = str((ROOT / folder / target).resolve().relative_to(ROOT))
            to = site / "pictures" / path.replace("docs/images/", "docs/")
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(picture_file(path, out_examples), to)


def gallery_address(site):
    """Copies a picture of the gallery into the site, and says where it lies there."""
    def address(lesson, picture):
        to = site / "pictures/docs" / Path(lesson.source).stem / picture.name
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(picture, to)
        return str(to.relative_to(site))
    return address


def index_body(lessons):
    hero = (ROOT / "docs/site/index.html").read_text(encoding="utf-8")
    text = [hero]
    for digit, family in pages.FAMILIES.items():
        cards = []
        for page in (p for p in lessons if p.number.startswith(digit)):
            source = page.picture.replace("images/", "pictures/docs/")
            cards.append(f'<li><a href="{page.file}"><img src="{source}" alt="" loading="lazy"><h3><b>{page.number}</b> '
                         f'{html.escape(page.title)}</h3></a><p>{html.escape(pages.plain(page.goal))}</p></li>')
        if cards:
            text.append(f'<section><h2 id="family-{digit}"><b>{digit}x</b> {family}</h2><ul class="cards">'
                        f'{"".join(cards)}</ul></section>')
    return "\n".join(text)


def heading(page, eyebrow):
    above = f'<p class="eyebrow">{eyebrow}</p>' if eyebrow else ""
    number = f'<span class="lesson">{page.number}</span> ' if page.number else ""
    return f"{above}<h1>{number}{html.escape(page.title)}</h1>"


class Site:
    def __init__(self, folder, kreda, out_examples, only=()):
        self.only = set(only)
        self.folder, self.kreda, self.out_examples = folder, kreda, out_examples
        self.template = template.read()
        self.lessons, self.guides, self.assignments = pages.lessons(ROOT), pages.guides(ROOT), pages.assignments(ROOT)
        self.pages = self.lessons + [p for g in self.guides.values() for p in g] + self.assignments
        if (ROOT / LICENCE.source).exists():
            licence = pages.read_page(ROOT, LICENCE.source)
            licence.file = LICENCE.file
            self.pages.append(licence)
        self.metadata = folder / "pages.lua"
        self.sources = set()

    def write(self, page, body, **more):
        """One file of the site; `more` are values of the template."""
        depth = page.file.count("/")
        body = re.sub(r"<pre(?![^>]*tabindex)", '<pre tabindex="0"', body)  # what scrolls is reached by keys
        body = re.sub(r"<code>([^<]*/[^<]*)</code>", lambda m: f'<code>{m.group(1).replace("/", "/<wbr>")}</code>', body)
        body = re.sub(r"<th[^>]*></th>", "<td></td>", body)  # an empty corner is no heading
        body = re.sub(r' role="(?:doc-\w+|list|listitem)"', "", body)
        values = {"pagetitle": html.escape(f"{page.number} {page.title}".strip()), "title": html.escape(page.title),
                  "number": page.number, "body": body, "nav": "yes", "menu": menu(self.lessons, self.guides, page),
                  "source": page.source.replace("/", "--"), "path": page.source.replace("/", "/<wbr>"), **more}
        values.setdefault("heading", heading(page, values.get("eyebrow", "")))
        text = template.fill(self.template, values)
        if depth:
            text = re.sub(r'(href|src)="(?![a-z]+:|#|\.\./)([^"]+)"', r'\1="' + "../" * depth + r'\2"', text)
        self.sources.update(re.findall(r'href="(?:\.\./)*source/([^"#]+)\.html', text))
        to = self.folder / page.file
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text(text, encoding="utf-8")

    def pager(self, page):
        if page not in self.lessons:
            return ""
        i = self.lessons.index(page)
        before = self.lessons[i - 1] if i > 0 else None
        after = self.lessons[i + 1] if i + 1 < len(self.lessons) else None
        return ((f'<a class="prev" href="{before.file}"><span>Before</span> {before.number} {before.title}</a>' if before else "")
                + (f'<a class="next" href="{after.file}"><span>Next</span> {after.number} {after.title}</a>' if after else ""))

    def convert(self, page):
        folder = str(Path(page.source).parent)
        body = pandoc.fragment(page.markdown, self.metadata, ROOT, folder if folder != "." else "", SITE / "filter.lua")
        body = self.symbols.link(page, body)
        body = self.glossary.link(page, body)
        if page.number in self.live:
            body = live.put(body, self.live[page.number], page.title)
        if page.number in self.edit:
            body = live_code.put(body, self.edit[page.number], page.title)
        eyebrow = (f'{page.number[0]}x {pages.FAMILIES[page.number[0]]} · <a href="gallery.html#{page.name}">its pictures</a>'
                   if page.number in self.shown else f"{page.number[0]}x {pages.FAMILIES[page.number[0]]}" if page.number else "")
        self.write(page, body, pager=self.pager(page), eyebrow=eyebrow,
                   kind="lesson" if page.number else "guide")
        return page, body

    def source(self, name):
        path = name.replace("--", "/")
        if not (ROOT / path).is_file():
            raise SystemExit(f"docs: a page links {path}, which is no file")
        code = (ROOT / path).read_text(encoding="utf-8")
        body = pandoc.source_page(code, LANGUAGES.get(Path(path).suffix, ""))
        self.write(pages.Page(path, f"source/{name}.html", path), body, kind="source", source="")

    def build(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        lines = "".join(f"  [{json.dumps(p.source)}] = {json.dumps(p.file)},\n" for p in self.pages)
        self.metadata.write_text(f"return {{\n{lines}}}\n", encoding="utf-8")
        places = {} if self.only else reference.build(self.folder / "api")
        self.symbols = symbols.Symbols(ROOT, self.kreda, places)
        self.glossary = glossary.Glossary(ROOT)
        for name in ("style.css", "site.js", "icon.svg"):
            shutil.copyfile(SITE / name, self.folder / name)
        chosen = [p for p in self.pages if not self.only or p.name in self.only]
        copy_pictures(chosen, self.folder, self.out_examples)
        self.shown = {p.number for p in self.lessons if gallery.pictures_of(p, self.out_examples, ROOT / "docs/images")}
        self.live = {} if self.only else live.write(ROOT, self.folder, self.kreda)
        self.edit = live_code.write(ROOT, self.folder, {p.number: p.title for p in self.lessons})
        with ThreadPoolExecutor(2) as pool:
            bodies = list(pool.map(self.convert, [p for p in chosen if p.markdown]))
        made = {"docs/symbols.toml": "<p>Every symbol of every numbered equation: what it is, where the code has it, and its number at one "
                "pixel or in the page's session.</p>\n" + self.symbols.list_of_all(),
                "docs/references.bib": pandoc.references(ROOT / "docs/references.bib")}
        for page in chosen:
            if page.source in made:
                self.write(page, made[page.source], kind="guide")
                bodies.append((page, made[page.source] if page.source.endswith(".bib") else ""))
        home = pages.Page("docs/site/index.html", "index.html", "A rasterizer to teach lighting with")
        self.write(home, index_body(self.lessons), heading=" ", kind="home")
        shown = gallery.body(self.lessons, self.out_examples, ROOT / "docs/images", lambda lesson: lesson.file, gallery_address(self.folder))
        self.write(pages.Page("docs/site/gallery.py", "gallery.html", gallery.TITLE), f"<p>{gallery.WORDS}</p>{shown}", kind="home")
        search_index.write(self.folder / "search_index.js", bodies, self.symbols, self.glossary)
        with ThreadPoolExecutor(2) as pool:
            list(pool.map(self.source, sorted(self.sources)))
        self.metadata.unlink()
        self.bodies = {page.source: body for page, body in bodies}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--out", default=ROOT / "out/site", type=Path, help="folder of the site (out/site)")
    parser.add_argument("--kreda", default=ROOT / "build/release/bin/kreda", type=Path,
                        help="the program that explains the pages' pixels (build/release/bin/kreda)")
    parser.add_argument("--examples", default=ROOT / "out", type=Path, help="folder that the examples drew into (out)")
    parser.add_argument("--only", nargs="+", default=[], metavar="PAGE", help="these pages (42_cook_torrance gltf), for a quick look; others' links lead nowhere")
    parser.add_argument("--pdf", action="store_true", help="print all lessons, too: course.pdf beside the site's folder (with Chromium)")
    parser.add_argument("-v", "--verbose", action="store_true", help="name every symbol that does not resolve")
    parser.add_argument("--symbols", action="store_true", help="build nothing: does every symbol resolve?")
    options = parser.parse_args()
    if not pandoc.is_there():
        raise SystemExit("docs: pandoc is missing; install it (apt-get install pandoc) and try again. "
                         "The gallery needs no pandoc: ./course examples")
    if options.pdf and not paper.browser():
        raise SystemExit("docs: the PDF is printed by Chromium or Chrome, and neither is there; install one (apt-get install chromium)")
    begin = time.monotonic()
    if options.symbols:
        lessons = pages.lessons(ROOT)
        table = symbols.Symbols(ROOT, options.kreda)
        table.check(lessons)
        print(f"{table.equations} equations: {table.report()}")
        raise SystemExit("\n".join(table.problems) if table.problems else 0)
    pandoc.cache = options.out.resolve().parent / "site_cache"
    site = Site(options.out.resolve(), options.kreda, options.examples, options.only)
    site.build()
    for problem in site.symbols.problems[:None if options.verbose else 0]:
        print(problem)
    said = site.symbols.report()
    print(f"{len(site.bodies)} pages in {time.monotonic() - begin:.0f} s; {said}")
    print(f"The site: file://{options.out.resolve()}/index.html")
    if options.pdf:
        to = options.out.resolve().parent / "course.pdf"
        count = paper.write(site.folder, site.lessons, site.pages, site.bodies, to)
        print(f"The course on paper: file://{to}, {count} pages, {to.stat().st_size / 1e6:.1f} MB, {time.monotonic() - begin:.0f} s in all")


if __name__ == "__main__":
    main()
