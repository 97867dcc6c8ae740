#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stretch::test {

/// A reader of files, and the promise that no bytes bring it down: what can be read is whole and is used as
/// the program would use it, what cannot is refused with a reason. A broken promise ends the program.
struct Reader {
  std::string name; ///< As its programs (fuzz_NAME) and its seeds (tests/fuzz/seeds/NAME) are called.
  void (*read)(std::span<const std::uint8_t> bytes) = nullptr;
};

/// - gltf: opened, looked at, exaggerated, saved, and what was saved opened; the same file as a mesh sequence
/// - image: a texture
/// - recipe: placed on the bundled character, which is looked at
/// - work: what a file of ours keeps, taken up by the bundled character, looked at and kept again
/// - obj: an OBJ, a zero byte, its MTL
/// - ply: a PLY
/// - cache: of four points; a PC2 when it begins so, else an MDD
/// - log: the positions of a Sibernetic log, a zero byte, its membranes
/// - meshopt: one byte each for mode, filter, stride and two for the count; then packed data
/// - draco: packed data
[[nodiscard]] std::vector<Reader> fuzzedReaders();

/// One of them, which has to exist.
[[nodiscard]] Reader readerNamed(std::string_view name);

} // namespace stretch::test
