#!/usr/bin/env bash
# Grade a class as a Slurm array: one task a submission, at most KREDA_AT_ONCE (default 50) at a time.
#
#   grade_slurm.sh CLASS RUBRIC OUT [OPTION OF kreda grade...]      prints the number of the job
#
# A task whose node dies is queued again (--requeue); a result appears whole or not at all, so none is lost or doubled.
# When the array has ended: kreda grade --class CLASS --rubric RUBRIC -o OUT writes the overview and grades what is missing.
# Variables: KREDA, the program; SBATCH_..., Slurm's own (SBATCH_PARTITION, SBATCH_ACCOUNT, SBATCH_TIMELIMIT).
set -euo pipefail
(( $# >= 3 )) || { sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2; }
kreda=$(command -v "${KREDA:-kreda}") || { echo "there is no program ${KREDA:-kreda}; set KREDA" >&2; exit 2; }
class=$(realpath "$1") rubric=$(realpath "$2") out=$(realpath -m "$3")
shift 3
command -v sbatch >/dev/null || { echo "sbatch is missing: this is no machine of a Slurm cluster" >&2; exit 2; }
mkdir -p "$out"
list=$out/submissions.txt  # written once: a task is a line of it
find "$class" -mindepth 1 -maxdepth 1 -type d -not -name '.*' -printf '%f\n' | sort >"$list"
count=$(wc -l <"$list")
(( count > 0 )) || { echo "$class holds no folders; each submission is one" >&2; exit 2; }
sbatch --parsable --job-name=kreda-grade --requeue --array="1-$count%${KREDA_AT_ONCE:-50}" --cpus-per-task=1 \
    --output=/dev/null /dev/stdin "$kreda" "$class" "$rubric" "$out" "$@" <<'TASK'
#!/usr/bin/env bash
kreda=$1 class=$2 rubric=$3 out=$4
shift 4
name=$(sed -n "${SLURM_ARRAY_TASK_ID}p" "$out/submissions.txt")
mkdir -p "$out/$name"
exec "$kreda" grade "$class/$name" --rubric "$rubric" -o "$out/$name" --resume "$@" >"$out/$name/grader.txt" 2>&1
TASK
