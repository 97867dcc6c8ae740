#include "skinning/sequence/read_sequence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "core/base/file.h"
#include "core/base/number.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/text.h"
#include "skinning/sequence/topology.h"

namespace stretch::skinning {
namespace {

constexpr const char* positionsName = "position_buffer.txt";
constexpr const char* membranesName = "membranes_buffer.txt";

/// The first numbers of a line (at most four) and how many it holds; -1 when one of them is no number.
struct NumberLine {
  std::array<double, 4> numbers{};
  int count = 0;
};

NumberLine parseNumbers(std::string_view line) {
  NumberLine parsed;
  for (std::string_view word = nextWord(line); !word.empty(); word = nextWord(line)) {
    const auto number = parseNumber(word);
    if (!number || parsed.count == 4) {
      parsed.count = -1;
      return parsed;
    }
    parsed.numbers[static_cast<std::size_t>(parsed.count++)] = *number;
  }
  return parsed;
}

Result<std::vector<Triangle>> readMembranes(const std::filesystem::path& path) {
  const auto content = readText(path);
  if (!content) {
    return content.error();
  }
  std::vector<Triangle> triangles;
  std::string_view rest(*content);
  std::string_view line;
  for (std::size_t number = 1; nextLine(rest, line); ++number) {
    const NumberLine parsed = parseNumbers(line);
    if (parsed.count == 0 || (parsed.count == 1 && number == 1)) {
      continue; // Blank, or the number of membranes: the lines that follow are counted themselves.
    }
    Triangle triangle{};
    for (std::size_t c = 0; c < 3; ++c) {
      const double particle = parsed.numbers[c];
      if (parsed.count < 3 || !(particle >= 0.0 && particle < 1e9) || particle != std::floor(particle)) {
        return Error{"a membrane needs three particle numbers", placeOf(membranesName, number),
                     "log the run again"};
      }
      triangle[c] = static_cast<std::uint32_t>(particle);
    }
    triangles.push_back(triangle);
  }
  if (triangles.empty()) {
    return Error{"no membranes are listed", path.string(), "log a run of a body with membranes"};
  }
  return triangles;
}

/// Renumbers the corners so that only particles of membranes count; returns the particle of every vertex,
/// ascending.
std::vector<std::uint32_t> keepUsedParticles(std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> particles;
  for (const Triangle& triangle : triangles) {
    particles.insert(particles.end(), triangle.begin(), triangle.end());
  }
  std::sort(particles.begin(), particles.end());
  particles.erase(std::unique(particles.begin(), particles.end()), particles.end());
  for (Triangle& triangle : triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = static_cast<std::uint32_t>(std::lower_bound(particles.begin(), particles.end(), corner) -
                                          particles.begin());
    }
  }
  return particles;
}

/// Collects the frames of the position log line by line; particles without a membrane are dropped at once.
class PositionLog {
public:
  PositionLog(const std::vector<std::uint32_t>& particles, MeshSequence& sequence)
      : particles_(particles), sequence_(sequence) {}

  /// False when the line is not understood.
  bool take(std::string_view line) {
    const NumberLine parsed = parseNumbers(line);
    if (parsed.count == 1 && rows_ == 0) {
      header_.push_back(parsed.numbers[0]);
      return true;
    }
    if (parsed.count == 0) {
      return true;
    }
    return parsed.count == 4 && takeRow(parsed);
  }

  /// Rows per frame: elastic and liquid particles, the seventh and eighth number of the head.
  [[nodiscard]] double rowsPerFrame() const { return header_.size() < 8 ? 0.0 : header_[6] + header_[7]; }
  [[nodiscard]] bool endsWithWholeFrame() const { return rows_ > 0 && row_ == 0; }

private:
  bool takeRow(const NumberLine& parsed) {
    const double frameRows = rowsPerFrame();
    if (!(frameRows > static_cast<double>(particles_.back()) && frameRows < 1e9)) {
      return false;
    }
    if (next_ < particles_.size() && particles_[next_] == row_) {
      sequence_.positions.emplace_back(static_cast<float>(parsed.numbers[0]),
                                       static_cast<float>(parsed.numbers[1]),
                                       static_cast<float>(parsed.numbers[2]));
      ++next_;
      if (!isUsablePlace(sequence_.positions.back())) {
        return false;
      }
    }
    ++rows_;
    if (static_cast<double>(++row_) >= frameRows) {
      row_ = 0;
      next_ = 0;
      sequence_.frameNames.push_back("frame " + std::to_string(sequence_.frameNames.size()));
    }
    return true;
  }

  const std::vector<std::uint32_t>& particles_;
  MeshSequence& sequence_;
  std::vector<double> header_;
  std::uint64_t rows_ = 0;
  std::uint32_t row_ = 0;
  std::size_t next_ = 0;
};

Status readPositions(const std::filesystem::path& path, PositionLog& log, const Progress& progress) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return Error{"the file cannot be read", path.string(), "give the folder that the simulation logged to"};
  }
  std::error_code problem;
  const auto bytes = static_cast<double>(std::filesystem::file_size(path, problem));
  double read = 0.0;
  std::string line;
  constexpr std::size_t linesBetweenReports = 100000;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    read += static_cast<double>(line.size() + 1);
    if (!log.take(line)) {
      return Error{
          "the line is no particle (x, y, z, type), or the head's particle counts do not cover the membranes",
          placeOf(positionsName, number), "log the run again"};
    }
    if (progress && number % linesBetweenReports == 0) {
      progress(read / bytes);
    }
  }
  if (!log.endsWithWholeFrame()) {
    return Error{"the log ends within a frame or holds none", path.string(),
                 "copy it again, or cut the last frame off"};
  }
  return Success{};
}

} // namespace

Result<MeshSequence> readSibernetic(const std::filesystem::path& folder, const Progress& progress) {
  auto triangles = readMembranes(folder / membranesName);
  if (!triangles) {
    return triangles.error();
  }
  MeshSequence sequence;
  sequence.name = folder.filename().string();
  sequence.triangles = std::move(triangles.value());
  const std::vector<std::uint32_t> particles = keepUsedParticles(sequence.triangles);
  sequence.vertexCount = particles.size();
  PositionLog log(particles, sequence);
  const auto read = readPositions(folder / positionsName, log, progress);
  if (!read) {
    return read.error();
  }
  const std::size_t turned = orientOutwards(sequence.frame(0), sequence.triangles);
  if (turned > 0) {
    sequence.warnings.push_back(std::to_string(turned) + " of " + std::to_string(sequence.triangles.size()) +
                                " membranes were wound inwards and have been turned");
  }
  return sequence;
}

} // namespace stretch::skinning
