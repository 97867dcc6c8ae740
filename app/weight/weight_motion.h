#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/weight/report.h"
#include "app/weight/sample_clip.h"
#include "rig/reach/limb_weight.h"

namespace stretch::app {

/// Sizes of limbs, measured once for a scene and its limbs.
class LimbSizes {
public:
  [[nodiscard]] const LimbSize& of(const WeightInput& input, const rig::Limb& limb);

private:
  std::shared_ptr<const Scene> scene_;
  std::vector<rig::Limb> limbs_;
  std::map<std::string, LimbSize> sizes_;
};

struct WeightMotion {
  std::vector<rig::LimbWeight> weights; ///< With legs that do not give way but know where they stand.
  std::vector<WeightReport> reports;    ///< In the order of WeightInput::weights; without lengths
                                        ///< (measureLengths).
};

/// How the limbs of a clip that have weight give way (skinning::limbElasticity): legs that stand share the
/// body above them, a clip that loops is in the swing of its loop from the start, and a range inside the clip
/// fades in and out.
[[nodiscard]] WeightMotion weightMotion(const WeightInput& input, const SampledClip& sampled,
                                        LimbSizes& sizes);

} // namespace stretch::app
