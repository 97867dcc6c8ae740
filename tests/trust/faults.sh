#!/usr/bin/env bash
# faults.sh PROGRAM ROOT [disks]: folders and files that may not be written, output that nobody takes; or a full disk and one that
# may only be read. What was there is there afterwards, nothing else is, and one line says why. Exit code 77 where no disk may be
# mounted.
set -euo pipefail
program=$(realpath "$1") root=$(realpath "$2")
work=$(mktemp -d)
mounted=()
cleanup() {
  for place in "${mounted[@]}"; do umount "$place" || true; done
  chmod -R u+w "$work"
  rm -rf "$work"
}
trap cleanup EXIT
source="$root/assets/dummy.glb"

fail() {
  echo "FAILED: $1"
  cat "$work/told"
  exit 1
}

# Runs the program, which has to fail with one line that holds these words.
refused() {
  local words=$1 status=0
  shift
  "$@" >"$work/said" 2>"$work/told" || status=$?
  [ "$status" = 1 ] || fail "exit code $status instead of 1: $*"
  [ "$(wc -l <"$work/told")" = 1 ] || fail "not one line: $*"
  grep -q "$words" "$work/told" || fail "nothing about '$words': $*"
}

# What is in a folder, by name and content.
contents() { (cd "$1" && find . -type f -exec sha256sum {} + | sort); }

save() { echo "$program" exaggerate "$source" -o "$1" --limb left-arm --range 21:27 --scale 3; }

# old_work FOLDER: what stood there before, as .glb and as a pair.
old_work() {
  "$program" resave "$root/tests/fuzz/seeds/gltf/biped.glb" -o "$1/punch.glb"
  "$program" resave "$root/tests/fuzz/seeds/gltf/biped.glb" -o "$1/pair.gltf"
}

# unchanged_by WORDS FOLDER COMMAND...
unchanged_by() {
  local words=$1 folder=$2 before
  shift 2
  before=$(contents "$folder")
  refused "$words" "$@"
  [ "$(contents "$folder")" = "$before" ] || fail "$folder is not as it was: $*"
}

if [ "${3:-}" = disks ]; then
  mkdir "$work/disk"
  if ! mount -t tmpfs -o size=300k none "$work/disk" 2>/dev/null; then
    echo "left out: mounting is not allowed here"
    exit 77
  fi
  mounted+=("$work/disk")
  old_work "$work/disk"
  for name in punch.glb pair.gltf new.glb; do
    # shellcheck disable=SC2046
    unchanged_by "No space left" "$work/disk" $(save "$work/disk/$name")
  done
  echo "a full disk: told, nothing changed"
  mount -o remount,ro "$work/disk"
  for name in punch.glb pair.gltf new.glb; do
    # shellcheck disable=SC2046
    unchanged_by "Read-only file system" "$work/disk" $(save "$work/disk/$name")
  done
  echo "a disk that may only be read: told, nothing changed"
  exit
fi

mkdir "$work/limited"
old_work "$work/limited"
for name in punch.glb pair.gltf; do
  # shellcheck disable=SC2046
  unchanged_by "cannot be written" "$work/limited" bash -c "ulimit -f 200 && exec $(save "$work/limited/$name")"
done
echo "a limit on the size of files: told, nothing changed"

mkdir "$work/protected"
old_work "$work/protected"
chmod a-w "$work/protected"/*
for name in punch.glb pair.gltf; do
  # shellcheck disable=SC2046
  unchanged_by "write-protected" "$work/protected" $(save "$work/protected/$name")
done
echo "files that are write-protected: told, nothing changed"

# shellcheck disable=SC2046
refused "no such folder" $(save "$work/missing/punch.glb")
# shellcheck disable=SC2046
refused "cannot be written" $(save /proc/punch.glb)
# shellcheck disable=SC2046
if [ -w /dev/full ]; then
  status=0
  "$program" info "$source" --json >/dev/full 2>"$work/told" || status=$?
  [ "$status" = 1 ] || fail "a report that was not written is no report: exit code $status"
  grep -q "report cannot be written" "$work/told" || fail "nothing about the report"
fi
echo "reports that nobody takes: told"
