#pragma once

#include <string>
#include <vector>

namespace stretch::app {

/// What becomes of the scale of joints in an engine.
enum class JointScale { plays, mayBeDropped, notSupported };

/// What is known of an engine (docs/engines.md, with sources): what the forecast goes by.
struct Engine {
  std::string id;                   ///< "unity-generic"
  std::string name;                 ///< For people.
  bool turnsNormalsPlainly = false; ///< By the joints' own matrices.
  JointScale scale = JointScale::plays;
  bool dropsMappedChannels = false; ///< Of mapped bones: scale, and translation but for a few.
  bool holdsShear = true;           ///< In a joint's matrix.
  bool cullsByRestBox = false;
  int mostInfluences = 0; ///< Of a vertex; 0: not known.
  bool knowsAllInterpolations = false;
  std::string cullingRemedy = {};
  std::vector<std::string> notJudged = {}; ///< Subjects that nobody here has read or run.
};

[[nodiscard]] const std::vector<Engine>& engines();

} // namespace stretch::app
