#!/usr/bin/env bash
# synchronised.sh PROGRAM ROOT file|folder: what is saved outlives a loss of power. The content of every new file is synchronised
# before the file gets its name, and the folder afterwards, so that the name is on the disk when the program ends. A kill cannot
# show either: it keeps what the system has in memory. So the calls are looked at. Exit code 77 where strace may not trace.
set -euo pipefail
program=$1 root=$2 what=$3
if ! strace -o /dev/null true 2>/dev/null; then
  echo "left out: strace is missing or may not trace here"
  exit 77
fi
work=$(cd "$(mktemp -d)" && pwd -P)
trap 'rm -rf "$work"' EXIT
mkdir "$work/out"

# The calls of one save, each with the path that its file has: "sync PATH" and "name FROM TO".
calls() {
  strace -f -y -s 4096 -o "$work/trace" -e trace=fsync,fdatasync,rename,renameat,renameat2 "$program" exaggerate \
    "$root/assets/dummy.glb" -o "$1" --limb left-arm --scale 2 --in-place >/dev/null 2>&1
  sed -nE -e 's/^.*f(data)?sync\([0-9]+<([^>]*)>\) += 0$/sync \2/p' \
    -e 's/^.*rename(at2?)?\(([^"]*)"([^"]*)", ([^"]*)"([^"]*)".*\) += 0$/name \3 \5/p' "$work/trace" |
    sed "s|$work/||g"
}

for name in new.glb new.gltf new.glb new.gltf; do # the second time over files that are there
  calls "$work/out/$name" >"$work/calls"
  grep -q '^name ' "$work/calls" || { echo "FAILED: $name got its name by no call that is known"; cat "$work/trace"; exit 1; }
  while read -r call from to; do
    [ "$call" = name ] || continue
    before=$(sed "\\|^name $from $to\$|q" "$work/calls")
    after=$(sed "0,\\|^name $from $to\$|d" "$work/calls")
    if [ "$what" = file ] && ! grep -qxF "sync $from" <<<"$before"; then
      echo "FAILED: $to was not synchronised before it got its name"
      cat "$work/calls"
      exit 1
    fi
    if [ "$what" = folder ] && ! grep -qxF "sync $(dirname "$to")" <<<"$after"; then
      echo "FAILED: the folder of $to was not synchronised after it got its name"
      cat "$work/calls"
      exit 1
    fi
  done <"$work/calls"
done
echo "every $what is synchronised"
