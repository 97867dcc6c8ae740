#include "skinning/bind/bind_weights.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <queue>

#include "skinning/bind/voxel_body.h"
#include "skinning/weights/geodesic_weights.h"

namespace stretch::skinning {

namespace {

struct Segment {
  std::uint16_t joint = 0;
  Vec3 start{0.0};
  Vec3 end{0.0};
};

// How far a line runs inside the body.
double lengthInside(const VoxelBody& body, const Vec3& start, const Vec3& direction, double most) {
  double length = 0.0;
  while (length < most && body.cellAt[body.grid.indexOf(body.grid.placeOf(start + direction * length))] >= 0) {
    length += 0.5 * body.grid.size;
  }
  return length;
}

// From each joint to each of its children; a last joint goes on as its bone came, to the end of the body.
std::vector<Segment> segmentsOf(const VoxelBody& body, const std::vector<BindJoint>& joints) {
  std::vector<Segment> segments;
  const double LEAST = std::getenv("LEAST") ? std::atof(std::getenv("LEAST")) : 0.0;
  const double SHARE = std::getenv("SHARE") ? std::atof(std::getenv("SHARE")) : 0.8;
  const double longest = body.grid.size * *std::max_element(body.grid.counts.begin(), body.grid.counts.end());
  std::vector<int> children(joints.size(), 0);
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    const int parent = joints[joint].parent;
    if (parent >= 0) {
      ++children[static_cast<std::size_t>(parent)];
      segments.push_back({static_cast<std::uint16_t>(parent), joints[static_cast<std::size_t>(parent)].place, joints[joint].place});
    }
  }
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    if (children[joint] == 0) {
      const int parent = joints[joint].parent;
      const Vec3 along = parent < 0 ? Vec3(0.0) : joints[joint].place - joints[static_cast<std::size_t>(parent)].place;
      segments.push_back({static_cast<std::uint16_t>(joint), joints[joint].place, joints[joint].place + along * (glm::length(along) > 0.0 ? std::max(LEAST, SHARE * lengthInside(body, joints[joint].place, glm::normalize(along), 0.25 * longest) / glm::length(along)) : 0.0)});
    }
  }
  return segments;
}

struct Seed {
  std::size_t cell = 0;
  std::uint16_t joint = 0;
  double distance = 0.0;
};

std::vector<Seed> seedsOf(const VoxelBody& body, const std::vector<Segment>& segments) {
  std::vector<Seed> seeds;
  constexpr int around = 3;
  for (const Segment& segment : segments) {
    const double length = glm::distance(segment.start, segment.end);
    const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * length / body.grid.size)));
    for (int i = 0; i <= steps; ++i) {
      const Vec3 point = glm::mix(segment.start, segment.end, static_cast<double>(i) / steps);
      const std::int32_t cell = body.cellNear(point, around);
      if (cell >= 0) {
        const auto c = static_cast<std::size_t>(cell);
        seeds.push_back({c, segment.joint, glm::distance(point, body.grid.middleOf(body.grid.placeOfIndex(body.cubeOf[c])))});
      }
    }
  }
  return seeds;
}

// Half the body's thickness along each joint's bones: the median depth of the cells that they pass.
std::vector<double> radiiOf(const VoxelBody& body, const std::vector<Seed>& seeds, std::size_t joints) {
  std::vector<std::vector<double>> depths(joints);
  for (const Seed& seed : seeds) {
    depths[seed.joint].push_back(static_cast<double>(body.depths[seed.cell]));
  }
  std::vector<double> radii(joints, body.grid.size);
  for (std::size_t joint = 0; joint < joints; ++joint) {
    auto& known = depths[joint];
    if (!known.empty()) {
      std::nth_element(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2), known.end());
      radii[joint] = known[known.size() / 2];
    }
  }
  return radii;
}

template <typename Visit>
void eachNeighbour(const VoxelBody& body, std::size_t cell, Visit&& visit) {
  const std::array<int, 3> place = body.grid.placeOfIndex(body.cubeOf[cell]);
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const int steps = x * x + y * y + z * z;
        const std::int32_t next = body.cellAt[body.grid.indexOf({place[0] + x, place[1] + y, place[2] + z})];
        if (steps > 0 && next >= 0) {
          visit(static_cast<std::size_t>(next), steps);
        }
      }
    }
  }
}

constexpr std::uint16_t nobody = std::numeric_limits<std::uint16_t>::max();

std::vector<std::uint16_t> regionsOf(const VoxelBody& body, const std::vector<Seed>& seeds, const std::vector<double>& radii,
                                     double regions) {
  std::vector<double> distances(body.cellCount(), std::numeric_limits<double>::max());
  std::vector<std::uint16_t> owners(body.cellCount(), nobody);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (const Seed& seed : seeds) {
    const double distance = seed.distance - regions * radii[seed.joint];
    if (distance < distances[seed.cell]) {
      distances[seed.cell] = distance;
      owners[seed.cell] = seed.joint;
      open.emplace(distance, static_cast<std::uint32_t>(seed.cell));
    }
  }
  const std::array<double, 4> lengths{0.0, body.grid.size, body.grid.size * std::sqrt(2.0), body.grid.size * std::sqrt(3.0)};
  while (!open.empty()) {
    const auto [distance, cell] = open.top();
    open.pop();
    if (distance > distances[cell]) {
      continue;
    }
    eachNeighbour(body, cell, [&, from = distance, owner = owners[cell]](std::size_t next, int steps) {
      const double reached = from + lengths[static_cast<std::size_t>(steps)];
      if (reached < distances[next]) {
        distances[next] = reached;
        owners[next] = owner;
        open.emplace(reached, static_cast<std::uint32_t>(next));
      }
    });
  }
  return owners;
}

struct CellWeights {
  static constexpr std::size_t capacity = 6;
  std::array<std::uint16_t, capacity> joints{};
  std::array<float, capacity> weights{};
};

void add(std::map<std::uint16_t, double>& sum, const CellWeights& cell, double factor) {
  for (std::size_t i = 0; i < CellWeights::capacity; ++i) {
    if (cell.weights[i] > 0.0F) {
      sum[cell.joints[i]] += factor * static_cast<double>(cell.weights[i]);
    }
  }
}

struct SmallSum {
  std::array<std::uint16_t, 48> joints{};
  std::array<float, 48> weights{};
  std::size_t count = 0;
  void add(std::uint16_t joint, float weight) {
    for (std::size_t i = 0; i < count; ++i) {
      if (joints[i] == joint) { weights[i] += weight; return; }
    }
    if (count < joints.size()) { joints[count] = joint; weights[count++] = weight; }
  }
};

CellWeights strongest(SmallSum& sum) {
  CellWeights kept;
  float total = 0.0F;
  for (std::size_t k = 0; k < CellWeights::capacity; ++k) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < sum.count; ++i) {
      if (sum.weights[i] > sum.weights[best]) { best = i; }
    }
    if (sum.count == 0 || sum.weights[best] <= 0.0F) { break; }
    kept.joints[k] = sum.joints[best];
    kept.weights[k] = sum.weights[best];
    total += sum.weights[best];
    sum.weights[best] = 0.0F;
  }
  for (float& weight : kept.weights) { weight /= total > 0.0F ? total : 1.0F; }
  return kept;
}

std::vector<CellWeights> blended(const VoxelBody& body, const std::vector<std::uint16_t>& owners, const std::vector<double>& radii,
                                 double blend) {
  std::vector<CellWeights> now(body.cellCount());
  std::vector<float> rates(body.cellCount(), 0.0F);
  double widest = 0.0;
  for (const std::uint16_t owner : owners) {
    if (owner != nobody) { widest = std::max(widest, radii[owner]); }
  }
  if (widest <= 0.0) { return now; }
  // Spread of one step: variance 2 a h^2 with a = 1/7 for each of six neighbours.
  const double sigma = blend * widest / body.grid.size;
  const int steps = std::clamp(static_cast<int>(std::ceil(sigma * sigma * 3.5)), 1, 400);
  const double most = sigma * sigma / (2.0 * steps);
  for (std::size_t cell = 0; cell < owners.size(); ++cell) {
    if (owners[cell] != nobody) {
      now[cell].joints[0] = owners[cell];
      now[cell].weights[0] = 1.0F;
      const double part = radii[owners[cell]] / widest;
      rates[cell] = static_cast<float>(most * part * part);
    }
  }
  std::vector<std::array<std::int32_t, 6>> neighbours(body.cellCount());
  for (std::size_t cell = 0; cell < owners.size(); ++cell) {
    const std::array<int, 3> p = body.grid.placeOfIndex(body.cubeOf[cell]);
    neighbours[cell] = {body.cellAt[body.grid.indexOf({p[0] + 1, p[1], p[2]})], body.cellAt[body.grid.indexOf({p[0] - 1, p[1], p[2]})],
                        body.cellAt[body.grid.indexOf({p[0], p[1] + 1, p[2]})], body.cellAt[body.grid.indexOf({p[0], p[1] - 1, p[2]})],
                        body.cellAt[body.grid.indexOf({p[0], p[1], p[2] + 1})], body.cellAt[body.grid.indexOf({p[0], p[1], p[2] - 1})]};
  }
  std::vector<CellWeights> next = now;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t cell = 0; cell < owners.size(); ++cell) {
      SmallSum sum;
      float kept = 1.0F;
      bool isPlain = now[cell].weights[0] == 1.0F;
      for (const std::int32_t n : neighbours[cell]) {
        if (n < 0) { continue; }
        const CellWeights& other = now[static_cast<std::size_t>(n)];
        isPlain = isPlain && other.weights[0] == 1.0F && other.joints[0] == now[cell].joints[0];
      }
      if (isPlain) { next[cell] = now[cell]; continue; }
      for (const std::int32_t n : neighbours[cell]) {
        if (n < 0) { continue; }
        const float rate = 0.5F * (rates[cell] + rates[static_cast<std::size_t>(n)]);
        kept -= rate;
        const CellWeights& other = now[static_cast<std::size_t>(n)];
        for (std::size_t i = 0; i < CellWeights::capacity && other.weights[i] > 0.0F; ++i) { sum.add(other.joints[i], rate * other.weights[i]); }
      }
      for (std::size_t i = 0; i < CellWeights::capacity && now[cell].weights[i] > 0.0F; ++i) { sum.add(now[cell].joints[i], kept * now[cell].weights[i]); }
      next[cell] = strongest(sum);
    }
    std::swap(now, next);
  }
  return now;
}

// What a point between the middles of cells follows.
std::vector<double> weightsAt(const VoxelBody& body, const std::vector<CellWeights>& cells, const Vec3& point, std::size_t joints) {
  std::map<std::uint16_t, double> sum;
  const Vec3 local = (point - body.grid.origin) / body.grid.size - 0.5;
  const Vec3 base = glm::floor(local);
  const Vec3 part = local - base;
  for (int corner = 0; corner < 8; ++corner) {
    const std::array<int, 3> place{static_cast<int>(base.x) + (corner & 1), static_cast<int>(base.y) + ((corner >> 1) & 1),
                                   static_cast<int>(base.z) + ((corner >> 2) & 1)};
    const double factor = ((corner & 1) != 0 ? part.x : 1.0 - part.x) * ((corner & 2) != 0 ? part.y : 1.0 - part.y) *
                          ((corner & 4) != 0 ? part.z : 1.0 - part.z);
    const std::int32_t cell = body.cellAt[body.grid.indexOf(place)];
    if (cell >= 0 && factor > 0.0) { add(sum, cells[static_cast<std::size_t>(cell)], factor); }
  }
  if (sum.empty()) {
    const std::int32_t cell = body.cellNear(point, 3);
    if (cell >= 0) { add(sum, cells[static_cast<std::size_t>(cell)], 1.0); }
  }
  std::vector<double> weights(joints, 0.0);
  for (const auto& [joint, weight] : sum) { weights[joint] = weight; }
  return weights;
}

// Shells of the mesh: vertices joined by triangles, or at one place.
std::vector<std::size_t> shellsOf(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles) {
  std::vector<std::size_t> parent(positions.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t v) {
    while (parent[v] != v) { parent[v] = parent[parent[v]]; v = parent[v]; }
    return v;
  };
  std::map<std::array<float, 3>, std::size_t> places;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto [found, isNew] = places.try_emplace({positions[v].x, positions[v].y, positions[v].z}, v);
    if (!isNew) { parent[root(v)] = root(found->second); }
  }
  for (const Triangle& t : triangles) {
    parent[root(t[0])] = root(t[1]);
    parent[root(t[1])] = root(t[2]);
  }
  for (std::size_t v = 0; v < positions.size(); ++v) { parent[v] = root(v); }
  return parent;
}

// Whether a point lies within triangles: by most of three lines through it.
bool liesWithin(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles, const Vec3& point) {
  int votes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    int above = 0;
    int all = 0;
    for (const Triangle& t : triangles) {
      const Vec3 p0(positions[t[0]]);
      const Vec3 p1(positions[t[1]]);
      const Vec3 p2(positions[t[2]]);
      const double area = (p1[a] - p0[a]) * (p2[b] - p0[b]) - (p1[b] - p0[b]) * (p2[a] - p0[a]);
      if (area == 0.0) { continue; }
      const double u = ((point[a] - p0[a]) * (p2[b] - p0[b]) - (point[b] - p0[b]) * (p2[a] - p0[a])) / area;
      const double v = ((p1[a] - p0[a]) * (point[b] - p0[b]) - (p1[b] - p0[b]) * (point[a] - p0[a])) / area;
      if (u >= 0.0 && v >= 0.0 && u + v <= 1.0) {
        ++all;
        above += p0[axis] * (1.0 - u - v) + p1[axis] * u + p2[axis] * v > point[axis] ? 1 : 0;
      }
    }
    votes += all % 2 == 0 && above % 2 == 1 ? 1 : 0;
  }
  return votes >= 2;
}

// A shell in which one bone runs is a piece of its own and moves as one; so does a small one in which none does.
void stiffenShells(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                   const std::vector<Segment>& segments, double share, std::vector<std::vector<double>>& weights) {
  const std::vector<std::size_t> shells = shellsOf(positions, triangles);
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t v = 0; v < positions.size(); ++v) { members[shells[v]].push_back(v); }
  if (members.size() < 2) { return; }
  std::map<std::size_t, std::vector<Triangle>> faces;
  glm::vec3 low = positions[0];
  glm::vec3 high = positions[0];
  for (const glm::vec3& p : positions) { low = glm::min(low, p); high = glm::max(high, p); }
  const float height = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  for (const Triangle& t : triangles) { faces[shells[t[0]]].push_back(t); }
  const double AGREE = std::getenv("AGREE") ? std::atof(std::getenv("AGREE")) : 0.4;
  const double RUN = std::getenv("RUN") ? std::atof(std::getenv("RUN")) : 0.2;
  const std::size_t joints = weights.front().size();
  for (const auto& [shell, vertices] : members) {
    glm::vec3 lowest = positions[vertices[0]];
    glm::vec3 highest = lowest;
    for (const std::size_t v : vertices) { lowest = glm::min(lowest, positions[v]); highest = glm::max(highest, positions[v]); }
    const glm::vec3 extent = highest - lowest;
    std::vector<double> inside(joints, 0.0);
    std::vector<double> whole(joints, 0.0);
    for (const Segment& s : segments) {
      constexpr int samples = 12;
      const double length = glm::distance(s.start, s.end) / samples;
      for (int i = 0; i < samples; ++i) {
        const Vec3 point = glm::mix(s.start, s.end, (i + 0.5) / samples);
        whole[s.joint] += length;
        if (glm::all(glm::greaterThan(point, Vec3(lowest))) && glm::all(glm::lessThan(point, Vec3(highest))) && liesWithin(positions, faces[shell], point)) {
          inside[s.joint] += length;
        }
      }
    }
    std::vector<double> sum(joints, 0.0);
    for (const std::size_t v : vertices) {
      for (std::size_t j = 0; j < joints; ++j) { sum[j] += weights[v][j]; }
    }
    const double total = std::accumulate(sum.begin(), sum.end(), 0.0);
    int running = 0;
    std::size_t owner = 0;
    for (std::size_t j = 0; j < joints; ++j) {
      const double enough = std::min(0.2 * whole[j], RUN * static_cast<double>(std::max({extent.x, extent.y, extent.z})));
      if (inside[j] > 0.0 && inside[j] > enough) { ++running; owner = j; }
    }
    const auto best = static_cast<std::size_t>(std::max_element(sum.begin(), sum.end()) - sum.begin());
    std::vector<double> piece(joints, 0.0);
    if (running == 1 && sum[owner] > AGREE * total) {
      piece[owner] = 1.0;
    } else if (running == 0 && std::max({extent.x, extent.y, extent.z}) < 0.2F * height) {
      for (std::size_t j = 0; j < joints; ++j) { piece[j] = sum[j] / total; }
    } else if (running == 0 && sum[best] > share * total) {
      piece[best] = 1.0;
    } else {
      continue;
    }
    for (const std::size_t v : vertices) { weights[v] = piece; }
  }
}

} // namespace

Result<std::vector<Influences>> bindWeights(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                                            const std::vector<BindJoint>& joints, const BindSettings& settings) {
  const Result<VoxelBody> body = voxelBody(positions, triangles, settings.cubesAlong);
  if (!body) { return body.error(); }
  const std::vector<Segment> segments = segmentsOf(*body, joints);
  const std::vector<Seed> seeds = seedsOf(*body, segments);
  const std::vector<double> radii = radiiOf(*body, seeds, joints.size());
  if (std::getenv("RADII")) { for (std::size_t j = 0; j < joints.size(); ++j) { double l = 0; int n = 0; for (const Segment& s : segments) if (s.joint == j) { l += glm::distance(s.start, s.end); ++n; } std::printf("joint %zu r %.3f l %.3f r/l %.2f n %d\n", j, radii[j] , l / n, radii[j] / (l / n), n); } }
  std::vector<std::uint16_t> owners = regionsOf(*body, seeds, radii, settings.regions);
  // What no bone reaches inside follows the nearest one in space.
  for (std::size_t cell = 0; cell < owners.size(); ++cell) {
    if (owners[cell] == nobody) {
      const Vec3 middle = body->grid.middleOf(body->grid.placeOfIndex(body->cubeOf[cell]));
      double nearest = std::numeric_limits<double>::max();
      for (const Segment& s : segments) {
        const Vec3 d = s.end - s.start;
        const double l = glm::dot(d, d);
        const double t = l > 0.0 ? std::clamp(glm::dot(middle - s.start, d) / l, 0.0, 1.0) : 0.0;
        const double distance = glm::distance(middle, s.start + t * d) - settings.regions * radii[s.joint];
        if (distance < nearest) { nearest = distance; owners[cell] = s.joint; }
      }
    }
  }
  const std::vector<CellWeights> cells = blended(*body, owners, radii, settings.blend);
  std::vector<std::vector<double>> weights(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) { weights[v] = weightsAt(*body, cells, Vec3(positions[v]), joints.size()); }
  stiffenShells(positions, triangles, segments, settings.shells, weights);
  std::vector<Influences> influences;
  influences.reserve(positions.size());
  for (const std::vector<double>& w : weights) { influences.push_back(strongestFour(w)); }
  return influences;
}

} // namespace stretch::skinning
