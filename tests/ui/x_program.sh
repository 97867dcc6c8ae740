# The program with settings of its own and a punch open, on the screen that is there; to be sourced by scripts that drive it through X.
# Sets window, pid and work.
start_program() {
  root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
  work=$(mktemp -d)
  export XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state HOME=$work LIBGL_ALWAYS_SOFTWARE=1
  mkdir -p "$work/config/stretch-engine" && echo '{"version": 1}' >"$work/config/stretch-engine/settings.json"
  cp "$root/assets/dummy.glb" "$work/punch.glb"
  "$1" "$work/punch.glb" &
  pid=$!
  window=
  for _ in $(seq 100); do
    window=$(xdotool search --name 'punch.glb' 2>/dev/null | head -n 1)
    [ -n "$window" ] && break
    kill -0 $pid 2>/dev/null || finish 1 "the program ended before its window came up"
    sleep 0.2
  done
  [ -n "$window" ] || finish 1 "no window named after the file"
  xdotool windowfocus "$window"
  sleep 0.5
}
finish() { kill $pid 2>/dev/null; rm -rf "$work"; echo "$2"; exit "$1"; }
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
# Answers whether the program ends by itself within seconds.
await_end() {
  for _ in $(seq 50); do
    kill -0 $pid 2>/dev/null || return 0
    sleep 0.1
  done
  return 1
}
