#!/usr/bin/env bash
# library.sh PROGRAM ROOT: a library of clips by docs/batch/Makefile: what can be done is done, what fails is named, a second
# call does nothing, and the number of runs at a time changes no byte.
set -euo pipefail
program=$1 root=$2
command -v make >/dev/null || exit 77
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/clips/deep"
for place in one two deep/three; do
  cp "$root/assets/dummy.glb" "$work/clips/$place.glb"
done
printf 'no model' >"$work/clips/broken.glb"
cp "$root/docs/recipes/refined-punch.json" "$work/recipe.json"

# library OUT RUNS: exit code of make, which has nothing to say to the terminal.
library() {
  make -k -j "$2" -C "$work" -f "$root/docs/batch/Makefile" PROGRAM="$program" OUT="$1" >"$work/$1.out" 2>"$work/$1.err" && echo 0 || echo $?
}

fail() {
  echo "FAILED: $1"
  cat "$work"/*.err
  exit 1
}

[ "$(library alone 1)" = 2 ] || fail "a file that cannot be read does not make the run fail"
[ "$(library beside 4)" = 2 ] || fail "a file that cannot be read does not make the run fail"
grep -q "stretch-engine: clips/broken.glb" "$work/alone.err" || fail "the broken file is not named"
[ ! -e "$work/alone/broken.glb" ] || fail "something was written for the broken file"
for place in one two deep/three; do
  cmp "$work/alone/$place.glb" "$work/beside/$place.glb" || fail "$place.glb differs from run to run"
  [ "$(wc -l <"$work/alone/$place.glb.report")" = 1 ] || fail "the report of $place.glb is not one line"
  grep -q '"left-arm"' "$work/alone/$place.glb.report" || fail "the report of $place.glb names no limb"
done

rm "$work/clips/broken.glb"
touch -d 2000-01-01 "$work/alone/one.glb"
before=$(stat -c %Y "$work/alone/two.glb")
sleep 1
[ "$(library alone 2)" = 0 ] || fail "without the broken file the run fails"
[ "$(stat -c %Y "$work/alone/two.glb")" = "$before" ] || fail "what was done is done again"
[ "$(stat -c %Y "$work/alone/one.glb")" -gt "$before" ] || fail "what is older than its source stays"
echo "three clips, the same bytes one at a time and four at a time"
