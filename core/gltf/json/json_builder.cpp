#include "core/gltf/json/json_builder.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace stretch::gltf {

namespace {

// A list or an object whose end is not read yet. What holds it does not grow meanwhile, so it stays where it
// is.
struct OpenValue {
  Json* value;
  std::unordered_map<std::string, std::size_t> places; ///< Of the members, where there are too many to look
                                                       ///< through.

  // The member of this name; none where it is new.
  std::optional<std::size_t> placeOf(const std::string& name) {
    constexpr std::size_t manyMembers = 64;
    const Json::object_t::Container& members = value->get_ref<const Json::object_t&>();
    if (members.size() < manyMembers) {
      const auto member =
          std::ranges::find(members, name, [](const auto& one) -> const std::string& { return one.first; });
      return member == members.end() ? std::nullopt : std::optional<std::size_t>(member - members.begin());
    }
    for (std::size_t i = places.size(); i < members.size(); ++i) {
      places.emplace(members[i].first, i);
    }
    const auto place = places.find(name);
    return place == places.end() ? std::nullopt : std::optional(place->second);
  }
};

constexpr std::string_view mark = "data:taken-out";

// The text with the mark in the place of each long string of data: the parser grows strings letter
// by letter, twice. A quote before "data:" begins a string in any valid JSON, unless it is escaped.
std::string withoutData(std::string_view text, std::vector<std::string_view>& taken) {
  constexpr std::string_view start = "\"data:";
  constexpr std::size_t isLong = 1 << 20;
  const auto isPlain = [](char letter) { return letter > ' ' && letter <= '~' && letter != '\\'; };
  std::string rest;
  std::size_t copied = 0;
  for (std::size_t at = text.find(start); at != std::string_view::npos; at = text.find(start, at + 1)) {
    const std::string_view data = text.substr(at + 1, text.find('"', at + 1) - at - 1);
    if (data.size() >= isLong && at > 0 && text[at - 1] != '\\' && std::ranges::all_of(data, isPlain)) {
      rest.append(text, copied, at + 1 - copied).append(mark);
      taken.push_back(data);
      copied = at + 1 + data.size();
    }
  }
  return taken.empty() ? rest : rest.append(text, copied);
}

// Takes the events of the library's parser. A value goes where `open_` ends: into the list there, or to the
// key that was named last.
class Builder {
public:
  explicit Builder(Json& root, std::span<const std::string_view> taken = {}) : root_(root), taken_(taken) {}

  [[nodiscard]] const std::optional<JsonFailure>& failure() const { return failure_; }
  [[nodiscard]] const std::optional<std::string>& repeated() const { return repeated_; }
  /// Whether a string of the text itself begins as a mark does, which took what belongs to another one.
  [[nodiscard]] bool hasMoreMarks() const { return hasMore_; }

  // NOLINTBEGIN(readability-identifier-naming): the library's names of its events
  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(Json::number_integer_t value) { return add(value); }
  bool number_unsigned(Json::number_unsigned_t value) { return add(value); }
  bool number_float(Json::number_float_t value, const std::string& /*text*/) { return add(value); }
  bool string(std::string& value) { return add(std::move(whole(value))); }
  bool binary(Json::binary_t& value) { return add(std::move(value)); }

  bool start_object(std::size_t /*count*/) { return open(Json::object()); }
  bool start_array(std::size_t /*count*/) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    auto& object = open_.back().value->get_ref<Json::object_t&>();
    Json::object_t::Container& members = object;
    if (const std::optional<std::size_t> present = open_.back().placeOf(whole(name))) {
      repeated_ = repeated_ ? repeated_ : pathTo(name);
      named_ = &members[*present].second;
      return true;
    }
    if (members.size() == members.capacity()) {
      reserveMembers(object, std::max<std::size_t>(2 * members.size(), fewMembers));
    }
    named_ = &members.emplace_back(std::move(name), nullptr).second;
    return true;
  }

  bool parse_error(std::size_t position, const std::string& /*token*/, const Json::exception& problem) {
    constexpr int numberOverflow = 406; // in the library's list of exceptions
    failure_ = {position, problem.id == numberOverflow};
    return false;
  }
  // NOLINTEND(readability-identifier-naming)

private:
  static constexpr std::size_t fewMembers = 4;

  // The string itself where a mark stands for it.
  std::string& whole(std::string& text) {
    if (text.starts_with(mark)) {
      hasMore_ = hasMore_ || taken_.empty();
      text = taken_.empty() ? text : std::string(taken_.front());
      taken_ = taken_.empty() ? taken_ : taken_.subspan(1);
    }
    return text;
  }

  // Of a key where every open value is the last one in what holds it, as long as none came twice.
  [[nodiscard]] std::string pathTo(const std::string& name) const {
    std::string path;
    for (const OpenValue& open : open_) {
      if (open.value->is_array()) {
        path.append("[").append(std::to_string(open.value->size() - 1)).append("]");
      } else {
        const bool isLast = &open == &open_.back();
        path.append(path.empty() ? "" : ".")
            .append(isLast ? name : open.value->get_ref<const Json::object_t&>().rbegin()->first);
      }
    }
    return path;
  }

  Json& place(Json value) {
    if (!open_.empty() && open_.back().value->is_array()) {
      return open_.back().value->get_ref<Json::array_t&>().emplace_back(std::move(value));
    }
    Json& target = open_.empty() ? root_ : *named_;
    target = std::move(value);
    return target;
  }

  bool add(Json value) {
    place(std::move(value));
    return true;
  }

  bool open(Json value) {
    open_.push_back({&place(std::move(value)), {}});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  Json& root_;
  std::span<const std::string_view> taken_; ///< By withoutData, those that were not put back yet.
  std::vector<OpenValue> open_;             ///< From the root inwards.
  Json* named_ = nullptr;
  std::optional<JsonFailure> failure_;
  bool hasMore_ = false;
  std::optional<std::string> repeated_;
};

} // namespace

void reserveMembers(Json::object_t& object, std::size_t count) {
  Json::object_t roomy;
  roomy.reserve(count);
  for (auto& [key, value] : object) {
    static_cast<Json::object_t::Container&>(roomy).emplace_back(key, std::move(value));
  }
  object.swap(roomy);
}

std::optional<JsonFailure> buildJson(std::string_view text, Json& tree) {
  std::vector<std::string_view> taken;
  if (text.find(mark) == std::string_view::npos) {
    const std::string rest = withoutData(text, taken);
    Builder builder(tree, taken);
    if (!taken.empty() && Json::sax_parse(rest, &builder) && !builder.hasMoreMarks()) {
      return std::nullopt;
    }
  }
  tree = nullptr; // an error is told by its place in the whole text
  Builder builder(tree);
  const bool isWhole = Json::sax_parse(text, &builder);
  if (!isWhole && !builder.failure()) {
    return JsonFailure{};
  }
  return builder.failure();
}

std::optional<std::string> repeatedKey(std::string_view text) {
  Json tree;
  Builder builder(tree);
  static_cast<void>(Json::sax_parse(text, &builder));
  return builder.repeated();
}

} // namespace stretch::gltf
