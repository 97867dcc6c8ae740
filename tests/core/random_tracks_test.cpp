// Tracks by chance, sampled at times by chance, against formulas of the specification written out; poses and
// places of whole trees against products along each way to the root.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/anim/sampling.h"
#include "core/math/rotation.h"
#include "core/math/transform.h"
#include "tests/support/nodes.h"

using namespace stretch;

namespace {

class Chance {
public:
  explicit Chance(unsigned seed) : numbers_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(numbers_);
  }
  std::size_t below(std::size_t count) { return numbers_() % count; }

private:
  std::mt19937 numbers_;
};

Track trackOf(Chance& chance, Channel channel, Interpolation interpolation, std::size_t keys) {
  Track track;
  track.channel = channel;
  track.interpolation = interpolation;
  track.width = channel == Channel::rotation ? 4 : channel == Channel::weights ? 5 : 3;
  double time = chance.between(-0.5, 0.5);
  for (std::size_t k = 0; k < keys; ++k, time += chance.between(0.01, 0.7)) {
    track.times.push_back(static_cast<float>(time));
  }
  const std::size_t perKey = interpolation == Interpolation::cubicSpline ? 3 : 1;
  for (std::size_t i = 0; i < keys * perKey * static_cast<std::size_t>(track.width); ++i) {
    track.values.push_back(static_cast<float>(chance.between(-2.0, 2.0)));
  }
  return track;
}

using Value = std::vector<double>;

/// Value (1), tangent into (0) or out of (2) a key.
Value partOf(const Track& track, std::size_t key, std::size_t part) {
  const auto width = static_cast<std::size_t>(track.width);
  const std::size_t first =
      track.interpolation == Interpolation::cubicSpline ? (3 * key + part) * width : key * width;
  return {track.values.begin() + static_cast<std::ptrdiff_t>(first),
          track.values.begin() + static_cast<std::ptrdiff_t>(first + width)};
}

Value unit(Value value) {
  double square = 0.0;
  for (const double number : value) {
    square += number * number;
  }
  for (double& number : value) {
    number /= std::sqrt(square);
  }
  return value;
}

/// The shorter arc between two turns, by the angle between them.
Value arc(const Value& from, const Value& to, double share) {
  const Value a = unit(from);
  Value b = unit(to);
  double cosine = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    cosine += a[i] * b[i];
  }
  for (double& number : b) {
    number *= cosine < 0.0 ? -1.0 : 1.0;
  }
  const double angle = std::acos(std::min(1.0, std::abs(cosine)));
  Value value(4);
  for (std::size_t i = 0; i < 4; ++i) {
    value[i] = angle < 1e-9 ? a[i]
                            : (std::sin((1.0 - share) * angle) * a[i] + std::sin(share * angle) * b[i]) /
                                  std::sin(angle);
  }
  return value;
}

/// A cubic by de Casteljau's steps: the tangents are thirds of the way to the inner points.
Value cubic(const Track& track, std::size_t key, double share, double span) {
  const Value a = partOf(track, key, 1);
  const Value out = partOf(track, key, 2);
  const Value in = partOf(track, key + 1, 0);
  const Value b = partOf(track, key + 1, 1);
  Value value(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::array<double, 4> points{a[i], a[i] + out[i] * span / 3.0, b[i] - in[i] * span / 3.0, b[i]};
    for (std::size_t level = 3; level > 0; --level) {
      for (std::size_t p = 0; p < level; ++p) {
        points[p] = (1.0 - share) * points[p] + share * points[p + 1];
      }
    }
    value[i] = points[0];
  }
  return value;
}

Value expectedAt(const Track& track, double time) {
  std::size_t key = 0;
  while (key + 1 < track.times.size() && static_cast<double>(track.times[key + 1]) <= time) {
    ++key;
  }
  const auto start = static_cast<double>(track.times[key]);
  Value value = partOf(track, key, 1);
  if (time > start && key + 1 < track.times.size() && track.interpolation != Interpolation::step) {
    const double span = static_cast<double>(track.times[key + 1]) - start;
    const double share = (time - start) / span;
    if (track.interpolation == Interpolation::cubicSpline) {
      value = cubic(track, key, share, span);
    } else if (track.channel == Channel::rotation) {
      value = arc(value, partOf(track, key + 1, 1), share);
    } else {
      const Value next = partOf(track, key + 1, 1);
      for (std::size_t i = 0; i < value.size(); ++i) {
        value[i] = (1.0 - share) * value[i] + share * next[i];
      }
    }
  }
  return track.channel == Channel::rotation ? unit(value) : value;
}

constexpr std::array channels{Channel::translation, Channel::rotation, Channel::scale, Channel::weights};
constexpr std::array interpolations{Interpolation::step, Interpolation::linear, Interpolation::cubicSpline};

Quat turnBy(Chance& chance) {
  return glm::normalize(
      Quat(chance.between(-1, 1), chance.between(-1, 1), chance.between(-1, 1), chance.between(-1, 1)));
}

Scene treeOf(Chance& chance, std::size_t nodes) {
  Scene scene;
  for (std::size_t i = 0; i < nodes; ++i) {
    const NodeIndex parent = i == 0 || chance.below(5) == 0 ? NodeIndex::none : NodeIndex(chance.below(i));
    const NodeIndex node =
        test::addNode(scene, "node", parent, Vec3(chance.between(-1, 1), 0.5, chance.between(-2, 2)));
    scene.nodes[at(node)].rest.rotation = turnBy(chance);
    scene.nodes[at(node)].rest.scale = Vec3(chance.between(0.5, 2), 1.0, chance.between(-2, -0.5));
    if (chance.below(4) == 0) {
      Mat4 matrix = toMatrix(scene.nodes[at(node)].rest);
      matrix[1][0] += 0.3; // sheared: no three parts say it
      scene.nodes[at(node)].matrix = matrix;
    }
    if (chance.below(3) == 0) {
      scene.nodes[at(node)].morphWeights = {0.25F, 0.5F, 0.75F, 0.1F, 0.9F};
    }
  }
  return scene;
}

Clip clipOf(Chance& chance, std::size_t nodes) {
  Clip clip;
  for (std::size_t node = 0; node < nodes; ++node) {
    for (const Channel channel : channels) {
      if (chance.below(3) == 0) {
        Track track = trackOf(chance, channel, interpolations.at(chance.below(3)), 1 + chance.below(5));
        track.node = NodeIndex(node);
        clip.tracks.emplace_back(std::move(track));
      }
    }
  }
  return clip;
}

double farthest(const Mat4& a, const Mat4& b) {
  double most = 0.0;
  for (glm::length_t column = 0; column < 4; ++column) {
    most = std::max(most, glm::length(a[column] - b[column]));
  }
  return most;
}

} // namespace

TEST_CASE("A track by chance has, at any time, the value that the specification's formulas give") {
  Chance chance(21);
  for (int round = 0; round < 120; ++round) {
    const Track track =
        trackOf(chance, channels.at(static_cast<std::size_t>(round) % 4),
                interpolations.at(static_cast<std::size_t>(round) / 4 % 3), 1 + chance.below(6));
    std::vector<double> times{-10.0, 10.0};
    for (const float key : track.times) {
      times.push_back(static_cast<double>(key));
      times.push_back(static_cast<double>(key) + chance.between(0.0, 0.7));
      times.push_back(static_cast<double>(key) - 1e-9);
    }
    for (const double time : times) {
      Value is(static_cast<std::size_t>(track.width));
      sampleTrack(track, time, is.data());
      const Value wanted = expectedAt(track, time);
      CAPTURE(round, time);
      double most = 0.0;
      for (std::size_t i = 0; i < is.size(); ++i) {
        most = std::max(most, std::abs(is[i] - wanted[i]));
      }
      CHECK(most < 1e-9);
    }
  }
}

TEST_CASE("A turn of no length is none, at a key and between two") {
  const Track track{
      NodeIndex(0), Channel::rotation, Interpolation::linear, 4, {0, 1}, {0, 0, 0, 0, 0, 0, 0, 0}, -1};
  for (const double time : {0.0, 0.4, 1.0}) {
    Value is(4);
    sampleTrack(track, time, is.data());
    CHECK(is == Value{0, 0, 0, 1});
  }
}

TEST_CASE("In a clip's pose each node has what its tracks say, and what it has at rest beside") {
  Chance chance(22);
  for (int round = 0; round < 12; ++round) {
    const Scene scene = treeOf(chance, 8);
    const Clip clip = clipOf(chance, 8);
    const double time = chance.between(-0.5, 2.0);
    const Pose pose = samplePose(scene, clip, time);
    REQUIRE(pose.locals.size() == 8);
    for (std::size_t node = 0; node < 8; ++node) {
      Transform local = scene.nodes[node].rest;
      std::vector<float> weights = scene.nodes[node].morphWeights;
      bool usesMatrix = scene.nodes[node].matrix.has_value();
      for (const CopyOnWrite<Track>& track : clip.tracks) {
        if (at(track->node) != node) {
          continue;
        }
        const Value value = expectedAt(*track, time);
        usesMatrix = usesMatrix && track->channel == Channel::weights;
        switch (track->channel) {
        case Channel::translation:
          local.translation = Vec3(value[0], value[1], value[2]);
          break;
        case Channel::scale:
          local.scale = Vec3(value[0], value[1], value[2]);
          break;
        case Channel::rotation:
          local.rotation = Quat(value[3], value[0], value[1], value[2]);
          break;
        case Channel::weights:
          weights.assign(value.begin(), value.end());
        }
      }
      CHECK(glm::distance(pose.locals[node].translation, local.translation) < 1e-9);
      CHECK(glm::distance(pose.locals[node].scale, local.scale) < 1e-9);
      CHECK(glm::length(pose.locals[node].rotation - local.rotation) < 1e-9);
      CHECK(pose.usesMatrix[node] == usesMatrix);
      REQUIRE(pose.weights[node].size() == weights.size());
      for (std::size_t i = 0; i < weights.size(); ++i) {
        CHECK(pose.weights[node][i] == Approx(weights[i]).margin(1e-6));
      }
      const Mat4 wanted = usesMatrix ? *scene.nodes[node].matrix : toMatrix(local);
      CHECK(farthest(localMatrix(scene, pose, NodeIndex(node)), wanted) < 1e-9);
    }
  }
}

TEST_CASE("A node's place in the world is the product of all on its way to the root") {
  Chance chance(23);
  for (int round = 0; round < 12; ++round) {
    const Scene scene = treeOf(chance, 12);
    const Pose pose = round % 2 == 0 ? restPose(scene) : samplePose(scene, clipOf(chance, 12), 0.3);
    const std::vector<Mat4> worlds = worldMatrices(scene, pose);
    for (std::size_t node = 0; node < 12; ++node) {
      Mat4 wanted(1.0);
      for (NodeIndex above(node); above.exists(); above = scene.nodes[at(above)].parent) {
        wanted = localMatrix(scene, pose, above) * wanted;
      }
      CHECK(farthest(worlds[node], wanted) < 1e-9);
    }
  }
}

TEST_CASE("A matrix of parts by chance, mirrored or not, comes apart into parts that make it again") {
  Chance chance(24);
  for (int round = 0; round < 200; ++round) {
    Transform made{Vec3(chance.between(-3, 3), chance.between(-3, 3), chance.between(-3, 3)), turnBy(chance),
                   Vec3(chance.between(0.1, 4), chance.between(0.1, 4), chance.between(0.1, 4))};
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      made.scale[axis] *= chance.below(2) == 0 ? 1.0 : -1.0;
    }
    const Mat4 matrix = toMatrix(made);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      Vec3 unitAxis(0.0);
      unitAxis[axis] = made.scale[axis];
      CHECK(glm::distance(Vec3(matrix[axis]), made.rotation * unitAxis) < 1e-9);
    }
    CHECK(Vec3(matrix[3]) == made.translation);
    const Transform found = toTransform(matrix);
    CHECK(farthest(toMatrix(found), matrix) < 1e-9);
    CHECK(found.scale.y > 0.0);
    CHECK(found.scale.z > 0.0);
    CHECK((found.scale.x < 0.0) == (made.scale.x * made.scale.y * made.scale.z < 0.0));
    CHECK(angleBetween(rotationOf(matrix), found.rotation) < 1e-7);
  }
}
