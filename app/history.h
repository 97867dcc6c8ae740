#pragma once

#include <string>
#include <vector>

#include "app/document.h"

namespace stretch::app {

/// Snapshots of the document with labels; undo and redo move an index. Without limit: a snapshot shares what
/// did not change.
class History {
public:
  explicit History(Document start);

  [[nodiscard]] const Document& current() const { return entries_[index_].document; }
  /// Pushes a new state and drops what was undone. A state equal to the current one pushes nothing and
  /// answers false.
  bool push(Document document, std::string label);

  [[nodiscard]] bool canUndo() const { return index_ > 0; }
  [[nodiscard]] bool canRedo() const { return index_ + 1 < entries_.size(); }
  /// Label of what undo or redo would take back or bring; empty when there is nothing.
  [[nodiscard]] std::string undoLabel() const;
  [[nodiscard]] std::string redoLabel() const;
  bool undo();
  bool redo();

  /// Remembers the current state as the saved one.
  void markSaved();
  [[nodiscard]] bool isSaved() const { return index_ == savedIndex_; }

private:
  struct Entry {
    Document document;
    std::string label;
  };
  static constexpr std::size_t never = static_cast<std::size_t>(-1);
  std::vector<Entry> entries_;
  std::size_t index_ = 0;
  std::size_t savedIndex_ = 0;
};

} // namespace stretch::app
