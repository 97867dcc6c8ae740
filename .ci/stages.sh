# Sourced by .ci/run: stages that share the seconds there are, each with a share of its own, so that none starves another.
#   stage SHARE NAME COMMAND   queues a command (a function); SHARE is how many seconds it wants. With `only` set, those alone that have
#                              it in their name
#   begin_with N               the Nth of them, counted from 0, is the first to run; those before it follow the last
#   run_stages SECONDS         runs them in their order, within so many seconds of the script's beginning, or `unlimited`
#   counts_of LOG              adds the counts in the last line of a log to ours
#   told_at_last               what was left out, then the counts
# A stage has its share as long as there are seconds for it; what all that fit leave over is shared out by their shares, again after
# each. The last to run may have less, and one that would get less than a third of its share is left out.
# A command finds how long it has in `left`, runs what takes long by `within`, and says how far it came by `tell`. It ends with 0,
# with 77 where something that it needs is missing, with 75 where its seconds were up before its work was done.
passed=0 failed=0 skipped=0
names=() shares=() commands=() left_out=()
deadline=0 told=""

stage() {
  [[ "$2" == *"${only:-}"* ]] || return 0
  shares+=("$1") names+=("$2") commands+=("$3")
}

left() {
  echo $((deadline > SECONDS ? deadline - SECONDS : 0))
}

tell() {
  told=$1
}

# within COMMAND...: 75 where the stage's seconds were up.
within() {
  local status=0
  timeout --kill-after=10 "$(($(left) + 1))" "$@" || status=$?
  case $status in 124 | 137) return 75 ;; esac
  return "$status"
}

skip() {
  skipped=$((skipped + 1))
  left_out+=("left out: $1")
}

run_stage() {
  local name=$1 granted=$2 began=$SECONDS status=0
  deadline=$((SECONDS + granted)) told=""
  echo "$name: at most $granted s"
  "$3" || status=$?
  local seconds="$((SECONDS - began)) s${told:+: $told}"
  case $status in
    0) passed=$((passed + 1)); echo "passed: $name, $seconds" ;;
    75) skip "$name, in part: its share of $granted s was up${told:+: $told}" ;;
    77) skip "$name${told:+: $told}" ;;
    *) failed=$((failed + 1)); echo "FAILED: $name, $seconds" ;;
  esac
}

begin_with() {
  shares=("${shares[@]:$1}" "${shares[@]:0:$1}") names=("${names[@]:$1}" "${names[@]:0:$1}")
  commands=("${commands[@]:$1}" "${commands[@]:0:$1}")
}

# granted_of I TOTAL: the seconds for the Ith stage: its part of what is left beside those of the following that fit.
granted_of() {
  local seconds_left=$(($2 > SECONDS ? $2 - SECONDS : 0)) wanted=${shares[$1]} share
  for share in "${shares[@]:$1 + 1}"; do
    [ $((wanted + share)) -gt "$seconds_left" ] || wanted=$((wanted + share))
  done
  echo $((seconds_left * shares[$1] / wanted))
}

run_stages() {
  local i granted=86400
  for i in "${!names[@]}"; do
    [ "$1" = unlimited ] || granted=$(granted_of "$i" "$1")
    if [ $((granted * 3)) -lt "${shares[i]}" ]; then
      skip "${names[i]}: $granted s were left of the ${shares[i]} s that it wants"
    else
      run_stage "${names[i]}" "$granted" "${commands[i]}"
    fi
  done
}

counts_of() {
  local counts
  counts=$(tail -n 1 "$1" | sed -nE 's/^([0-9]+) passed, ([0-9]+) failed, ([0-9]+) skipped$/\1 \2 \3/p')
  if [ -z "$counts" ]; then
    failed=$((failed + 1))
    return
  fi
  # shellcheck disable=SC2086
  set -- $counts
  passed=$((passed + $1)) failed=$((failed + $2)) skipped=$((skipped + $3))
}

told_at_last() {
  [ "${#left_out[@]}" -eq 0 ] || printf '%s\n' "${left_out[@]}"
  echo "$passed passed, $failed failed, $skipped skipped"
  [ "$failed" -eq 0 ]
}
