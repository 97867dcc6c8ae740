#include "skinning/sequence/frame_names.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "core/base/number.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/text.h"

namespace stretch::skinning {
namespace {

namespace fs = std::filesystem;

using Texts = std::vector<std::string>;

/// A number of any length, as it is written; 007 is 7.
struct FrameNumber {
  std::string zeros;    ///< In front.
  std::string digits;   ///< Behind them; none for 0.
  std::string fraction; ///< Without zeros at its end.
  bool isNegative = false;

  friend std::strong_ordering operator<=>(const FrameNumber& a, const FrameNumber& b) {
    if (a.isNegative != b.isNegative) {
      return a.isNegative ? std::strong_ordering::less : std::strong_ordering::greater;
    }
    const auto size = [](const FrameNumber& one) {
      return std::tuple(one.digits.size(), std::string_view(one.digits), std::string_view(one.fraction));
    };
    return a.isNegative ? size(b) <=> size(a) : size(a) <=> size(b);
  }
  friend bool operator==(const FrameNumber& a, const FrameNumber& b) { return (a <=> b) == 0; }
};

/// A text and the number behind it; behind the last text there is none.
struct NamePart {
  std::string text;
  FrameNumber number;

  friend auto operator<=>(const NamePart&, const NamePart&) = default;
};

/// A file and its name taken apart: "wolf-" 12, "".
struct FrameName {
  fs::path file;
  std::vector<NamePart> parts;

  [[nodiscard]] Texts texts() const {
    Texts texts;
    for (const NamePart& part : parts) {
      texts.push_back(part.text);
    }
    return texts;
  }
  [[nodiscard]] bool hasNumber() const { return parts.size() > 1; }
  /// The last one with a number.
  [[nodiscard]] NamePart& last() { return parts[parts.size() - 2]; }
  [[nodiscard]] const NamePart& last() const { return parts[parts.size() - 2]; }
};

FrameName takenApart(const fs::path& file) {
  constexpr std::string_view digits = "0123456789";
  FrameName name{file, {}};
  std::string rest = file.stem().string();
  for (std::size_t at = rest.find_first_of(digits); at != std::string::npos;
       at = rest.find_first_of(digits)) {
    const std::size_t end = std::min(rest.find_first_not_of(digits, at), rest.size());
    const std::size_t first = std::min(rest.find_first_not_of('0', at), end);
    name.parts.push_back(
        {rest.substr(0, at), {rest.substr(at, first - at), rest.substr(first, end - first), {}, false}});
    rest = rest.substr(end);
  }
  name.parts.push_back({rest, {}});
  return name;
}

/// Frames between frames: a number behind a point at the end is a fraction where others have none.
void joinFractions(std::vector<FrameName>& names) {
  std::map<Texts, int> counts;
  for (const FrameName& name : names) {
    ++counts[name.texts()];
  }
  for (FrameName& name : names) {
    if (name.parts.size() < 3 || name.last().text != "." || !name.parts.back().text.empty()) {
      continue;
    }
    const FrameNumber behind = name.last().number;
    FrameName joined = name;
    joined.parts.erase(joined.parts.end() - 2);
    std::string& fraction = joined.last().number.fraction;
    fraction = behind.zeros + behind.digits;
    fraction.erase(fraction.find_last_not_of('0') + 1);
    // One alone would be a mesh beside a series: sim_v2 beside sim_v2.0001.
    if (counts[joined.texts()] > 1) {
      name = std::move(joined);
    }
  }
}

void takeSigns(std::vector<FrameName>& names) {
  std::set<Texts> withZero;
  for (const FrameName& name : names) {
    if (name.hasNumber() && name.last().number == FrameNumber()) {
      withZero.insert(name.texts());
    }
  }
  for (FrameName& name : names) {
    if (!name.hasNumber() || !name.last().text.ends_with('-')) {
      continue;
    }
    FrameName below = name;
    below.last().text.pop_back();
    below.last().number.isNegative = true;
    if (withZero.contains(below.texts())) {
      name = std::move(below);
    }
  }
}

std::vector<FrameName> namesOf(const std::vector<fs::path>& files) {
  std::vector<FrameName> names;
  names.reserve(files.size());
  std::ranges::transform(files, std::back_inserter(names), takenApart);
  joinFractions(names);
  takeSigns(names);
  std::ranges::sort(names, {}, [](const FrameName& name) { return std::tie(name.parts, name.file); });
  return names;
}

std::string fileOf(const FrameName& name) {
  return name.file.filename().string();
}

/// "rest.obj, base.obj and 3 more".
std::string listOf(const std::vector<FrameName>& names) {
  constexpr std::size_t most = 4;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    list += (i == 0 ? "" : ", ") + fileOf(names[i]);
  }
  return names.size() > most ? fmt::format("{} and {} more", list, names.size() - most) : list;
}

/// Places of the numbers in which the names of a series differ, ascending.
std::vector<std::size_t> differingPlaces(const std::vector<FrameName>& series) {
  std::vector<std::size_t> places;
  for (std::size_t place = 0; place + 1 < series.front().parts.size(); ++place) {
    if (std::ranges::any_of(series, [&](const FrameName& name) {
          return name.parts[place].number != series.front().parts[place].number;
        })) {
      places.push_back(place);
    }
  }
  return places;
}

/// The number of each file, ascending: the one at a place of its name; none where frames lie between frames.
std::vector<double> frameNumbers(const std::vector<FrameName>& series, std::size_t place) {
  std::vector<double> numbers;
  for (const FrameName& name : series) {
    const FrameNumber& number = name.parts[place].number;
    if (!number.fraction.empty()) {
      return {};
    }
    numbers.push_back((number.isNegative ? -1.0 : 1.0) * parseNumber(number.digits).value_or(0.0));
  }
  std::ranges::sort(numbers);
  return numbers;
}

/// "7, 9 to 12": what is missing in a row of numbers that go up by the least of its steps; empty for nothing.
std::string missingNumbers(const std::vector<double>& numbers) {
  double step = 0.0;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const double gap = numbers[i] - numbers[i - 1];
    step = step == 0.0 || (gap > 0.0 && gap < step) ? gap : step;
  }
  constexpr int mostTold = 8;
  std::string told;
  int count = 0;
  for (std::size_t i = 1; step > 0.0 && i < numbers.size(); ++i) {
    const double first = numbers[i - 1] + step;
    const double last = numbers[i] - step;
    if (numbers[i] <= first || std::fmod(numbers[i] - first, step) != 0.0) {
      continue;
    }
    if (++count > mostTold) {
      return told + " and more";
    }
    told += fmt::format("{}{}", told.empty() ? "" : ", ", first);
    told += last > first ? fmt::format(" to {}", last) : "";
  }
  return told;
}

/// What is odd about the numbers of a series.
std::vector<std::string> tellNumbers(const std::vector<FrameName>& series) {
  const std::vector<std::size_t> places = differingPlaces(series);
  if (places.empty()) {
    return {};
  }
  std::vector<std::string> told;
  if (const std::string missing = missingNumbers(frameNumbers(series, places.back())); !missing.empty()) {
    told.push_back("no frame has the number " + missing + ": the next one follows at once");
  }
  if (places.size() > 1) {
    told.push_back(fmt::format("the names differ in {} numbers: all are played one after the other, {} to {}",
                               places.size(), fileOf(series.front()), fileOf(series.back())));
  }
  return told;
}

} // namespace

Result<FrameFiles> framesInOrder(const std::vector<fs::path>& files) {
  const std::vector<FrameName> names = namesOf(files);
  const std::string folder = folderOf(files.front()).string();
  std::map<Texts, std::vector<FrameName>> series;
  for (const FrameName& name : names) {
    series[name.texts()].push_back(name);
  }
  std::vector<FrameName> played;
  std::vector<FrameName> left;
  for (const auto& [texts, alike] : series) {
    if (alike.size() > 1 && !played.empty()) {
      return Error{fmt::format("the folder holds several series of frames, {} and {}", fileOf(played.front()),
                               fileOf(alike.front())),
                   folder, "name a frame of the one that is wanted, or keep one in the folder"};
    }
    std::vector<FrameName>& to = alike.size() > 1 ? played : left;
    to.insert(to.end(), alike.begin(), alike.end());
  }
  FrameFiles frames;
  if (played.empty()) {
    played = names;
    if (names.size() > 1) {
      frames.warnings.push_back(
          fmt::format("no two frames have names that are alike but for numbers: they are "
                      "played in the order of their names, {}",
                      listOf(names)));
    }
  } else {
    frames.warnings = tellNumbers(played);
    if (!left.empty()) {
      frames.warnings.push_back(
          fmt::format("left out what is not named like {}: {}", fileOf(played.front()), listOf(left)));
    }
  }
  const auto twice = std::ranges::adjacent_find(played, {}, &FrameName::parts);
  if (twice != played.end()) {
    return Error{fmt::format("{} and {} have the same number", fileOf(*twice), fileOf(*(twice + 1))), folder,
                 "keep one of them in the folder"};
  }
  std::ranges::transform(played, std::back_inserter(frames.files), &FrameName::file);
  return frames;
}

std::vector<fs::path> seriesOf(const fs::path& mesh) {
  const auto meshes = filesIn(folderOf(mesh), isMeshFile);
  std::vector<fs::path> files = meshes ? *meshes : std::vector<fs::path>();
  std::erase_if(files, [&](const fs::path& file) { return lowerExtension(file) != lowerExtension(mesh); });
  std::vector<FrameName> names = namesOf(files);
  const auto own =
      std::ranges::find(names, mesh.filename(), [](const FrameName& name) { return name.file.filename(); });
  if (own == names.end() || !own->hasNumber() || !own->parts.back().text.empty()) {
    return {mesh};
  }
  FrameName alike = *own;
  std::vector<fs::path> series;
  for (const FrameName& name : names) {
    if (name.hasNumber()) {
      alike.last().number = name.last().number;
    }
    if (alike.parts == name.parts) {
      series.push_back(name.file);
    }
  }
  return series;
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

Result<std::vector<fs::path>> filesIn(const fs::path& folder, bool (*wanted)(const fs::path&)) {
  std::vector<fs::path> files;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    if (wanted(entry->path())) {
      files.push_back(entry->path());
    }
  }
  if (problem) {
    return Error{"the folder cannot be read", folder.string(), "check that it exists and may be read"};
  }
  return files;
}

} // namespace stretch::skinning
