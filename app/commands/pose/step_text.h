#pragma once

#include <string>
#include <vector>

#include "app/document.h"
#include "app/history.h"
#include "app/sequence/sequence_document.h"

namespace stretch::app {

/// Says what an edit did, as the history, menus and messages name it: its label, the limbs that it changed
/// and the value that they have since. "Exaggerate – left arm ×3", "Change the range – left arm 21 to 27".
[[nodiscard]] std::string stepText(const std::string& label, const Document& before, const Document& after);

/// Says what an edit of a mesh sequence did: "Change the bones – 20".
[[nodiscard]] std::string stepText(const std::string& label, const SequenceDocument& before,
                                   const SequenceDocument& after);

/// One text for each state of a history; the beginning's is empty.
template <typename Document>
[[nodiscard]] std::vector<std::string> stepTexts(const History<Document>& history) {
  std::vector<std::string> texts = history.labels();
  for (std::size_t i = 1; i < texts.size(); ++i) {
    texts[i] = stepText(texts[i], history.at(i - 1), history.at(i));
  }
  return texts;
}

} // namespace stretch::app
