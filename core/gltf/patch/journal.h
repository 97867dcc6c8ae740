#pragma once

#include <map>
#include <string>
#include <utility>

#include "core/gltf/json/json.h"
#include "core/gltf/source/source.h"

namespace stretch::gltf {

/// A JSON document that remembers how to take back every change made through it, key order included.
class Journal {
public:
  using Pointer = Json::json_pointer;

  explicit Journal(Json json);

  [[nodiscard]] const Json& json() const { return json_; }
  /// The document, out of a journal that is not needed any more.
  [[nodiscard]] Json takeJson() && { return std::move(json_); }

  /// Sets a property or an element; the parent has to be there.
  void set(const Pointer& pointer, Json value);
  /// Removes a property of an object below the root.
  void erase(const Pointer& pointer);
  /// Adds to the end of an array, which is made where it is missing; answers the index.
  std::size_t append(const Pointer& array, Json value);

  /// Record that `takeBack` needs.
  [[nodiscard]] Json undo() const;

private:
  void remember(Json step) { steps_.push_back(std::move(step)); }

  Json json_;
  std::vector<Json> steps_;                       ///< In the order of the changes.
  std::map<std::string, bool> rememberedLengths_; ///< Arrays whose length before the first append is
                                                  ///< remembered.
};

/// Takes back all changes of a journal. False, and `json` in an undefined but valid state, when the steps do
/// not fit it.
[[nodiscard]] bool takeBack(Json& json, const Json& undo);

} // namespace stretch::gltf
