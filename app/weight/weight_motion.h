#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/weight/limb_widths.h"
#include "app/weight/sample_clip.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// What the weight of one limb came to.
struct WeightReport {
  std::string limb;
  double youngModulus = 0.0;  ///< Pa, as used: given or chosen.
  std::vector<double> widths; ///< One for each bone, metres of a character of characterHeightMetres.
  std::vector<double> masses; ///< One for each bone, kg.
  double shortest = 1.0;      ///< Limb lengths over the lengths without weight, along the bones.
  double shortestFrame = 0.0;
  double longest = 1.0;
  double longestFrame = 0.0;
  std::vector<std::string> warnings; ///< One line each, with its frame.
};

/// Sizes of limbs, measured once for a scene.
class LimbSizes {
public:
  [[nodiscard]] const LimbSize& of(const Document& document, const rig::Limb& limb);

private:
  std::shared_ptr<const Scene> scene_;
  std::vector<rig::Limb> limbs_;
  std::map<std::string, LimbSize> sizes_;
};

struct WeightMotion {
  std::vector<rig::LimbWeight> weights;
  std::vector<WeightReport> reports; ///< In the order of Document::weights.
};

/// How the limbs of a clip that have weight give way (skinning::limbElasticity): legs that stand share the
/// body above them, a clip that loops is in the swing of its loop from the start, and a range inside the clip
/// fades in and out.
[[nodiscard]] WeightMotion weightMotion(const Document& document, const SampledClip& sampled, int clip,
                                        LimbSizes& sizes);

/// Whether any limb of the clip has weight that is on.
[[nodiscard]] bool hasWeight(const Document& document, int clip);

/// Null when the limb has none in the clip.
[[nodiscard]] const WeightedLimb* findWeight(const Document& document, const std::string& limb, int clip);

} // namespace stretch::app
