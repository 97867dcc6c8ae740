#pragma once

#include <optional>
#include <string>
#include <utility>

#include "app/history.h"
#include "core/base/check.h"

namespace stretch::app {

/// The one door for edits of an open document: a finished edit, or begin, preview, commit, cancel.
template <typename Document>
class Editing {
public:
  explicit Editing(Document start) : history_(std::move(start)) {}
  Editing(Editing&&) noexcept = default;
  Editing& operator=(Editing&&) noexcept = default;
  virtual ~Editing() = default;

  /// The document to show: the preview while a drag is on, else the current state.
  [[nodiscard]] const Document& document() const { return preview_ ? *preview_ : history_.current(); }
  [[nodiscard]] const History<Document>& history() const { return history_; }

  /// One finished edit, one undo step. Refused (false) while a drag is on.
  bool edit(Document changed, std::string label) {
    if (isDragging()) {
      return false;
    }
    const bool pushed = history_.push(std::move(changed), std::move(label));
    documentChanged();
    return pushed;
  }

  /// Another current state without a step: what belongs to the document and is kept beside its file.
  void restore(Document current) {
    history_.replaceCurrent(std::move(current));
    documentChanged();
  }

  /// A drag or a modal: begin remembers the state; each preview is computed from the state AT BEGIN; commit
  /// pushes one undo step (none when nothing changed), cancel restores.
  void begin(std::string label) {
    cancel();
    preview_ = history_.current();
    dragLabel_ = std::move(label);
  }
  [[nodiscard]] bool isDragging() const { return preview_.has_value(); }
  [[nodiscard]] const Document& atBegin() const { return history_.current(); }
  void preview(Document changed) {
    check(isDragging(), "a preview belongs to a drag that was begun");
    preview_ = std::move(changed);
    documentChanged();
  }
  void commit() {
    check(isDragging(), "a commit ends a drag that was begun");
    Document changed = std::move(*preview_);
    preview_.reset();
    history_.push(std::move(changed), std::move(dragLabel_));
    documentChanged();
  }
  void cancel() {
    preview_.reset();
    documentChanged();
  }

  bool undo() { ///< Cancels a drag first.
    cancel();
    const bool done = history_.undo();
    documentChanged();
    return done;
  }
  bool redo() {
    cancel();
    const bool done = history_.redo();
    documentChanged();
    return done;
  }

  void goTo(std::size_t position) { ///< Goes to a position of the history. Cancels a drag first.
    cancel();
    history_.goTo(position);
    documentChanged();
  }

protected:
  /// Another state is shown: what is selected may be gone.
  virtual void documentChanged() {}
  void markSaved() { history_.markSaved(); }

private:
  History<Document> history_;
  std::optional<Document> preview_;
  std::string dragLabel_;
};

} // namespace stretch::app
