#!/usr/bin/env bash
# The program as a user starts it, driven from outside through X: xdotool_smoke.sh PROGRAM
set -u
if [ "${2:-}" != inside ]; then
  exec "$(dirname "$0")/on_screen.sh" 1600x1000 "$0" "$(realpath "$1")" inside
fi
source "$(dirname "$0")/x_program.sh"
start_program "$1"
for _ in $(seq 100); do grep -q 'punch.glb' "$work/config/stretch-engine/settings.json" && break; sleep 0.1; done
grep -q 'punch.glb' "$work/config/stretch-engine/settings.json" || finish 1 "the file is not among the recent ones until the program ends"
xdotool key --delay 60 1 Home bracketleft e 3 y Return
until_dot yes || finish 1 "typing the punch did not change the file: $(title)"
xdotool key --delay 60 ctrl+z
until_dot no || finish 1 "undo did not take the punch back: $(title)"
xdotool key --delay 60 ctrl+q
await_end || finish 1 "Ctrl+Q did not end the program"
wait $pid || finish 1 "the program ended with an error"
finish 0 "punch, undo and quit through X"
