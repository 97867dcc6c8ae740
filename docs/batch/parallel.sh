#!/usr/bin/env bash
# parallel.sh LIST LOGS [HOSTS]: a list of commands in blocks of twenty by GNU parallel, on the cores of this machine, or on those of the machines that
# the file HOSTS names, one in each line as ssh knows it. They share a disk, and start in this folder. A second call does what is not done.
set -euo pipefail
list=$1 logs=$2 hosts=${3:-}
program=${PROGRAM:-stretch-engine} block=${BLOCK:-20}
mkdir -p "$logs/lists"
rm -f "$logs"/lists/[0-9]* # parts of another list
awk -v block="$block" -v to="$logs/lists" 'NF && !/^[ \t]*#/ { print > sprintf("%s/%06d", to, int((n++) / block)) }' "$list"
where=()
[ -z "$hosts" ] || where=(--sshloginfile "$hosts" --workdir "$PWD")
find "$logs/lists" -type f | sort |
  parallel -q "${where[@]}" --retries 3 "$program" batch {} --resume "$logs/{/}.jsonl"
