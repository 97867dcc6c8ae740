#include "skinning/sequence/read_sequence.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <system_error>
#include <utility>

#include "core/base/file.h"
#include "core/base/number.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/text.h"

namespace stretch::skinning {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Order in which runs of digits count as numbers: 2 before 10, and 002 equal to 2 but for the tie.
bool numbersBefore(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (!isDigit(a[i]) || !isDigit(b[j])) {
      if (a[i] != b[j]) {
        return a[i] < b[j];
      }
      ++i;
      ++j;
      continue;
    }
    const auto endOfRun = [](const std::string& text, std::size_t at) {
      return static_cast<std::size_t>(
          std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), isDigit) -
          text.begin());
    };
    const std::size_t endA = endOfRun(a, i);
    const std::size_t endB = endOfRun(b, j);
    const std::size_t firstA = std::min(a.find_first_not_of('0', i), endA);
    const std::size_t firstB = std::min(b.find_first_not_of('0', j), endB);
    if (endA - firstA != endB - firstB) {
      return endA - firstA < endB - firstB;
    }
    const int order = a.compare(firstA, endA - firstA, b, firstB, endB - firstB);
    if (order != 0) {
      return order < 0;
    }
    i = endA;
    j = endB;
  }
  return std::pair(a.size() - i, a) < std::pair(b.size() - j, b);
}

Result<std::vector<std::filesystem::path>> frameFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> objs;
  std::vector<std::filesystem::path> plys;
  std::error_code problem;
  for (std::filesystem::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    if (isMeshFile(entry->path())) {
      (lowerExtension(entry->path()) == ".ply" ? plys : objs).push_back(entry->path());
    }
  }
  if (problem) {
    return Error{"the folder cannot be read", folder.string(), "check that it exists and may be read"};
  }
  if (!objs.empty() && !plys.empty()) {
    return Error{"the folder holds OBJ and PLY frames", folder.string(), "keep one kind"};
  }
  std::vector<std::filesystem::path> files = objs.empty() ? std::move(plys) : std::move(objs);
  if (files.empty()) {
    return Error{"the folder holds no .obj or .ply frames", folder.string(), "give the folder of the frames"};
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
    return numbersBefore(a.filename().string(), b.filename().string());
  });
  return files;
}

/// A file name taken apart: "wolf-", "12", ".obj".
struct NumberedName {
  std::vector<std::string> texts;
  std::vector<std::uint64_t> numbers;
};

NumberedName takenApart(const std::string& name) {
  NumberedName parts{{""}, {}};
  for (std::size_t i = 0; i < name.size();) {
    if (!isDigit(name[i])) {
      parts.texts.back() += name[i++];
      continue;
    }
    const std::size_t end = std::min(name.find_first_not_of("0123456789", i), name.size());
    parts.numbers.push_back(parseNumber<std::uint64_t>(name.substr(i, end - i)).value_or(0));
    parts.texts.emplace_back();
    i = end;
  }
  return parts;
}

/// The number of each file: the last one in its name that differs; empty where the names are not alike
/// otherwise.
std::vector<std::uint64_t> frameNumbers(const std::vector<std::filesystem::path>& files) {
  std::vector<NumberedName> names;
  for (const std::filesystem::path& file : files) {
    names.push_back(takenApart(file.stem().string()));
    if (names.back().texts != names.front().texts) {
      return {};
    }
  }
  for (std::size_t place = names.front().numbers.size(); place-- > 0;) {
    std::vector<std::uint64_t> numbers;
    numbers.reserve(names.size());
    for (const NumberedName& name : names) {
      numbers.push_back(name.numbers[place]);
    }
    if (std::ranges::adjacent_find(numbers, std::ranges::not_equal_to()) != numbers.end()) {
      std::ranges::sort(numbers);
      return numbers;
    }
  }
  return {};
}

/// "7, 9 to 12": what is missing in a row of numbers that go up by the least of its steps; empty for nothing.
std::string missingNumbers(const std::vector<std::uint64_t>& numbers) {
  std::uint64_t step = 0;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const std::uint64_t gap = numbers[i] - numbers[i - 1];
    step = step == 0 || (gap > 0 && gap < step) ? gap : step;
  }
  constexpr int mostTold = 8;
  std::string told;
  int count = 0;
  for (std::size_t i = 1; step > 0 && i < numbers.size(); ++i) {
    const std::uint64_t first = numbers[i - 1] + step;
    const std::uint64_t last = numbers[i] - std::min(step, numbers[i]);
    if (numbers[i] <= first || (numbers[i] - first) % step != 0) {
      continue;
    }
    if (++count > mostTold) {
      return told + " and more";
    }
    told += (told.empty() ? "" : ", ") + std::to_string(first);
    told += last > first ? " to " + std::to_string(last) : "";
  }
  return told;
}

Status addFrame(MeshSequence& sequence, const MeshFile& mesh, const std::string& file) {
  if (sequence.vertexCount == 0) {
    sequence.vertexCount = mesh.positions.size();
    sequence.triangles = mesh.triangles;
  }
  if (mesh.positions.size() != sequence.vertexCount) {
    return Error{"the frame has " + std::to_string(mesh.positions.size()) + " vertices where the first has " +
                     std::to_string(sequence.vertexCount),
                 file, "every frame needs the same topology"};
  }
  if (mesh.triangles != sequence.triangles) {
    return Error{"the faces differ from those of the first frame", file,
                 "every frame needs the same topology"};
  }
  sequence.positions.insert(sequence.positions.end(), mesh.positions.begin(), mesh.positions.end());
  sequence.frameNames.push_back(file);
  return Success{};
}

} // namespace

bool isMeshFile(const std::filesystem::path& path) {
  const std::string extension = lowerExtension(path);
  return extension == ".obj" || extension == ".ply";
}

Result<MeshFile> readMeshFile(const std::filesystem::path& path) {
  const auto content = readText(path);
  if (!content) {
    return content.error();
  }
  const std::string name = path.filename().string();
  return lowerExtension(path) == ".ply" ? parsePly(*content, name) : parseObj(*content, name);
}

Result<MeshSequence> readFrameFolder(const std::filesystem::path& folder, const Progress& progress) {
  const auto files = frameFiles(folder);
  if (!files) {
    return files.error();
  }
  MeshSequence sequence;
  sequence.name = folder.filename().string();
  if (const std::string missing = missingNumbers(frameNumbers(*files)); !missing.empty()) {
    sequence.warnings.push_back("no frame has the number " + missing + ": the next one follows at once");
  }
  for (std::size_t i = 0; i < files->size(); ++i) {
    const std::filesystem::path& path = files.value()[i];
    const auto mesh = readMeshFile(path);
    if (!mesh) {
      return mesh.error();
    }
    if (i == 0) {
      sequence.surface = surfaceOfMeshFile(path, *mesh, sequence.warnings);
      sequence.positions.reserve(mesh->positions.size() * files->size());
    }
    const auto added = addFrame(sequence, *mesh, path.filename().string());
    if (!added) {
      return added.error();
    }
    if (progress) {
      progress(static_cast<double>(i + 1) / static_cast<double>(files->size()));
    }
  }
  return sequence;
}

} // namespace stretch::skinning
