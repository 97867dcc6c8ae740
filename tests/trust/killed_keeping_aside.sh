#!/usr/bin/env bash
# killed_keeping_aside.sh KEEP_ASIDE ROOT [KILLS]: two windows on one file keep their unsaved work aside, and both are killed at a
# random moment: of each there is a state that can be taken up whole.
set -euo pipefail
keep=$1 root=$2 kills=${3:-20}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
RANDOM=11
export XDG_STATE_HOME="$work/state"
file="$work/punch.glb" folder="$work/state/stretch-engine/autosave"
cp "$root/assets/dummy.glb" "$file"

fail() {
  echo "FAILED: $1"
  ls -la "$folder" || true
  exit 1
}

kept() { find "$folder" -name '*.json' 2>/dev/null | wc -l; }

for ((round = 0; round < kills; round += 2)); do
  "$keep" "$file" &
  first=$!
  "$keep" "$file" &
  second=$!
  for ((wait = 0; wait < 600; ++wait)); do
    [ "$(kept)" -lt 2 ] || break
    sleep 0.05
  done
  sleep "$(printf '0.%03d' $((RANDOM % 120)))"
  kill -9 "$first"
  sleep "$(printf '0.%03d' $((RANDOM % 30)))"
  kill -9 "$second"
  { wait "$first" "$second"; } 2>/dev/null || true
  found=$("$keep" "$file" found) || fail "$found"
  [ "$found" = 2 ] || fail "two windows kept their work aside, $found of them is there"
  rm -f "$folder"/.stretch-engine-*
done
echo "killed $kills times while unsaved work was kept aside: each time it was there, whole"
