#!/bin/bash
# adopt.sh KREDA SOURCE WORK: what a teacher does by docs/grading.md, "Make it yours", in a fresh folder: the page's own
# commands, in their order.
set -eu
kreda=$1 source=$2 work=$3
rm -rf "$work"
mkdir -p "$work/examples" && cp -r "$source/examples/assignments" "$work/examples"
PATH=$(dirname "$kreda"):$PATH
cd "$work"
awk '/^### /{wanted = /Make it yours/} /^```/{inside = wanted && /^```sh/; next} inside' \
    "$source/docs/grading.md" > commands.sh
[[ $(grep -c . commands.sh) -ge 12 ]] || { echo "FAILED: the page has too few commands"; exit 1; }
bash -eu commands.sh > said.txt 2>&1 || { cat said.txt; echo "FAILED: a command of docs/grading.md"; exit 1; }

expect() {  # expect WHAT COMMAND...: the command succeeds
    local what=$1
    shift
    "$@" > /dev/null || { cat said.txt; echo "FAILED: $what"; exit 1; }
}
# 18 points, and two more for Phong's terms.
expect "the solution has all points" grep -q "20 of 20 points" said.txt
expect "the stub has none" grep -q "0 of 20 points" said.txt
expect "the deadline is in the report" grep -q "Sunday 24:00" graded/solution/report.html
expect "the students' page has the deadline" grep -q "by Sunday 24:00" my/A3_lights/README.md
expect "the students' page has the points" grep -q "^| 5 Phong.* 5 |$" my/A3_lights/README.md
expect "the hidden scene was graded" grep -q "wide" graded/solution/report.html
expect "the changed scene has another picture" test "$(cksum < my/A3_lights/golden/spot.png)" != \
    "$(cksum < "$source/examples/assignments/A3_lights/golden/spot.png")"
expect "the others have the same" "$kreda" compare my/A3_lights/golden/two_lamps.png \
    "$source/examples/assignments/A3_lights/golden/two_lamps.png"
tar -tzf A3.tar.gz > handed_out.txt
expect "what is handed out can be graded" grep -qx "harness.hpp" handed_out.txt
if grep -qE "teacher|solution" handed_out.txt; then echo "FAILED: the solution is handed out"; exit 1; fi
# A student unpacks it and checks the stub by its own page's command.
mkdir student && tar -xzf A3.tar.gz -C student && cd student
"$kreda" grade A3_lights --rubric A3_lights/rubric.toml > ../student.txt 2>&1
expect "a student can check the stub" grep -q "0 of 16 points" ../student.txt
echo "adopted"
