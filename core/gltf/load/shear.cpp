#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "core/gltf/load/report.h"

namespace stretch::gltf {

namespace {

constexpr std::size_t mostTimesAClip = 64;

// Nodes that meshes follow: their own, as joints, or as the second leaf of a stretched joint.
std::vector<NodeIndex> visibleNodes(const Scene& scene) {
  std::vector<bool> isVisible(scene.nodes.size(), false);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    isVisible[i] = scene.nodes[i].mesh >= 0 && scene.nodes[i].skin < 0;
  }
  for (const Skin& skin : scene.skins) {
    for (const NodeIndex joint : skin.joints) {
      isVisible[at(joint)] = true;
    }
  }
  for (const BindChain& chain : scene.bindChains) {
    if (chain.endLeaf.exists()) {
      isVisible[at(chain.endLeaf)] = true;
    }
  }
  std::vector<NodeIndex> nodes;
  for (std::size_t i = 0; i < isVisible.size(); ++i) {
    if (isVisible[i]) {
      nodes.emplace_back(i);
    }
  }
  return nodes;
}

// A node scaled to nothing has no axes to compare.
double largestCosine(const Mat4& world) {
  double largest = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Vec3 first(world[a]);
      const Vec3 second(world[b]);
      const double lengths = glm::length(first) * glm::length(second);
      largest = std::max(largest, lengths > 1e-12 ? std::abs(glm::dot(first, second)) / lengths : 0.0);
    }
  }
  return std::min(largest, 1.0);
}

std::vector<double> someKeyTimes(const Clip& clip) {
  std::vector<float> times;
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    times.insert(times.end(), track->times.begin(), track->times.end());
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<double> some;
  const std::size_t count = std::min(times.size(), mostTimesAClip);
  for (std::size_t i = 0; i < count; ++i) {
    some.push_back(static_cast<double>(times[i * times.size() / count]));
  }
  return some;
}

class WorstShear {
public:
  explicit WorstShear(const Scene& scene) : scene_(scene) {
    for (const NodeIndex node : visibleNodes(scene)) {
      worst_.push_back({node, -1, 0.0, 0.0});
    }
  }

  void look(const Pose& pose, int clip, double timeSeconds) {
    const std::vector<Mat4> worlds = worldMatrices(scene_, pose);
    for (Shear& worst : worst_) {
      const double cosine = largestCosine(worlds[at(worst.node)]);
      if (cosine > worst.cosine) {
        worst = {worst.node, clip, timeSeconds, cosine};
      }
    }
  }

  [[nodiscard]] std::vector<Shear> above(double tolerance) && {
    std::erase_if(worst_, [&](const Shear& shear) { return shear.cosine <= tolerance; });
    return std::move(worst_);
  }

private:
  const Scene& scene_;
  std::vector<Shear> worst_;
};

} // namespace

std::vector<Shear> residualShear(const Scene& scene, const std::vector<Clip>& clips, double tolerance) {
  WorstShear worst(scene);
  worst.look(restPose(scene), -1, 0.0);
  for (std::size_t clip = 0; clip < clips.size(); ++clip) {
    for (const double time : someKeyTimes(clips[clip])) {
      worst.look(samplePose(scene, clips[clip], time), static_cast<int>(clip), time);
    }
  }
  return std::move(worst).above(tolerance);
}

} // namespace stretch::gltf
