#!/usr/bin/env python3
"""coverage.py BUILD ROOM...: what gcov counted in a build with --coverage, room by room. See coverage.sh."""
import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LEAST = 95.0


def counted_lines(build):
    """{file: {line: how often}}: a line of a header counts where any source runs it."""
    lines = {}
    notes = [str(path.resolve()) for path in Path(build).rglob("*.gcda")]
    for i in range(0, len(notes), 50):
        done = subprocess.run(["gcov", "--json-format", "--stdout", *notes[i:i + 50]], check=True, capture_output=True, text=True)
        for report in done.stdout.splitlines():
            for file in json.loads(report)["files"]:
                name = Path(file["file"])
                if not name.is_absolute() or not name.is_relative_to(ROOT):
                    continue
                counts = lines.setdefault(str(name.relative_to(ROOT)), {})
                for line in file["lines"]:
                    number = line["line_number"]
                    counts[number] = counts.get(number, 0) + line["count"]
    return lines


def main():
    build, rooms = sys.argv[1], sys.argv[2:]
    lines = counted_lines(build)
    missing, is_enough = [], True
    for room in rooms:
        counts = {name: found for name, found in lines.items() if name.startswith(room + "/")}
        total = sum(len(found) for found in counts.values())
        run = sum(count > 0 for found in counts.values() for count in found.values())
        share = 100.0 * run / max(total, 1)
        is_enough = is_enough and share >= LEAST
        print(f"{room:9} {run:6} of {total:6} lines, {share:.1f} %")
        for name in sorted(counts):
            missing += [f"{name}:{line}" for line, count in sorted(counts[name].items()) if count == 0]
    (Path(build) / "missing.txt").write_text("\n".join(missing) + "\n", encoding="utf-8")
    print(f"lines that no test runs: {build}/missing.txt")
    raise SystemExit(0 if is_enough else 1)


if __name__ == "__main__":
    main()
