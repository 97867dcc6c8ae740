#include "tests/support/recorded.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

namespace stretch::test {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

std::optional<double> numberOf(const std::string& word) {
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  const bool isWhole = !word.empty() && end == word.c_str() + word.size();
  return isWhole ? std::optional(number) : std::nullopt;
}

bool isSame(const std::string& recorded, const std::string& now, double tolerance) {
  const std::vector<std::string> a = wordsOf(recorded);
  const std::vector<std::string> b = wordsOf(now);
  return std::ranges::equal(a, b, [&](const std::string& left, const std::string& right) {
    const std::optional<double> x = numberOf(left);
    const std::optional<double> y = numberOf(right);
    return left == right || (x && y && std::abs(*x - *y) <= tolerance * std::max(1.0, std::abs(*x)));
  });
}

std::string textOf(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

fs::path keepForALook(const std::string& name, const std::string& text) {
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path() / "recorded-differences";
  fs::create_directories(folder);
  fs::path path = folder / (name + ".txt");
  std::ofstream(path) << text;
  return path;
}

} // namespace

std::string differenceFromRecord(const std::string& name, const std::string& text, double tolerance) {
  const fs::path record = fs::path(STRETCH_SOURCE_DIR) / "tests" / "recorded" / (name + ".txt");
  const std::vector<std::string> before = linesOf(textOf(record));
  const std::vector<std::string> now = linesOf(text);
  const auto [was, is] = std::ranges::mismatch(
      before, now, [&](const std::string& a, const std::string& b) { return isSame(a, b, tolerance); });
  if (was == before.end() && is == now.end()) {
    return {};
  }
  const std::string end = "(the end)";
  return "line " + std::to_string(was - before.begin() + 1) + " of " + name + " was\n" +
         (was == before.end() ? end : *was) + "\nand is\n" + (is == now.end() ? end : *is) + "\nCompare " +
         keepForALook(name, text).string() + " with " + record.string() +
         " and, if it is right, copy it there.";
}

void compareWithRecord(const std::string& name, const std::string& text, double tolerance) {
  const std::string difference = differenceFromRecord(name, text, tolerance);
  INFO(difference);
  CHECK(difference.empty());
}

} // namespace stretch::test
