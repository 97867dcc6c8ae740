#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "core/base/file.h"

namespace stretch::test {

/// Changes bytes at random; they may become as many as `room`.
using ChangeBytes = std::function<void(Bytes& bytes, std::size_t room)>;

/// A GLB with its JSON, one value of it, or its data changed, at most `most` bytes long; empty for what is no
/// GLB, and where it would be longer.
[[nodiscard]] Bytes damagedGlb(std::span<const std::uint8_t> glb, std::size_t most, unsigned seed,
                               const ChangeBytes& change);

} // namespace stretch::test
