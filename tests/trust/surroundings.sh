#!/usr/bin/env bash
# surroundings.sh PROGRAM DRIVEN_EDITOR ROOT: the same punch, in batch and in the window, wherever a user may start the program: a locale
# with a comma, names that are no ASCII, no home, a home that cannot be written, windows tiny and huge, no OpenGL 3.3, no screen, no EGL.
# Pictures go to $STRETCH_UI_PICTURES, if it is set.
set -euo pipefail
program=$(realpath "$1") driven=$(realpath "$2") root=$(realpath "$3")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
source="$root/assets/dummy.glb"
export HOME="$work/home" LIBGL_ALWAYS_SOFTWARE=1
unset XDG_CONFIG_HOME XDG_STATE_HOME DISPLAY WAYLAND_DISPLAY LC_ALL LANG LOCPATH
mkdir "$HOME"

fail() {
  echo "FAILED: $1"
  [ ! -e "$work/told" ] || cat "$work/told"
  exit 1
}

# batch FILE OUT [env arguments...]
batch() {
  local file=$1 out=$2
  shift 2
  env "$@" "$program" exaggerate "$file" -o "$out" --limb left-arm --range 21:27 --scale 2.5 --json >"$out.json" 2>"$work/told" || fail "batch in: $*"
}

# window NAME SIZE SCALE FILE [env arguments...]: pictures are kept under the name.
window() {
  local name=$1 size=$2 scale=$3 file=$4 folder="$work/window"
  shift 4
  rm -rf "$folder" && mkdir "$folder"
  cp "$file" "$folder/"
  (cd "$folder" && env "$@" STRETCH_UI_SIZE="$size" STRETCH_UI_SCALE="$scale" "$root/tests/ui/on_screen.sh" 3840x2160 \
    timeout 300 "$driven" "$root/tests/trust/punch.script" "$folder/$(basename "$file")") >"$work/told" 2>&1 || fail "window: $name"
  [ "$(find "$folder" -name '*-stretched.glb' | wc -l)" = 1 ] || fail "window: $name saved nothing"
  [ -z "${STRETCH_UI_PICTURES:-}" ] || {
    mkdir -p "$STRETCH_UI_PICTURES"
    for picture in opened saved; do cp "$folder/$picture.png" "$STRETCH_UI_PICTURES/$name-$picture.png"; done
  }
}

batch "$source" "$work/plain.glb" LC_ALL=C
same() { cmp "$work/plain.glb" "$1" && cmp "$work/plain.glb.json" "$1.json" || fail "$2 makes another file"; }

if localedef -i de_DE -f UTF-8 "$work/de_DE.UTF-8" 2>/dev/null || [ -d "$work/de_DE.UTF-8" ]; then
  batch "$source" "$work/comma.glb" LOCPATH="$work" LC_ALL=de_DE.UTF-8
  same "$work/comma.glb" "a locale with a comma"
  window comma 1280x720 1 "$source" LOCPATH="$work" LC_ALL=de_DE.UTF-8
  echo "a locale with a comma: the same bytes"
else
  echo "a locale with a comma is left out: it cannot be made here"
fi

named="$work/ein Schlag – 拳 é"
mkdir "$named"
cp "$source" "$named/dummy's «Schlag» 拳.glb"
batch "$named/dummy's «Schlag» 拳.glb" "$named/aus gäbe 出.glb" LC_ALL=C
same "$named/aus gäbe 出.glb" "a name with blanks that is no ASCII"
"$program" resave "$named/aus gäbe 出.glb" -o "$named/paar 双.gltf" && "$program" check "$named/paar 双.gltf" >/dev/null || fail "a pair with such a name"
odd="$named/"$'\xff\xfe\n.glb'
cp "$source" "$odd"
"$program" info "$odd" --json >/dev/null 2>"$work/told" || fail "a name that is no UTF-8"
window names 1280x720 1 "$named/dummy's «Schlag» 拳.glb"
echo "names with blanks, beyond ASCII and beyond UTF-8: read and written"

batch "$source" "$work/nohome.glb" -u HOME
same "$work/nohome.glb" "no home"
window no-home 1280x720 1 "$source" -u HOME TMPDIR="$work"
batch "$source" "$work/readonly.glb" HOME=/proc
same "$work/readonly.glb" "a home that cannot be written"
window read-only-home 1280x720 1 "$source" HOME=/proc
grep -q "cannot be written" "$work/told" || fail "nobody is told that settings are not kept"
echo "no home, and one that cannot be written: the window works, and says that settings are not kept"

window tiny 1x1 1 "$source"
window huge 3840x2160 2 "$source"
echo "a window of one pixel's wish, and one of 3840x2160 at twice the size: the punch is saved"

# refused WORDS COMMAND...: the editor ends with one line.
refused() {
  local words=$1 status=0
  shift
  "$@" >"$work/said" 2>"$work/told" || status=$?
  [ "$status" = 1 ] || fail "exit code $status instead of 1: $*"
  [ "$(grep -c . "$work/told")" = 1 ] && grep -q "$words" "$work/told" || fail "not one line about '$words': $*"
}
refused "OpenGL 3.3" env MESA_GL_VERSION_OVERRIDE=2.1 "$root/tests/ui/on_screen.sh" 1280x720 timeout 60 "$program" "$source"
refused "cannot open a window" timeout 60 "$program" "$source"
mkdir "$work/broken" && : >"$work/broken/libEGL.so.1"
refused "libegl1" env LD_LIBRARY_PATH="$work/broken" timeout 60 "$program" render "$source" -o "$work/picture.png"
echo "no OpenGL 3.3, no screen, no EGL: one line, which says what to do"
