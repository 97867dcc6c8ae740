#include "core/gltf/json/json_document.h"

#include "core/gltf/json/json.h"

namespace stretch::gltf {

JsonDocument::JsonDocument() : json_(std::make_unique<Json>()) {}
JsonDocument::JsonDocument(Json json) : json_(std::make_unique<Json>(std::move(json))) {}
JsonDocument::JsonDocument(const JsonDocument& other) : json_(std::make_unique<Json>(*other)) {}
JsonDocument::JsonDocument(JsonDocument&& other) noexcept = default;
JsonDocument& JsonDocument::operator=(JsonDocument&& other) noexcept = default;
JsonDocument::~JsonDocument() = default;

JsonDocument& JsonDocument::operator=(const JsonDocument& other) {
  if (this != &other) {
    json_ = std::make_unique<Json>(*other);
  }
  return *this;
}

bool JsonDocument::isNull() const {
  return json_->is_null();
}

bool operator==(const JsonDocument& a, const JsonDocument& b) {
  return *a == *b;
}

bool operator==(const JsonDocument& a, const Json& b) {
  return *a == b;
}

} // namespace stretch::gltf
