#!/usr/bin/env bash
# The program as a user starts it, driven from outside through X: xdotool_smoke.sh PROGRAM
set -u
if [ "${2:-}" != inside ]; then
  exec "$(dirname "$0")/on_screen.sh" 1600x1000 "$0" "$(realpath "$1")" inside
fi
program=$1
root=$(realpath "$(dirname "$0")/../..")
work=$(mktemp -d)
export XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state HOME=$work LIBGL_ALWAYS_SOFTWARE=1
mkdir -p "$work/config/stretch-engine" && echo '{"version": 1}' >"$work/config/stretch-engine/settings.json"
cp "$root/assets/dummy.glb" "$work/punch.glb"
"$program" "$work/punch.glb" &
pid=$!
finish() { kill $pid 2>/dev/null; rm -rf "$work"; echo "$2"; exit "$1"; }

window=
for _ in $(seq 100); do
  window=$(xdotool search --name 'punch.glb' 2>/dev/null | head -n 1)
  [ -n "$window" ] && break
  kill -0 $pid 2>/dev/null || finish 1 "the program ended before its window came up"
  sleep 0.2
done
[ -n "$window" ] || finish 1 "no window named after the file"

title() { xdotool getwindowname "$window"; }
# Answers whether the title comes to start with a dot (yes) or without (no).
until_dot() {
  for _ in $(seq 100); do
    case "$(title)" in
      "●"*) [ "$1" = yes ] && return 0 ;;
      *) [ "$1" = no ] && return 0 ;;
    esac
    sleep 0.1
  done
  return 1
}
xdotool windowfocus "$window"
sleep 0.5
xdotool key --delay 60 1 Home bracketleft e 3 y Return
until_dot yes || finish 1 "typing the punch did not change the file: $(title)"
xdotool key --delay 60 ctrl+z
until_dot no || finish 1 "undo did not take the punch back: $(title)"
xdotool key --delay 60 ctrl+q
for _ in $(seq 50); do
  kill -0 $pid 2>/dev/null || break
  sleep 0.1
done
kill -0 $pid 2>/dev/null && finish 1 "Ctrl+Q did not end the program"
wait $pid || finish 1 "the program ended with an error"
finish 0 "punch, undo and quit through X"
