#include "app/schema/selection_set_json.h"

#include <algorithm>

#include "app/schema/entry_schema.h"

namespace stretch::app {

namespace {

using gltf::Json;

EntryMember<SelectionSet> idsMember(const std::string& key, std::vector<std::string> SelectionSet::*ids) {
  return {key, [=](const SelectionSet& set) { return Json(set.*ids); },
          [=](const Json& json, SelectionSet& set) -> Status {
            const auto isText = [](const Json& id) { return id.is_string(); };
            if (!json.is_array() || !std::ranges::all_of(json, isText)) {
              return Error{"is not a list of names", key, R"(give ids, such as ["left-hand", "right-hand"])"};
            }
            set.*ids = json.get<std::vector<std::string>>();
            return Success{};
          },
          false, [=](const SelectionSet& set) { return !(set.*ids).empty(); }};
}

EntrySchema<SelectionSet> selectionSetSchema() {
  return {needed(entryMember("name", 1.0, &SelectionSet::name)), idsMember("limbs", &SelectionSet::limbs),
          idsMember("controllers", &SelectionSet::controllers)};
}

} // namespace

Json selectionSetsToJson(const std::vector<SelectionSet>& sets) {
  Json list = Json::array();
  for (const SelectionSet& set : sets) {
    list.push_back(writeEntry(selectionSetSchema(), set));
  }
  return list;
}

Result<std::vector<SelectionSet>> selectionSetsFromJson(const Json& json) {
  const auto unknown = [](const std::string& key) -> Status {
    return Error{"is not a part of a selection set", key, keysOf(selectionSetSchema())};
  };
  if (!json.is_array()) {
    return Error{"is not a list", "selection_sets", "give a list of selection sets"};
  }
  std::vector<SelectionSet> sets;
  for (const Json& entry : json) {
    SelectionSet set;
    if (const Status read = readEntry(entry, selectionSetSchema(), unknown, set); !read) {
      return read.error();
    }
    const bool isKnown = std::ranges::find(sets, set.name, &SelectionSet::name) != sets.end();
    if (set.name.empty() || isKnown || set.limbs.empty() == set.controllers.empty()) {
      return Error{"is not a selection set of its own", "selection_sets",
                   "give each a name of its own, and limbs or controllers"};
    }
    sets.push_back(std::move(set));
  }
  return sets;
}

} // namespace stretch::app
