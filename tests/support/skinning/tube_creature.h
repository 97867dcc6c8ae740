#pragma once

#include "tests/support/skinning/tube_person.h"

namespace stretch::test {

// Bodies of tubes, about two units long, on the ground, facing +Z; joints by the names of their locators.

[[nodiscard]] TubePerson tubeQuadruped(bool hasTail = true);

/// With wings spread, and a tail.
[[nodiscard]] TubePerson tubeBird();

/// With so many pairs of legs, and an abdomen.
[[nodiscard]] TubePerson tubeInsect(int rows);

/// Upon two legs, its trunk halfway between standing and lying, without arms.
[[nodiscard]] TubePerson tubeStooping();

} // namespace stretch::test
