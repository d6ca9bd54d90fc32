#!/usr/bin/env python3
"""The pictures that lessons set side by side, before and after. Usage: pairs.py KREDA [--check]
Draws each into docs/images/pairs; with --check it only compares: are the pictures what their scenes give, to the last byte?"""
import subprocess
import sys
import tempfile
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "images/pairs"
PICTURES = {"flat": ("shading", ["shading.frequency=flat"]), "phong": ("shading", ["shading.frequency=phong"]),
            "no_bias": ("bias", ["shadow.bias=none"]), "bias": ("bias", ["shadow.bias=slope"]),
            "affine": ("floor", ["shading.interpolation=affine"]), "perspective": ("floor", ["shading.interpolation=perspective"])}


def draw(kreda, name, to):
    scene, settings = PICTURES[name]
    options = [word for setting in settings for word in ("--set", setting)]
    subprocess.run([kreda, "render", str(FOLDER / f"{scene}.toml"), "-o", str(to), *options], check=True, capture_output=True)


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        raise SystemExit(__doc__)
    kreda, wrong = sys.argv[1], []
    for name in PICTURES:
        if sys.argv[2:] != ["--check"]:
            draw(kreda, name, FOLDER / f"{name}.png")
            continue
        with tempfile.TemporaryDirectory() as folder:
            draw(kreda, name, Path(folder) / "now.png")
            if (Path(folder) / "now.png").read_bytes() != (FOLDER / f"{name}.png").read_bytes():
                wrong.append(name)
    if wrong:
        raise SystemExit(f"docs/images/pairs: not what their scenes give: {', '.join(wrong)}; look at them, then run docs/site/pairs.py KREDA")


if __name__ == "__main__":
    main()
