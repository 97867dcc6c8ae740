#pragma once

#include <memory>

#include <nlohmann/json_fwd.hpp>

namespace stretch::gltf {

/// JSON with the order of its keys kept, as the file has it. Complete only where core/gltf/json/json.h is
/// included.
using Json = nlohmann::ordered_json;

/// A Json as a value, for structs whose header must not pull in the whole library: it copies, compares and is
/// read as the Json it holds. Null until it is given one.
class JsonDocument {
public:
  JsonDocument();
  JsonDocument(Json json); // NOLINT(google-explicit-constructor): stands for the Json it holds
  JsonDocument(const JsonDocument& other);
  JsonDocument(JsonDocument&& other) noexcept;
  JsonDocument& operator=(const JsonDocument& other);
  JsonDocument& operator=(JsonDocument&& other) noexcept;
  ~JsonDocument();

  [[nodiscard]] bool isNull() const;

  operator const Json&() const { return *json_; } // NOLINT(google-explicit-constructor)
  operator Json&() { return *json_; }             // NOLINT(google-explicit-constructor)
  const Json& operator*() const { return *json_; }
  Json& operator*() { return *json_; }
  const Json* operator->() const { return json_.get(); }
  Json* operator->() { return json_.get(); }

  friend bool operator==(const JsonDocument& a, const JsonDocument& b);
  friend bool operator==(const JsonDocument& a, const Json& b);

private:
  std::unique_ptr<Json> json_; ///< Never empty, except in a document that was moved from.
};

} // namespace stretch::gltf
