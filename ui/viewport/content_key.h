#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace stretch::ui {

/// FNV-1a over plain memory.
class ContentKey {
public:
  template <typename Plain>
  void add(const Plain& value) {
    addBytes(&value, sizeof(value));
  }
  template <typename Plain>
  void addAll(const std::vector<Plain>& values) {
    add(values.size());
    addBytes(values.data(), values.size() * sizeof(Plain));
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

private:
  void addBytes(const void* data, std::size_t bytes) {
    const auto* from = static_cast<const unsigned char*>(data);
    std::size_t i = 0;
    for (; i + 8 <= bytes; i += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, from + i, 8);
      hash_ = (hash_ ^ word) * 1099511628211ULL;
      hash_ ^= hash_ >> 29U;
    }
    for (; i < bytes; ++i) {
      hash_ = (hash_ ^ from[i]) * 1099511628211ULL;
    }
  }
  std::uint64_t hash_ = 1469598103934665603ULL;
};

} // namespace stretch::ui
