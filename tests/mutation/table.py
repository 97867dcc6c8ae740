"""The table of what lives, by room, and whether the goals are kept."""

GOALS = {"core": 90, "rig": 90, "skinning": 90, "app": 90, "ui": 80}


def score(mutants, results, equivalent):
    """(killed, tried, equivalent ones) of some mutants."""
    same = [one for one in mutants if one.key in equivalent]
    tried = [one for one in mutants if one.key not in equivalent and results[one.number][0] != "untried"]
    return sum(results[one.number][0] == "killed" for one in tried), len(tried), len(same)


def told(mutants, results, equivalent, refused):
    """Prints the living with their sentences and the score of each room; 1 where a goal is missed, else 0."""
    missed = False
    for one in refused:
        print(f"does not compile: {one.file}: {one.line}  =>  {one.becomes}")
    for room in GOALS:
        own = [one for one in mutants if one.room == room]
        for one in own:
            outcome, detail = results[one.number]
            if one.key in equivalent or outcome in ("killed", "untried"):
                continue
            print(f"\n{one.file}  [{one.number}, {one.operator}, {outcome}{', ' + detail if detail else ''}]")
            print(f"  is:      {one.line}")
            print(f"  becomes: {one.becomes or '(nothing)'}")
            if one.says:
                print(f"  {one.says}")
    print(f"\n{'room':10} {'drawn':>12} {'written':>12} {'together':>12} {'':6} {'equivalent':>10}")
    for room, goal in GOALS.items():
        own = [one for one in mutants if one.room == room]
        drawn = score([one for one in own if one.operator != "written"], results, equivalent)
        written = score([one for one in own if one.operator == "written"], results, equivalent)
        killed, tried = drawn[0] + written[0], drawn[1] + written[1]
        if not tried:
            continue
        percent = 100 * killed / tried
        missed = missed or percent < goal
        columns = [f"{part[0]} of {part[1]}" for part in (drawn, written)]
        print(f"{room:10} {columns[0]:>12} {columns[1]:>12} {f'{killed} of {tried}':>12} {percent:5.0f}% {drawn[2] + written[2]:>10}")
    return 1 if missed else 0
