#!/usr/bin/env bash
# Shortcuts by the letters of the keyboard's layout, which changes while the program runs, driven from outside through X by the keys' places:
# xdotool_layouts.sh PROGRAM [FOLDER FOR PICTURES]
set -u
if [ "${2:-}" != inside ]; then
  exec "$(dirname "$0")/on_screen.sh" 1600x1000 "$0" "$(realpath "$1")" inside "${2:-}"
fi
program=$1
pictures=${3:-}
source "$(dirname "$0")/x_program.sh"
start_program "$program"

# X's codes of places: the ones that a US keyboard labels Z, W, Y and so on.
place_z=52 place_w=25 place_y=29 place_slash=61 place_a=38 place_q=24
press() { xdotool key --delay 60 "$@"; }

press 1 Home bracketleft e 3 y Return
until_dot yes || finish 1 "typing the punch did not change the file: $(title)"
for undo in fr:$place_w de:$place_y dvorak:$place_slash ru:$place_z us:$place_z; do
  layout=${undo%:*} place=${undo#*:}
  setxkbmap "$layout" || finish 1 "there is no layout $layout"
  sleep 1
  press "ctrl+$place"
  until_dot no || finish 1 "$layout: the key that prints z did not undo: $(title)"
  press "ctrl+shift+$place"
  until_dot yes || finish 1 "$layout: the key that prints z did not redo with Shift: $(title)"
  if [ -n "$pictures" ]; then
    xdotool mousemove 85 12 click 1 && sleep 1 && import -window root "$pictures/menu_$layout.png"
    press Escape && sleep 0.5
  fi
done
setxkbmap fr
sleep 1
press "ctrl+$place_w"
until_dot no || finish 1 "undo did not take the punch back: $(title)"
press "ctrl+$place_q"
sleep 1
kill -0 $pid 2>/dev/null || finish 1 "fr: the key that prints a ended the program"
press "ctrl+$place_a"
await_end || finish 1 "fr: Ctrl with the key that prints q did not end the program"
finish 0 "undo, redo and quit on five layouts"
