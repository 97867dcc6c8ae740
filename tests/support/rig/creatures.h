#pragma once

#include <string>
#include <vector>

#include "tests/support/rig/synthetic_biped.h"

namespace stretch::test {

/// Made-up bodies that are no bipeds, about 2 units long, standing on the floor, facing +Z, left at +X.
/// Joints are named by their keys ("thigh.l") until the names are taken away.
struct Creature {
  std::string title;
  std::string plan; ///< That it is of.
  SyntheticBiped body;
};

[[nodiscard]] SyntheticBiped makeHorse(); ///< With scapulae, and hind legs of four bones that end in hoofs.
[[nodiscard]] SyntheticBiped makeManyLegged(int rows);
[[nodiscard]] SyntheticBiped makeSnake();
[[nodiscard]] SyntheticBiped makeFish();
[[nodiscard]] SyntheticBiped makeBird();
[[nodiscard]] SyntheticBiped makeCentaur();

/// One of each.
[[nodiscard]] std::vector<Creature> creatures();

void nameByKeys(SyntheticBiped& body);

} // namespace stretch::test
