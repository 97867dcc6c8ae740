#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rig/body/evidence/name_text.h"

namespace stretch::rig::body {

/// Meaning of a word in a joint's name, whatever its language.
enum class Word {
  left,
  right,
  upper,
  lower,
  fore,
  arm,
  leg,
  upperArm,
  foreArm,
  elbow,
  wrist,
  hand,
  palm,
  finger,
  clavicle,
  shoulder,
  thigh,
  hip,
  hips,
  knee,
  shin,
  ankle,
  foot,
  toe,
  spine,
  chest,
  torso,
  waist,
  body,
  neck,
  head,
  twist,     ///< A joint that shares a bone with another one.
  control,   ///< A handle of the animator's: IK target, pole, FK copy.
  end,       ///< The tip of a bone, no joint of its own.
  accessory, ///< Anything that a biped has besides limbs and trunk: hair, cloth, weapons.
  face,      ///< Front of the head: eyes, jaw, nose.
  fin,       ///< Fin or flipper.
  noise      ///< "joint", "bone": says nothing.
};

/// The meaning of a folded word, if the dictionary has it.
[[nodiscard]] std::optional<Word> lookUpWord(std::string_view word);

using KnowsWord = std::function<bool(std::string_view)>;

/// Cuts a text that is written without gaps into as few known words as can be ("leftupleg" into left, up,
/// leg). A side's letter counts at the ends only. Empty where known words do not cover it.
[[nodiscard]] std::vector<std::string_view> cutIntoWords(std::string_view text, const KnowsWord& knows);

/// The known words of a chunk: the whole chunk as a row of dictionary words ("leftupleg", "lThigh") where
/// that works, else part by part; parts that no word covers are left out.
[[nodiscard]] std::vector<Word> chunkWords(const NameChunk& chunk);

} // namespace stretch::rig::body
