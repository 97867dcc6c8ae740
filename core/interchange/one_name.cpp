#include "core/interchange/one_name.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <set>
#include <string_view>
#include <vector>

namespace stretch::interchange {

namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::string_view endSite = "EndSite_"; // what the library puts before the parent's name

struct Span {
  std::size_t start = 0;
  std::size_t length = 0;
};

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// "NAME\0\1Model" as a text with its length before.
std::vector<Span> namesOfBinaryFbx(std::string_view text) {
  constexpr std::string_view mark("\0\1Model", 7);
  constexpr std::size_t longest = 1024;
  std::vector<Span> names;
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
    for (std::size_t length = 1; length <= std::min(longest, at); ++length) {
      const std::size_t start = at - length;
      std::uint32_t said = 0;
      if (start < 5) {
        break;
      }
      std::memcpy(&said, text.data() + start - 4, sizeof(said));
      if (text[start - 5] == 'S' && said == length + mark.size()) {
        names.push_back({start, length});
        break;
      }
    }
  }
  return names;
}

// Model: 123, "Model::NAME", "LimbNode" {
std::vector<Span> namesOfTextFbx(std::string_view text) {
  constexpr std::string_view mark = "\"Model::";
  std::vector<Span> names;
  for (std::size_t at = text.find("Model: "); at != std::string_view::npos;
       at = text.find("Model: ", at + 1)) {
    const std::size_t number = at + 7;
    std::size_t place = number;
    while (place < text.size() && isDigit(text[place])) {
      ++place;
    }
    const std::size_t open = text.find(mark, place);
    const std::size_t close = open == std::string_view::npos ? open : text.find('"', open + mark.size());
    if (place > number && close != std::string_view::npos && close < text.find('\n', place)) {
      names.push_back({open + mark.size(), close - open - mark.size()});
    }
  }
  return names;
}

std::vector<Span> namesOfBvh(std::string_view text) {
  std::vector<Span> names;
  const std::size_t end = std::min(text.find("MOTION"), text.size());
  bool isName = false;
  for (std::size_t at = text.find_first_not_of(blanks); at < end;) {
    const std::size_t stop = std::min(text.find_first_of(blanks, at), text.size());
    const std::string_view word = text.substr(at, stop - at);
    if (isName) {
      names.push_back({at, word.size()});
    }
    isName = !isName && (word == "ROOT" || word == "JOINT");
    at = text.find_first_not_of(blanks, stop);
  }
  return names;
}

Span attribute(std::string_view text, Span tag, std::string_view name) {
  const std::string_view whole = text.substr(tag.start, tag.length);
  const std::string mark = " " + std::string(name) + "=\"";
  const std::size_t at = whole.find(mark);
  const std::size_t close = at == std::string_view::npos ? at : whole.find('"', at + mark.size());
  return close == std::string_view::npos ? Span{}
                                         : Span{tag.start + at + mark.size(), close - at - mark.size()};
}

class Renamer {
public:
  explicit Renamer(std::span<const std::uint8_t> bytes) { made_.bytes.assign(bytes.begin(), bytes.end()); }

  [[nodiscard]] std::string_view text() const {
    return {reinterpret_cast<const char*>(made_.bytes.data()), made_.bytes.size()};
  }

  [[nodiscard]] std::string at(const Span& span) const {
    return std::string(text().substr(span.start, span.length));
  }

  void take(const std::string& name) { taken_.insert(name); }

  void parted(const std::vector<Span>& names) {
    for (const Span& span : names) {
      take(at(span));
    }
    std::set<std::string> seen;
    for (const Span& span : names) {
      if (!seen.insert(at(span)).second) {
        rename(span);
      }
    }
  }

  // Where no other name of its length is free it stays.
  void rename(const Span& span) {
    constexpr std::string_view digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    const std::string before = at(span);
    const std::size_t changed = std::min<std::size_t>(4, span.length);
    std::size_t& next = next_[span.length];
    for (std::size_t most = power(digits.size(), changed); next < most;) {
      std::string name = before;
      std::size_t rest = next++;
      for (std::size_t i = 0; i < changed; ++i, rest /= digits.size()) {
        name[span.length - 1 - i] = digits[rest % digits.size()];
      }
      if (taken_.insert(name).second) {
        std::memcpy(made_.bytes.data() + span.start, name.data(), name.size());
        made_.original.emplace(name, before);
        return;
      }
    }
  }

  [[nodiscard]] NamesApart finish() {
    made_.names = std::move(taken_);
    return std::move(made_);
  }

private:
  static std::size_t power(std::size_t base, std::size_t exponent) {
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
  }

  NamesApart made_;
  std::set<std::string> taken_;
  std::map<std::size_t, std::size_t> next_; // by the length of the name
};

// The library looks for an id among names, too: the first node that has it as either is taken for its own.
void partCollada(Renamer& renamer) {
  std::set<std::string> ids;
  std::vector<std::pair<Span, std::string>> named; // the name, and the id of its node
  const std::string_view text = renamer.text();
  for (std::size_t at = text.find("<node "); at != std::string_view::npos; at = text.find("<node ", at + 1)) {
    const Span tag{at, std::min(text.find('>', at), text.size()) - at};
    const Span id = attribute(text, tag, "id");
    const Span name = attribute(text, tag, "name");
    ids.insert(renamer.at(id));
    named.emplace_back(name, renamer.at(id));
  }
  ids.erase("");
  std::ranges::for_each(ids, [&](const std::string& id) { renamer.take(id); });
  std::ranges::for_each(named, [&](const auto& one) { renamer.take(renamer.at(one.first)); });
  for (const auto& [name, id] : named) {
    if (const std::string called = renamer.at(name); !id.empty() && called != id && ids.contains(called)) {
      renamer.rename(name);
    }
  }
}

} // namespace

std::string NamesApart::nameOf(const std::string& given) const {
  const bool isEnd = given.starts_with(endSite);
  const auto found = original.find(isEnd ? given.substr(endSite.size()) : given);
  return found == original.end() ? given : (isEnd ? std::string(endSite) : "") + found->second;
}

NamesApart withNamesApart(std::span<const std::uint8_t> bytes, Format format) {
  Renamer renamer(bytes);
  switch (format) {
  case Format::fbx:
    renamer.parted(renamer.text().starts_with("Kaydara FBX Binary") ? namesOfBinaryFbx(renamer.text())
                                                                    : namesOfTextFbx(renamer.text()));
    break;
  case Format::bvh:
    renamer.parted(namesOfBvh(renamer.text()));
    break;
  case Format::collada:
    partCollada(renamer);
    break;
  }
  return renamer.finish();
}

} // namespace stretch::interchange
