#!/usr/bin/env python3
"""The reference of the code, from the docstrings with Doxygen. Usage: reference.py --check
--check makes nothing and asks: has every struct, function, enumeration and constant of raster, lighting and shadows its docstring?"""
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


def run(settings):
    """Doxygen's warnings."""
    text = (ROOT / "docs/site/Doxyfile").read_text() + "".join(f"{key} = {value}\n" for key, value in settings.items())
    done = subprocess.run(["doxygen", "-"], input=text, cwd=ROOT, capture_output=True, text=True, encoding="utf-8")
    if done.returncode != 0:
        raise SystemExit("docs: doxygen failed: " + done.stderr.strip()[-500:])
    return done.stderr.splitlines()


def is_fault(warning):
    """A plain member of a struct may speak by its name and its neighbours' comments; all else has words of its own."""
    return re.search(r":\d+: warning:", warning) and not re.search(r"\(variable\) of struct", warning)


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
    faults = [w for w in run({"GENERATE_HTML": "NO", "OUTPUT_DIRECTORY": "."}) if is_fault(w)]
    print("\n".join(faults + [f"{len(faults)} symbols without a docstring"]))
    raise SystemExit(1 if faults else 0)


if __name__ == "__main__":
    main()
