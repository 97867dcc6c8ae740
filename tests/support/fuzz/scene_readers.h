#pragma once

#include <cstdint>
#include <span>

namespace stretch::test {

// Readers of characters and of what is kept with them; see fuzzedReaders.
void readGltfAnyhow(std::span<const std::uint8_t> bytes);
void readImageAnyhow(std::span<const std::uint8_t> bytes);
void readRecipeAnyhow(std::span<const std::uint8_t> bytes);
void readWorkAnyhow(std::span<const std::uint8_t> bytes);
void readMeshoptAnyhow(std::span<const std::uint8_t> bytes);
void readDracoAnyhow(std::span<const std::uint8_t> bytes);

} // namespace stretch::test
