#!/usr/bin/env bash
# slurm.sh PROGRAM ROOT [COUNT]: a library of COUNT commands (40), three of which fail, by `batch`, as single calls, by GNU parallel
# (docs/batch/parallel.sh) and as an array job (docs/batch/slurm.sh) on two nodes of Slurm, both on this machine, one of which is killed with all that runs on it. All ways make
# the same bytes, each failure is named once, and what the killed node had begun is done again. Prints a table: seconds, seconds of processor time, files for
# each second of it. Exit code 77 where Slurm (Debian's slurm-wlm) or GNU parallel is missing, or no name space for processes is allowed.
set -euo pipefail
program=$(realpath "$1") root=$(realpath "$2") count=${3:-40}
for needed in slurmctld slurmd munged sbatch parallel unshare; do
  command -v "$needed" >/dev/null || { echo "skipped: $needed is missing"; exit 77; }
done
unshare --pid --fork --mount-proc true 2>/dev/null || { echo "skipped: no name space for processes"; exit 77; }
work=$(mktemp -d)
chmod 755 "$work"
cd "$work"
daemons=()
# shellcheck disable=SC2317
ended() {
  local daemon
  for daemon in "${daemons[@]}"; do kill -9 "$daemon" 2>/dev/null || true; done
  cd / && rm -rf "$work"
}
trap ended EXIT

fail() {
  echo "FAILED: $1"
  tail -n 5 ./*.err ./*.log slurm-*.out 2>/dev/null || true
  exit 1
}

# list FOLDER: the commands; every one its own arm, scale and range, and three without what they need.
list() {
  local i
  mkdir -p "$1"
  for ((i = 0; i < count - 3; ++i)); do
    echo "exaggerate boxer.glb -o $1/$i.glb --limb $([ $((i % 2)) = 0 ] && echo left-arm || echo right-arm) --range $((15 + i % 7)):$((24 + i % 5)) --scale $((150 + i))e-2"
  done
  echo "info broken.glb"
  echo "exaggerate boxer.glb -o $1/none.glb --limb left-wing"
  echo "exaggerate missing.glb -o $1/none.glb --limb left-arm"
}

# A program that writes down what processor time it took.
cat >timed <<END
#!/usr/bin/env bash
TIMEFORMAT='%U %S'
status=0
{ time "$program" "\$@" 2>&3 || status=\$?; } 3>&2 2>>"$work/times"
exit \$status
END
chmod +x timed

# row NAME FOLDER SECONDS: a line of the table, of the files in the folder and the processor time in `times`.
row() {
  local made processor
  made=$(find "$2" -name '*.glb' | wc -l)
  processor=$(awk '{sum += $1 + $2} END {print sum}' times)
  [ "$made" = $((count - 3)) ] || fail "$1 made $made files of $((count - 3))"
  awk -v name="$1" -v made="$made" -v wall="$3" -v processor="$processor" \
    'BEGIN {printf "| %s | %.0f | %.1f | %.1f | %.1f |\n", name, wall, made / wall, processor, made / processor}'
  rm -f times
}

seconds() {
  date +%s.%N
}

since() {
  awk -v began="$1" -v now="$(seconds)" 'BEGIN {print now - began}'
}

# same FOLDER: its files are those of `batch`.
same() {
  diff -rq batch "$1" >/dev/null || fail "files differ from those by batch: $(diff -rq batch "$1" | head -n 1)"
}

# failures_of LOGS: the commands that failed are named once each as the last of what is told of them.
failures_of() {
  [ "$(cat "$1"/*.jsonl | grep -c '"exit":1')" -ge 3 ] || fail "$1: not all that failed is told"
  [ "$(cat "$1"/*.jsonl | grep '"exit":1' | grep -oE '"command":"[^"]*"' | sort -u | wc -l)" = 3 ] || fail "$1: others than three failed"
}

cp "$root/assets/dummy.glb" boxer.glb
printf 'no model' >broken.glb
for way in batch single parallel slurm; do list "$way" >"$way.txt"; done
echo "| $count commands, three fail | s | files a second | s of processor | files for each second of it |"
echo "|---|---|---|---|---|"

began=$(seconds)
mkdir -p batch.logs
./timed batch batch.txt --jobs 2 --resume batch.logs/0.jsonl >/dev/null 2>batch.err && fail "three commands fail, and batch says nothing"
row "one \`batch\`, two jobs" batch "$(since "$began")"
failures_of batch.logs

began=$(seconds)
while read -r -a words; do ./timed "${words[@]}" >/dev/null 2>>single.err || true; done <single.txt
row "single calls" single "$(since "$began")"
same single
[ "$(grep -c "^stretch-engine: " single.err)" = 3 ] || fail "single calls tell $(grep -c "^stretch-engine: " single.err) failures"

began=$(seconds)
PROGRAM="$work/timed" "$root/docs/batch/parallel.sh" parallel.txt parallel.logs >/dev/null 2>parallel.err && fail "three commands fail, and parallel says nothing"
row "GNU parallel, blocks of twenty" parallel "$(since "$began")"
same parallel
failures_of parallel.logs

# The two nodes, each with its processes in a name space of its own: who kills it kills all that runs there.
key=munge.key host=$(hostname -s)
dd if=/dev/urandom of=$key bs=64 count=16 2>/dev/null
chmod 600 $key
cat >slurm.conf <<END
ClusterName=two
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=7117
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CredType=cred/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
MpiDefault=none
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool.%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.%n.pid
SlurmdTimeout=10
MinJobAge=3600
ReturnToService=2
NodeName=one NodeHostname=$host NodeAddr=127.0.0.1 Port=7118 CPUs=1
NodeName=two NodeHostname=$host NodeAddr=127.0.0.1 Port=7119 CPUs=1
PartitionName=all Nodes=ALL Default=YES State=UP MaxTime=60
END
mkdir -p state spool.one spool.two
export SLURM_CONF="$work/slurm.conf"
munged --force --foreground --key-file="$work/$key" --socket="$work/munge.socket" --pid-file="$work/munged.pid" --log-file="$work/munged.log" \
  --seed-file="$work/munge.seed" >munged.err 2>&1 &
daemons+=($!)
disown
slurmctld -D -c >slurmctld.log 2>&1 &
daemons+=($!)
disown
node() {
  unshare --pid --fork --kill-child --mount-proc slurmd -D -N "$1" >>"slurmd.$1.log" 2>&1 &
  daemons+=($!)
  disown
}
# waited SECONDS COMMAND...: until it succeeds.
waited() {
  local left=$1
  shift
  until "$@"; do
    [ $((left--)) -gt 0 ] || fail "waited too long for: $*"
    sleep 1
  done
}
idle() { [ "$(sinfo -h -t idle -o %D 2>/dev/null | awk '{n += $1} END {print n + 0}')" = 2 ]; }
node one
node two
second=${daemons[-1]}
waited 60 idle

# The program as the tasks call it. The first one that starts on node two does half of its list, begins the rest, and stands still there until
# it is killed: however fast the machine is, it is killed in the middle.
cat >held <<END
#!/usr/bin/env bash
list=\$(cat)
if [ "\$SLURMD_NODENAME" = two ] && mkdir "$work/one_is_held" 2>/dev/null; then
  head -n \$((\$(wc -l <<<"\$list") / 2)) <<<"\$list" | "$work/timed" "\$@" || true
  "$program" "\$@" <<<"\$list" &
  kill -STOP \$!
  echo "\$SLURM_ARRAY_TASK_ID" >"$work/task_held.part"
  mv "$work/task_held.part" "$work/task_held"
  sleep 3600
fi
"$work/timed" "\$@" <<<"\$list"
END
chmod +x held

began=$(seconds)
job=$(LIST=slurm.txt LOGS=slurm.logs PROGRAM="$work/held" sbatch --parsable --array=0-3 --ntasks=1 "$root/docs/batch/slurm.sh") || fail "the job is not taken"
ended_all() { ! squeue -h -j "$job" -o %i 2>/dev/null | grep -q .; }
waited 300 test -e task_held
killed=$(cat task_held)
before=$(wc -l <"slurm.logs/$killed.jsonl")
[ "$before" -ge $((count / 8)) ] || fail "task $killed was held after $before of its commands"
kill -9 "$second"
is_down() { sinfo -h -n two -o %T | grep -q down; }
waited 120 is_down
node two
# Slurm puts a lost task off by two minutes.
is_queued() { scontrol update jobid="${job}_$killed" starttime=now 2>/dev/null || squeue -h -j "${job}_$killed" -t running -o %i | grep -q .; }
waited 60 is_queued
waited 900 ended_all
row "an array of four tasks on two nodes of Slurm, one killed" slurm "$(since "$began")"
same slurm
failures_of slurm.logs
scontrol show job "${job}_$killed" | grep -q Restarts=1 || fail "the killed node's task was not started again"
[ "$(cat slurm.logs/*.jsonl | grep -c '"exit":0')" = $((count - 3)) ] || fail "a command that was done is done again"
echo "task $killed was killed after $before of its commands, with all that ran on its node, and went on behind them"
