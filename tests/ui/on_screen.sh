#!/usr/bin/env bash
# Runs a command on an X screen of its own: on_screen.sh WIDTHxHEIGHT COMMAND ARGUMENT...
# The server itself takes a free number and says which (-displayfd). A script that looks for a free number first, as xvfb-run does,
# gives two tests that start at the same moment the same one now and then.
set -u
size=$1
shift
work=$(mktemp -d)
mkfifo "$work/number"
Xvfb -displayfd 3 -screen 0 "${size}x24" -nolisten tcp 3>"$work/number" 2>"$work/log" &
server=$!
trap 'kill $server 2>/dev/null; wait $server 2>/dev/null; rm -rf "$work"' EXIT
if ! read -r -t 60 number <"$work/number"; then
  echo "no X screen came up:" >&2
  cat "$work/log" >&2
  exit 1
fi
DISPLAY=:$number "$@"
