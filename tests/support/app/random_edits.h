#pragma once

#include <random>

#include "app/document.h"

namespace stretch::test {

class Dice {
public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

private:
  std::mt19937 engine_;
};

/// The document after an edit at random, of its first clip: trails, adjustments, keys, holds, weight, rates.
/// Some change nothing.
[[nodiscard]] app::Document randomEdit(const app::Document& document, Dice& dice);

} // namespace stretch::test
