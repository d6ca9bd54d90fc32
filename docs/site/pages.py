"""What pages the site has, in which order, and what stands beside each."""
import re
from dataclasses import dataclass, field
from pathlib import Path

FAMILIES = {"1": "Raster", "2": "Local illumination", "3": "Fog", "4": "Reflection, physically",
            "5": "Light from images", "6": "Shadows", "7": "Film", "9": "Speed and accuracy"}
# Pages beside the lessons: file (from the repository's root), name of the page, what the menu calls it.
GUIDES = {
    "To teach": [("docs/course.md", "How a lesson is made"), ("docs/teach.md", "A semester of twelve weeks"),
                 ("docs/grading.md", "Grade it"), ("docs/map.md", "The map of the sources"),
                 ("docs/glossary.md", "Glossary in four languages"), ("docs/symbols.toml", "Every symbol"),
                 ("docs/references.bib", "References")],
    "To use": [("README.md", "Kreda in a page"), ("docs/debugging.md", "Step through it"),
               ("docs/steps.md", "Every stage a picture"), ("docs/view.md", "Live, in a browser"),
               ("docs/environment.md", "Light from an image"), ("docs/gltf.md", "Models from elsewhere"),
               ("docs/brdf_plots.md", "Reflection models side by side"), ("docs/measure.md", "Speed against accuracy"),
               ("docs/performance.md", "Performance")],
    "To build on": [("docs/architecture.md", "The rooms of the house"), ("docs/extend.md", "Add a distribution"),
                    ("docs/extremes.md", "What is done to break it"),
                    ("docs/install.md", "Install it, build on it"),
                    ("CONTRIBUTING.md", "How to change Kreda"), ("docs/joss.md", "For a journal's reviewer"),
                    ("docs/sources-of-data.md", "Where the data comes from"), ("CODE_OF_CONDUCT.md", "Code of conduct"),
                    ("CHANGELOG.md", "What changed")],
}


def plain(markdown):
    """Words without marks: of a goal, for the index."""
    text = re.sub(r"<!--.*?-->", "", markdown)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return re.sub(r"[*`$]", "", text).replace("\n", " ").strip()


@dataclass
class Page:
    """A page of the site: `source` is its Markdown, seen from the repository's root; `file` its name in the site."""
    source: str
    file: str
    title: str
    number: str = ""
    goal: str = ""
    picture: str = ""
    markdown: str = field(default="", repr=False)

    @property
    def name(self):
        return self.file.removesuffix(".html")


def file_of(source):
    """docs/21_lambert.md -> 21_lambert.html; examples/assignments/A3_lights/README.md -> A3_lights.html."""
    path = Path(source)
    if path.name == "README.md":
        return "readme.html" if path.parent == Path(".") else path.parent.name + ".html"
    return path.stem.lower() + ".html"


def read_page(root, source, title=None):
    text = (root / source).read_text(encoding="utf-8")
    page = Page(source, file_of(source), "", markdown=text)
    if not source.endswith(".md"):  # made by the site, not converted
        page.markdown, page.title = "", title
        return page
    heading = re.match(r"# (?:(\d\d) )?(.*)", text)
    page.number = heading.group(1) or "" if heading else ""
    page.title = title or (heading.group(2) if heading else source)
    goal = re.search(r"^## Goal\n+(.*?)\n\n", text, re.S | re.M)
    page.goal = goal.group(1) if goal else ""
    picture = re.search(r"!\[[^\]]*\]\(([^)]+)\)", text)
    page.picture = picture.group(1) if picture else ""
    return page


def lessons(root):
    return [read_page(root, f"docs/{p.name}") for p in sorted((root / "docs").glob("[0-9][0-9]_*.md"))]


def guides(root):
    """{heading of the menu: [Page]}; pages that are not there are left out."""
    return {group: [read_page(root, source, title) for source, title in files if (root / source).exists()]
            for group, files in GUIDES.items()}


def assignments(root):
    return [read_page(root, str(p.relative_to(root))) for p in sorted((root / "examples/assignments").glob("A*/README.md"))]
