// Prints where the program itself puts the vertices of a file, trails included, in the shape that measure.mjs
// prints:
//   dump-vertices FILE CLIP STEP TIME...
// {"vertices": {"#node mesh/primitive": [[x, y, z, ...] a time]}}
#include <cstdlib>
#include <iostream>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/document.h"
#include "app/evaluate/evaluate.h"
#include "app/files/save.h"
#include "skinning/linear_blend_skinning.h"

namespace {

using namespace stretch;

void addFrame(const Scene& scene, const FrameState& frame, std::size_t step, nlohmann::json& out) {
  const std::vector<Vec3> positions = skinning::skinnedPositions(scene, frame);
  std::size_t first = 0;
  for (const NodeIndex node : skinning::drawnMeshNodes(scene)) {
    const int mesh = scene.nodes[at(node)].mesh;
    const auto& primitives = scene.meshes[static_cast<std::size_t>(mesh)].primitives;
    for (std::size_t primitive = 0; primitive < primitives.size(); ++primitive) {
      nlohmann::json numbers = nlohmann::json::array();
      for (std::size_t i = 0; i < primitives[primitive].positions.size(); i += step) {
        const Vec3& p = positions[first + i];
        numbers.insert(numbers.end(), {p.x, p.y, p.z});
      }
      first += primitives[primitive].positions.size();
      out[fmt::format("#{} {}/{}", node.value, mesh, primitive)].push_back(std::move(numbers));
    }
  }
}

} // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount < 5) {
    std::cerr << "usage: dump-vertices FILE CLIP STEP TIME...\n";
    return 2;
  }
  const Result<app::Document> document = app::openDocument(arguments[1]);
  if (!document) {
    std::cerr << document.error().line() << '\n';
    return 1;
  }
  const int clip = std::atoi(arguments[2]);
  const auto step = static_cast<std::size_t>(std::max(1, std::atoi(arguments[3])));
  const rig::MotionState motion = app::prepareMotion(*document, clip);
  nlohmann::json out;
  for (int i = 4; i < argumentCount; ++i) {
    addFrame(*document->scene, app::evaluate(*document, motion, std::strtod(arguments[i], nullptr)), step,
             out);
  }
  std::cout << nlohmann::json{{"vertices", out}}.dump() << '\n';
  return 0;
}
