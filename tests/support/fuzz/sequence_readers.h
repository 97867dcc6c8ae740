#pragma once

#include <cstdint>
#include <span>

namespace stretch::test {

// Readers of mesh sequences; see fuzzedReaders.
void readObjAnyhow(std::span<const std::uint8_t> bytes);
void readPlyAnyhow(std::span<const std::uint8_t> bytes);
void readCacheAnyhow(std::span<const std::uint8_t> bytes);
void readLogAnyhow(std::span<const std::uint8_t> bytes);

} // namespace stretch::test
