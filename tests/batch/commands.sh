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

# A command is done when its line has come, not when the list ends: two at a time, the third waits for a free process.
mkdir slow
mkfifo slowly
timeout 60 "$program" batch - --jobs 2 --json-lines --resume slow.log <slowly >slow.out 2>slow.err &
running=$!
exec 9>slowly
given=0
while read -r line; do
  given=$((given + 1))
  printf '%s' "${line%???}" >&9 # in two parts
  sleep 0.05
  printf '%s\n' "${line: -3}" >&9
  case $given in 1 | 3 | 9)
    for _ in $(seq 200); do [ "$(wc -l <slow.out)" -ge "$given" ] || sleep 0.05; done
    [ "$(wc -l <slow.out)" = "$given" ] || fail "of $given commands that came $(wc -l <slow.out) are answered"
    ;;
  esac
done < <(list slow | sed '/^#/d; /^$/d')
exec 9>&-
wait "$running" && fail "the failures of a pipe are forgotten"
[ "$(wc -l <slow.out)" = 12 ] || fail "not every line of a pipe is answered"
cmp slow.out slow.log || fail "the log of a pipe is another one"
for scale in 2 2.5 3 3.5 4; do cmp "single/$scale.glb" "slow/$scale.glb" || fail "$scale differs by a pipe"; done
# Two at a time are two: while both processes are stopped in the middle of a command, a third command waits for one of them.
mkfifo stopped
"$program" batch - --jobs 2 --json-lines <stopped >stopped.out 2>stopped.err &
running=$!
exec 9>stopped
tell() { echo "info 'the boxer.glb' --json-line" >&9; }
answered() {
  for _ in $(seq 400); do [ "$(wc -l <stopped.out)" -ge "$1" ] || sleep 0.05; done
  [ "$(wc -l <stopped.out)" = "$1" ] || fail "$(wc -l <stopped.out) commands are answered and not $1, $2"
}
tell
answered 1 "of one that came"
first=$(pgrep -P "$running")
kill -STOP "$first"
tell
tell
answered 2 "while one of two processes is stopped"
second=$(pgrep -P "$running" | grep -vx "$first")
kill -STOP "$second"
tell
tell
sleep 0.5
[ "$(pgrep -P "$running" | wc -l)" = 2 ] || fail "more than two commands are done at a time"
[ "$(wc -l <stopped.out)" = 2 ] || fail "a command is answered that waits for a free process"
kill -CONT "$second"
answered 4 "of which two waited for one process"
kill -CONT "$first"
answered 5 "when both processes go on"
exec 9>&-
wait "$running" || fail "commands that waited could not be done"

list slow | "$program" batch - --resume slow.log >slow-again.out 2>/dev/null && fail "a pipe forgets what failed"
grep -q "done:" slow-again.out && fail "a pipe that is resumed does something again"
printf 'info "the boxer.glb" --json-line' | "$program" batch - >last.out || fail "a last line without an end is left out"
grep -q "^done: info" last.out || fail "a last line without an end is not answered"
"$program" batch - </dev/null 2>nothing.err && fail "an empty pipe is accepted"
grep -q "holds no command" nothing.err || fail "it is not told that the pipe is empty"

: >empty
"$program" batch empty 2>empty.err && fail "an empty list is accepted"
grep -q "holds no command" empty.err || fail "it is not told that the list is empty"
"$program" batch list --resume nowhere/log >unwritable.out 2>unwritable.err && fail "a log that cannot be written is accepted"
grep -q "nowhere/log.* cannot be written" unwritable.err || fail "it is not told that the log cannot be written"
cp list kept
"$program" batch list --resume list >itself.out 2>itself.err && fail "answers are written into the list"
grep -q "is the list itself" itself.err && cmp list kept || fail "the list is not as it was"
cp "the boxer.glb" other.glb
"$program" batch list --resume other.glb >other.out 2>other.err && fail "answers are written behind a character"
grep -q "other.glb.* holds something else than answers" other.err || fail "it is not told that a file is no log"
cmp "the boxer.glb" other.glb || fail "a file that is no log is not as it was"
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
