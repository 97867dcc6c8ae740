#!/usr/bin/env bash
# killed_while_saving.sh PROGRAM ROOT [KILLS|calls]: the program is killed while it saves over a file, as .glb and as a pair of .gltf
# and .bin: what stands there is the old work or the new one, whole. Killed so many times at random moments, or before each of
# the calls that change a folder. Exit code 77 where strace cannot do the latter.
set -euo pipefail
program=$1 root=$2 kills=${3:-40}
if [ "$kills" = calls ] && ! strace -o /dev/null true 2>/dev/null; then
  echo "left out: strace is missing or may not trace here"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
RANDOM=7
moves="$work/here"

# save SCALE FILE COMMAND...: the command runs the program. Without the work in the file, by which a pair could be put right again.
save() {
  local scale=$1 file=$2
  shift 2
  exec "$@" "$program" exaggerate "$root/assets/dummy.glb" -o "$file" --limb left-arm --range 21:27 --scale "$scale" --clean >/dev/null 2>&1
}

# What is in a saved file, whatever its buffers are called.
contents() {
  "$program" resave "$1" -o "$work/contents.glb" >/dev/null 2>"$work/problem" || { echo "unreadable: $(cat "$work/problem")"; return; }
  sha256sum "$work/contents.glb" | cut -d ' ' -f 1
}

# judge KIND MOMENT: counts what is there, and lets the next save replace it.
judge() {
  local found
  found=$(contents "$moves/punch.$1")
  if [ "$found" != "$two" ] && [ "$found" != "$three" ]; then
    echo "FAILED: killed $2, punch.$1 is neither the old nor the new work: $found"
    ls -la "$moves"
    exit 1
  fi
  if [ "$found" = "$now" ]; then old=$((old + 1)); else new=$((new + 1)); fi
  now=$found
  rm -f "$moves"/.stretch-engine-* "$work/contents.glb"
}

# The scale that is not there now.
other() {
  if [ "$now" = "$two" ]; then echo 3; else echo 2; fi
}

# Every one of the calls in turn, until there are no more.
killed_before_each_call() {
  local kind=$1 call at status
  for call in fsync link rename unlink; do
    for ((at = 1; at < 30; ++at)); do
      status=0
      { (save "$(other)" "$moves/punch.$kind" strace -f -o "$work/trace" -e "trace=$call" -e "inject=$call:signal=KILL:when=$at"); } \
        2>/dev/null || status=$?
      judge "$kind" "before $call $at"
      [ "$status" -ne 0 ] || break
    done
    [ "$at" -gt 1 ] || [ "$call" = link ] || [ "$call" = unlink ] || { echo "FAILED: saving made no call of $call"; exit 1; }
  done
}

killed_at_random() {
  local kind=$1 i job
  for ((i = 0; i < kills; ++i)); do
    save "$(other)" "$moves/punch.$kind" env &
    job=$!
    # Late moments count more: writing comes at the end.
    sleep "$(printf '0.%03d' $((takes * (400 + RANDOM % 700) / 1000)))"
    kill -9 "$job" 2>/dev/null || true
    wait "$job" 2>/dev/null || true
    judge "$kind" "at random"
  done
}

(save 2 "$work/warm.glb" env)
began=$(date +%s%N)
(save 2 "$work/warm.glb" env)
takes=$((($(date +%s%N) - began) / 1000000 + 1)) # milliseconds of a whole save
for kind in glb gltf; do
  mkdir -p "$work/three" "$moves"
  (save 3 "$work/three/punch.$kind" env)
  (save 2 "$moves/punch.$kind" env)
  three=$(contents "$work/three/punch.$kind") two=$(contents "$moves/punch.$kind")
  [ "$two" != "$three" ] || { echo "FAILED: both files are the same"; exit 1; }
  old=0 new=0 now=$two
  if [ "$kills" = calls ]; then killed_before_each_call "$kind"; else killed_at_random "$kind"; fi
  (save 3 "$moves/punch.$kind" env)
  [ "$(contents "$moves/punch.$kind")" = "$three" ] || { echo "FAILED: the next save does not save"; exit 1; }
  echo "punch.$kind, killed $((old + new)) times: $old times the old work stood there, $new times the new"
done
