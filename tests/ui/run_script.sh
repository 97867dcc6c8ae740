#!/usr/bin/env bash
# Drives the real window through a script, on a screen of its own: run_script.sh DRIVEN_EDITOR SCRIPT
# Lines of the script set it up: "#! file PATH" (from the root of the sources), "#! size 1280x720", "#! scale 2", "#! screen 1280x720",
# "#! first start" (the tour is shown), "#! beside PATH" (another file in the folder of the first),
# "#! sequence NAME" (a folder of frames made by the program make-sequence, opened instead of a file),
# "#! creature NAME" (a file of that name made by the program make-creature, opened instead of a file),
# "#! statue NAME.gltf" (a person without a skeleton made by the program make-statue, opened instead of a file),
# "#! plays as RECIPE" (what was saved beside the file plays as the recipe makes it in batch, within 1e-5 of the picture's size),
# "#! looks like PATH" (the picture that it takes under that name is the one of the sources, but for one pixel in two hundred),
# "#! then OTHER.script" (started afterwards with the same user folder). Pictures go to $STRETCH_UI_PICTURES, if it is set.
set -u
program=$(realpath "$1")
script=$(realpath "$2")
root=$(realpath "$(dirname "$0")/../..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state HOME=$work LIBGL_ALWAYS_SOFTWARE=1

setting() { sed -n "s/^#! $1 //p" "$2" | head -n 1; }

run() {
  local file beside size scale screen sequence creature statue first
  file=$(setting file "$1")
  size=$(setting size "$1")
  scale=$(setting scale "$1")
  first=$(setting first "$1")
  screen=$(setting screen "$1")
  # The copy is opened, so that saving beside it leaves the sources alone.
  if [ -n "$file" ] && [ ! -e "$work/$(basename "$file")" ]; then
    cp "$root/$file" "$work/" || return 1
  fi
  beside=$(setting beside "$1")
  [ -z "$beside" ] || cp "$root/$beside" "$work/" || return 1
  sequence=$(setting sequence "$1")
  if [ -n "$sequence" ]; then
    "$(dirname "$program")/make-sequence" "$work/$sequence" || return 1
    file=$sequence
  fi
  creature=$(setting creature "$1")
  if [ -n "$creature" ]; then
    file=$creature.glb
    [ -e "$work/$file" ] || "$(dirname "$program")/make-creature" "$creature" "$work/$file" || return 1
  fi
  statue=$(setting statue "$1")
  if [ -n "$statue" ]; then
    [ -e "$work/$statue" ] || "$(dirname "$program")/make-statue" "$work/$statue" || return 1
    file=$statue
  fi
  (cd "$work" && STRETCH_UI_SIZE=${size:-1280x720} STRETCH_UI_SCALE=${scale:-1} STRETCH_UI_FIRST=${first:-} \
    "$root/tests/ui/on_screen.sh" "${screen:-2560x1440}" timeout 300 "$program" "$1" ${file:+"$work/$(basename "$file")"})
}

# keys_of FILE: those that its first clip plays.
keys_of() {
  python3 -B - "$1" <<'END'
import json, struct, sys
data = open(sys.argv[1], "rb").read()
file = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])
clip = file["animations"][0]
print(sum(file["accessors"][clip["samplers"][channel["sampler"]]["input"]]["count"] for channel in clip["channels"]))
END
}

# What the window saved against what batch makes of the same file.
compare() {
  local recipe file engine largest saved
  recipe=$(setting 'plays as' "$1")
  [ -n "$recipe" ] || return 0
  file=$(setting file "$1")
  engine=$(dirname "$program")/../stretch-engine
  saved=$work/$(basename "$file" .glb)-stretched.glb
  "$engine" exaggerate "$root/$file" -o "$work/batch.glb" --clean --recipe "$root/$recipe" --key-frames clip >"$work/batch.txt" || return 1
  # The frames alone are compared below: what stands between them is told by the number of keys.
  [ -n "$(keys_of "$saved")" ] && [ "$(keys_of "$saved")" = "$(keys_of "$work/batch.glb")" ] ||
    { echo "the window wrote $(keys_of "$saved") keys, batch $(keys_of "$work/batch.glb")"; return 1; }
  largest=$("$engine" compare "$work/batch.glb" "$saved" --json |
    sed -n 's/.*"largest_percent": \([^,]*\),*/\1/p')
  echo "against $recipe in batch: at most $largest % apart"
  awk -v largest="${largest:-1}" 'BEGIN { exit !(largest + 0 <= 1e-3) }'
}

# A picture that the pages show against what is there now.
looks_alike() {
  local kept
  kept=$(setting 'looks like' "$1")
  [ -n "$kept" ] || return 0
  python3 -B "$root/docs/pictures/differs.py" "$root/$kept" "$work/$(basename "$kept")" && return 0
  echo "$kept is older than what it shows: docs/pictures/make takes it anew"
  return 1
}

status=0
first=$script
while [ -n "$script" ] && [ $status -eq 0 ]; do
  run "$script" || status=$?
  next=$(setting then "$script")
  script=${next:+$(dirname "$script")/$next}
done
[ $status -ne 0 ] || compare "$first" || status=$?
# Where pictures are kept, they are being made.
[ $status -ne 0 ] || [ -n "${STRETCH_UI_PICTURES:-}" ] || looks_alike "$first" || status=$?
if [ $status -ne 0 ] && [ -e "$work/monkey.script" ]; then
  echo "What the monkey did, as a script that does it again:" >&2
  cat "$work/monkey.script" >&2
fi
if [ -n "${STRETCH_UI_PICTURES:-}" ]; then
  mkdir -p "$STRETCH_UI_PICTURES" && cp "$work"/*.png "$STRETCH_UI_PICTURES/" 2>/dev/null
fi
exit $status
