#pragma once

#include <string>
#include <vector>

namespace stretch::app {

/// Limbs or controllers that are selected together by one name: of one kind, as a selection is.
struct SelectionSet {
  std::string name;                     ///< Not empty, and of no other set.
  std::vector<std::string> limbs;       ///< Ids; empty where it is a set of controllers.
  std::vector<std::string> controllers; ///< Ids; empty where it is a set of limbs.

  [[nodiscard]] bool empty() const { return limbs.empty() && controllers.empty(); }
  friend bool operator==(const SelectionSet&, const SelectionSet&) = default;
};

} // namespace stretch::app
