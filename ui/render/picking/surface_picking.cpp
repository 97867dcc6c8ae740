#include "ui/render/picking/surface_picking.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "skinning/linear_blend_skinning.h"

namespace stretch::ui {

namespace {

/// A vertex on the screen: pixels and depth; `behind` the eye it has none.
struct Projected {
  Vec3 place{0.0};
  bool behind = true;
};

using Corners = std::array<std::size_t, 3>;
using Barycentric = std::array<double, 3>;

Projected project(const Mat4& toClip, const Viewport& size, const Vec3& world) {
  const glm::dvec4 clip = toClip * glm::dvec4(world, 1.0);
  if (!(clip.w > 1e-9)) {
    return {};
  }
  const Vec3 device = Vec3(clip) / clip.w;
  return {{0.5 * (device.x + 1.0) * size.widthPixels, 0.5 * (1.0 - device.y) * size.heightPixels, device.z},
          false};
}

std::optional<Barycentric> insideTriangle(const std::array<Vec3, 3>& corners, const Vec2& point) {
  const Vec2 a = Vec2(corners[0]) - point;
  const Vec2 b = Vec2(corners[1]) - point;
  const Vec2 c = Vec2(corners[2]) - point;
  if (std::min({a.x, b.x, c.x}) > 0.0 || std::max({a.x, b.x, c.x}) < 0.0 || std::min({a.y, b.y, c.y}) > 0.0 ||
      std::max({a.y, b.y, c.y}) < 0.0) {
    return std::nullopt;
  }
  const auto cross = [](const Vec2& u, const Vec2& v) { return u.x * v.y - u.y * v.x; };
  const Barycentric areas{cross(b, c), cross(c, a), cross(a, b)};
  const double whole = areas[0] + areas[1] + areas[2];
  if (whole == 0.0) {
    return std::nullopt;
  }
  const Barycentric shares{areas[0] / whole, areas[1] / whole, areas[2] / whole};
  const bool inside = shares[0] >= 0.0 && shares[1] >= 0.0 && shares[2] >= 0.0;
  return inside ? std::optional(shares) : std::nullopt;
}

std::vector<SurfaceShare> sharesOf(const Primitive& primitive, const Skin* skin, NodeIndex node,
                                   const Corners& corners, const Barycentric& shares) {
  if (skin == nullptr || primitive.influences.empty()) {
    return {{node, 1.0}};
  }
  std::vector<SurfaceShare> found;
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexInfluences& influences = primitive.influences[corners[i]];
    for (std::size_t k = 0; k < VertexInfluences::capacity; ++k) {
      if (influences.weights[k] > 0.0F && influences.joints[k] < skin->joints.size()) {
        found.push_back(
            {skin->joints[influences.joints[k]], shares[i] * static_cast<double>(influences.weights[k])});
      }
    }
  }
  return found.empty() ? std::vector<SurfaceShare>{{node, 1.0}} : found;
}

} // namespace

PosedSurface posedSurface(const Scene& scene, const FrameState& frame) {
  return {skinning::drawnMeshNodes(scene), skinning::skinnedPositions(scene, frame)};
}

std::optional<SurfaceHit> pickSurface(const View& view, const Scene& scene, const PosedSurface& surface,
                                      const Vec2& mousePixels) {
  const Mat4 toClip = view.projection * view.view;
  std::vector<Projected> projected(surface.positions.size());
  std::transform(surface.positions.begin(), surface.positions.end(), projected.begin(),
                 [&](const Vec3& world) { return project(toClip, view.viewport, world); });
  std::optional<SurfaceHit> best;
  std::size_t first = 0;
  for (const NodeIndex node : surface.nodes) {
    const Node& holder = scene.nodes[at(node)];
    const Skin* const skin = holder.skin >= 0 ? &scene.skins[at(holder.skin)] : nullptr;
    for (const Primitive& primitive : scene.meshes[at(holder.mesh)].primitives) {
      for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const Corners corners{primitive.indices[i], primitive.indices[i + 1], primitive.indices[i + 2]};
        const Projected& a = projected[first + corners[0]];
        const Projected& b = projected[first + corners[1]];
        const Projected& c = projected[first + corners[2]];
        if (a.behind || b.behind || c.behind) {
          continue;
        }
        const auto shares = insideTriangle({a.place, b.place, c.place}, mousePixels);
        if (!shares) {
          continue;
        }
        const double depth = (*shares)[0] * a.place.z + (*shares)[1] * b.place.z + (*shares)[2] * c.place.z;
        if (!best || depth < best->depth) {
          best = SurfaceHit{sharesOf(primitive, skin, node, corners, *shares), depth};
        }
      }
      first += primitive.positions.size();
    }
  }
  return best;
}

} // namespace stretch::ui
