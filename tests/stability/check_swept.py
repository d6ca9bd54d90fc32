#!/usr/bin/env python3
"""Is every public formula swept? Usage: check_swept.py SOURCE
Each free function that lighting/*.hpp, lighting/environment/*.hpp and shadows/*.hpp declare, and each of raster/*.hpp that
gives numbers, has a row in the table of docs/97_extremes.md or a line in not_swept.txt beside this file. A line there for what is swept, or is no
function any more, is an error, too."""
import re
import sys
from pathlib import Path

DECLARATION = re.compile(
    r"^((?:\[\[nodiscard\]\] |inline |constexpr )*[A-Za-z_][\w:<>,&* ]*? [&*]?)(\w+)\((?:[^;{}]*?)\)\s*(?:->[^;{]*)?[;{]", re.M
)
NUMBERS = re.compile(r"\b(float|double|int32_t|vec|vec2|vec3|vec4|dvec3|dvec2|SinCos|Exact)\b")


def functions_of(header, only_numbers):
    text = re.sub(r"//.*", "", header.read_text(encoding="utf-8"))
    for result, name in DECLARATION.findall(text):
        kind = re.sub(r"\[\[nodiscard\]\]|inline|constexpr", "", result).strip()
        if kind in ("", "return", "else", "struct", "enum class", "using") or kind.startswith(("return ", "const ")):
            continue
        is_number = NUMBERS.search(kind) and "std::vector" not in kind and "std::optional" not in kind
        if is_number or not only_numbers:
            yield name


def main():
    source = Path(sys.argv[1])
    declared = {}
    for folder in ("lighting", "lighting/environment", "shadows", "raster"):
        for header in sorted((source / folder).glob("*.hpp")):
            for name in functions_of(header, folder == "raster"):
                declared.setdefault(name, header.relative_to(source))
    page = (source / "docs/97_extremes.md").read_text(encoding="utf-8")
    swept = set(re.findall(r"^\| `(\w+)[^`|]*` \| [^|]* \| [^|]* \| [^|]* \| [\d,]+ \|$", page, re.M))
    reasons = {}
    for line in Path(__file__).with_name("not_swept.txt").read_text(encoding="utf-8").splitlines():
        names, _, reason = line.partition(":")
        if line and not line.startswith("#"):
            reasons.update({name.strip(): reason.strip() for name in names.split(",")})
    faults = [f"{where}: {name} is neither in the table of docs/97_extremes.md nor in tests/stability/not_swept.txt"
              for name, where in declared.items() if name not in swept and not reasons.get(name)]
    faults += [f"not_swept.txt: {name} is in the table" for name in reasons if name in swept]
    faults += [f"not_swept.txt: {name} is no such function" for name in reasons if name not in declared]
    print("\n".join(faults + [f"{len(declared)} functions, {len(swept & set(declared))} swept, {len(faults)} faults"]))
    raise SystemExit(1 if faults else 0)


if __name__ == "__main__":
    main()
