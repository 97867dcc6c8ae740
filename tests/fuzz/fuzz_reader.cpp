// A reader of files under libFuzzer: STRETCH_READER names it.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "tests/support/fuzz/damage.h"
#include "tests/support/fuzz/readers.h"

// libFuzzer's own way of changing bytes.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

const stretch::test::Reader& reader() {
  static const stretch::test::Reader found = stretch::test::readerNamed(STRETCH_READER);
  return found;
}

} // namespace

// NOLINTBEGIN(readability-identifier-naming): names that libFuzzer asks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reader().read({data, size});
  return 0;
}

// A GLB stays one: its parts are changed, and their lengths told as they are.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  const auto byLibrary = [](stretch::Bytes& bytes, std::size_t room) {
    const std::size_t length = bytes.size();
    bytes.resize(std::max(room, length));
    bytes.resize(LLVMFuzzerMutate(bytes.data(), length, bytes.size()));
  };
  const stretch::Bytes damaged = stretch::test::damagedGlb({data, size}, most, seed, byLibrary);
  if (damaged.empty()) {
    return LLVMFuzzerMutate(data, size, most);
  }
  std::copy(damaged.begin(), damaged.end(), data);
  return damaged.size();
}
// NOLINTEND(readability-identifier-naming)
