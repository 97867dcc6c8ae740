#include "rig/body/evidence/name_evidence.h"

#include <algorithm>
#include <vector>

#include "rig/body/evidence/name_words.h"

namespace stretch::rig::body {

namespace {

struct RoleOfWord {
  Word word;
  Role role;
  double fit;
};

constexpr std::array roleTable = std::to_array<RoleOfWord>({
    {Word::clavicle, Role::clavicle, 1.0}, {Word::shoulder, Role::clavicle, 0.7},
    {Word::shoulder, Role::upperArm, 0.6}, {Word::arm, Role::upperArm, 0.6},
    {Word::arm, Role::foreArm, 0.25},      {Word::upperArm, Role::upperArm, 1.0},
    {Word::foreArm, Role::foreArm, 1.0},   {Word::elbow, Role::foreArm, 1.0},
    {Word::wrist, Role::wrist, 1.0},       {Word::hand, Role::wrist, 0.85},
    {Word::thigh, Role::thigh, 1.0},       {Word::hip, Role::thigh, 0.85},
    {Word::leg, Role::thigh, 0.4},         {Word::leg, Role::shin, 0.55},
    {Word::knee, Role::shin, 1.0},         {Word::shin, Role::shin, 1.0},
    {Word::ankle, Role::ankle, 1.0},       {Word::foot, Role::ankle, 0.85},
    {Word::foot, Role::toe, 0.3},          {Word::toe, Role::toe, 1.0},
    {Word::hips, Role::hips, 1.0},         {Word::spine, Role::spine, 1.0},
    {Word::spine, Role::chest, 0.6},       {Word::chest, Role::chest, 1.0},
    {Word::chest, Role::spine, 0.6},       {Word::torso, Role::spine, 0.8},
    {Word::torso, Role::chest, 0.7},       {Word::waist, Role::spine, 0.6},
    {Word::waist, Role::hips, 0.4},        {Word::body, Role::spine, 0.4},
    {Word::body, Role::hips, 0.3},         {Word::neck, Role::neck, 1.0},
    {Word::head, Role::head, 1.0},
});

bool isPaired(Role role) {
  return role <= Role::toe;
}

bool has(const std::vector<Word>& words, Word word) {
  return std::ranges::find(words, word) != words.end();
}

void replace(std::vector<Word>& words, Word part, Word other, Word joined) {
  if (has(words, part) && has(words, other)) {
    std::erase(words, part);
    std::ranges::replace(words, other, joined);
  }
}

// The front leg of what may be a biped is its arm.
void readFrontLegs(std::vector<Word>& words) {
  const bool isFrontLeg = has(words, Word::fore) && (has(words, Word::leg) || has(words, Word::foot));
  if (isFrontLeg) {
    std::erase(words, Word::fore);
    std::ranges::replace(words, Word::leg, Word::arm);
    std::ranges::replace(words, Word::foot, Word::hand);
  }
}

// "upper" and "leg", in any order and however written, are the thigh, and so on.
void joinWords(std::vector<Word>& words) {
  replace(words, Word::upper, Word::arm, Word::upperArm);
  replace(words, Word::lower, Word::arm, Word::foreArm);
  replace(words, Word::fore, Word::arm, Word::foreArm);
  replace(words, Word::upper, Word::leg, Word::thigh);
  replace(words, Word::lower, Word::leg, Word::shin);
  replace(words, Word::upper, Word::body, Word::torso);
  replace(words, Word::lower, Word::body, Word::hips);
}

Side sideOf(const std::vector<Word>& words) {
  const bool left = has(words, Word::left);
  const bool right = has(words, Word::right);
  // "r.l" is the rear left leg.
  const bool isRearLeft =
      words.size() > 1 && words.back() == Word::left && words[words.size() - 2] == Word::right;
  return isRearLeft || left != right ? (left ? Side::left : Side::right) : Side::none;
}

// French and Portuguese rigs mark sides with G/D and E/D; the letters mean nothing beside English words.
Side romanceSide(const std::vector<NameChunk>& chunks) {
  Side side = Side::none;
  for (const NameChunk& chunk : chunks) {
    if (chunk.whole == "g") {
      side = Side::left;
    } else if (chunk.whole == "d") {
      side = Side::right;
    }
  }
  return side;
}

// Legs are called FL, FR, BL and BR, or LF, RF, LH and RH.
Side sideOfRow(const std::vector<NameChunk>& chunks) {
  for (const NameChunk& chunk : chunks) {
    for (const std::string& part : chunk.parts) {
      if (const std::optional<RowLetters> letters = rowLetters(part)) {
        return letters->side == 'l' ? Side::left : Side::right;
      }
    }
  }
  return Side::none;
}

void addRoles(NameEvidence& evidence, const std::vector<Word>& words) {
  for (const RoleOfWord& entry : roleTable) {
    if (!has(words, entry.word)) {
      continue;
    }
    // A limb joint without a side, or a trunk joint with one, is a weaker sign.
    const bool fits = isPaired(entry.role) == (evidence.side != Side::none);
    double& fit = evidence.roles[static_cast<std::size_t>(entry.role)];
    fit = std::max(fit, fits ? entry.fit : entry.fit * (isPaired(entry.role) ? 0.5 : 0.0));
  }
  // "head neck upper" is what carries a head.
  if (has(words, Word::neck) && has(words, Word::head)) {
    double& head = evidence.roles[static_cast<std::size_t>(Role::head)];
    head = std::min(head, 0.5);
  }
  // A cervical vertebra is of the neck.
  if (has(words, Word::neck) && has(words, Word::spine)) {
    evidence.roles[static_cast<std::size_t>(Role::spine)] = 0.0;
    evidence.roles[static_cast<std::size_t>(Role::chest)] = 0.0;
  }
  if (has(words, Word::hip) && evidence.side == Side::none) {
    evidence.roles[static_cast<std::size_t>(Role::hips)] = 1.0;
    evidence.roles[static_cast<std::size_t>(Role::thigh)] = 0.0;
  }
  // A palm, a finger or a slot in the hand is no wrist.
  if (evidence.palm || evidence.finger || evidence.accessory) {
    evidence.roles.fill(0.0);
  }
}

std::string mirrorKey(const std::vector<NameChunk>& chunks) {
  std::string key;
  for (const NameChunk& chunk : chunks) {
    for (const std::string& part : chunk.parts) {
      if (const std::optional<RowLetters> letters = rowLetters(part)) {
        key += part == "rf" ? "" : std::string{letters->row, ' '}; // the other side's "lf" says its side
                                                                   // alone
        continue;
      }
      const std::optional<Word> word = lookUpWord(part);
      if (word != Word::left && word != Word::right) {
        key += part;
        key += ' ';
      }
    }
  }
  return key;
}

// Digits tell the joints of a row apart: they belong to the key, what exporters append ("_045") does not.
std::string digitsOf(std::string_view name) {
  std::string digits;
  std::size_t run = 0;
  for (const char c : name) {
    run = c >= '0' && c <= '9' ? run + 1 : 0;
    if (run == 1) {
      digits += '#';
    }
    if (run > 0) {
      digits += c;
    }
  }
  return digits;
}

} // namespace

NameEvidence readName(std::string_view name) {
  constexpr std::size_t longestName = 256;
  const std::vector<NameChunk> chunks = nameChunks(name.substr(0, longestName));
  std::vector<Word> words;
  for (const NameChunk& chunk : chunks) {
    const std::vector<Word> found = chunkWords(chunk);
    words.insert(words.end(), found.begin(), found.end());
  }
  readFrontLegs(words);
  joinWords(words);
  NameEvidence evidence;
  evidence.side = sideOf(words);
  const bool namesLimb =
      std::ranges::any_of(words, [](Word word) { return word >= Word::arm && word <= Word::toe; });
  if (evidence.side == Side::none && namesLimb) {
    evidence.side = sideOfRow(chunks);
  }
  if (evidence.side == Side::none && namesLimb) {
    evidence.side = romanceSide(chunks);
  }
  evidence.twist = has(words, Word::twist);
  evidence.control = has(words, Word::control);
  evidence.end = has(words, Word::end);
  // "middle" and "index" are fingers, the middle of the spine is none.
  const bool namesTrunk =
      std::ranges::any_of(words, [](Word word) { return word >= Word::spine && word <= Word::head; });
  // So is the middle leg of an insect.
  const bool namesLeg = has(words, Word::leg) || has(words, Word::foot) || has(words, Word::thigh) ||
                        has(words, Word::shin) || has(words, Word::knee);
  evidence.finger = has(words, Word::finger) && !namesTrunk && !namesLeg;
  evidence.palm = has(words, Word::palm);
  evidence.face = has(words, Word::face);
  evidence.fin = has(words, Word::fin) && !namesLimb;
  evidence.accessory = has(words, Word::accessory) || evidence.face;
  addRoles(evidence, words);
  evidence.key = mirrorKey(chunks) + digitsOf(name);
  return evidence;
}

} // namespace stretch::rig::body
