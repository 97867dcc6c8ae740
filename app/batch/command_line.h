#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace CLI { // NOLINT(readability-identifier-naming): the library's own
class App;
class Option;
} // namespace CLI

namespace stretch::app {

/// One option of a verb, while it is declared.
class DeclaredOption {
public:
  /// Says in one line what is wrong with a value; empty when nothing is.
  using Check = std::function<std::string(const std::string& text)>;

  explicit DeclaredOption(CLI::Option& option) : option_(&option) {}

  const DeclaredOption& required() const;
  /// Values that the option takes, at least and at most.
  const DeclaredOption& takes(int least, int most) const;
  const DeclaredOption& check(const Check& problemOf) const;
  const DeclaredOption& between(int least, int most) const;
  const DeclaredOption& oneOf(const std::vector<std::string>& choices) const;
  const DeclaredOption& excludes(const DeclaredOption& other) const;
  /// A wrong argument where the other is not given.
  const DeclaredOption& needs(const DeclaredOption& other) const;
  /// Shows the value that the variable holds now as the default.
  const DeclaredOption& showDefault() const;
  /// The heading in the help under which the option stands.
  const DeclaredOption& group(const std::string& heading) const;

private:
  friend class CommandLine;
  CLI::Option* option_;
};

/// The arguments of one verb: declares options whose values land in variables, which have to live as long.
/// The one seam to the library that takes command lines apart.
class CommandLine {
public:
  explicit CommandLine(CLI::App& verb);

  /// `name` is "--clip", "-o,--output", or "FILE" for an argument without a name.
  DeclaredOption option(const std::string& name, std::string& value, const std::string& help);
  DeclaredOption option(const std::string& name, int& value, const std::string& help);
  DeclaredOption option(const std::string& name, std::size_t& value, const std::string& help);
  DeclaredOption option(const std::string& name, double& value, const std::string& help);
  /// Several values after one name.
  DeclaredOption options(const std::string& name, std::vector<std::string>& values, const std::string& help);
  /// The name may be given as often as wanted, each time with one value.
  DeclaredOption repeated(const std::string& name, std::vector<std::string>& values, const std::string& help);
  DeclaredOption flag(const std::string& name, bool& value, const std::string& help);

  /// One of the two has to be given.
  void requireOne(const DeclaredOption& one, const DeclaredOption& other);

  /// Says what is wrong with all arguments together, once they are read: then they are wrong arguments, and
  /// the verb does not run.
  void checkTogether(const std::function<Status(const CommandLine&)>& problem);

  /// An option or a flag that is read by inOrder() only: it may be repeated, and its place among the others
  /// counts.
  DeclaredOption ordered(const std::string& name, const std::string& help);
  DeclaredOption orderedFlag(const std::string& name, const std::string& help);
  /// Command lines that the end of the verb's help shows, without the program's name.
  void examples(const std::vector<std::string>& lines);

  /// Every option given, with its text, in the order of the command line. To be asked after the line was
  /// parsed.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> inOrder() const;

private:
  /// To read what was given alone: what it declares is asked by nobody.
  CommandLine(CLI::App* verb, std::nullptr_t) : verb_(verb) {}

  CLI::App* verb_;
  std::shared_ptr<std::vector<std::function<void()>>> checks_; ///< Each throws what is wrong.
};

} // namespace stretch::app
