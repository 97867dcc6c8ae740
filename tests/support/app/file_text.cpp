#include "tests/support/app/file_text.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/files/save.h"
#include "tests/support/temporary_folder.h"

namespace stretch::test {

namespace {

double sumOf(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [](double sum, float value) { return sum + std::abs(static_cast<double>(value)); });
}

} // namespace

std::string fileText(const std::string& name, const Bytes& bytes) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / std::filesystem::path(name).filename().string();
  REQUIRE(writeFile(path, bytes));
  const Result<app::Document> document = app::openDocument(path);
  if (!document) {
    return "  " + name + " , " + std::to_string(bytes.size()) + " bytes\n";
  }
  Vec3 places(0.0);
  double weights = 0.0;
  for (const Mesh& mesh : document->scene->meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      for (const auto& position : primitive.positions) {
        places += Vec3(position);
      }
      for (const VertexInfluences& one : primitive.influences) {
        for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
          weights += static_cast<double>(one.weights[i]) * one.joints[i];
        }
      }
    }
  }
  Vec3 rests(0.0);
  for (const Node& node : document->scene->nodes) {
    rests += Vec3(node.rest.translation);
  }
  std::string text = fmt::format(
      "  {} , {} nodes at {:.4f} {:.4f} {:.4f} , vertices {:.3f} {:.3f} {:.3f} , weights {:.2f}\n", name,
      document->scene->nodes.size(), rests.x, rests.y, rests.z, places.x, places.y, places.z, weights);
  for (const Clip& clip : *document->clips) {
    std::map<std::string, std::array<double, 3>> sums; // keys, times and values by channel
    for (const CopyOnWrite<Track>& track : clip.tracks) {
      std::array<double, 3>& sum = sums["channel " + std::to_string(static_cast<int>(track->channel))];
      sum[0] += static_cast<double>(track->times.size());
      sum[1] += sumOf(track->times);
      sum[2] += sumOf(track->values);
    }
    text += fmt::format("   clip {} , {} tracks\n", clip.name, clip.tracks.size());
    for (const auto& [channel, sum] : sums) {
      text +=
          fmt::format("    {} : {} keys , times {:.3f} , values {:.3f}\n", channel, sum[0], sum[1], sum[2]);
    }
  }
  return text;
}

} // namespace stretch::test
