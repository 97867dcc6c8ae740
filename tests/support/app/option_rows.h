#pragma once

#include <string>
#include <vector>

namespace stretch::test {

/// The words of two command lines that differ in one option. IN and OUT stand for the folders of inputs and
/// outputs.
struct OptionRow {
  std::string option;
  std::string without;
  std::string with;
};

/// Rows of options that stand behind the same words, each left out and given: {"--scale", "3"}; or with what
/// stands in its place.
[[nodiscard]] std::vector<OptionRow> rowsBehind(const std::string& words, const std::vector<OptionRow>& rows);

[[nodiscard]] std::vector<OptionRow> joinedRows(std::vector<OptionRow> rows,
                                                const std::vector<OptionRow>& more);

/// Options of `exaggerate --auto`, each where the clip shows it: the leap moves legs, the punch is followed
/// by the trunk, and read as no plan it has chains alone. IN has dummy.glb (the punch) and leap.glb.
[[nodiscard]] std::vector<OptionRow> styleRows();

} // namespace stretch::test
