#!/usr/bin/env python3
"""Is what the pages name there? Usage: check_repository.py [FOLDER]. The map of the sources, the glossary, works that are cited, the table of symbols,
and what a journal asks of a repository. One line a fault; exit code 1 if there are any. It needs Python alone."""
import re
import sys
from pathlib import Path

LANGUAGES = ("English", "Croatian", "Serbian", "Czech")
COMMUNITY = ("LICENSE", "docs/LICENSE.md", "README.md", "CONTRIBUTING.md", "CODE_OF_CONDUCT.md", "CITATION.cff", "CHANGELOG.md",
             "docs/teach.md", "docs/course.md", "docs/grading.md", "docs/references.bib")


def read(file):
    return file.read_text(encoding="utf-8")


def has_word(text, word):
    return re.search(rf"(?<!\w){re.escape(word)}(?!\w)", text) is not None


def rows_of(text):
    """Cells of the tables' rows, without their heads."""
    for line in text.splitlines():
        if line.startswith("| ") and not line.startswith("| ---"):
            yield [cell.strip() for cell in line.strip().strip("|").split("|")]


def check_links(root, faults):
    """Files that the pages link, and works that they cite."""
    works = set(re.findall(r"^@\w+\{(\w+),", read(root / "docs/references.bib"), re.M))
    cited = set(re.findall(r"^cite\.\w+ = \"(.*)\"$", read(root / "docs/symbols.toml"), re.M))
    used = {part.split(",")[0].strip() for line in cited for part in line.split("; ")}
    pages = [*(root / "docs").glob("*.md"), root / "README.md", root / "CODE_OF_CONDUCT.md", root / "CONTRIBUTING.md"]
    for page in pages:
        for target in re.findall(r"\]\(([^)\s]+)\)", read(page)):
            path, _, mark = target.partition("#")
            if re.match(r"[a-z]+:", target) or not path:
                continue
            if not (page.parent / path).exists():
                faults.append(f"{page.name}: {target} is not there")
            if path.endswith("references.bib") and mark:
                used.add(mark)
    faults += [f"references.bib has no work {key}, which a page cites" for key in sorted(used - works)]
    faults += [f"references.bib: nobody cites {key}" for key in sorted(works - used - {"kajiya1986", "veach1995"})]


def check_map(root, faults):
    """docs/map.md: functions are in the files beside them, tests and pictures exist; what has none says why."""
    rows = 0
    for cells in rows_of(read(root / "docs/map.md")):
        if cells[0] == "item":
            continue
        rows += 1
        names = re.findall(r"((?:`\w+`(?:, )?)+) in `([^`]+)`", cells[1])
        if not names and not re.fullmatch(r"\*.{20,}\*", cells[1]):
            faults.append(f"map.md: {cells[0]}: neither a function nor why not")
        for words, file in names:
            text = read(root / file) if (root / file).is_file() else ""
            faults += [f"map.md: {file} has no {word}" for word in re.findall(r"`(\w+)`", words) if not has_word(text, word)]
        faults += [f"map.md: {test} is not there" for test in re.findall(r"`([^`]+)`", cells[2]) if not (root / test).is_file()]
        if names and not re.search(r"\d\d", cells[3]):
            faults.append(f"map.md: {cells[0]}: no lesson")
    if rows < 70:
        faults.append(f"map.md has {rows} rows")


def check_glossary(root, faults):
    rows = [cells for cells in rows_of(read(root / "docs/glossary.md"))]
    if tuple(rows[0][:4]) != LANGUAGES:
        faults.append(f"glossary.md: its columns are {rows[0][:4]}")
    for cells in rows[1:]:
        if len(cells) != 5 or not all(cells):
            faults.append(f"glossary.md: {cells[0]}: a cell is empty")
    terms = [cells[0].lower() for cells in rows[1:]]
    faults += [f"glossary.md: {term} comes twice" for term in sorted({t for t in terms if terms.count(t) > 1})]


def check_course(root, faults):
    """What a journal asks of each lesson, and of the repository."""
    faults += [f"{file} is not there" for file in COMMUNITY if not (root / file).is_file()]
    if "cff-version: 1.2.0" not in read(root / "CITATION.cff"):
        faults.append("CITATION.cff: no version of its format")
    for page in sorted((root / "docs").glob("[0-9][0-9]_*.md")):
        text = read(page)
        if not re.search(r"^## Goal\n.{20}", text, re.M | re.S):
            faults.append(f"{page.name}: no goal")
        exercises = text.partition("## Exercises\n")[2].partition("\n## ")[0]
        asked, answered = len(re.findall(r"^\d\. ", exercises, re.M)), exercises.count("<details>")
        if asked == 0 or asked != answered:
            faults.append(f"{page.name}: {asked} exercises and {answered} answers")
        numbers = [int(n) for n in re.findall(r"\\tag\{(\d+)\}", text)]
        if numbers != sorted(set(numbers)):
            faults.append(f"{page.name}: equations are numbered {numbers}")


def main():
    if len(sys.argv) > 2 or sys.argv[1:] in (["-h"], ["--help"]):
        raise SystemExit(__doc__)
    root = Path(sys.argv[1] if len(sys.argv) == 2 else ".").resolve()
    faults = []
    for each in (check_links, check_map, check_glossary, check_course):
        each(root, faults)
    print("\n".join(faults + [f"{len(faults)} faults"]))
    raise SystemExit(1 if faults else 0)


if __name__ == "__main__":
    main()
