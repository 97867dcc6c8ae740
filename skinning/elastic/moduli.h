#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace stretch::skinning {

/// Stiffness by segment, so that stiff regions (a ribcage) can be named. Segments count from 0 at the body's
/// first end.
struct SegmentModuli {
  struct Range {
    std::size_t first = 0;
    std::size_t last = 0; ///< Inclusive.
    double youngModulus = 0.0;

    friend bool operator==(const Range&, const Range&) = default;
  };
  std::optional<double> youngModulus; ///< Modulus of every segment that no range names.
  std::vector<Range> ranges;          ///< Later ones win.

  /// Modulus of a segment; `fallback` where nothing is said.
  [[nodiscard]] double at(std::size_t segment, double fallback) const;

  friend bool operator==(const SegmentModuli&, const SegmentModuli&) = default;
};

/// JSON: {"young": 3770, "segments": [{"from": 0, "to": 4, "young": 20000}, ...]}; both keys may be left out,
/// an unknown one is an error that names it. Moduli are positive.
[[nodiscard]] Result<SegmentModuli> parseModuli(std::string_view text);

/// Returns the JSON that parseModuli reads.
[[nodiscard]] std::string moduliText(const SegmentModuli& moduli);

} // namespace stretch::skinning
