#!/usr/bin/env bash
# run_in_parts_test.sh ROOT: what tests/support/run_in_parts.py promises of a program whose cases it runs some to a process. The program
# here stands in for a test program: each case's name says what it does.
set -euo pipefail
root=$1
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
program="$folder/program"
cat >"$program" <<'PROGRAM'
#!/usr/bin/env bash
if [ "$1" = --list-test-names-only ]; then
  cat "$(dirname "$0")/cases"
  exit "$(wc -l <"$(dirname "$0")/cases")"
fi
count=$(wc -l <"$2")
echo "$count" >>"$(dirname "$0")/processes"
while IFS= read -r name; do
  case $name in
    *fails*) echo "test cases: $count | 1 failed"; exit 1 ;;
    *crashes*) kill -SEGV $$ ;;
    *"has no files"*) echo "  nothing ran: there are no files" ;;
    *overflows*) echo "sum.cpp:3:5: runtime error: signed integer overflow" ;;
    *hangs*) exec sleep 60 ;;
    *"is no case of that name"*) count=$((count - 1)) ;;
    *[!\\],* | *[!\\][][]*) count=$((count - 1)) ;; # as Catch does
    *company*) [ "$count" -eq 1 ] || { echo "test cases: $count | 1 failed"; exit 1; } ;;
  esac
done <"$2"
echo "All tests passed (no assertions in $count test cases)"
PROGRAM
chmod +x "$program"

seconds=60 more=()
# expect STATUS LINES CASE...: how it ends with these cases, and which lines of its output tell of them.
expect() {
  local status=0 wanted=$1 lines=$2 told
  shift 2
  printf '%s\n' "$@" >"$folder/cases"
  rm -f "$folder/processes"
  told=$("$root/tests/support/run_in_parts.py" "$program" "${more[@]}" --cases 3 --jobs 2 --seconds "$seconds") || status=$?
  told=$(grep -E '^(failed|too long): |took too long$' <<<"$told" | paste -s -d '|')
  [ "$status $told" = "$wanted $lines" ] || { echo "FAILED: '$status $told' in place of '$wanted $lines'"; exit 1; }
}

expect 0 "4 passed, 0 failed, 0 skipped, 0 took too long" "one" "two, with a comma" "three [3]" "four"
[ "$(sort "$folder/processes" | paste -s -d ' ')" = "2 2" ] || { echo "FAILED: four cases, three to a process at most"; exit 1; }
expect 1 "failed: it fails|3 passed, 1 failed, 0 skipped, 0 took too long" "one" "it fails" "three" "four"
expect 1 "failed: it crashes|1 passed, 1 failed, 0 skipped, 0 took too long" "it crashes" "two"
expect 1 "failed: it overflows|1 passed, 1 failed, 0 skipped, 0 took too long" "one" "it overflows"
expect 1 "failed: there is no case of that name|1 passed, 1 failed, 0 skipped, 0 took too long" "one" "there is no case of that name"
expect 1 "failed: cases that pass each by itself|1 passed, 1 failed, 0 skipped, 0 took too long" "one that minds company" "two"
expect 0 "2 passed, 0 failed, 1 skipped, 0 took too long" "one" "one that has no files" "three"
expect 1 "failed: it fails|1 passed, 1 failed, 1 skipped, 0 took too long" "one" "one that has no files" "it fails"
printf 'program:it fails\nprogram:one\nother:two\n' >"$folder/list"
more=(--except "$folder/list")
expect 0 "2 passed, 0 failed, 0 skipped, 0 took too long" "one" "it fails" "two" "one more"
# The second program has cases of its own, and a failure in either is one of both.
mkdir "$folder/other"
cp "$program" "$folder/other/program"
printf 'four\nit crashes\n' >"$folder/other/cases"
more=("$folder/other/program")
expect 1 "failed: it crashes|3 passed, 1 failed, 0 skipped, 0 took too long" "one" "two"
printf '' >"$folder/other/cases"
expect 1 "2 passed, 0 failed, 0 skipped, 0 took too long" "one" "two" # none that a program has
more=() seconds=3
expect 75 "too long: it hangs|0 passed, 0 failed, 0 skipped, 1 took too long" "it hangs"
expect 1 "failed: it fails|too long: it hangs|0 passed, 1 failed, 0 skipped, 1 took too long" "it fails" "it hangs"
printf '' >"$folder/cases"
! "$root/tests/support/run_in_parts.py" "$program" >/dev/null || { echo "FAILED: a program without a case passes"; exit 1; }
