#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

namespace stretch {

/// FNV-1a, 64 bits (http://www.isthe.com/chongo/tech/comp/fnv): the same at every start and on every machine.
/// For keys of caches, names and changes by accident, not against anyone who means it.
class Hash {
public:
  void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
      value_ = (value_ ^ byte) * prime;
    }
  }
  void add(std::string_view text) { add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}); }

  /// The memory of values without padding, eight bytes at a time and with another answer than `add`: for keys
  /// that live no longer than the program.
  template <typename Plain>
  requires std::is_trivially_copyable_v<Plain>
  void mix(std::span<const Plain> values) {
    const auto* from = reinterpret_cast<const std::uint8_t*>(values.data());
    std::size_t left = values.size_bytes();
    for (; left >= sizeof(std::uint64_t); left -= sizeof(std::uint64_t), from += sizeof(std::uint64_t)) {
      std::uint64_t word = 0;
      std::memcpy(&word, from, sizeof(word));
      value_ = (value_ ^ word) * prime;
      value_ ^= value_ >> 29U;
    }
    add({from, left});
  }
  template <typename Plain>
  requires std::is_trivially_copyable_v<Plain>
  void mix(const Plain& value) { mix(std::span<const Plain>(&value, 1)); }

  [[nodiscard]] std::uint64_t value() const { return value_; }

private:
  static constexpr std::uint64_t prime = 0x100000001B3U;
  std::uint64_t value_ = 0xCBF29CE484222325U;
};

} // namespace stretch
