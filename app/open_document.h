#pragma once

#include <utility>
#include <variant>

#include "app/sequence/open_any.h"
#include "app/sequence/sequence_session.h"
#include "app/session.h"

namespace stretch::app {

/// Document that is open: nothing, a character or a mesh sequence, each with its history.
class OpenDocument {
public:
  OpenDocument() = default;
  explicit OpenDocument(Opened opened) { open(std::move(opened)); }

  /// Shows it in place of what was open. A pose that was copied from one character can be pasted on the next.
  void open(Opened opened);
  [[nodiscard]] bool isEmpty() const { return std::holds_alternative<std::monostate>(session_); }

  /// Null while something else is open.
  [[nodiscard]] Session* character();
  [[nodiscard]] const Session* character() const;
  [[nodiscard]] SequenceSession* sequence();
  [[nodiscard]] const SequenceSession* sequence() const;

  /// Returns what `ask` answers of the session that is open, of either kind; `whenEmpty` without one.
  template <typename Answer, typename Ask>
  [[nodiscard]] Answer with(Answer whenEmpty, const Ask& ask) {
    if (Session* const open = character()) {
      return ask(*open);
    }
    SequenceSession* const open = sequence();
    return open != nullptr ? ask(*open) : std::move(whenEmpty);
  }

private:
  std::variant<std::monostate, Session, SequenceSession> session_;
};

} // namespace stretch::app
