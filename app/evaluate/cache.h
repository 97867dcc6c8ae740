#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/document.h"
#include "app/evaluate/evaluation_input.h"
#include "app/weight/weight_motion.h"
#include "core/anim/frame_state.h"
#include "rig/adjust/controller_shapes.h"
#include "rig/motion/controller_places.h"
#include "rig/motion/motion.h"
#include "rig/rekey/key_places.h"

namespace stretch::app {

/// The last answer of one stage, with all that it was made from: another is made when the key is another.
template <typename Key, typename Value>
class LastAnswer {
public:
  struct Entry {
    Key key;
    Value value;
  };

  /// `make` gets the last entry (null: none) and answers the value of the new key.
  template <typename Make>
  const Value& of(Key key, Make&& make) {
    if (!last_ || !(last_->key == key)) {
      Value value = make(last_ ? &*last_ : nullptr);
      last_ = Entry{std::move(key), std::move(value)};
    }
    return last_->value;
  }

  /// The last answer, whatever it was made from; null: none.
  [[nodiscard]] const Value* last() const { return last_ ? &last_->value : nullptr; }

private:
  std::optional<Entry> last_;
};

/// Remembers the last answer of each stage of evaluation. A stage keys on the values that it is made from, or
/// on the identity of what an earlier stage answered, which it keeps alive, so that nothing else takes its
/// place in memory: nobody invalidates anything. Of trails that did not change, and of paths that no changed
/// trail moves, the last answers are used again.
class EvaluationCache {
public:
  [[nodiscard]] std::shared_ptr<const rig::MotionState> motion(const Document& document, int clip);
  /// Reports of the limbs with weight, in the order of Document::weights.
  [[nodiscard]] const std::vector<WeightReport>& weightReports(const Document& document, int clip);
  [[nodiscard]] const FrameState& frame(const Document& document, int clip, double timeSeconds);
  [[nodiscard]] const FrameState& original(const Document& document, int clip, double timeSeconds);
  /// One for each trail of motion(); the clip must be there.
  [[nodiscard]] const std::vector<TrailPaths>& paths(const Document& document, int clip,
                                                     std::size_t samplesPerFrame);
  /// The clip as its adjustments, applied trails and holds re-key it: the keys that the timeline and the
  /// graph show. The clip must be there; without any of them it is the document's. `places`: as saving keys.
  [[nodiscard]] const Clip& keyed(const Document& document, int clip,
                                  rig::KeyPlaces places = rig::KeyPlaces::needed);

  /// Places of all controllers (rig::placeControllers), with the shapes that are drawn.
  [[nodiscard]] const std::vector<rig::PlacedController>& controllers(const Document& document, int clip,
                                                                      double timeSeconds);
  [[nodiscard]] const std::vector<rig::ControllerShape>& shapes(const Document& document, int clip);

private:
  using Body = std::shared_ptr<const rig::AdjustedBody>;
  using Places = std::shared_ptr<const rig::BindPlaces>;
  using Motion = std::shared_ptr<const rig::MotionState>;

  struct TrailsKey {
    EvaluationGround ground;
    std::vector<rig::Trail> trails;
    friend bool operator==(const TrailsKey&, const TrailsKey&) = default;
  };
  struct HoldsKey {
    Motion trails;
    rig::Holds holds;
    friend bool operator==(const HoldsKey&, const HoldsKey&) = default;
  };
  struct SampleKey {
    Motion held;
    std::vector<std::string> limbs; ///< That give way: a drag of a limb's softness keeps the samples.
    Vec3 up{0.0, 1.0, 0.0};
    friend bool operator==(const SampleKey&, const SampleKey&) = default;
  };
  struct WeightKey {
    Motion held;
    std::vector<WeightedLimb> weights;
    friend bool operator==(const WeightKey&, const WeightKey&) = default;
  };
  struct Weighted {
    Motion motion;
    std::vector<WeightReport> reports; ///< Without lengths.
  };
  struct FrameKey {
    Motion motion;
    double timeSeconds = 0.0;
    friend bool operator==(const FrameKey&, const FrameKey&) = default;
  };
  struct OriginalKey {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const std::vector<Clip>> clips;
    int clip = -1;
    double timeSeconds = 0.0;
    friend bool operator==(const OriginalKey&, const OriginalKey&) = default;
  };
  struct PathsKey {
    EvaluationGround ground;
    Motion held;
    std::size_t samplesPerFrame = 0;
    friend bool operator==(const PathsKey&, const PathsKey&) = default;
  };

  struct KeyedKey {
    TrailsKey trails;
    rig::Holds holds;
    rig::KeyPlaces places = rig::KeyPlaces::needed;
    friend bool operator==(const KeyedKey&, const KeyedKey&) = default;
  };

  const Body& body(const EvaluationGround& ground);
  const Places& places(const std::shared_ptr<const Scene>& scene);
  const Motion& trails(const EvaluationInput& input);
  /// The trails with the holds on top; the trails' own answer where there are none.
  const Motion& held(const EvaluationInput& input);
  const SampledClip& sampled(const WeightInput& weight, const Motion& held);
  const Weighted& weighted(const Document& document, int clip);

  LastAnswer<EvaluationGround, Body> body_;
  LastAnswer<std::shared_ptr<const Scene>, Places> places_;
  LastAnswer<Body, std::vector<rig::ControllerShape>> shapes_;
  LastAnswer<FrameKey, std::vector<rig::PlacedController>> controllers_;
  LastAnswer<TrailsKey, Motion> trails_;
  LastAnswer<HoldsKey, Motion> held_;
  LastAnswer<SampleKey, SampledClip> sampled_;
  LimbSizes sizes_;
  LastAnswer<WeightKey, Weighted> weighted_;
  LastAnswer<Motion, std::vector<WeightReport>> reports_;
  LastAnswer<FrameKey, FrameState> frame_;
  LastAnswer<OriginalKey, FrameState> original_;
  LastAnswer<PathsKey, std::vector<TrailPaths>> paths_;
  LastAnswer<KeyedKey, Clip> keyed_;
};

} // namespace stretch::app
