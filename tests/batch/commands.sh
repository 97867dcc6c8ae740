#!/usr/bin/env bash
# commands.sh PROGRAM ROOT: many commands by the verb batch: what can be done is done, what fails is named, a list that was killed goes
# on where it was, and neither the number at a time nor one process instead of many changes a byte.
set -euo pipefail
program=$1 root=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cp "$root/assets/dummy.glb" "the boxer.glb"
printf 'no model' >broken.glb

fail() {
  echo "FAILED: $1"
  cat ./*.err ./*.out 2>/dev/null || true
  exit 1
}

# list FOLDER: twelve commands, two of which fail.
list() {
  echo "# a library"
  for scale in 2 2.5 3 3.5 4; do
    echo "exaggerate 'the boxer.glb' -o $1/$scale.glb --limb left-arm --range 21:27 --scale $scale --json"
    echo "stretch-engine info \"the boxer.glb\" --json-line"
  done
  echo
  echo "info broken.glb"
  echo "exaggerate 'the boxer.glb' -o $1/none.glb --limb left-wing"
}

mkdir single one two killed
list two >list
status=0
"$program" batch list --jobs 2 --json-lines >two.out 2>two.err || status=$?
[ "$status" = 1 ] || fail "two commands fail, and the exit code is $status"
grep -q "2 of 12 commands could not be done" two.err || fail "it is not told how many failed"
[ "$(wc -l <two.out)" = 12 ] || fail "there is not one line for each command"
[ "$(grep -c '"exit":0' two.out)" = 10 ] || fail "not ten commands are done"
grep -q '"line":13,.*"exit":1,.*broken.glb' two.out || fail "the broken file is not named: $(cat two.out)"
grep -q '"report":{.*"left-arm"' two.out || fail "no report stands in its answer"
python3 -c 'import json,sys; [json.loads(line) for line in open("two.out")]' || fail "a line is no JSON"

list one | "$program" batch - --json-lines >one.out 2>one.err || true
for scale in 2 2.5 3 3.5 4; do
  "$program" exaggerate "the boxer.glb" -o "single/$scale.glb" --limb left-arm --range 21:27 --scale "$scale"
  cmp "single/$scale.glb" "one/$scale.glb" || fail "$scale differs from a single call"
  cmp "single/$scale.glb" "two/$scale.glb" || fail "$scale differs two at a time"
done
sort one.out | sed 's|one/|two/|g' >one.sorted
sort two.out | diff - one.sorted || fail "the answers differ"

# Killed after three answers: what is in the log is not done again, a torn line is.
list killed >list
"$program" batch list --resume log >/dev/null 2>killed.err &
running=$!
while [ "$(cat log 2>/dev/null | wc -l)" -lt 3 ]; do sleep 0.02; done
kill -9 "$running"
wait "$running" 2>/dev/null || true
before=$(wc -l <log)
printf '{"line":2,"command":"torn' >>log
for file in killed/*.glb; do touch -d 2000-01-01 "$file"; done
"$program" batch list --resume log >resumed.out 2>resumed.err && fail "the broken file is forgotten"
"$program" batch list --resume log >again.out 2>again.err && fail "what failed is taken for done"
for scale in 2 2.5 3 3.5 4; do cmp "single/$scale.glb" "killed/$scale.glb" || fail "$scale differs after a kill"; done
[ "$(stat -c %Y killed/2.glb)" = "$(date -d 2000-01-01 +%s)" ] || fail "what was done is done again"
grep -q "done:" again.out && fail "a third call does something again"
grep -q "line 13: broken.glb" again.err || fail "what failed is not tried again"

: >empty
"$program" batch empty 2>empty.err && fail "an empty list is accepted"
grep -q "holds no command" empty.err || fail "it is not told that the list is empty"
"$program" batch list --resume nowhere/log >unwritable.out 2>unwritable.err && fail "a log that cannot be written is accepted"
grep -q "nowhere/log.* cannot be written" unwritable.err || fail "it is not told that the log cannot be written"
cp list kept
"$program" batch list --resume list >itself.out 2>itself.err && fail "answers are written into the list"
grep -q "is the list itself" itself.err && cmp list kept || fail "the list is not as it was"
mkfifo pipe
timeout 20 "$program" batch list --resume pipe >pipe.out 2>pipe.err && fail "a pipe keeps no answers"
grep -q "is a pipe" pipe.err || fail "it is not told that a pipe keeps nothing"
"$program" batch list <&- >closed.out 2>closed.err || true
grep -q '^done: exaggerate' closed.out || fail "a closed standard input takes the commands' answers"
status=0
"$program" info missing.glb 2>/dev/full || status=$?
[ "$status" = 1 ] || fail "an error that nobody can be told ends in $status"
"$program" batch list --resume /dev/full >full.out 2>full.err && fail "a log that was not written is accepted"
grep -q "/dev/full.* could not be written to the end" full.err || fail "it is not told that the log is torn"
grep -q "batch" <("$program" --help) || fail "the help does not name the verb"
echo "batch list" >nested
"$program" batch nested 2>nested.err && fail "a list runs itself"
echo "12 commands, $before before the kill; the same bytes one and two at a time, and by single calls"
