#include "tests/support/fuzz/readers.h"

#include <algorithm>

#include "core/base/check.h"
#include "tests/support/fuzz/scene_readers.h"
#include "tests/support/fuzz/sequence_readers.h"

namespace stretch::test {

std::vector<Reader> fuzzedReaders() {
  return {{"gltf", readGltfAnyhow},   {"image", readImageAnyhow}, {"recipe", readRecipeAnyhow},
          {"work", readWorkAnyhow},   {"obj", readObjAnyhow},     {"ply", readPlyAnyhow},
          {"cache", readCacheAnyhow}, {"log", readLogAnyhow},     {"meshopt", readMeshoptAnyhow},
          {"draco", readDracoAnyhow}};
}

Reader readerNamed(std::string_view name) {
  const std::vector<Reader> readers = fuzzedReaders();
  const auto found =
      std::find_if(readers.begin(), readers.end(), [&](const Reader& reader) { return reader.name == name; });
  check(found != readers.end(), "there is a reader of this name");
  return *found;
}

} // namespace stretch::test
