#!/usr/bin/env bash
# manual.sh PROGRAM FOLDER: writes the manual pages of the program and of each verb, made from --help, packed.
set -euo pipefail
program=$1 folder=$2
rm -rf "$folder"
mkdir -p "$folder"

# page NAME WORDS SENTENCE
page() {
  help2man --no-info --no-discard-stderr --name "$3" --help-option "$2 --help" --version-string "$version" "$program" |
    sed -e "s/^\.TH [^ ]*/.TH ${1^^}/" -e "s/^stretch-engine \\\\-/$1 \\\\-/" >"$folder/$1.1"
  gzip -9n "$folder/$1.1"
}

version=$("$program" --version | cut -d ' ' -f 2)
page stretch-engine "" "make a realistic clip hit like a cartoon"
"$program" --help | sed -nE '/^Subcommands:/,$s/^  ([a-z][a-z-]*) +(.*)\.$/\1\t\2/p' | while IFS=$'\t' read -r verb sentence; do
  page "stretch-engine-$verb" "$verb" "$sentence"
done
