#!/usr/bin/env bash
# slurm.sh: a list of commands as an array job of Slurm; every task takes each so-many-th command of the list.
#   LIST=commands.txt LOGS=logs sbatch --array=0-9 docs/batch/slurm.sh
# The list, what it names and LOGS lie on a disk that all nodes see. A task whose node is lost, or that was killed, is put into the queue
# again and goes on where its log ends; a task that fails is tried anew by
#   TASKS=10 LIST=commands.txt LOGS=logs sbatch --array=NUMBER docs/batch/slurm.sh
#SBATCH --job-name=stretch-engine
#SBATCH --requeue
#SBATCH --open-mode=append
set -euo pipefail
: "${LIST:?names the list of commands}" "${LOGS:=logs}" "${PROGRAM:=stretch-engine}"
# An array over 0 to N-1 is N tasks; one of them alone says with TASKS how many there were.
task=${SLURM_ARRAY_TASK_ID:-0} tasks=${TASKS:-${SLURM_ARRAY_TASK_COUNT:-1}}
mkdir -p "$LOGS"
mine=$(awk -v tasks="$tasks" -v task="$task" 'NF && !/^[ \t]*#/ && n++ % tasks == task' "$LIST")
[ -n "$mine" ] || exit 0 # more tasks than commands
"$PROGRAM" batch - --jobs "${SLURM_CPUS_PER_TASK:-1}" --resume "$LOGS/$task.jsonl" <<<"$mine"
