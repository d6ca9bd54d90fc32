"""Pandoc, called once a page or once for many formulas. What it made of the same input before is kept beside the site."""
import hashlib
import json
import re
import shutil
import subprocess
from pathlib import Path

import highlight

READER = "gfm+tex_math_dollars-yaml_metadata_block"
cache = None  # a folder: set by build_site.py


class PandocError(RuntimeError):
    pass


def is_there():
    return shutil.which("pandoc") is not None


def kept_or(asked, make):
    """What was made of the same input before, else what make() returns, which is kept."""
    kept = cache / hashlib.sha256("\0".join(asked).encode()).hexdigest() if cache else None
    if kept and kept.exists():
        return kept.read_text(encoding="utf-8")
    made = make()
    if kept:
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.write_text(made, encoding="utf-8")
    return made


def run(arguments, text, reads=()):
    """Pandoc's output. `reads`: files that the arguments name, whose text decides what comes out."""
    def call():
        done = subprocess.run(["pandoc", *arguments], input=text, capture_output=True, text=True, encoding="utf-8")
        if done.returncode != 0:
            raise PandocError(done.stderr.strip())
        if "Could not convert TeX math" in done.stderr:
            raise PandocError("a formula that pandoc cannot read: " + " ".join(done.stderr.split()))
        return done.stdout
    return kept_or([*arguments, text, *(Path(f).read_text(encoding="utf-8") for f in reads)], call)


def fragment(markdown, pages, root, folder, lua_filter):
    """The HTML of a page's text, without head and foot. The file holds what the filter must know of all pages."""
    return highlight.blocks(run(["-f", READER, "-t", "html5", "--mathml", "--wrap=preserve", "--no-highlight", "-M", f"pages={pages}",
                                 "-M", f"root={root}", "-M", f"folder={folder}", "-L", str(lua_filter)], markdown, [pages, lua_filter]))


def source_page(code, language):
    """A source as HTML; line N has the id L-N."""
    return kept_or([code, language, Path(highlight.__file__).read_text(encoding="utf-8"), str(highlight.pygments)],
                   lambda: highlight.numbered(code, language))


def mathml(formulas):
    """{LaTeX: MathML of it}, all in one run."""
    formulas = list(dict.fromkeys(formulas))
    if not formulas:
        return {}
    html = run(["-f", READER, "-t", "html5", "--mathml", "--wrap=preserve"], "\n\n".join(f"${f}$" for f in formulas))
    found = re.findall(r"<math.*?</math>", html, re.S)
    if len(found) != len(formulas):
        raise PandocError(f"{len(formulas)} formulas gave {len(found)}")
    return dict(zip(formulas, found))


def names_of(bibliography):
    """{key: "Walter et al. 2007"} of a BibTeX file."""
    names = {}
    for work in json.loads(run(["-f", "bibtex", "-t", "csljson"], Path(bibliography).read_text(encoding="utf-8"))):
        authors = [" ".join(filter(None, (a.get("non-dropping-particle"), a.get("family") or a.get("literal"))))
                   for a in work["author"]]
        who = authors[0] if len(authors) == 1 else " & ".join(authors) if len(authors) == 2 else authors[0] + " et al."
        names[work["id"]] = f'{who} {work["issued"]["date-parts"][0][0]}' if "issued" in work else who
    return names


def references(bibliography):
    """The list of all works of a BibTeX file; the work with key K has the id ref-K."""
    return run(["-f", "markdown", "-t", "html5", "--wrap=preserve", "--citeproc", "--bibliography", str(bibliography),
                "-M", "link-citations=true"], "---\nnocite: '@*'\n---\n", [bibliography])
