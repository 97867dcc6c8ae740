#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace stretch::gltf {

enum class Severity {
  error,     ///< Cannot be read.
  violation, ///< Breaks the specification, though what is meant can be read: see Tolerance.
  warning,   ///< Odd, or wrong in a way that files in use are known for.
};

/// One thing that is wrong or odd in a file.
struct Problem {
  Severity severity = Severity::error;
  std::string where; ///< "meshes[0].primitives[1].attributes.POSITION"; empty for the file as a whole.
  std::string what;
  std::string remedy; ///< The way out; for a violation, what reading makes of it; empty when there is
                      ///< nothing special.

  friend bool operator==(const Problem&, const Problem&) = default;
};

/// Problems in the order in which they were found. Keeps at most `capacity` of them, so that a broken file
/// cannot fill the memory with complaints; the first error is always kept.
class Problems {
public:
  static constexpr std::size_t capacity = 20000;

  void error(std::string where, std::string what, std::string remedy = {});
  /// `mend`: what reading makes of it ("it is normalised").
  void violation(std::string where, std::string what, std::string mend = {});
  void warning(std::string where, std::string what);
  void add(const Problems& others);

  [[nodiscard]] bool hasErrors() const { return hasErrors_; }
  [[nodiscard]] bool hasViolations() const;
  [[nodiscard]] const std::vector<Problem>& list() const { return list_; }

  /// The first error, or without one the first violation, as an error for the user; there has to be one.
  [[nodiscard]] Error firstError() const;

  /// Warnings and violations, one line each; those that differ only in their place share a line.
  [[nodiscard]] std::vector<std::string> warningLines() const;

private:
  std::vector<Problem> list_;
  bool hasErrors_ = false;
};

/// "nodes[3]"
[[nodiscard]] std::string at(std::string_view list, std::size_t index);

} // namespace stretch::gltf
