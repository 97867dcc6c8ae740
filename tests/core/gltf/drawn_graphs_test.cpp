// What is wrong in graphs of nodes that are drawn by chance, against walking up from every node.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "core/gltf/json/json.h"
#include "core/gltf/read/structure.h"
#include "tests/support/row.h"

using namespace stretch;
using gltf::Json;
using gltf::Problem;
using gltf::Problems;
using gltf::Severity;

namespace {

std::vector<std::string> linesOf(const Problems& problems) {
  std::vector<std::string> lines;
  for (const Problem& problem : problems.list()) {
    const char* const kind = problem.severity == Severity::error       ? "error"
                             : problem.severity == Severity::violation ? "violation"
                                                                       : "warning";
    lines.push_back(fmt::format("{} {}: {}{}", kind, problem.where, problem.what, problem.remedy));
  }
  return lines;
}

std::vector<std::string> toldOfGraph(const Json& json) {
  Problems problems;
  gltf::validateGraph(json, problems);
  return linesOf(problems);
}

/// Nodes that hang on each other as their lists of children say.
struct Graph {
  std::vector<std::vector<int>> children;
  std::vector<int> roots;
  std::vector<int> joints;
  int skeleton = -1;

  Json json() const {
    Json json{{"nodes", Json::array()}, {"scenes", {{{"nodes", roots}}}}, {"skins", {{{"joints", joints}}}}};
    for (const std::vector<int>& list : children) {
      Json node = Json::object();
      if (!list.empty()) {
        node["children"] = list;
      }
      json["nodes"].push_back(node);
    }
    if (skeleton >= 0) {
      json["skins"][0]["skeleton"] = skeleton;
    }
    return json;
  }
};

Graph drawnGraph(test::Row& row) {
  Graph graph;
  const std::uint32_t count = 2 + row.below(7);
  graph.children.resize(count);
  const bool mayBreak = row.once(2);
  for (std::uint32_t node = 1; node < count; ++node) {
    if (!row.once(4)) { // below one before it
      graph.children[row.below(node)].push_back(static_cast<int>(node));
    }
  }
  while (mayBreak && row.once(2)) {
    graph.children[row.below(count)].push_back(static_cast<int>(row.below(count)));
  }
  for (std::uint32_t i = row.below(3); i > 0; --i) {
    graph.roots.push_back(static_cast<int>(row.below(count)));
  }
  for (std::uint32_t i = row.below(4); i > 0; --i) {
    graph.joints.push_back(static_cast<int>(row.below(count)));
  }
  graph.skeleton = row.once(3) ? -1 : static_cast<int>(row.below(count));
  return graph;
}

/// All nodes that are met on the way up from a node, itself among them, by the first parent of each.
std::vector<int> wayUp(const std::vector<int>& parents, int node) {
  std::vector<int> way;
  while (node >= 0 && std::ranges::find(way, node) == way.end()) {
    way.push_back(node);
    node = parents[static_cast<std::size_t>(node)];
  }
  return way;
}

/// What is to be told, as sets: loops are told once each, at any of their nodes.
struct Expected {
  std::vector<std::string> lines;   ///< But for loops and skins.
  std::vector<std::set<int>> loops; ///< Their nodes.
  std::vector<std::string> skinLines;
};

Expected plainlyTold(const Graph& graph) {
  Expected expected;
  std::vector<int> parents(graph.children.size(), -1);
  for (std::size_t node = 0; node < parents.size(); ++node) {
    for (const int child : graph.children[node]) {
      int& parent = parents[static_cast<std::size_t>(child)];
      if (parent >= 0) {
        expected.lines.push_back(
            fmt::format("error nodes[{}]: has two parents, nodes[{}] and nodes[{}]", child, parent, node));
      } else {
        parent = static_cast<int>(node);
      }
    }
  }
  std::set<int> known;
  for (std::size_t node = 0; node < parents.size(); ++node) {
    const std::vector<int> above = wayUp(parents, parents[node]);
    const auto self = std::ranges::find(above, static_cast<int>(node));
    if (self != above.end() && !known.contains(static_cast<int>(node))) {
      const std::set<int> loop(above.begin(), self + 1);
      known.insert(loop.begin(), loop.end());
      expected.loops.push_back(loop);
    }
  }
  for (const int root : graph.roots) {
    if (parents[static_cast<std::size_t>(root)] >= 0) {
      expected.lines.push_back(fmt::format("error scenes[0]: lists nodes[{}], which has a parent", root));
    }
  }
  if (expected.lines.empty() && expected.loops.empty()) {
    if (graph.joints.empty()) {
      expected.skinLines.emplace_back("error skins[0].joints: is empty");
    }
    const bool isAbove = std::ranges::all_of(graph.joints, [&](int joint) {
      const std::vector<int> way = wayUp(parents, joint);
      return std::ranges::find(way, graph.skeleton) != way.end();
    });
    if (graph.skeleton >= 0 && !isAbove) {
      expected.skinLines.emplace_back(
          "warning skins[0].skeleton: is no common ancestor of the joints; it is not used");
    }
  }
  return expected;
}

} // namespace

TEST_CASE("Of drawn graphs each second parent, loop, root below a node and wrong skeleton is told once",
          "[drawn-graphs]") {
  test::Row row(5);
  std::size_t loops = 0;
  std::size_t skeletons = 0;
  std::size_t fine = 0;
  for (int i = 0; i < 3000; ++i) {
    const Graph graph = drawnGraph(row);
    const Expected expected = plainlyTold(graph);
    std::vector<std::string> told = toldOfGraph(graph.json());
    INFO(graph.json().dump());
    for (const std::set<int>& loop : expected.loops) {
      const auto line = std::ranges::find_if(told, [&](const std::string& text) {
        return std::ranges::any_of(loop, [&](int node) {
          return text == fmt::format("error nodes[{}]: is its own ancestor", node);
        });
      });
      REQUIRE(line != told.end());
      told.erase(line);
      ++loops;
    }
    std::vector<std::string> wanted = expected.lines;
    wanted.insert(wanted.end(), expected.skinLines.begin(), expected.skinLines.end());
    CHECK(told == wanted);
    skeletons += expected.skinLines.size();
    fine += wanted.empty() && expected.loops.empty() ? 1U : 0U;
  }
  CHECK(loops > 100);
  CHECK(skeletons > 100);
  CHECK(fine > 300);
}

TEST_CASE("A node's numbers are told where they are too large, no unit or beside a matrix",
          "[drawn-graphs]") {
  const auto told = [](const Json& node) { return toldOfGraph({{"nodes", {Json::object(), node}}}); };
  using Lines = std::vector<std::string>;
  const double largest = 3.4028234663852886e38;
  const std::vector<double> unit{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  for (const auto& [key, size] :
       {std::pair<std::string, std::size_t>("translation", 3), {"scale", 3}, {"matrix", 16}}) {
    for (std::size_t at = 0; at < size; ++at) {
      std::vector<double> numbers(size, 1.0);
      for (const double sign : {-1.0, 1.0}) {
        numbers[at] = sign * largest;
        CHECK(told({{key, numbers}}).empty());
        numbers[at] = sign * 3.41e38;
        CHECK(told({{key, numbers}}) ==
              Lines{fmt::format("error nodes[1].{}: holds {}, which is too large for single precision", key,
                                numbers[at])});
      }
    }
  }
  const Lines noUnit{"violation nodes[1].rotation: is no unit quaternionit is normalised"};
  for (std::size_t at = 0; at < 4; ++at) {
    for (const auto& [square, isUnit] :
         {std::pair(0.98, false), {0.991, true}, {1.0, true}, {1.009, true}, {1.02, false}, {0.0, false}}) {
      std::vector<double> turn(4, 0.0);
      turn[at] = std::sqrt(0.5 * square);
      turn[(at + 1) % 4] = -std::sqrt(0.5 * square);
      CHECK(told({{"rotation", turn}}) == (isUnit ? Lines{} : noUnit));
    }
  }
  const Lines both{"error nodes[1]: has both a matrix and translation, rotation or scale"};
  CHECK(told({{"matrix", unit}}).empty());
  CHECK(told({{"matrix", unit}, {"translation", {0, 0, 0}}}) == both);
  CHECK(told({{"matrix", unit}, {"rotation", {0, 0, 0, 1}}}) == both);
  CHECK(told({{"matrix", unit}, {"scale", {1, 1, 1}}}) == both);
  CHECK(told({{"translation", {0, 0, 0}}, {"rotation", {0, 0, 0, 1}}, {"scale", {1, 1, 1}}}).empty());
}
