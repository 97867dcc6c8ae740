// dem-bones [--bones N]... [--influences N] SEQUENCE...: this program's measured bones beside Dem Bones', the skinning
// decomposition of Le and Deng as Electronic Arts publishes it, at the same number of bones: errors over the same
// vertices and frames, processor time of both in one process. Its headers are not part of this repository; see
// CMakeLists.txt.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <DemBones/DemBones.h>
#include <Eigen/Core>
#include <fmt/core.h>

#include "core/scene/mesh_sequence.h"
#include "skinning/compress/compress.h"
#include "skinning/metrics.h"
#include "skinning/sequence/read_sequence.h"

namespace stretch::bench {

namespace {

using Solver = Dem::DemBones<double, float>;

struct Outcome {
  int bones = 0;
  double percent = 0.0; ///< RMSE, of the first frame's diagonal.
  double seconds = 0.0; ///< Of all processors together.
};

double processorSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The sequence as one subject that rests in its first frame.
void load(const MeshSequence& sequence, Solver& solver) {
  const auto vertices = static_cast<Eigen::Index>(sequence.vertexCount);
  const auto frames = static_cast<Eigen::Index>(sequence.frameCount());
  solver.nV = static_cast<int>(vertices);
  solver.nF = static_cast<int>(frames);
  solver.nS = 1;
  solver.fStart = Eigen::Vector2i(0, solver.nF);
  solver.subjectID = Eigen::VectorXi::Zero(frames);
  solver.u.resize(3, vertices);
  solver.v.resize(3 * frames, vertices);
  for (Eigen::Index k = 0; k < frames; ++k) {
    const auto positions = sequence.frame(static_cast<std::size_t>(k));
    for (Eigen::Index i = 0; i < vertices; ++i) {
      const glm::vec3& p = positions[static_cast<std::size_t>(i)];
      solver.v.col(i).segment<3>(3 * k) = Eigen::Vector3f(p.x, p.y, p.z);
    }
  }
  solver.u = solver.v.topRows(3).cast<double>();
  for (const Triangle& t : sequence.triangles) {
    solver.fv.push_back({static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
  }
}

Outcome theirs(const MeshSequence& sequence, int bones, int influences) {
  Solver solver;
  load(sequence, solver);
  solver.nB = bones;
  solver.nnz = influences;
  const double start = processorSeconds();
  solver.compute();
  const double seconds = processorSeconds() - start;
  return {solver.nB, 100.0 * solver.rmse() / boxDiagonal(sequence.frame(0)), seconds};
}

Outcome ours(const MeshSequence& sequence, int bones, int influences) {
  skinning::CompressSettings settings;
  settings.stretch = skinning::StretchOption::measured;
  settings.bones = bones;
  settings.influences =
      influences > 4 ? skinning::InfluenceLimit::eight : skinning::InfluenceLimit::four;
  const double start = processorSeconds();
  const auto made = skinning::compress(sequence, settings);
  const double seconds = processorSeconds() - start;
  if (!made) {
    fmt::print(stderr, "{}\n", made.error().line());
    return {0, 0.0, seconds};
  }
  return {static_cast<int>(made->skinned.bones.size()), made->metrics.rmsePercent, seconds};
}

} // namespace

} // namespace stretch::bench

int main(int argumentCount, char** arguments) {
  using namespace stretch;
  CLI::App line("Measured bones beside Dem Bones'");
  std::vector<int> bones{10, 20, 30};
  int influences = 4;
  std::vector<std::filesystem::path> words;
  line.add_option("--bones", bones, "How many, as often as wanted");
  line.add_option("--influences", influences, "Bones of a vertex, at most: 4 or 8");
  line.add_option("SEQUENCE", words, "As of compress")->required();
  CLI11_PARSE(line, argumentCount, arguments);
  auto sequence = skinning::readSequence(words);
  if (!sequence) {
    fmt::print(stderr, "{}\n", sequence.error().line());
    return 1;
  }
  skinning::joinDuplicates(*sequence); // Dem Bones smooths weights over edges: seams would cut its mesh apart.
  for (const int count : bones) {
    const bench::Outcome peer = bench::theirs(*sequence, count, influences);
    const bench::Outcome own = bench::ours(*sequence, peer.bones, influences);
    fmt::print("| {} | {} | {:.4f} | {:.4f} | {:.2f} | {:.2f} | {:.2f} |\n", sequence->name, own.bones, own.percent,
               peer.percent, own.percent / peer.percent, own.seconds, peer.seconds);
  }
  return 0;
}
