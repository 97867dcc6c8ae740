#include "skinning/compress/fewest_bones.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace stretch::skinning {
namespace {

/// One number of bones, and how far off it is.
struct Trial {
  int bones = 0;
  CompressedSequence fitted;
  double percent = 0.0;
};

class BoneSearch {
public:
  BoneSearch(const MeshSequence& sequence, const CompressSettings& settings, const Proceed& proceed)
      : sequence_(sequence), settings_(settings), proceed_(proceed),
        most_(static_cast<int>(std::clamp<std::size_t>(sequence.vertexCount / 4, 1, mostBonesOfTolerance))) {}

  Result<CompressedSequence> run() {
    if (const Status grown = grow(); !grown) {
      return grown.error();
    }
    if (!meets(best_)) {
      best_.fitted.warnings.push_back(
          fmt::format("{:g} % of the diagonal is not met: {} bones are off by {:.2g} %, and more, up to {}, "
                      "do not help",
                      *settings_.tolerancePercent, best_.fitted.skinned.bones.size(), best_.percent, most_));
      return std::move(best_.fitted);
    }
    if (const Status narrowed = narrow(); !narrowed) {
      return narrowed.error();
    }
    return std::move(best_.fitted);
  }

private:
  [[nodiscard]] bool meets(const Trial& trial) const { return trial.percent <= *settings_.tolerancePercent; }

  /// Each trial is given a part of the work that is left, since nobody knows how many there will be.
  Result<Trial> tryWith(int bones) {
    constexpr double part = 0.25;
    const double from = 1.0 - std::pow(1.0 - part, trials_);
    const double to = 1.0 - std::pow(1.0 - part, ++trials_);
    CompressSettings settings = settings_;
    settings.bones = bones;
    auto fitted = fittedBones(sequence_, settings, partOf(proceed_, from, to));
    if (!fitted) {
      return fitted.error();
    }
    const double percent = distancesOf(sequence_, skinAllFrames(fitted->skinned)).rmsePercent;
    return Trial{bones, std::move(fitted).value(), percent};
  }

  Status grow() {
    constexpr int first = 4;
    constexpr double leastGain = 0.97;
    for (int bones = std::min(first, most_);; bones = std::min(2 * bones, most_)) {
      auto trial = tryWith(bones);
      if (!trial) {
        return trial.error();
      }
      const bool helps = best_.bones == 0 || trial->percent < leastGain * best_.percent;
      if (meets(*trial) || best_.bones == 0 || trial->percent < best_.percent) {
        tooFew_ = best_.bones;
        best_ = std::move(trial).value();
      }
      if (meets(best_) || !helps || bones == most_) {
        return Success{};
      }
    }
  }

  Status narrow() {
    while (best_.bones - tooFew_ > 1) {
      const int bones = (best_.bones + tooFew_) / 2;
      auto trial = tryWith(bones);
      if (!trial) {
        return trial.error();
      }
      if (meets(*trial)) {
        best_ = std::move(trial).value();
      } else {
        tooFew_ = bones;
      }
    }
    return Success{};
  }

  const MeshSequence& sequence_;
  const CompressSettings& settings_;
  const Proceed& proceed_;
  int most_;
  int trials_ = 0;
  int tooFew_ = 0; ///< The most bones that are known not to meet it.
  Trial best_;
};

} // namespace

Result<CompressedSequence> fewestBones(const MeshSequence& sequence, const CompressSettings& settings,
                                       const Proceed& proceed) {
  return BoneSearch(sequence, settings, proceed).run();
}

} // namespace stretch::skinning
