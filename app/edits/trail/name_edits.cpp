#include "app/edits/trail/name_edits.h"

#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/trail_edits.h"

namespace stretch::app {

namespace {

constexpr std::size_t longestName = 80;

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

/// Not longer than the most, and no half of a letter at its end.
std::string shortened(std::string text) {
  if (text.size() > longestName) {
    std::size_t end = longestName;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
      --end;
    }
    text.resize(end);
  }
  return text;
}

} // namespace

std::string keptName(const std::string& typed) {
  return shortened(trimmed(typed));
}

Result<Document> renameTrail(const Document& document, int trailId, const std::string& name) {
  Document changed = document;
  rig::Trail* const trail = findTrail(changed, trailId);
  if (trail == nullptr) {
    return missingTrail(trailId);
  }
  trail->name = keptName(name);
  return changed;
}

Result<Document> renameGroup(const Document& document, int trailId, const std::string& name) {
  const std::vector<int> members = groupMembers(document, trailId);
  if (members.empty()) {
    return Error{"the trail stands alone", "trail " + std::to_string(trailId), "group it with another one"};
  }
  Document changed = document;
  for (const int id : members) {
    findTrail(changed, id)->groupName = keptName(name);
  }
  return changed;
}

} // namespace stretch::app
