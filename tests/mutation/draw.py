"""Draws lines of the product by chance and a fault for each: so that nobody chooses kindly."""

import hashlib

import operators
from mutants import Mutant


def chance(*words):
    """A number that only the words decide: what is drawn stays the same where other lines change."""
    return hashlib.sha256("|".join(str(word) for word in words).encode()).digest()


def drawn(tree, seed, room, count, without=(), under=()):
    """Mutants of a room, count of them where it has that many lines. Every line that holds code is as likely as any other; under: only
    lines of files whose path begins with one of these, where any is given."""
    lines = []
    for file in tree.files(room):
        if under and not file.startswith(tuple(under)):
            continue
        seen = {}
        for number, line in enumerate(tree.source(file).lines()):
            text = line.strip()
            if not text:
                continue
            seen[text] = seen.get(text, 0) + 1
            lines.append((chance(seed, file.rsplit("/", 1)[1], text, seen[text]), file, number, seen[text]))
    lines.sort()
    mutants = []
    for _, file, number, nth in lines:
        if len(mutants) == count:
            break
        mutant = mutated(tree, seed, file, number, nth)
        if mutant and mutant.key not in without:
            mutants.append(mutant)
    return mutants


def mutated(tree, seed, file, number, nth):
    """A fault of that line: first the operator is drawn, then its place. None where no operator applies."""
    source = tree.source(file)
    text = source.lines()[number].strip()
    found = operators.candidates(source, number)
    if not found:
        return None
    kinds = sorted({name for name, *_ in found})
    kind = min(kinds, key=lambda name: chance(seed, file.rsplit("/", 1)[1], text, nth, name))
    places = [one for one in found if one[0] == kind]
    _, begin, end, replaced = min(places, key=lambda one: chance(seed, text, nth, one[1:]))
    start, stop = source.line_span(number)
    gone = replaced is None
    becomes = "" if gone else source.text[start:begin] + replaced + source.text[end : max(end, stop)]
    return Mutant(file, text, " ".join(becomes.split()), "", kind, nth, begin, end, "" if gone else replaced)
