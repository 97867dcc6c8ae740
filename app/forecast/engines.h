#pragma once

#include <string>
#include <vector>

namespace stretch::app {

/// Fate of the scale of joints in an engine.
enum class JointScale { plays, mayBeDropped, notSupported };

/// Facts about an engine (docs/engines.md, with sources): what the forecast goes by.
struct Engine {
  std::string id;                   ///< "unity-generic"
  std::string name;                 ///< For people.
  bool turnsNormalsPlainly = false; ///< By the joints' own matrices.
  JointScale scale = JointScale::plays;
  bool dropsMappedChannels = false; ///< Drops of mapped bones: scale, and translation but for a few.
  bool holdsShear = true;           ///< In a joint's matrix.
  bool cullsByRestBox = false;
  int mostInfluences = 0; ///< Most of a vertex; 0: not known.
  bool knowsAllInterpolations = false;
  std::string cullingRemedy = {};
  std::vector<std::string> notJudged = {}; ///< Subjects that nobody here has read or run.
};

[[nodiscard]] const std::vector<Engine>& engines();

} // namespace stretch::app
