#include "tests/support/fuzz/damage.h"

#include <random>
#include <string>

#include "core/gltf/json/json.h"
#include "core/gltf/source/glb.h"
#include "tests/support/damaged_json.h"

namespace stretch::test {

namespace {

void changeText(std::string& text, std::size_t room, const ChangeBytes& change) {
  Bytes bytes(text.begin(), text.end());
  change(bytes, room);
  text.assign(bytes.begin(), bytes.end());
}

void changeValues(std::string& text, std::mt19937& random) {
  gltf::Json json = gltf::Json::parse(text, nullptr, false);
  for (auto changes = 1 + random() % 3; !json.is_discarded() && json.is_structured() && changes > 0;
       --changes) {
    json = withOtherValue(std::move(json), random);
    text = json.dump(-1, ' ', false, gltf::Json::error_handler_t::replace);
  }
}

} // namespace

Bytes damagedGlb(std::span<const std::uint8_t> glb, std::size_t most, unsigned seed,
                 const ChangeBytes& change) {
  Result<gltf::Glb> parts = gltf::readGlb(glb);
  if (!gltf::isGlb(glb) || !parts || glb.size() >= most) {
    return {};
  }
  std::mt19937 random(seed);
  const std::size_t room = most - glb.size();
  switch (random() % 4) {
  case 0:
    changeText(parts->json, parts->json.size() + room, change);
    break;
  case 1:
    change(parts->binary, parts->binary.size() + room);
    break;
  default:
    changeValues(parts->json, random);
    break;
  }
  const Result<Bytes> written = gltf::writeGlb(*parts);
  return written && written->size() <= most ? *written : Bytes();
}

} // namespace stretch::test
