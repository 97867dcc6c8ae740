#!/usr/bin/env bash
# stages_test.sh ROOT: what .ci/stages.sh promises. Stages share their seconds, none starves another, and what did not run is named
# as left out and counted as skipped.
set -euo pipefail
root=$1
# shellcheck source=.ci/stages.sh
. "$root/.ci/stages.sh"

fine() { tell "all of it"; }
broken() { false; }
missing() { tell "no compiler"; return 77; }
endless() { tell "a part"; within sleep 600; }
seen=0
quick() { seen=$(left); }

# expect WHAT IS SHOULD
expect() {
  [ "$2" = "$3" ] || { echo "FAILED: $1: '$2' in place of '$3'"; exit 1; }
}

SECONDS=0
stage 3 "an endless one" endless
stage 3 "a fine one" fine
stage 3 "a broken one" broken
stage 3 "one that lacks something" missing
stage 60 "a quick one" quick
run_stages 72 >/dev/null
[ "$SECONDS" -lt 30 ] || { echo "FAILED: an endless stage took $SECONDS s of a share of 3"; exit 1; }
[ "$seen" -gt 40 ] || { echo "FAILED: the last stage had $seen s of 60"; exit 1; }
expect "passed" "$passed" 2
expect "failed" "$failed" 1
expect "skipped" "$skipped" 2
expect "the part" "${left_out[0]}" "left out: an endless one, in part: its share of 3 s was up: a part"
expect "the lack" "${left_out[1]}" "left out: one that lacks something: no compiler"

# Seconds that are used up leave out what has not begun, and no stage of it is passed.
names=() shares=() commands=() left_out=() passed=0 failed=0 skipped=0
stage 30 "one too late" fine
run_stages 1 >/dev/null
expect "passed too late" "$passed $failed $skipped" "0 0 1"
expect "the late one" "${left_out[0]}" "left out: one too late: 0 s were left of the 30 s that it wants"

# Where there is no time for all, the first has all of its share and the others what it leaves: not a part of it each.
names=() shares=() commands=() left_out=() passed=0 failed=0 skipped=0
stage 40 "one that fits" quick
stage 60 "a long one" quick
stage 9 "a short one" quick
expect "the first of too many" "$(SECONDS=0; granted_of 0 50)" "$((50 * 40 / 49))"
expect "the second of too many" "$(SECONDS=0; granted_of 1 50)" 50
SECONDS=0
run_stages 50 >/dev/null
expect "passed of too many" "$passed $failed $skipped" "3 0 0"

# Each has its turn to be the first, and those before it are not forgotten.
begin_with 1
expect "the turn's names" "${names[*]}" "a long one a short one one that fits"
expect "the turn's shares" "${shares[*]}" "60 9 40"
expect "the turn's commands" "${commands[*]}" "quick quick quick"

# Without a limit everything runs.
names=() shares=() commands=() left_out=() passed=0 failed=0 skipped=0
stage 30 "one without a limit" fine
run_stages unlimited >/dev/null
expect "the last line" "$(told_at_last | tail -n 1)" "1 passed, 0 failed, 0 skipped"

# A test run that says no counts has failed.
log=$(mktemp)
echo "a crash" >"$log"
counts_of "$log"
expect "no counts" "$failed" 1
echo "3 passed, 1 failed, 2 skipped" >"$log"
counts_of "$log"
expect "counts" "$passed $failed $skipped" "4 2 2"
rm "$log"

# Checks on real files that take minutes have one turn of six, and none is forgotten; the quick ones run each time.
all=$("$root/tests/data/run" none folder --names | sort)
turns=$(for i in 0 1 2 3 4 5; do "$root/tests/data/run" none folder --turn "$i/6" --names | grep -v '^left out: '; done | sort)
expect "checks that have a turn" "$(uniq <<<"$turns")" "$all"
expect "times that a quick check runs" "$(grep -c '^corpus$' <<<"$turns")" 6
expect "times that a long check runs" "$(grep -c '^pose$' <<<"$turns")" 1
expect "what is left out" "$("$root/tests/data/run" none folder --turn 1/6 --names | grep -c '^left out: ')" 9
