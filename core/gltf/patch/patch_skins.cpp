#include <map>
#include <set>
#include <utility>

#include "core/gltf/import/accessor.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/patch_parts.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

using Pointer = Json::json_pointer;

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

// The skin keeps the joints that lose their slots, behind the others, where no vertex names them: importers
// that work out how a joint stands in the bind pose from its inverse bind matrix (Blender does) go on finding
// it.
void keepJoint(std::size_t skin, std::size_t slot, const Json& joint, std::vector<float>& numbers,
               Journal& journal) {
  const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(slot * matrixSize);
  const std::vector<float> own(first, first + matrixSize);
  numbers.insert(numbers.end(), own.begin(), own.end());
  journal.append(Pointer("/skins") / skin / "joints", joint);
}

} // namespace

void store(const Mat4& matrix, float* numbers) {
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      numbers[column * 4 + row] = static_cast<float>(matrix[column][row]);
    }
    numbers[column * 4 + 3] = column == 3 ? 1.0F : 0.0F;
  }
}

void patchSkins(const Source& source, const Edits& edits, Journal& journal, AppendedData& data) {
  std::map<int, std::vector<float>> matrices;
  const auto numbersOf = [&](int skin) {
    const auto [numbers, isNew] = matrices.try_emplace(skin);
    if (isNew) {
      numbers->second =
          inverseBindNumbers(source, element(source.json, "skins", static_cast<std::size_t>(skin)));
    }
    return numbers;
  };
  for (const AddedSlot& slot : edits.addedSlots) {
    std::vector<float>& numbers = numbersOf(slot.skin)->second;
    numbers.resize(numbers.size() + matrixSize);
    store(slot.inverseBind, numbers.data() + numbers.size() - matrixSize);
    journal.append(Pointer("/skins") / static_cast<std::size_t>(slot.skin) / "joints", slot.node.value);
  }
  std::set<std::pair<int, int>> kept; // skins and joints
  for (const SkinSlot& slot : edits.skinSlots) {
    const auto skin = static_cast<std::size_t>(slot.skin);
    const auto place = static_cast<std::size_t>(slot.slot);
    const Json& ofSource = element(source.json, "skins", skin);
    const auto numbers = numbersOf(slot.skin);
    const int joint = ofSource["joints"][place].get<int>();
    const bool losesSlot = slot.node != NodeIndex(joint); // a leaf that is used again keeps its own
    if (losesSlot && kept.insert({slot.skin, joint}).second) {
      keepJoint(skin, place, joint, numbers->second, journal);
    }
    store(slot.inverseBind, numbers->second.data() + place * matrixSize);
    journal.set(Pointer("/skins") / skin / "joints" / place, slot.node.value);
  }
  for (const auto& [skin, numbers] : matrices) {
    const std::size_t accessor = data.add(AppendedData::Use::inverseBind, "MAT4", matrixSize, numbers, false);
    journal.set(Pointer("/skins") / static_cast<std::size_t>(skin) / "inverseBindMatrices", accessor);
  }
}

} // namespace stretch::gltf
