// dem-bones [--bones N]... [--influences N] SEQUENCE...: this program's measured bones beside Dem Bones', the
// skinning decomposition of Le and Deng as Electronic Arts publishes it, at the same number of bones: errors
// over the same vertices and frames, processor time of both in one process. Its headers are not part of this
// repository (see CMakeLists.txt); without them only this program is measured.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#if __has_include(<DemBones/DemBones.h>)
#define STRETCH_HAS_DEM_BONES 1
#include <DemBones/DemBones.h>
#endif
#include <fmt/core.h>

#include "core/scene/mesh_sequence.h"
#include "skinning/compress/compress.h"
#include "skinning/fit/motion_clusters.h"
#include "skinning/metrics.h"
#include "skinning/sequence/read_sequence.h"

namespace stretch::bench {

namespace {

struct Outcome {
  int bones = 0;
  double percent = 0.0; ///< RMSE, of the first frame's diagonal.
  double seconds = 0.0; ///< Of all processors together.
  bool given = false;   ///< Started from this program's clusters: by its own it ends with fewer bones.
};

double processorSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

#ifdef STRETCH_HAS_DEM_BONES

using Solver = Dem::DemBones<double, float>;

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

/// Every vertex on the bone of the part that it moves with.
void startFromClusters(const MeshSequence& sequence, int bones, Solver& solver) {
  const skinning::SkinnedSequence clusters = skinning::clustersOfMotion(sequence, bones, 0);
  std::vector<Eigen::Triplet<double>> weights;
  for (std::size_t v = 0; v < clusters.influences.size(); ++v) {
    weights.emplace_back(clusters.influences[v].bones[0], static_cast<int>(v), 1.0);
  }
  solver.nB = static_cast<int>(clusters.bones.size());
  solver.w.resize(solver.nB, solver.nV);
  solver.w.setFromTriplets(weights.begin(), weights.end());
}

Outcome theirs(const MeshSequence& sequence, int bones, int influences, bool given) {
  Solver solver;
  load(sequence, solver);
  solver.nB = bones;
  solver.nnz = influences;
  if (given) {
    startFromClusters(sequence, bones, solver);
  }
  const double start = processorSeconds();
  solver.compute();
  const double seconds = processorSeconds() - start;
  return {solver.nB, 100.0 * solver.rmse() / boxDiagonal(sequence.frame(0)), seconds, given};
}

/// Its own start, unless that ends with fewer than half of the bones that were asked for.
Outcome theirsWithEnoughBones(const MeshSequence& sequence, int bones, int influences) {
  const Outcome own = theirs(sequence, bones, influences, false);
  return 2 * own.bones < bones ? theirs(sequence, bones, influences, true) : own;
}

#else

Outcome theirsWithEnoughBones(const MeshSequence&, int bones, int) {
  return {bones, 0.0, 0.0};
}

#endif

Outcome ours(const MeshSequence& sequence, int bones, int influences) {
  skinning::CompressSettings settings;
  settings.stretch = skinning::StretchOption::measured;
  settings.bones = bones;
  settings.influences = influences > 4 ? skinning::InfluenceLimit::eight : skinning::InfluenceLimit::four;
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
  bool own = false;
  std::vector<std::filesystem::path> words;
  line.add_option("--bones", bones, "How many, as often as wanted");
  line.add_option("--influences", influences, "Bones of a vertex, at most: 4 or 8");
  line.add_flag("--own", own, "Only this program");
  line.add_option("SEQUENCE", words, "As of compress")->required();
  CLI11_PARSE(line, argumentCount, arguments);
  auto sequence = skinning::readSequence(words);
  if (!sequence) {
    fmt::print(stderr, "{}\n", sequence.error().line());
    return 1;
  }
  skinning::joinDuplicates(*sequence); // Dem Bones smooths weights over edges: seams would cut its mesh
                                       // apart.
  for (const int count : bones) {
    const bench::Outcome peer =
        own ? bench::Outcome{count, 0.0, 0.0} : bench::theirsWithEnoughBones(*sequence, count, influences);
    const bench::Outcome mine = bench::ours(*sequence, peer.bones, influences);
    fmt::print("| {} | {} | {:.4f} | {} | {:.2f} | {} |\n", sequence->name, mine.bones, mine.percent,
               peer.seconds > 0.0 ? fmt::format("{:.4f}", peer.percent) : "-", mine.seconds,
               peer.seconds > 0.0 ? fmt::format("{:.2f}", peer.seconds) : "-");
  }
  return 0;
}
