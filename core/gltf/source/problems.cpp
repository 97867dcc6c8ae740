#include "core/gltf/source/problems.h"

#include <algorithm>
#include <map>

#include <fmt/core.h>

namespace stretch::gltf {

namespace {

struct Repeated {
  std::string firstPlace;
  std::size_t count = 0;
};

std::string lineOf(const std::string& what, const Repeated& places) {
  if (places.firstPlace.empty()) {
    return what;
  }
  const std::string others = places.count > 1 ? fmt::format(" and {} more", places.count - 1) : "";
  return fmt::format("{}{}: {}", places.firstPlace, others, what);
}

} // namespace

void Problems::error(std::string where, std::string what, std::string remedy) {
  if (list_.size() < capacity || !hasErrors_) {
    list_.push_back({Severity::error, std::move(where), std::move(what), std::move(remedy)});
  }
  hasErrors_ = true;
}

void Problems::violation(std::string where, std::string what, std::string mend) {
  if (list_.size() < capacity) {
    list_.push_back({Severity::violation, std::move(where), std::move(what), std::move(mend)});
  }
}

void Problems::warning(std::string where, std::string what) {
  if (list_.size() < capacity) {
    list_.push_back({Severity::warning, std::move(where), std::move(what), {}});
  }
}

void Problems::add(const Problems& others) {
  for (const Problem& problem : others.list_) {
    if (problem.severity == Severity::error) {
      error(problem.where, problem.what, problem.remedy);
    } else if (list_.size() < capacity) {
      list_.push_back(problem);
    }
  }
}

bool Problems::hasViolations() const {
  return std::ranges::any_of(list_,
                             [](const Problem& problem) { return problem.severity == Severity::violation; });
}

Error Problems::firstError() const {
  const Severity worst = hasErrors_ ? Severity::error : Severity::violation;
  const auto found =
      std::ranges::find_if(list_, [&](const Problem& problem) { return problem.severity == worst; });
  check(found != list_.end(), "a failed reading has an error");
  if (worst == Severity::violation) {
    return {found->what, found->where,
            "repair the file or export it again, or take it as it is with --tolerant"};
  }
  return {found->what, found->where,
          found->remedy.empty() ? "repair the file or export it again" : found->remedy};
}

std::vector<std::string> Problems::warningLines() const {
  std::vector<std::string> order;
  std::map<std::string, Repeated> places;
  for (const Problem& problem : list_) {
    if (problem.severity == Severity::error) {
      continue;
    }
    const std::string what = problem.remedy.empty() ? problem.what : problem.what + "; " + problem.remedy;
    Repeated& repeated = places[what];
    if (repeated.count++ == 0) {
      repeated.firstPlace = problem.where;
      order.push_back(what);
    }
  }
  std::vector<std::string> lines;
  lines.reserve(order.size());
  for (const std::string& what : order) {
    lines.push_back(lineOf(what, places[what]));
  }
  return lines;
}

std::string at(std::string_view list, std::size_t index) {
  return fmt::format("{}[{}]", list, index);
}

} // namespace stretch::gltf
