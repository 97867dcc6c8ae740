#include "core/gltf/patch/journal.h"

#include <algorithm>
#include <utility>

#include "core/gltf/json/json_builder.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

// Steps are arrays: ["set", pointer, value], ["remove", pointer], ["cut", pointer, length].
constexpr const char* setStep = "set";
constexpr const char* removeStep = "remove";
constexpr const char* cutStep = "cut";

Json::json_pointer parentOf(Json::json_pointer pointer) {
  pointer.pop_back();
  return pointer;
}

std::string textAt(const Json& step, std::size_t index) {
  const bool isText = step.is_array() && index < step.size() && step[index].is_string();
  return isText ? step[index].get_ref<const std::string&>() : std::string();
}

// The root gets room for what is added to it (extras, buffers, skins...) before it grows.
Json withRoom(Json json) {
  constexpr std::size_t additions = 8;
  if (json.is_object()) {
    reserveMembers(json.get_ref<Json::object_t&>(), json.size() + additions);
  }
  return json;
}

bool takeBackStep(Json& json, const Json& step) {
  const std::string kind = textAt(step, 0);
  const Json::json_pointer pointer(textAt(step, 1));
  if (pointer.empty() || !json.contains(pointer)) {
    return false;
  }
  if (kind == setStep && step.size() == 3) {
    json.at(pointer) = step[2];
    return true;
  }
  if (kind == removeStep && json.at(parentOf(pointer)).is_object()) {
    json.at(parentOf(pointer)).erase(pointer.back());
    return true;
  }
  Json& array = json.at(pointer);
  const bool isCut =
      kind == cutStep && step.size() == 3 && array.is_array() && wholeNumber(step[2]).has_value();
  if (!isCut || *wholeNumber(step[2]) > array.size()) {
    return false;
  }
  array.erase(array.begin() + static_cast<std::ptrdiff_t>(*wholeNumber(step[2])), array.end());
  return true;
}

} // namespace

Journal::Journal(Json json) : json_(withRoom(std::move(json))) {}

void Journal::set(const Pointer& pointer, Json value) {
  if (json_.contains(pointer)) {
    remember({setStep, pointer.to_string(), json_.at(pointer)});
  } else {
    remember({removeStep, pointer.to_string()});
  }
  json_[pointer] = std::move(value);
}

void Journal::erase(const Pointer& pointer) {
  if (!json_.contains(pointer)) {
    return;
  }
  // Put back as a whole: a property that is only added again would come last.
  const Pointer parentPointer = parentOf(pointer);
  Json& parent = json_.at(parentPointer);
  remember({setStep, parentPointer.to_string(), parent});
  parent.erase(pointer.back());
}

std::size_t Journal::append(const Pointer& array, Json value) {
  if (!json_.contains(array)) {
    set(array, Json::array());
    rememberedLengths_[array.to_string()] = true;
  }
  Json& list = json_.at(array);
  if (!std::exchange(rememberedLengths_[array.to_string()], true)) {
    remember({cutStep, array.to_string(), list.size()});
  }
  list.push_back(std::move(value));
  return list.size() - 1;
}

Json Journal::undo() const {
  Json undo = Json::array();
  std::copy(steps_.rbegin(), steps_.rend(), std::back_inserter(undo));
  return undo;
}

bool takeBack(Json& json, const Json& undo) {
  if (!undo.is_array()) {
    return false;
  }
  try {
    return std::ranges::all_of(undo, [&](const Json& step) { return takeBackStep(json, step); });
  } catch (const Json::exception&) {
    return false;
  }
}

} // namespace stretch::gltf
