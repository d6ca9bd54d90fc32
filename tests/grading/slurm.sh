#!/usr/bin/env bash
# slurm.sh KREDA SOURCE FOLDER: a class of 20 on a Slurm of one node, made here for the test; its node dies and comes back.
# No result may be lost, none doubled. Says "SKIPPED: why" where Slurm or MUNGE are not there or cannot start.
set -uo pipefail
kreda=$1 source=$2 folder=$3
rubric=$source/examples/assignments/A3_lights/rubric.toml
export PATH=$PATH:/usr/sbin:/sbin

skip() { echo "SKIPPED: $*"; exit 0; }
fail() { echo "FAILED: $*"; tail -n 5 "$folder"/*.log 2>/dev/null; exit 1; }
for tool in munged slurmctld slurmd sbatch squeue scontrol sacct; do
    command -v "$tool" >/dev/null || skip "$tool is not installed (apt-get install slurm-wlm munge)"
done
[[ $(id -u) == 0 ]] || skip "starting slurmd needs root"

rm -rf "$folder"; mkdir -p "$folder"/{state,spool,munge,class}
chmod 755 "$folder"; chmod 700 "$folder/munge"
daemons=()
stop_all() {
    scancel --full --name=kreda-grade 2>/dev/null
    local i
    for (( i = ${#daemons[@]} - 1; i >= 0; --i )); do kill "${daemons[i]}" 2>/dev/null; done
    wait 2>/dev/null
}
trap stop_all EXIT

# MUNGE with a key and a socket of our own.
head -c 1024 /dev/urandom >"$folder/munge/key"; chmod 400 "$folder/munge/key"
munged --foreground --force --key-file="$folder/munge/key" --socket="$folder/munge.socket" \
    --pid-file="$folder/munge/pid" --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" >"$folder/munged.log" 2>&1 &
daemons+=($!)

port=$(( 20000 + $$ % 20000 ))
host=$(hostname -s)
cat >"$folder/slurm.conf" <<CONF
ClusterName=kreda
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$(( port + 1 ))
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1
SlurmdTimeout=10
ReturnToService=2
JobRequeue=1
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$folder/slurm.conf
start_node() { slurmd -D -f "$SLURM_CONF" >"$folder/slurmd.out.log" 2>&1 & node=$!; daemons+=("$node"); }
sleep 1
slurmctld -D -c -f "$SLURM_CONF" >"$folder/slurmctld.out.log" 2>&1 &
daemons+=($!)
start_node
for (( i = 0; i < 30; ++i )); do
    [[ $(sinfo -h -o %t 2>/dev/null) == idle ]] && break
    sleep 1
done
[[ $(sinfo -h -o %t 2>/dev/null) == idle ]] || skip "Slurm does not start here: $(tail -n 1 "$folder/slurmctld.out.log")"

for i in $(seq -w 20); do
    mkdir -p "$folder/class/s$i"
    { cat "$source/examples/assignments/A3_lights/teacher/solution.cpp"; echo "// $i"; } >"$folder/class/s$i/student.cpp"
done
job=$(KREDA=$kreda "$source/tools/grade/cluster/grade_slurm.sh" "$folder/class" "$rubric" "$folder/out" --formats none) ||
    fail "sbatch"
count() { find "$folder/out" -mindepth 2 -maxdepth 2 -name result.json 2>/dev/null | wc -l; }
for (( i = 0; i < 240; ++i )); do (( $(count) >= 4 )) && break; sleep 0.5; done
(( $(count) >= 4 )) || fail "no task got anywhere"

# The node dies with what runs on it, and comes back.
before=$(count)
stepds=$(pgrep -f "^slurmstepd: \[${job}" ; true)
kill -9 "$node" $stepds 2>/dev/null
(( before < 20 )) || fail "all was over before the node was killed: the test shows nothing"
scontrol update NodeName="$host" State=DOWN Reason=killed || fail "scontrol"
sleep 2
start_node
sleep 1
scontrol update NodeName="$host" State=RESUME 2>/dev/null
for (( i = 0; i < 600; ++i )); do
    [[ -z $(squeue -h -j "$job" 2>/dev/null) ]] && break
    (( i % 20 != 19 )) || scontrol update NodeName="$host" State=RESUME 2>/dev/null
    sleep 0.5
done
[[ -z $(squeue -h -j "$job" 2>/dev/null) ]] || fail "the array does not end: $(squeue -h -j "$job" | head -3)"
after=$(count)
echo "$before results when the node was killed, $after when the array had ended"
(( after == 20 )) || fail "results were lost: $after of 20"
said=$("$kreda" grade --class "$folder/class" --rubric "$rubric" -o "$folder/out" --formats none 2>/dev/null)
[[ $said == "20 submissions: 0 graded now, 20 before" ]] || fail "the overview graded again: $said"
(( $(wc -l <"$folder/out/results.csv") == 21 )) || fail "results.csv does not have 20 lines"
(( $(cut -d, -f1 "$folder/out/results.csv" | sort -u | wc -l) == 21 )) || fail "a result is doubled"
echo "20 of 20, each once"
