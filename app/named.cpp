#include "app/named.h"

#include <algorithm>
#include <cctype>

#include <fmt/core.h>

#include "core/base/number.h"
#include "rig/body/reading/planned_body.h"

namespace stretch::app {

namespace {

std::string limbList(const Document& document) {
  std::string list;
  for (const rig::Limb& limb : document.body.limbs) {
    list += (list.empty() ? "" : ", ") + limb.id;
  }
  return list.empty() ? "none was found" : list;
}

int indexOf(const std::string& text, std::size_t count) {
  const auto index = stretch::parseNumber<std::size_t>(std::string_view(text).substr(1));
  return index && *index < count ? static_cast<int>(*index) : -1;
}

bool isSameButForCase(const std::string& a, const std::string& b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string clipHint(const std::vector<Clip>& clips, const std::string& text) {
  const auto meant =
      std::ranges::find_if(clips, [&](const Clip& clip) { return isSameButForCase(clip.name, text); });
  return meant == clips.end() ? std::string() : "did you mean '" + meant->name + "'? ";
}

} // namespace

std::string clipList(const Document& document) {
  std::string list;
  for (std::size_t i = 0; i < document.clips->size(); ++i) {
    const std::string& name = (*document.clips)[i].name;
    list += (i == 0 ? "" : ", ") + (name.empty() ? fmt::format("#{}", i) : name);
  }
  return list;
}

Result<int> findClip(const Document& document, const std::string& text, const std::string& where) {
  const std::vector<Clip>& clips = *document.clips;
  if (clips.empty()) {
    const std::string file = document.source ? document.source->path.string() : std::string();
    return Error{"the file holds no clip", file.empty() ? "animations" : file + ": animations",
                 "give a file with an animation"};
  }
  if (text.empty()) {
    return 0;
  }
  int found = -1;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (clips[i].name == text && found >= 0) {
      return Error{"two clips are named '" + text + "'", where,
                   fmt::format("name one by its number, such as #{}", found)};
    }
    found = clips[i].name == text ? static_cast<int>(i) : found;
  }
  if (found < 0 && text.front() == '#') {
    found = indexOf(text, clips.size());
  }
  if (found < 0) {
    return Error{"there is no clip '" + text + "'", where,
                 clipHint(clips, text) + "the file has: " + clipList(document)};
  }
  return found;
}

Result<rig::Limb> findOrAddLimb(Document& document, const std::string& text, const std::string& where) {
  if (const rig::Limb* limb = findLimb(document, text)) {
    return *limb;
  }
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos && document.body.limbs.empty() && !document.body.warnings.empty()) {
    return Error{"there is no limb '" + text + "'", where, document.body.warnings.back()};
  }
  if (const std::string why = dots == std::string::npos ? rig::whyNoLimb(document.body, text) : "";
      !why.empty()) {
    return Error{"there is no limb '" + text + "'", where, why};
  }
  if (dots == std::string::npos) {
    return Error{"there is no limb '" + text + "'", where,
                 "limbs of this character: " + limbList(document) + "; any chain: JOINT_A..JOINT_B"};
  }
  Result<rig::Limb> chain = rig::chainLimb(*document.scene, text.substr(0, dots), text.substr(dots + 2));
  if (!chain) {
    return Error{chain.error().what, where + ": " + chain.error().where, chain.error().remedy};
  }
  document.chains.push_back(*chain);
  return chain;
}

std::string nodeTitle(const Document& document, NodeIndex node) {
  const std::string& name = document.scene->nodes[at(node)].name;
  return name.empty() ? fmt::format("#{}", node.value) : name;
}

rig::ControllerList controllersOf(const Document& document) {
  return rig::controllersOf(*document.scene, document.body.limbs, document.body.hips);
}

std::vector<rig::Controller> jointControllersOf(const Document& document) {
  return rig::jointControllers(*document.scene, document.body.limbs, document.body.hips);
}

Result<rig::Controller> findController(const Document& document, const rig::ControllerList& list,
                                       const std::string& id) {
  return rig::controllerNamed(*document.scene, document.body.limbs, document.body.hips, list, id);
}

} // namespace stretch::app
