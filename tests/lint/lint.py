#!/usr/bin/env python3
"""Checks one rule of the house over the sources.

    lint.py RULE [ROOT]     exit 0: kept, 1: broken (one line for each finding), 77: cannot be checked here
    lint.py --list          names of the rules
"""

import pathlib
import sys

import comment_rules
import format_rule
import function_rule
import include_rules
import pointer_rules
import shape_rules
import size_rules
import text_rules

RULES = {
    "include-direction": include_rules.include_direction,
    "room-layers": include_rules.room_layers,
    "include-circles": include_rules.include_circles,
    "library-place": include_rules.library_place,
    "file-size": text_rules.file_size,
    "function-size": function_rule.function_size,
    "open-ends": text_rules.open_ends,
    "distributive": text_rules.distributive,
    "machine-paths": text_rules.machine_paths,
    "pointers": pointer_rules.pointers,
    "test-names": text_rules.test_names,
    "pragma-once": text_rules.pragma_once,
    "clocks-and-chance": text_rules.clocks_and_chance,
    "formatting": format_rule.formatting,
    "folder-size": size_rules.folder_size,
    "product-lines": size_rules.product_lines,
    "readme-words": size_rules.readme_words,
    "rooms-named": size_rules.rooms_named,
    "struct-members": shape_rules.struct_members,
    "parameters": shape_rules.parameter_count,
    "kind-switches": shape_rules.kind_switches,
    "settings-json": shape_rules.settings_json,
    "same-bodies": shape_rules.same_bodies,
    "comment-openings": comment_rules.comment_openings,
}
SKIPPED = 77


def main(arguments):
    if arguments == ["--list"]:
        print("\n".join(RULES))
        return 0
    if not 1 <= len(arguments) <= 2 or arguments[0] not in RULES:
        print(f"usage: lint.py RULE [ROOT], RULE one of {', '.join(RULES)}", file=sys.stderr)
        return 2
    root = pathlib.Path(arguments[1] if len(arguments) == 2 else pathlib.Path(__file__).parents[2])
    try:
        findings = RULES[arguments[0]](root)
    except format_rule.Unavailable as reason:
        print(f"skipped: {reason}")
        return SKIPPED
    for finding in findings:
        print(finding)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
