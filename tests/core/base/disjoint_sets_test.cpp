#include "core/base/disjoint_sets.h"

#include <catch2/catch.hpp>

using namespace stretch;

TEST_CASE("Things that are joined share the smallest of their numbers as leader, in every order") {
  const auto joins = GENERATE(std::vector<std::pair<std::size_t, std::size_t>>{{5, 2}, {2, 7}, {4, 7}},
                              std::vector<std::pair<std::size_t, std::size_t>>{{4, 7}, {7, 5}, {5, 2}},
                              std::vector<std::pair<std::size_t, std::size_t>>{{7, 4}, {2, 5}, {5, 4}});
  DisjointSets sets(8);
  for (const auto& [a, b] : joins) {
    CHECK(sets.join(a, b));
    CHECK_FALSE(sets.join(b, a));
  }
  for (const std::size_t one : {2, 4, 5, 7}) {
    CHECK(sets.leaderOf(one) == 2);
  }
  for (const std::size_t one : {0, 1, 3, 6}) {
    CHECK(sets.leaderOf(one) == one);
  }
}

TEST_CASE("A long row of things is one set, and a thing joined with itself is none the larger") {
  constexpr std::size_t count = 1000;
  DisjointSets sets(count);
  CHECK_FALSE(sets.join(3, 3));
  for (std::size_t i = count - 1; i > 0; --i) {
    CHECK(sets.join(i, i - 1));
  }
  for (std::size_t i = 0; i < count; ++i) {
    CHECK(sets.leaderOf(i) == 0);
  }
}
