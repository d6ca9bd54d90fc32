#!/usr/bin/env python3
"""The reference of the code, from the docstrings with Doxygen. Usage: reference.py --check
--check makes nothing and asks: has every struct, member, function, enumeration and constant of raster, lighting and shadows its docstring?"""
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
ROOMS = ("raster", "lighting", "shadows")


DECLARATOR = r"\w+(?:\[\w+\]| = [^,;{}]+|\{[^{}]*\})?"
SEVERAL = re.compile(rf"^( +)((?:alignas\(\w+\) )?[\w:<>]+) ({DECLARATOR}(?:, {DECLARATOR})+); +///< (.*)$", re.M)


def spread(header):
    """`float u, v;  ///< words`: Doxygen gives the words to v alone, here each has them. Lines keep their numbers."""
    def each(match):
        indent, kind, names, words = match.groups()
        return indent + " ".join(f"{kind} {name}; /**< {words} */" for name in re.findall(DECLARATOR, names))
    return SEVERAL.sub(each, header)


def run(settings):
    """Doxygen's warnings. It reads copies of the headers, see spread()."""
    with tempfile.TemporaryDirectory() as folder:
        for file in (f for room in ROOMS for f in (ROOT / room).rglob("*.hpp")):
            copy = Path(folder) / file.relative_to(ROOT)
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(spread(file.read_text(encoding="utf-8")), encoding="utf-8")
        shutil.copytree(ROOT / "docs/site", Path(folder) / "docs/site", ignore=shutil.ignore_patterns("*.py*"))
        text = (ROOT / "docs/site/Doxyfile").read_text() + "".join(f"{key} = {value}\n" for key, value in settings.items())
        done = subprocess.run(["doxygen", "-"], input=text, cwd=folder, capture_output=True, text=True, encoding="utf-8")
        if done.returncode != 0:
            raise SystemExit("docs: doxygen failed: " + done.stderr.strip()[-500:])
        return done.stderr.replace(f"{folder}/", "").splitlines()


def build(folder):
    """{identifier: address in the reference}; empty where there is no Doxygen."""
    if not shutil.which("doxygen"):
        return {}
    folder.mkdir(parents=True, exist_ok=True)
    run({"OUTPUT_DIRECTORY": folder, "GENERATE_TAGFILE": folder / "kreda.tag"})
    places = {}
    for compound in ElementTree.parse(folder / "kreda.tag").getroot():
        name = (compound.findtext("name") or "").rpartition("::")[2]
        if compound.get("kind") in ("struct", "class"):
            places[name] = "api/" + compound.findtext("filename")
        if compound.get("kind") == "namespace":
            for member in compound.iter("member"):
                places.setdefault(member.findtext("name"), f"api/{member.findtext('anchorfile')}#{member.findtext('anchor')}")
    return places


def main():
    if sys.argv[1:] != ["--check"]:
        raise SystemExit(__doc__)
    faults = [w for w in run({"GENERATE_HTML": "NO", "OUTPUT_DIRECTORY": "."}) if re.search(r":\d+: warning:", w)]
    print("\n".join(faults + [f"{len(faults)} symbols without a docstring"]))
    raise SystemExit(1 if faults else 0)


if __name__ == "__main__":
    main()
