#include <map>

#include "core/gltf/accessor.h"
#include "core/gltf/fields.h"
#include "core/gltf/json.h"
#include "core/gltf/patch_parts.h"

namespace stretch::gltf {

namespace {

using Pointer = Json::json_pointer;

constexpr std::size_t matrixSize = 16;

// The matrices of a skin as the file has them, identity where it has none.
std::vector<float> inverseBindNumbers(const Source& source, const Json& skin) {
  const std::size_t joints = sizeOf(skin, "joints");
  const int accessor = indexOr(skin, "inverseBindMatrices");
  std::vector<float> numbers = accessor >= 0 ? readFloats(source, accessor) : std::vector<float>();
  const std::size_t present = numbers.size();
  numbers.resize(joints * matrixSize, 0.0F);
  for (std::size_t i = present; i < numbers.size(); ++i) {
    numbers[i] = i % matrixSize % 5 == 0 ? 1.0F : 0.0F; // the diagonal
  }
  return numbers;
}

void store(const Mat4& matrix, float* numbers) {
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      numbers[column * 4 + row] = static_cast<float>(matrix[column][row]);
    }
    numbers[column * 4 + 3] = column == 3 ? 1.0F : 0.0F;
  }
}

} // namespace

void patchSkins(const Source& source, const std::vector<SkinSlot>& slots, Journal& journal,
                AppendedData& data) {
  std::map<int, std::vector<float>> matrices;
  for (const SkinSlot& slot : slots) {
    const auto skin = static_cast<std::size_t>(slot.skin);
    const auto [numbers, isNew] = matrices.try_emplace(slot.skin);
    if (isNew) {
      numbers->second = inverseBindNumbers(source, element(source.json, "skins", skin));
    }
    store(slot.inverseBind, numbers->second.data() + static_cast<std::size_t>(slot.slot) * matrixSize);
    journal.set(Pointer("/skins") / skin / "joints" / static_cast<std::size_t>(slot.slot), slot.node.value);
  }
  for (const auto& [skin, numbers] : matrices) {
    const std::size_t accessor = data.add(AppendedData::Use::inverseBind, "MAT4", matrixSize, numbers, false);
    journal.set(Pointer("/skins") / static_cast<std::size_t>(skin) / "inverseBindMatrices", accessor);
  }
}

} // namespace stretch::gltf
