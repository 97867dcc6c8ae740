"""The poses that an animator asks of a character first, and what has to hold of each, measured by three.js.

Each maker answers a Case, or None where the character lacks what it takes.
"""

import dataclasses
import math
import typing

from posed_character import ZERO
from vectors import across, add, angle, cross, dot, place, rotated, scaled, seen_from, skew, sub, turn_between, turn_miss, unit

TOLERANCE = 1e-4  # of the height
TURN_TOLERANCE = 1e-3  # radians
LEAST_ELBOW = math.radians(12)  # between the bones: below, it is collapsed
SPIKE = 1.5
SEEN_SPIKE = 3e-3  # of the height: less is not seen
CARRIED_OVER = math.radians(150)  # docs/controllers.md, Arms and legs: a line that turns farther carries its bend over otherwise


@dataclasses.dataclass
class Case:
    name: str
    adjustments: list
    check: typing.Callable  # of the posed file: what is wrong with it
    lists: dict = dataclasses.field(default_factory=dict)


class Measured:
    """Source and posed file at some frames: of each bone its world matrices."""

    def __init__(self, character, output, frames):
        self.character, self.frames = character, frames
        self.before, self.after = character.source(frames), character.worlds(output, character.bones, frames)

    def strays(self, name, frames=None):
        """A controller's joint that is to stay where the source has it."""
        node = self.character.joints.get(name)
        if node is None or node not in self.before:
            return []
        miss = max(math.dist(place(a), place(b)) for a, b in zip(self.before[node], self.after[node])) / self.character.height
        return [f"{name} strays by {miss:.2e} of the height"] if miss > TOLERANCE else []

    def misses(self, name, target):
        """Of its target, at the first frame."""
        node = self.character.joints.get(name)
        if node is None:
            return []
        miss = math.dist(place(self.after[node][0]), target) / self.character.height
        return [f"{name} misses by {miss:.2e} of the height"] if miss > TOLERANCE else []

    def misturned(self, name, rotation_vector):
        """Of its turn, at the first frame."""
        node = self.character.joints.get(name)
        if node not in self.before or not self.character.controllers[name]["turns"] or self.sheared(node):
            return []
        miss = turn_miss(self.before[node][0], rotation_vector, self.after[node][0])
        return [f"{name} is turned {math.degrees(miss):.2g} degrees off"] if miss > TURN_TOLERANCE else []

    def sheared(self, node):
        """Whether joints that are scaled unevenly skew it, so that its axes do not tell how it is turned."""
        return max(skew(file[node][0]) for file in (self.before, self.after)) > TURN_TOLERANCE

    def rides(self, carrier, name):
        """Keeps its place on what carries it."""
        node, on = self.character.joints.get(name), self.character.joints.get(carrier)
        if node is None or on is None:
            return []
        seen = [seen_from(file[on][0], place(file[node][0])) for file in (self.before, self.after)]
        miss = math.dist(*seen) / self.character.height
        return [f"{name} does not ride on {carrier}: {miss:.2e} of the height"] if miss > TOLERANCE else []

    def bones_of(self, limb, index):
        points = [[place(file[node][index]) for node in self.character.limbs[limb]] for file in (self.before, self.after)]
        return [[math.dist(a, b) for a, b in zip(own, own[1:])] for own in points]

    def unevenly_stretched(self, limb):
        """The bones of an arm or leg are scaled by one factor."""
        before, after = self.bones_of(limb, 0)
        factors = [b / a for a, b in zip(before, after)]
        return [f"the bones of {limb} are scaled by {factors}"] if max(factors) - min(factors) > 1e-3 * max(factors) else []


def feet(measured):
    return measured.strays("left-foot") + measured.strays("right-foot")


def hips_lowered(character, folder):
    if "hips" not in character.controllers:
        return None
    down = {"controller": "hips", "keys": character.rising(move=[0, -0.1 * character.height, 0])}

    def check(output):
        return feet(Measured(character, output, character.all_frames()))

    return Case("hips lowered", [down], check, {"units": "metres"})


def spine_bent(name, towards):
    """The tip of the spine on the arc of 45 degrees that its chord makes when it bends towards a side; the chest turned with it."""

    def maker(character, folder):
        if "spine-top" not in character.controllers:
            return None
        stands, axes = character.space(folder, "spine-top")
        base = place(character.source([character.full])[character.limbs["spine"][0]][0])
        bend = math.radians(45)
        left, up, forward = character.facing()
        turn = scaled(cross(up, forward if towards == "forward" else left), bend)
        chord = scaled(rotated(scaled(turn, 0.5), sub(stands, base)), math.sin(bend / 2) / (bend / 2))
        target = add(base, chord)
        bulge = scaled(cross(unit(turn), unit(chord)), -math.dist(stands, base) * (1 - math.cos(bend / 2)) / bend)
        adjustments = [{"controller": "spine-top", "keys": character.rising(move=character.along(axes, sub(target, stands)),
                                                                            turn=[math.degrees(x) for x in character.along(axes, turn)])},
                       {"controller": "spine-mid", "keys": character.rising(move=character.along(axes, bulge))}]

        def check(output):
            full = Measured(character, output, [character.full])
            problems = feet(Measured(character, output, character.all_frames())) + full.misturned("spine-top", turn)
            problems += full.misses("spine-top", target)
            for riding in ("head", "left-hand", "right-hand"):
                problems += full.rides("spine-top", riding)
            return problems

        return Case(name, adjustments, check, {"units": "metres"})

    return maker


def head_turned(character, folder):
    if "head" not in character.controllers or "spine" not in character.limbs:
        return None
    _, axes = character.space(folder, "head")
    turn = scaled([0, 1, 0], math.radians(60))
    turned = {"controller": "head", "keys": character.rising(turn=[math.degrees(x) for x in character.along(axes, turn)])}

    def check(output):
        full = Measured(character, output, [character.full])
        return full.misturned("head", turn) + full.strays("head") + full.strays("left-hand")

    return Case("head turned", [turned], check)


def hand_on_shoulder(character, folder):
    if not {"left-arm", "right-arm"} <= set(character.limbs) or "left-hand" not in character.controllers:
        return None
    stands, axes = character.space(folder, "left-hand")
    left, up, forward = character.facing()
    shoulder = place(character.source([character.full])[character.limbs["right-arm"][0]][0])
    target = add(shoulder, scaled(forward, 0.07 * character.height))
    moved = {"controller": "left-hand", "keys": character.rising(move=character.along(axes, sub(target, stands)))}

    def check(output):
        full = Measured(character, output, [character.full])
        problems = full.misses("left-hand", target)
        if "left-arm" in character.whole:
            problems += full.unevenly_stretched("left-arm")
            joints = character.limbs["left-arm"]
            points = [place(full.after[node][0]) for node in joints]
            if len(points) == 3 and angle(sub(points[0], points[1]), sub(points[2], points[1])) < LEAST_ELBOW:
                problems.append("the elbow is collapsed")
        return problems

    return Case("hand on the other shoulder", [moved], check, {"units": "metres"})


def bend_of(measured, limb, index=0, file="after"):
    """Which way a limb of two bones bends, across its line, and how far; nothing for others."""
    points = [place(getattr(measured, file)[node][index]) for node in measured.character.limbs[limb]]
    return across(sub(points[1], points[0]), unit(sub(points[-1], points[0])))


def turned_by_pole(limb, pole, end):
    def maker(character, folder):
        if pole not in character.controllers or limb not in character.whole or len(character.limbs[limb]) != 3:
            return None
        left, _, _ = character.facing()
        outwards = left if limb.startswith("left") else scaled(left, -1)
        reach = 2 * sum(joint["rest_length"] for joint in character.info["limbs"] if joint["limb"] == limb)

        # One that points against the bend would turn the limb over by way of no direction at all, one along it would do nothing.
        def posed(move):
            adjustment = {"controller": pole, "keys": character.rising(move=move)}
            output, _ = character.pose(folder, [adjustment], units="metres")
            full = Measured(character, output, [character.full])
            bend, source = unit(bend_of(full, limb)), unit(bend_of(full, limb, file="before"))
            turned = angle(bend, source)
            return dot(bend, outwards) - (0 if math.radians(20) < turned < math.radians(135) else 10)

        moves = [[sign * reach if axis == i else 0 for i in range(3)] for axis in range(3) for sign in (-1, 1)]
        best = max(moves, key=posed)

        def check(output):
            full = Measured(character, output, [character.full])
            problems = Measured(character, output, character.all_frames()).strays(end) + full.misturned(end, ZERO)
            before, after = full.bones_of(limb, 0)
            if max(abs(a - b) for a, b in zip(before, after)) > TOLERANCE * character.height:
                problems.append(f"the pole stretches {limb}")
            bend, source = bend_of(full, limb), bend_of(full, limb, file="before")
            if math.hypot(*bend) > 0.01 * character.height and angle(bend, source) < math.radians(20):
                problems.append(f"{pole} does not turn {limb}")
            return problems

        return Case(f"{pole} turned out", [{"controller": pole, "keys": character.rising(move=best)}], check, {"units": "metres"})

    return maker


def fists(character, folder):
    hands = [hand for hand in ("left-hand", "right-hand") if f"{hand}.curl" in character.attributes]
    adjustments = [{"attribute": f"{hand}.curl", "keys": character.rising(value=1)} for hand in hands]
    if not hands:
        return None

    def check(output):
        problems = []
        for hand in hands:
            joint = character.joints.get(hand)
            for chain in character.fingers(joint) if joint is not None else []:
                before, after = character.source([character.full])[joint][0], character.worlds(output, [joint] + chain, [character.full])
                source = character.worlds(character.file, chain, [character.full])
                reach = [math.dist(place(worlds[chain[-1]][0]), place(worlds[chain[0]][0])) for worlds in (source, after)]
                name = character.gltf["nodes"][chain[0]].get("name", chain[0])
                if reach[1] > 0.8 * sum(math.dist(place(source[a][0]), place(source[b][0])) for a, b in zip(chain, chain[1:])):
                    problems.append(f"{name} of {hand} does not close: {reach[0]:.3g} to {reach[1]:.3g}")
                if math.dist(place(before), place(after[joint][0])) > TOLERANCE * character.height:
                    problems.append(f"a fist moves {hand}")
        return problems

    return Case("fists", adjustments, check)


def rolled(value, degrees, name):
    def maker(character, folder):
        if "left-foot.roll" not in character.attributes:
            return None
        adjustments = [{"attribute": f"{foot}.roll", "keys": character.rising(value=value)} for foot in ("left-foot", "right-foot")]

        def check(output):
            full = Measured(character, output, [character.full])
            foot = character.joints["left-foot"]
            problems = []
            if full.sheared(foot):
                return []
            turned = math.degrees(turn_between(full.before[foot][0], full.after[foot][0]))
            if abs(turned - degrees) > 0.1:
                problems.append(f"the foot rolls by {turned:.3g} instead of {degrees} degrees")
            toes = [child for child in character.gltf["nodes"][foot].get("children", []) if child in full.before]
            if value > 0 and len(toes) == 1:
                seen = [worlds[toes[0]][0] for worlds in (full.before, full.after)]
                if math.dist(place(seen[0]), place(seen[1])) > TOLERANCE * character.height or turn_between(*seen) > TURN_TOLERANCE:
                    problems.append("the toes do not stay on the floor")
            return problems

        return Case(name, adjustments, check)

    return maker


def turned_alone(controller, rotation_vector):
    def maker(character, folder):
        if not character.controllers.get(controller, {"turns": False})["turns"]:
            return None
        axes = character.space(folder, controller)[1]
        turn = scaled(rotation_vector, math.pi / 180)
        keys = character.rising(turn=[math.degrees(x) for x in character.along(axes, turn)])

        def check(output):
            full = Measured(character, output, [character.full])
            problems = full.misturned("hips" if controller == "body" else controller, turn)
            problems += [] if controller == "body" else full.strays(controller)
            return problems + (feet(full) if controller in ("hips", "spine-top") else [])

        return Case(f"{controller} turned", [{"controller": controller, "keys": keys}], check)

    return maker


def spine_middle(character, folder):
    if "spine-mid" not in character.controllers:
        return None
    moved = {"controller": "spine-mid", "keys": character.rising(move=[0.05 * character.height, 0, 0])}

    def check(output):
        full = Measured(character, output, [character.full])
        return full.strays("spine-low") + full.strays("spine-top") + full.strays("left-hand") + feet(full)

    return Case("middle of the spine moved", [moved], check, {"units": "metres"})


CASES = [hips_lowered, spine_bent("spine bent forward", "forward"), spine_bent("spine bent sideways", "sideways"), head_turned, hand_on_shoulder,
         turned_by_pole("left-leg", "left-knee", "left-foot"), turned_by_pole("right-arm", "right-elbow", "right-hand"), fists,
         rolled(1, 60, "feet rolled onto the balls"), rolled(-1, 40, "feet rolled onto the heels"), spine_middle,
         turned_alone("body", [0, 50, 0]), turned_alone("hips", [0, 20, 10]), turned_alone("spine-top", [0, 40, 0]),
         turned_alone("left-hand", [0, 0, 30]), turned_alone("right-foot", [0, 30, 0])]


def line_turn(character, limb, before, after, index):
    """By how much the line of a limb from base to end is turned."""
    joints = character.limbs[limb]
    return angle(*(sub(place(file[joints[-1]][index]), place(file[joints[0]][index])) for file in (before, after)))


def folded(character, limb, worlds):
    """The knee or elbow of a limb that comes close to its base somewhere: which way the limb points turns as fast as one likes there."""
    joints = character.limbs[limb]
    rest = next(each["rest_length"] for each in character.info["limbs"] if each["limb"] == limb)
    nearest = min(math.dist(place(a), place(b)) for a, b in zip(worlds[joints[0]], worlds[joints[-1]]))
    return joints[1:-1] if nearest < 0.35 * rest else []


def straight(character, limb, worlds, index):
    """The knee or elbow of a limb that is straight at a frame: what brings its ends nearer bends it by the square root of that, at once."""
    points = [place(worlds[joint][index]) for joint in character.limbs[limb]]
    length = sum(math.dist(a, b) for a, b in zip(points, points[1:]))
    return character.limbs[limb][1:-1] if math.dist(points[0], points[-1]) > 0.995 * length else []


def accelerations(path):
    return [math.dist(add(a, c), scaled(b, 2)) for a, b, c in zip(path, path[1:], path[2:])]


def spikes(character, output):
    """Joints that accelerate by more than 1.5 times what the source and the offset together do, where they do most around that frame: the
    offset counts along axes that turn with the body, which the ends of the limbs tell. Knees and elbows count where the source bends them."""
    frames = list(range(character.last + 1))
    if character.last < 4:
        return []
    before, after = character.source(frames), character.worlds(output, character.bones, frames)
    turned_over = [limb for limb in character.limbs if any(line_turn(character, limb, before, after, i) > CARRIED_OVER for i in frames)]
    if turned_over:
        return []
    paths = {node: [[place(matrix) for matrix in file[node]] for file in (before, after)] for node in character.bones}
    own = [max(each) for each in zip(*(accelerations(source) for source, _ in paths.values()))]
    moved = max(math.dist(a, b) for source, posed in paths.values() for a, b in zip(source, posed))
    ends = [accelerations([sub(b, a) for a, b in zip(*paths[character.limbs[limb][-1]])]) for limb in character.limbs]
    offset = [max(6.0 * moved / character.full**2, *each) for each in zip(*ends)]  # the first: of 3 u^2 - 2 u^3

    free = set(character.bones) - {node for limb in character.limbs for node in folded(character, limb, after)}
    unbent = [{node for limb in character.limbs for node in straight(character, limb, before, i)} for i in frames]
    worst = (0.0, 0, 0, 0.0)
    for node in sorted(free):
        _, posed = paths[node]
        for index, now in enumerate(accelerations(posed)):
            if any(node in each for each in unbent[index:index + 3]):
                continue
            around = slice(max(0, index - 1), index + 2)
            allowed = max(own[around]) + max(offset[around]) + SEEN_SPIKE * character.height
            worst = max(worst, (now / allowed, node, index + 1, now / character.height))
    if worst[0] > SPIKE:
        name = character.gltf["nodes"][worst[1]].get("name", worst[1])
        return [f"{name} accelerates by {worst[3]:.2g} of the height at frame {worst[2]}, {worst[0]:.2g} times what it may"]
    return []
