#!/usr/bin/env python3
"""Are mistakes in the formulas noticed? Usage: mutants.py --scratch FOLDER --libraries FOLDER [--every N] [--jobs N]

A mutant is the program with one mistake: a sign, a wrong operator, exchanged operands, a comparison the other way round, a
constant half as large again. All of them are compiled into one program (mutant.hpp), which is run once for each with
the unit tests, up to the first that fails. FOLDER of --libraries holds libkreda_*.a. --every: one mutant of N, always the same
ones, whatever is changed elsewhere. Prints the share that is noticed and the others. Exits with 1 below 95 %, and where
docs/extremes.md says another number or does not list with its reason what is not noticed."""
import argparse
import concurrent.futures
import os
import re
import shutil
import subprocess
import time
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
# The formulas; the test cases of tests/stability/test_formulas.cpp that try them, which are run first; and the unit tests that
# are asked where those notice nothing. (cube_map.hpp, brdf_map.hpp and texel_taps.hpp are read through functions of the library,
# which has no mistakes in it.)
HEADERS = {
    "lighting/fresnel.hpp": ("*Fresnel*,*Schlick*", "lighting/test_fresnel"),
    "lighting/microfacet.hpp": ("*facets*,*directions*", "lighting/test_microfacet"),
    "lighting/ward.hpp": ("*Ward*,*models*", "lighting/test_ward"),
    "lighting/reflection.hpp": ("*reflection*", "lighting/test_reflection"),
    "lighting/energy.hpp": ("*energy*", "lighting/test_energy"),
    "lighting/fog.hpp": ("*lights*,*models*", "lighting/test_fog"),
    "lighting/light_sample.hpp": ("*lights*", "lighting/test_light"),
    "lighting/importance.hpp": ("*directions*", "lighting/test_importance"),
    "lighting/normal_map.hpp": ("*reflection*,*directions*", "lighting/test_normal_map"),
    "lighting/environment/sky.hpp": ("*light of environments*", "lighting/test_sky"),
    "lighting/environment/environment_image.hpp": ("*places in environments*", "lighting/test_environment_image"),
    "lighting/environment/light_table.hpp": ("*places in environments*", "lighting/test_light_table"),
    "lighting/environment/irradiance.hpp": ("*light of environments*", "lighting/test_irradiance"),
    "lighting/environment/prefilter.hpp": ("*light of environments*", "lighting/test_prefilter"),
    "shadows/map_point.hpp": ("*shadow maps*", "shadows/test_map_bias"),
    "shadows/soft_filter.hpp": ("*shadow maps*", ""),
    "shadows/light_ray.hpp": ("*exact shadows*", "shadows/test_light_ray"),
    "raster/scalar_math.hpp": ("*scalar*,*textures*,*depth*", ""),
    "raster/trigonometry.hpp": ("*depth*", ""),
    "raster/unit_vector.hpp": ("*textures*,*scalar*", ""),
    "raster/film.hpp": ("*film*", "raster/test_film"),
    "raster/depth.hpp": ("*depth*", "raster/test_depth"),
    "raster/depth_formats.hpp": ("*depth*", "raster/test_depth"),
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
            begins = re.match(r"(struct|enum)", line) and not line.endswith("};")
            in_struct = (in_struct or begins) and line != "};"
            inside = not in_struct and number > lines.index("#pragma once")
            out.append(mutate_line(line, f"{name}:{number}", mutants) if inside else line)
        text = "\n".join(out).replace("#pragma once", '#pragma once\n#include "tests/mutants/mutant.hpp"', 1)
        (scratch / name).parent.mkdir(parents=True, exist_ok=True)
        (scratch / name).write_text(text, encoding="utf-8")
    return mutants


def build(scratch, libraries, jobs):
    """The unit tests of the formulas with the mutated headers before the right ones. The headers take most of the time, so
    the files of tests/stability, whose names are all different, are compiled six at a time."""
    formulas = [ROOT / "tests/stability/test_formulas.cpp", *sorted((ROOT / "tests/stability").glob("formula*.cpp"))]
    sources = [ROOT / "tests/doctest_main.cpp", *(ROOT / f"tests/{unit}.cpp" for _, unit in HEADERS.values() if unit)]
    for i in range(0, len(formulas), 6):
        together = scratch / f"formulas_{i // 6}.cpp"
        together.write_text("".join(f'#include "{source}"\n' for source in formulas[i:i + 6]), encoding="utf-8")
        sources.insert(0, together)
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


def name_of(mutant):
    """File, line of code and mistake: what stays when lines are added above."""
    place, what, line = mutant
    return place.split(":")[0], line, what


def faults_of_page(tried, noticed, is_whole):
    """What docs/extremes.md says of these mutants and is not so."""
    page = (ROOT / "docs/extremes.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"^\| `([\w/]+\.hpp)` \| `([^|]*)` \| `([^|]*)` \| [^|]+ \|$", page, re.M))
    faults = [f"docs/extremes.md does not list: | `{file}` | `{line}` | `{what}` | why |"
              for (file, line, what), found in zip(tried, noticed) if not found and (file, line, what) not in listed]
    faults += [f"docs/extremes.md lists what is noticed: {' | '.join(name)}"
               for name in sorted(listed & {name for name, found in zip(tried, noticed) if found}
                                  - {name for name, found in zip(tried, noticed) if not found})]
    result = f"{sum(noticed)} of {len(noticed)} mistakes are noticed"
    return faults + ([f"docs/extremes.md should say: {result}"] if is_whole and result not in page else [])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", type=Path, required=True)
    parser.add_argument("--libraries", type=Path, required=True)
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--built", action="store_true", help="the program is there already")
    parser.add_argument("--only", default="", help="numbers of mutants, as the run before printed them: 12,55")
    wish = parser.parse_args()
    if not wish.built:
        shutil.rmtree(wish.scratch, ignore_errors=True)
    mutants = mutate(wish.scratch)
    if not wish.built:
        build(wish.scratch, wish.libraries, wish.jobs)
    if fails(wish.scratch, 0, "-sf=*test_formulas.cpp"):
        raise SystemExit("mutants: the tests fail without a mutant")
    numbers = [i + 1 for i, mutant in enumerate(mutants) if mutant]
    if wish.only:
        numbers = [int(number) for number in wish.only.split(",")]
    else:
        numbers = [number for number in numbers if zlib.crc32(" ".join(name_of(mutants[number - 1])).encode()) % wish.every == 0]
    begin = time.monotonic()

    def try_one(number):
        place, what, line = mutants[number - 1]
        is_found = is_noticed(wish.scratch, number, place.split(":")[0])
        if not is_found:
            print(f"{place}: {what}: {line}  [{number}]", flush=True)
        return is_found

    with concurrent.futures.ThreadPoolExecutor(wish.jobs) as pool:
        noticed = list(pool.map(try_one, numbers))
    share = sum(noticed) / len(numbers)
    print(f"{len(numbers)} mutants, {sum(noticed)} noticed, {100 * share:.1f} %, {time.monotonic() - begin:.0f} s")
    faults = faults_of_page([name_of(mutants[number - 1]) for number in numbers], noticed, not wish.only)
    print("\n".join(faults))
    raise SystemExit(0 if share >= 0.95 and not faults else 1)


if __name__ == "__main__":
    main()
