#include "app/evaluate/evaluation_input.h"

#include <algorithm>
#include <iterator>

#include "core/base/index.h"

namespace stretch::app {

namespace {

template <typename T>
std::vector<T> ofClip(const std::vector<T>& all, int clip) {
  std::vector<T> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [&](const T& one) { return one.clip == clip; });
  return some;
}

} // namespace

EvaluationInput evaluationInput(const Document& document, int clip) {
  const bool loops = std::find(document.loopingClips.begin(), document.loopingClips.end(), clip) !=
                     document.loopingClips.end();
  return {{document.scene, document.clips, clip, document.biped.hips, document.biped.height,
           allLimbs(document), loops},
          ofClip(document.trails, clip),
          ofClip(document.weights, clip)};
}

const Clip& clipOrStill(const std::vector<Clip>& clips, int clip) {
  static const Clip still;
  return clip >= 0 && at(clip) < clips.size() ? clips[at(clip)] : still;
}

const Clip& clipOf(const EvaluationGround& ground) {
  return clipOrStill(*ground.clips, ground.clip);
}

} // namespace stretch::app
