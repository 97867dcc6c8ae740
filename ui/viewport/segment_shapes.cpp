#include "ui/viewport/segment_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "ui/render/scene/value_colors.h"
#include "ui/render/view/palette.h"

namespace stretch::ui {

namespace {

constexpr int sides = 24;
/// Each end has two rings, so that its edge is hard, and a middle.
constexpr std::uint32_t verticesOfEnd = 2 * sides + 1;
constexpr std::uint32_t verticesOfCylinder = 2 * verticesOfEnd;

std::uint32_t onSide(std::uint32_t end, int side) {
  return end * verticesOfEnd + static_cast<std::uint32_t>(side % sides);
}

std::uint32_t onLid(std::uint32_t end, int side) {
  return onSide(end, side) + sides;
}

std::uint32_t middleOf(std::uint32_t end) {
  return end * verticesOfEnd + 2 * sides;
}

void addTriangles(std::uint32_t first, std::vector<Triangle>& triangles) {
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles.push_back({first + a, first + b, first + c});
  };
  for (int side = 0; side < sides; ++side) {
    add(onSide(0, side), onSide(1, side), onSide(1, side + 1));
    add(onSide(0, side), onSide(1, side + 1), onSide(0, side + 1));
    add(middleOf(0), onLid(0, side), onLid(0, side + 1));
    add(middleOf(1), onLid(1, side + 1), onLid(1, side));
  }
}

/// Vertices of a cylinder of radius 1 around x from 0 to 1, in the order that the triangles count.
std::vector<Vec3> unitCylinder() {
  std::vector<Vec3> vertices;
  for (const double x : {0.0, 1.0}) {
    for (int ring = 0; ring < 2; ++ring) {
      for (int side = 0; side < sides; ++side) {
        const double angle = 2.0 * pi * side / sides;
        vertices.emplace_back(x, std::cos(angle), std::sin(angle));
      }
    }
    vertices.emplace_back(x, 0.0, 0.0);
  }
  return vertices;
}

std::vector<double> widthsOf(const app::SequenceAnalysis& analysis,
                             const std::vector<skinning::Influences>& segments, std::size_t count) {
  std::vector<double> sums(count, 0.0);
  std::vector<double> weights(count, 0.0);
  for (std::size_t v = 0; v < segments.size(); ++v) {
    for (std::size_t i = 0; i < skinning::Influences::capacity; ++i) {
      const auto weight = static_cast<double>(segments[v].weights[i]);
      sums[segments[v].bones[i]] += weight * analysis.vertexDiameters[v];
      weights[segments[v].bones[i]] += weight;
    }
  }
  for (std::size_t s = 0; s < count; ++s) {
    sums[s] = weights[s] > 0.0 ? sums[s] / weights[s] : 0.0;
  }
  return sums;
}

/// Two directions across a line, of unit length and square to each other.
std::array<Vec3, 2> acrossOf(const Vec3& along) {
  const Vec3 helper = std::abs(along.y) < 0.9 ? Vec3(0.0, 1.0, 0.0) : Vec3(1.0, 0.0, 0.0);
  const Vec3 first = glm::normalize(glm::cross(along, helper));
  return {first, glm::cross(along, first)};
}

/// From the unit cylinder to one between two points.
Mat4 between(const Vec3& from, const Vec3& to, double width) {
  const Vec3 along = to - from;
  const double length = glm::length(along);
  const auto across = acrossOf(length > 0.0 ? along / length : Vec3(1.0, 0.0, 0.0));
  return {Vec4(along, 0.0), Vec4(0.5 * width * across[0], 0.0), Vec4(0.5 * width * across[1], 0.0),
          Vec4(from, 1.0)};
}

} // namespace

std::vector<skinning::Influences> segmentsOfVertices(const app::SequenceAnalysis& analysis,
                                                     const skinning::SkinnedSequence* result) {
  if (result != nullptr) {
    return result->influences;
  }
  std::vector<skinning::Influences> segments(analysis.vertexSegments.size());
  for (std::size_t v = 0; v < segments.size(); ++v) {
    segments[v].bones[0] = static_cast<std::uint16_t>(analysis.vertexSegments[v]);
    segments[v].weights[0] = 1.0F;
  }
  return segments;
}

std::size_t segmentCount(const app::SequenceAnalysis& analysis, const skinning::SkinnedSequence* result) {
  if (result != nullptr) {
    return result->bones.size();
  }
  return analysis.joints.empty() ? 0 : analysis.joints.front().size() - 1;
}

glm::vec4 segmentColor(std::size_t segment) {
  constexpr std::array<std::uint32_t, 7> colours{okabe::orange,       okabe::blue,    okabe::yellow,
                                                 okabe::vermilion,    okabe::skyBlue, okabe::bluishGreen,
                                                 okabe::reddishPurple};
  return rgba(colours[segment % colours.size()]);
}

std::vector<glm::vec4> segmentColors(const std::vector<skinning::Influences>& segments) {
  std::vector<glm::vec4> colors(segments.size(), glm::vec4(0.0F));
  for (std::size_t v = 0; v < segments.size(); ++v) {
    for (std::size_t i = 0; i < skinning::Influences::capacity; ++i) {
      colors[v] += segments[v].weights[i] * linearLight(segmentColor(segments[v].bones[i]));
    }
    colors[v].a = 1.0F;
  }
  return colors;
}

SegmentCylinders::SegmentCylinders(const app::SequenceAnalysis& analysis,
                                   const skinning::SkinnedSequence* result)
    : analysis_(analysis), result_(result),
      widths_(widthsOf(analysis, segmentsOfVertices(analysis, result), segmentCount(analysis, result))) {
  for (std::size_t segment = 0; segment < count(); ++segment) {
    addTriangles(static_cast<std::uint32_t>(segment) * verticesOfCylinder, triangles_);
  }
}

void SegmentCylinders::add(PlainMesh& mesh, std::size_t segment, std::size_t frame) const {
  static const std::vector<Vec3> unit = unitCylinder();
  Mat4 placed(1.0);
  if (result_ != nullptr) {
    const skinning::SkinBone& bone = result_->bones[segment];
    const Vec3 half(0.5 * widths_[segment], 0.0, 0.0);
    const bool isPoint = bone.pivot == bone.end;
    placed = skinning::skinMatrix(bone, result_->pose(frame, segment)) *
             between(isPoint ? bone.pivot - half : bone.pivot, isPoint ? bone.pivot + half : bone.end,
                     widths_[segment]);
  } else {
    const std::vector<Vec3>& joints = analysis_.joints[frame];
    placed = between(joints[segment], joints[segment + 1], widths_[segment]);
  }
  for (const Vec3& vertex : unit) {
    mesh.positions.emplace_back(transformPoint(placed, vertex));
  }
  mesh.colors.insert(mesh.colors.end(), unit.size(), linearLight(segmentColor(segment)));
}

PlainMesh SegmentCylinders::meshAt(std::size_t frame) const {
  PlainMesh mesh{{}, triangles_, {}};
  for (std::size_t segment = 0; segment < count(); ++segment) {
    add(mesh, segment, frame);
  }
  return mesh;
}

} // namespace stretch::ui
