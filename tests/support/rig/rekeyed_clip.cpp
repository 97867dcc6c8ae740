#include "tests/support/rig/rekeyed_clip.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace stretch::test {

Rekeyed rekeyedOf(const MovingBiped& moving, const std::vector<rig::Trail>& trails,
                  const rig::RekeyOptions& options, bool loops) {
  rig::RekeyOptions used = options;
  used.tolerance = 0.5e-4 * moving.body.height;
  Rekeyed rekeyed{solved(moving, trails, loops), {}, {}};
  rekeyed.keys = rig::rekey(moving.scene, moving.clip, rekeyed.motion, used);
  rekeyed.clip = rig::withTracks(moving.clip, rekeyed.keys.tracks);
  return rekeyed;
}

FrameState poseOf(const MovingBiped& moving, const Clip& clip, double frame) {
  const double seconds = frame / moving.clip.framesPerSecond;
  return frameOf(moving.scene, samplePose(moving.scene, clip, seconds), seconds);
}

double worstMiss(const MovingBiped& moving, const Rekeyed& rekeyed, int first, int last) {
  double worst = 0.0;
  for (int half = 2 * first; half <= 2 * last; ++half) {
    const double frame = 0.5 * half;
    worst = std::max(
        worst, largestNodeMiss(poseOf(moving, rekeyed.clip, frame), atFrame(moving, rekeyed.motion, frame)));
  }
  return worst;
}

const Track* sourceTrack(const Clip& clip, NodeIndex node, Channel channel) {
  const int index = findTrack(clip, node, channel);
  return index < 0 ? nullptr : &*clip.tracks[static_cast<std::size_t>(index)];
}

std::vector<float> keyNumbers(const Track& track, float timeSeconds) {
  const auto found = std::ranges::find(track.times, timeSeconds);
  if (found == track.times.end()) {
    return {};
  }
  const auto perKey =
      static_cast<std::ptrdiff_t>(track.width) * (track.interpolation == Interpolation::cubicSpline ? 3 : 1);
  const auto begin = track.values.begin() + (found - track.times.begin()) * perKey;
  return {begin, begin + perKey};
}

Mat3 stretchOf(const rig::StretchKeys& keys, double timeSeconds) {
  const auto next =
      std::ranges::find_if(keys.times, [&](float t) { return static_cast<double>(t) > timeSeconds; });
  std::size_t i = next == keys.times.begin() ? 0 : static_cast<std::size_t>(next - keys.times.begin()) - 1;
  double t = 0.0;
  if (next != keys.times.begin() && next != keys.times.end()) {
    const auto start = static_cast<double>(keys.times[i]);
    t = (timeSeconds - start) / (static_cast<double>(*next) - start);
  }
  const std::size_t j = t > 0.0 ? i + 1 : i;
  const Quat turn = keys.axisIsFixed() ? keys.axes[0] : glm::slerp(keys.axes[i], keys.axes[j], t);
  const Vec3 factors = keys.scales[i] + t * (keys.scales[j] - keys.scales[i]);
  const Mat3 axes = glm::mat3_cast(turn);
  Mat3 scale(1.0);
  for (int k = 0; k < 3; ++k) {
    scale[k][k] = factors[k];
  }
  return axes * scale * glm::transpose(axes);
}

} // namespace stretch::test
