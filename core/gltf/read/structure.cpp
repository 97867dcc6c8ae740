#include "core/gltf/read/structure.h"

#include <algorithm>
#include <map>
#include <vector>

#include <fmt/core.h>

#include "core/gltf/json/json.h"
#include "core/gltf/read/extensions.h"
#include "core/gltf/read/schema.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

// Where in the file something is; made a text only when there is something to say about it.
struct Place {
  const Place* parent = nullptr;
  std::string_view name;
  std::size_t index = 0;
  bool isElement = false;

  [[nodiscard]] std::string text() const {
    const std::string head = parent == nullptr ? "" : parent->text();
    if (isElement) {
      return at(head, index);
    }
    return head.empty() || name.empty() ? head + std::string(name) : head + "." + std::string(name);
  }
};

class StructureCheck {
public:
  StructureCheck(const Json& root, Problems& problems) : root_(root), problems_(problems) {
    for (const Property& property : schema()) {
      properties_[property.owner].push_back(&property);
    }
  }

  void object(const Json& value, std::string_view kind, const Place& place) {
    if (!value.is_object()) {
      problems_.error(place.text(), "is no object");
      return;
    }
    for (const Property* const property : properties_[kind]) {
      propertyOf(value, *property, place);
    }
  }

private:
  void propertyOf(const Json& value, const Property& property, const Place& parent) {
    const Place place{&parent, property.name};
    if (const Json* found = find(value, property.name)) {
      propertyValue(*found, property, place);
    } else if (property.isRequired) {
      problems_.error(place.text(), "is missing");
    }
  }

  void propertyValue(const Json& value, const Property& property, const Place& place) {
    switch (property.kind) {
    case PropertyKind::object:
      return object(value, property.target, place);
    case PropertyKind::index:
      return index(value, property.target, place);
    case PropertyKind::indexMap:
      return indexMap(value, property.target, place);
    case PropertyKind::objects:
    case PropertyKind::indices:
    case PropertyKind::indexMaps:
    case PropertyKind::texts:
      return array(value, property, place);
    case PropertyKind::numbers:
      return numbers(value, property, place);
    case PropertyKind::localIndex:
    case PropertyKind::whole:
      return expect(wholeNumber(value) && isWithin(value, property),
                    "is no whole number in the allowed range", place);
    case PropertyKind::number:
      return expect(value.is_number() && isWithin(value, property), "is no number in the allowed range",
                    place);
    case PropertyKind::text:
      return expect(value.is_string(), "is no text", place);
    case PropertyKind::flag:
      return expect(value.is_boolean(), "is neither true nor false", place);
    }
  }

  void expect(bool holds, std::string_view complaint, const Place& place) {
    if (!holds) {
      problems_.error(place.text(), std::string(complaint));
    }
  }

  static bool isWithin(const Json& value, const Property& property) {
    const auto number = value.get<double>();
    return number >= property.minimum && number <= property.maximum;
  }

  void index(const Json& value, std::string_view target, const Place& place) {
    const std::optional<std::uint64_t> whole = wholeNumber(value);
    if (!whole) {
      problems_.error(place.text(), fmt::format("is no index into {}", target));
    } else if (*whole >= sizeOf(root_, target)) {
      problems_.error(place.text(), fmt::format("refers to {}[{}], which is not there", target, *whole));
    }
  }

  void indexMap(const Json& value, std::string_view target, const Place& place) {
    if (!value.is_object()) {
      problems_.error(place.text(), "is no object");
      return;
    }
    for (const auto& [name, one] : value.items()) {
      index(one, target, {&place, name});
    }
  }

  void array(const Json& value, const Property& property, const Place& place) {
    if (!value.is_array()) {
      problems_.error(place.text(), "is no array");
      return;
    }
    if (value.empty()) {
      problems_.violation(place.text(), "is an empty array, which glTF does not allow",
                          "it is taken as absent");
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      const Place elementPlace{&place, {}, i, true};
      arrayElement(value[i], property, elementPlace);
    }
  }

  void arrayElement(const Json& value, const Property& property, const Place& place) {
    if (property.kind == PropertyKind::objects) {
      object(value, property.target, place);
    } else if (property.kind == PropertyKind::indices) {
      index(value, property.target, place);
    } else if (property.kind == PropertyKind::indexMaps) {
      indexMap(value, property.target, place);
    } else {
      expect(value.is_string(), "is no text", place);
    }
  }

  void numbers(const Json& value, const Property& property, const Place& place) {
    const bool areNumbers =
        value.is_array() && std::ranges::all_of(value, [](const Json& one) { return one.is_number(); });
    const bool fits =
        areNumbers && (property.count == 0 || value.size() == static_cast<std::size_t>(property.count));
    expect(fits,
           property.count == 0 ? "is not an array of numbers"
                               : fmt::format("is not an array of {} numbers", property.count),
           place);
  }

  const Json& root_;
  Problems& problems_;
  std::map<std::string_view, std::vector<const Property*>> properties_; // by their owners
};

void validateVersion(const Json& json, Problems& problems) {
  const Json* asset = find(json, "asset");
  const std::string version = asset == nullptr ? "" : textOr(*asset, "version");
  const std::string minimum = asset == nullptr ? "" : textOr(*asset, "minVersion", version);
  if (!version.empty() && (!version.starts_with("2.") || !minimum.starts_with("2."))) {
    problems.error("asset.version", fmt::format("glTF {} is not supported, only 2.0", version.substr(0, 20)),
                   "export it as glTF 2.0");
  }
}

void validateRequiredExtensions(const Json& json, Problems& problems) {
  std::string hiding;
  for (std::size_t i = 0; i < sizeOf(json, "extensionsRequired"); ++i) {
    const auto name = element(json, "extensionsRequired", i).get<std::string>();
    const ExtensionSupport support = supportOf(name);
    if (support == ExtensionSupport::hiding) {
      hiding += (hiding.empty() ? "" : ", ") + name;
    } else if (support == ExtensionSupport::ignored) {
      problems.warning(at("extensionsRequired", i),
                       fmt::format("{} is not supported; the file is shown without it", name));
    }
  }
  if (!hiding.empty()) {
    problems.error("extensionsRequired", fmt::format("needs {}, which cannot be read", hiding),
                   "export it without compression");
  }
}

} // namespace

void validateStructure(const Json& json, Problems& problems) {
  validateVersion(json, problems);
  if (problems.hasErrors()) {
    return; // another version has other rules
  }
  StructureCheck(json, problems).object(json, "root", {});
  if (!problems.hasErrors()) {
    validateRequiredExtensions(json, problems);
  }
}

} // namespace stretch::gltf
