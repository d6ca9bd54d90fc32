#!/usr/bin/env python3
"""Are mistakes in the formulas noticed? Usage: mutants.py --scratch FOLDER --libraries FOLDER [--sample N] [--jobs N]

A mutant is the program with one mistake: a sign, a wrong operator, exchanged operands, a comparison the other way round, a
constant half as large again. All of them are compiled into one program (mutant.hpp), which is run once for each with
the unit tests, up to the first that fails. FOLDER of --libraries holds libkreda_*.a. --sample: every n-th mutant, N in all.
Prints the share that is noticed and the others, and exits with 1 below 95 %."""
import argparse
import concurrent.futures
import os
import re
import shutil
import subprocess
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
# The formulas; the test cases of tests/stability/test_formulas.cpp that try them, which are run first; and the unit tests that
# are asked where those notice nothing.
HEADERS = {
    "lighting/fresnel.hpp": ("*Fresnel*", ""),
    "lighting/microfacet.hpp": ("*microfacets*,*directions*", "lighting/test_microfacet"),
    "lighting/ward.hpp": ("*microfacets*,*models*", "lighting/test_ward"),
    "lighting/reflection.hpp": ("*reflection*,*models*", "lighting/test_reflection"),
    "lighting/energy.hpp": ("*energy*", "lighting/test_energy"),
    "lighting/fog.hpp": ("*lights*,*models*", "lighting/test_fog"),
    "lighting/light_sample.hpp": ("*lights*,*directions*", "lighting/test_light"),
    "lighting/importance.hpp": ("*directions*", "lighting/test_importance"),
    "lighting/normal_map.hpp": ("*reflection*,*directions*", "lighting/test_normal_map"),
    "shadows/map_point.hpp": ("*bias*", "shadows/test_map_bias"),
    "shadows/soft_filter.hpp": ("*bias*", ""),
    "shadows/light_ray.hpp": ("*bias*", "shadows/test_light_ray"),
    "raster/scalar_math.hpp": ("*scalar*,*textures*,*depth*", ""),
    "raster/trigonometry.hpp": ("*depth*", ""),
    "raster/unit_vector.hpp": ("*textures*,*scalar*", ""),
    "raster/film.hpp": ("*lights*", "raster/test_film"),
    "raster/depth.hpp": ("*depth*", "raster/test_depth"),
    "raster/depth_formats.hpp": ("*depth*", ""),
    "raster/orthonormal_frame.hpp": ("*directions*", ""),
    "raster/screen.hpp": ("*depth*", "raster/test_screen"),
}
OPERATOR = re.compile(r"(?<=[\w)\]}]) ([-+*/<>]) (?=[\w({-])")
CONSTANT = re.compile(r"(?<![\w.])(\d+\.\d*(?:e[-+]?\d+)?f?)(?![\w.])")
SKIPPED = re.compile(r"^\s*(constexpr|static|template|return use|for \(|using|#)|KREDA_|static_assert|= default|noexcept")


def mutate_line(line, place, mutants):
    """The line with its operators and constants replaced; what each does is added to `mutants`."""
    code, slashes, comment = line.partition("//")
    if SKIPPED.search(code) or not code.startswith("    "):
        return line

    def operator(match):
        op, number = match.group(1), len(mutants) + 1
        wrong = {"+": "-", "-": "+", "*": "/", "/": "*", "<": ">", ">": "<"}[op]
        mutants.append((place, f"{op} -> {wrong}", code.strip()))
        # Two numbers: the other operator, and exchanged operands where those matter.
        mutants.append((place, f"exchanged operands of {op}", code.strip()) if op in "-/" else None)
        return f" {op} mutant::Operator<{number}>{{}} {op} "

    def constant(match):
        if re.search(r"e-?\d\d", match.group(1)):  # keeps a denominator from 0: half as much again is as good
            return match.group(0)
        mutants.append((place, f"{match.group(1)} times 1.5", code.strip()))
        return f"mutant::constant({len(mutants)}, {match.group(1)})"

    return OPERATOR.sub(operator, CONSTANT.sub(constant, code)) + slashes + comment


def mutate(scratch):
    """Copies of the headers with all mutants in them. Returns a list: mutant i is at i - 1, None is none."""
    mutants = []
    for name in HEADERS:
        lines = (ROOT / name).read_text(encoding="utf-8").split("\n")
        out, in_struct = [], False
        for number, line in enumerate(lines, 1):
            in_struct = (in_struct or re.match(r"(struct|enum)", line)) and line != "};"
            inside = not in_struct and number > lines.index("#pragma once")
            out.append(mutate_line(line, f"{name}:{number}", mutants) if inside else line)
        text = "\n".join(out).replace("#pragma once", '#pragma once\n#include "tests/mutants/mutant.hpp"', 1)
        (scratch / name).parent.mkdir(parents=True, exist_ok=True)
        (scratch / name).write_text(text, encoding="utf-8")
    return mutants


def build(scratch, libraries, jobs):
    """The unit tests of the formulas with the mutated headers before the right ones."""
    sources = [ROOT / "tests/doctest_main.cpp", ROOT / "tests/stability/test_formulas.cpp",
               *sorted((ROOT / "tests/stability").glob("formula*.cpp")),
               *(ROOT / f"tests/{unit}.cpp" for _, unit in HEADERS.values() if unit)]
    flags = ["-std=c++20", "-O0", "-w", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-DGLM_FORCE_XYZW_ONLY",
             f'-DKREDA_SOURCE_DIR="{ROOT}"', "-DKREDA_CHECKS=1", f"-I{scratch}", f"-I{ROOT}"]

    def compile_one(source):
        done = subprocess.run(["g++", *flags, "-c", source, "-o", scratch / f"{source.stem}.o"],
                              capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"mutants: {source} does not compile:\n{done.stderr[:4000]}")

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        list(pool.map(compile_one, sources))
    objects = [scratch / f"{source.stem}.o" for source in sources]
    archives = [libraries / f"libkreda_{room}.a" for room in ("lighting", "shadows", "raster")]
    subprocess.run(["g++", *objects, *archives, "-fopenmp", "-o", scratch / "tests"], check=True)


def fails(scratch, number, *options):
    """Do these tests fail, crash or never end with this mutant?"""
    environment = dict(os.environ, KREDA_MUTANT=str(number), KREDA_SWEEP_INPUTS="2000", OMP_NUM_THREADS="1")
    try:
        return subprocess.run([scratch / "tests", *options, "--abort-after=1", "-m"], env=environment,
                              capture_output=True, timeout=600).returncode != 0
    except subprocess.TimeoutExpired:
        return True


def is_noticed(scratch, number, header):
    cases, unit = HEADERS[header]
    return fails(scratch, number, f"-tc={cases}", "-sf=*test_formulas.cpp") or (
        unit != "" and fails(scratch, number, f"-sf=*{unit}.cpp"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", type=Path, required=True)
    parser.add_argument("--libraries", type=Path, required=True)
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--built", action="store_true", help="the program is there already")
    wish = parser.parse_args()
    if not wish.built:
        shutil.rmtree(wish.scratch, ignore_errors=True)
    mutants = mutate(wish.scratch)
    if not wish.built:
        build(wish.scratch, wish.libraries, wish.jobs)
    if fails(wish.scratch, 0, "-sf=*test_formulas.cpp"):
        raise SystemExit("mutants: the tests fail without a mutant")
    numbers = [i + 1 for i, mutant in enumerate(mutants) if mutant]
    if 0 < wish.sample < len(numbers):
        numbers = numbers[::len(numbers) // wish.sample][:wish.sample]
    begin = time.monotonic()

    def try_one(number):
        return is_noticed(wish.scratch, number, mutants[number - 1][0].split(":")[0])

    with concurrent.futures.ThreadPoolExecutor(wish.jobs) as pool:
        noticed = list(pool.map(try_one, numbers))
    for number, found in zip(numbers, noticed):
        if not found:
            place, what, line = mutants[number - 1]
            print(f"{place}: {what}: {line}  [{number}]")
    share = sum(noticed) / len(numbers)
    print(f"{len(numbers)} mutants, {sum(noticed)} noticed, {100 * share:.1f} %, {time.monotonic() - begin:.0f} s")
    raise SystemExit(0 if share >= 0.95 else 1)


if __name__ == "__main__":
    main()
