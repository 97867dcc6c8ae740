#!/usr/bin/env bash
# Runs a command on an X screen of its own: on_screen.sh WIDTHxHEIGHT COMMAND ARGUMENT...
# Each number of a screen has a lock that the server holds for as long as it lives. Neither looking for a free number (as xvfb-run does)
# nor letting the server take one (-displayfd alone) is enough: a server that ends removes the socket of its number, and with it that of
# a server that has taken the same number in that moment.
set -u
size=$1
shift
locks=${TMPDIR:-/tmp}/stretch-engine-screens-$(id -u)
mkdir -p "$locks"
work=$(mktemp -d)
mkfifo "$work/ready"
server=
trap '[ -z "$server" ] || { kill $server 2>/dev/null; wait $server 2>/dev/null; }; rm -rf "$work"' EXIT

# Starts the server on one number; fails where another of ours holds it, or where a foreign server has it.
start() {
  exec 9>"$locks/$1"
  flock --nonblock 9 || return 1
  # Opened for reading and writing, the pipe needs no other end: a server that dies at once leaves nobody waiting.
  exec 8<>"$work/ready"
  Xvfb ":$1" -displayfd 8 -screen 0 "${size}x24" -nolisten tcp -noreset 2>>"$work/log" &
  server=$!
  local answer=
  for _ in {1..120}; do
    if read -r -t 0.5 -u 8 answer; then break; fi
    kill -0 $server 2>/dev/null || break
  done
  exec 8>&-
  # The server's word is not enough: a client of the test's own must reach it.
  [ -n "$answer" ] && DISPLAY=:$1 timeout 30 xdotool getdisplaygeometry >>"$work/log" 2>&1 && return 0
  kill $server 2>/dev/null
  wait $server 2>/dev/null
  server=
  return 1
}

for number in {90..189}; do
  if start "$number"; then
    # The lock is the server's alone: what the command leaves behind must not keep the number.
    exec 9>&-
    DISPLAY=:$number "$@"
    exit $?
  fi
done
echo "no X screen came up:" >&2
cat "$work/log" >&2
exit 1
