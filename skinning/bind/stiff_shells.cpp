#include "skinning/bind/stiff_shells.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <tbb/parallel_for.h>

#include "core/base/disjoint_sets.h"
#include "skinning/bind/points_within.h"
#include "skinning/bind/skeleton_ways.h"
#include "skinning/bind/weight_row.h"

namespace stretch::skinning {

namespace {

struct ShellBox {
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};

  void take(const glm::vec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  [[nodiscard]] glm::vec3 middle() const { return 0.5F * (low + high); }
  [[nodiscard]] double longest() const {
    const glm::vec3 extent = high - low;
    return static_cast<double>(std::max({extent.x, extent.y, extent.z}));
  }
};

struct Shell {
  std::vector<std::size_t> vertices;
  ShellBox box;
  std::map<std::uint16_t, double> inside; // by joint: how much of its bones runs in the shell
};

std::vector<Shell> collect(std::span<const glm::vec3> positions, const std::vector<std::size_t>& numbers) {
  std::vector<Shell> shells(numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end()) + 1);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    shells[numbers[v]].vertices.push_back(v);
    shells[numbers[v]].box.take(positions[v]);
  }
  return shells;
}

constexpr std::size_t samplesOfBone = 12;

// Which shells points along all bones lie within: samplesOfBone for each line.
std::vector<std::vector<std::size_t>> shellsAlongBones(std::span<const glm::vec3> positions,
                                                       const std::vector<Triangle>& triangles,
                                                       const std::vector<std::size_t>& numbers,
                                                       const std::vector<BoneLine>& lines) {
  std::vector<Vec3> points;
  for (const BoneLine& line : lines) {
    for (std::size_t i = 0; i < samplesOfBone; ++i) {
      points.push_back(glm::mix(line.start, line.end, (static_cast<double>(i) + 0.5) / samplesOfBone));
    }
  }
  return shellsAround(positions, triangles, numbers, points);
}

// How much of each joint's bones runs in each shell; answers how long they are.
std::vector<double> measureBones(const std::vector<std::vector<std::size_t>>& around,
                                 const std::vector<BoneLine>& lines, std::size_t joints,
                                 std::vector<Shell>& shells) {
  std::vector<double> whole(joints, 0.0);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const BoneLine& line = lines[i / samplesOfBone];
    const double length = glm::distance(line.start, line.end) / samplesOfBone;
    whole[line.joint] += length;
    for (const std::size_t shell : around[i]) {
      shells[shell].inside[line.joint] += length;
    }
  }
  return whole;
}

// Joints whose bones run in the shell: with a part of their length, or for a part of the shell's.
std::vector<std::uint16_t> runningIn(const Shell& shell, const std::vector<double>& whole) {
  constexpr double partOfBone = 0.2;
  constexpr double partOfShell = 0.1;
  std::vector<std::uint16_t> running;
  for (const auto& [joint, length] : shell.inside) {
    if (length > std::min(partOfBone * whole[joint], partOfShell * shell.box.longest())) {
      running.push_back(joint);
    }
  }
  return running;
}

Influences aloneOn(std::uint16_t joint) {
  Influences row;
  row.bones[0] = joint;
  row.weights[0] = 1.0F;
  return row;
}

// For each shell without bones of its own the shell with bones that it sits in, with a fifth of its vertices
// or more: the head of an ear.
std::vector<const Shell*> hostsOf(std::span<const glm::vec3> positions,
                                  const std::vector<Triangle>& triangles,
                                  const std::vector<std::size_t>& numbers, const std::vector<Shell>& shells) {
  constexpr std::size_t most = 64; // vertices of a shell that are looked at
  constexpr double least = 0.2;
  constexpr float inwards = 0.03F; // off the edges of a host that is built on the same lattice
  std::vector<Vec3> points;
  std::vector<std::size_t> guests;
  std::vector<std::size_t> looked(shells.size(), 0);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const std::vector<std::size_t>& vertices = shells[i].vertices;
    const std::size_t step = std::max<std::size_t>(1, vertices.size() / most);
    for (std::size_t v = 0; shells[i].inside.empty() && v < vertices.size(); v += step) {
      const glm::vec3 middle = shells[i].box.middle();
      points.emplace_back(glm::mix(positions[vertices[v]], middle, inwards));
      guests.push_back(i);
      ++looked[i];
    }
  }
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> counts; // by guest and host
  const auto around = shellsAround(positions, triangles, numbers, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const std::size_t host : around[i]) {
      counts[{guests[i], host}] += shells[host].inside.empty() ? 0 : 1;
    }
  }
  std::vector<const Shell*> hosts(shells.size(), nullptr);
  std::vector<std::size_t> best(shells.size(), 0);
  for (const auto& [pair, count] : counts) {
    const auto [guest, host] = pair;
    if (count > best[guest] && static_cast<double>(count) >= least * static_cast<double>(looked[guest])) {
      best[guest] = count;
      hosts[guest] = &shells[host];
    }
  }
  return hosts;
}

// Of what a shell follows only joints whose bones run in its host; if that is hardly anything, the nearest of
// them.
Influences withHost(const WeightSum& mean, const Shell& host, const std::vector<BoneLine>& lines,
                    const Vec3& middle) {
  constexpr double enough = 0.2;
  WeightSum kept;
  double total = 0.0;
  for (const auto& [joint, length] : host.inside) {
    kept.add(joint, mean.of(joint));
    total += mean.of(joint);
  }
  if (total > enough) {
    return kept.strongest(Influences::capacity);
  }
  std::vector<std::size_t> among;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    if (host.inside.contains(lines[line].joint)) {
      among.push_back(line);
    }
  }
  return aloneOn(lines[nearestOnBones(lines, among, middle).first.line].joint);
}

// The one row that all of the shell follows; none: it bends.
std::optional<Influences> asOnePiece(const Shell& shell, const Shell* host,
                                     const std::vector<std::uint16_t>& running,
                                     const std::vector<BoneLine>& lines, double bodyLength,
                                     const std::vector<Influences>& weights) {
  WeightSum mean;
  for (const std::size_t v : shell.vertices) {
    mean.add(weights[v], 1.0 / static_cast<double>(shell.vertices.size()));
  }
  constexpr double agreeing = 0.4; // of the shell follows the bone that runs in it
  if (running.size() == 1 && mean.of(running.front()) > agreeing) {
    return aloneOn(running.front());
  }
  if (!running.empty()) {
    return std::nullopt;
  }
  constexpr double small = 0.2; // of the body
  if (shell.box.longest() < small * bodyLength) {
    return host == nullptr ? mean.strongest(Influences::capacity)
                           : withHost(mean, *host, lines, Vec3(shell.box.middle()));
  }
  constexpr double ruling = 0.6;
  const std::uint16_t best = mean.strongest(1).bones[0];
  return mean.of(best) > ruling ? std::optional(aloneOn(best)) : std::nullopt;
}

// Takes from vertices what they follow of bones that run in other shells alone where they are nearest: the
// head does not follow an arm beside it, the sleeve not the chest.
class Outsiders {
public:
  Outsiders(const std::vector<BoneLine>& lines, const std::vector<std::vector<std::size_t>>& around)
      : lines_(lines), around_(around) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      ofJoint_.resize(std::max<std::size_t>(ofJoint_.size(), lines[i].joint + std::size_t{1}));
      ofJoint_[lines[i].joint].push_back(i);
    }
  }

  [[nodiscard]] Influences without(const Influences& row, const Vec3& place, std::size_t shell) const {
    WeightSum kept;
    double total = 0.0;
    for (std::size_t i = 0; i < Influences::capacity && row.weights[i] > 0.0F; ++i) {
      if (!runsElsewhere(row.bones[i], place, shell)) {
        kept.add(row.bones[i], static_cast<double>(row.weights[i]));
        total += static_cast<double>(row.weights[i]);
      }
    }
    constexpr double enough = 0.02;
    return total > enough ? kept.strongest(Influences::capacity) : row;
  }

private:
  [[nodiscard]] bool runsElsewhere(std::uint16_t joint, const Vec3& place, std::size_t shell) const {
    const auto [on, distance] = nearestOnBones(lines_, ofJoint_[joint], place);
    const auto sample = std::min(static_cast<std::size_t>(on.along * samplesOfBone), samplesOfBone - 1);
    const std::size_t first = on.line * samplesOfBone;
    bool isInAny = false;
    for (std::size_t i = std::max<std::size_t>(sample, 1) - 1; i <= std::min(sample + 1, samplesOfBone - 1);
         ++i) {
      isInAny = isInAny || !around_[first + i].empty();
      if (std::ranges::find(around_[first + i], shell) != around_[first + i].end()) {
        return false;
      }
    }
    return isInAny;
  }

  const std::vector<BoneLine>& lines_;
  const std::vector<std::vector<std::size_t>>& around_;
  std::vector<std::vector<std::size_t>> ofJoint_;
};

// How much of the mesh follows each joint.
std::vector<double> followers(const std::vector<Influences>& weights, std::size_t joints) {
  std::vector<double> sums(joints, 0.0);
  for (const Influences& row : weights) {
    for (std::size_t i = 0; i < Influences::capacity; ++i) {
      sums[row.bones[i]] += static_cast<double>(row.weights[i]);
    }
  }
  return sums;
}

using Joints = std::set<std::uint16_t>;

bool areNext(const std::vector<BoneLine>& lines, std::uint16_t a, std::uint16_t b) {
  return std::ranges::any_of(lines, [&](const BoneLine& line) {
    return (line.joint == a && line.endJoint == b) || (line.joint == b && line.endJoint == a);
  });
}

// Joints that a small part of the shell follows, that have most of their followers in other shells, and that
// are next to none which the shell follows in earnest.
Joints guestsOf(const Shell& shell, const std::vector<double>& all, const std::vector<BoneLine>& lines,
                const std::vector<Influences>& weights) {
  constexpr double partOfJoint = 0.25;
  constexpr double partOfShell = 0.4;
  WeightSum here;
  Joints followed;
  for (const std::size_t v : shell.vertices) {
    here.add(weights[v], 1.0);
    followed.insert(weights[v].bones.begin(), weights[v].bones.end());
  }
  Joints own;
  std::ranges::copy_if(followed, std::inserter(own, own.end()), [&](std::uint16_t joint) {
    return here.of(joint) > 0.0 &&
           (here.of(joint) >= partOfJoint * all[joint] ||
            here.of(joint) >= partOfShell * static_cast<double>(shell.vertices.size()));
  });
  std::erase_if(followed, [&](std::uint16_t joint) {
    return own.contains(joint) ||
           std::ranges::any_of(own, [&](std::uint16_t other) { return areNext(lines, joint, other); });
  });
  return followed;
}

void dropGuests(const Shell& shell, const Joints& guests, std::vector<Influences>& weights) {
  for (const std::size_t v : shell.vertices) {
    WeightSum kept;
    double total = 0.0;
    for (std::size_t i = 0; i < Influences::capacity; ++i) {
      if (!guests.contains(weights[v].bones[i])) {
        kept.add(weights[v].bones[i], static_cast<double>(weights[v].weights[i]));
        total += static_cast<double>(weights[v].weights[i]);
      }
    }
    constexpr double enough = 0.02;
    if (total > enough) {
      weights[v] = kept.strongest(Influences::capacity);
    }
  }
}

} // namespace

std::vector<std::size_t> shellsOf(const std::vector<std::uint32_t>& welded,
                                  const std::vector<Triangle>& triangles) {
  DisjointSets sets(welded.size());
  for (std::uint32_t v = 0; v < welded.size(); ++v) {
    sets.join(v, welded[v]);
  }
  for (const Triangle& triangle : triangles) {
    sets.join(triangle[0], triangle[1]);
    sets.join(triangle[1], triangle[2]);
  }
  std::map<std::size_t, std::size_t> numbers;
  std::vector<std::size_t> shells(welded.size());
  for (std::uint32_t v = 0; v < welded.size(); ++v) {
    shells[v] = numbers.try_emplace(sets.leaderOf(v), numbers.size()).first->second;
  }
  return shells;
}

void stiffenShells(std::span<const glm::vec3> positions, const std::vector<Triangle>& triangles,
                   const std::vector<std::uint32_t>& welded, const std::vector<BoneLine>& lines,
                   std::size_t joints, std::vector<Influences>& weights) {
  const std::vector<std::size_t> numbers = shellsOf(welded, triangles);
  std::vector<Shell> shells = collect(positions, numbers);
  if (shells.size() < 2) {
    return;
  }
  const auto around = shellsAlongBones(positions, triangles, numbers, lines);
  const std::vector<double> whole = measureBones(around, lines, joints, shells);
  const Outsiders outsiders(lines, around);
  tbb::parallel_for(std::size_t{0}, weights.size(), [&](std::size_t v) {
    if (!shells[numbers[v]].inside.empty()) {
      weights[v] = outsiders.without(weights[v], Vec3(positions[v]), numbers[v]);
    }
  });
  const std::vector<double> all = followers(weights, joints);
  for (const Shell& shell : shells) {
    dropGuests(shell, guestsOf(shell, all, lines, weights), weights);
  }
  ShellBox body;
  for (const glm::vec3& position : positions) {
    body.take(position);
  }
  const std::vector<const Shell*> hosts = hostsOf(positions, triangles, numbers, shells);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const Shell& shell = shells[i];
    if (const auto row =
            asOnePiece(shell, hosts[i], runningIn(shell, whole), lines, body.longest(), weights)) {
      for (const std::size_t v : shell.vertices) {
        weights[v] = *row;
      }
    }
  }
}

} // namespace stretch::skinning
