#include "app/open_document.h"

namespace stretch::app {

void OpenDocument::open(Opened opened) {
  const auto copied = character() != nullptr ? character()->view().copiedPose : std::nullopt;
  if (auto* document = std::get_if<Document>(&opened)) {
    session_.emplace<Session>(std::move(*document)).view().copiedPose = copied;
  } else {
    session_.emplace<SequenceSession>(std::get<SequenceDocument>(std::move(opened)));
  }
}

Session* OpenDocument::character() {
  return std::get_if<Session>(&session_);
}
const Session* OpenDocument::character() const {
  return std::get_if<Session>(&session_);
}
SequenceSession* OpenDocument::sequence() {
  return std::get_if<SequenceSession>(&session_);
}
const SequenceSession* OpenDocument::sequence() const {
  return std::get_if<SequenceSession>(&session_);
}

} // namespace stretch::app
