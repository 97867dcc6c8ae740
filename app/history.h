#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace stretch::app {

/// Snapshots of a document with labels; undo and redo move an index. Without limit: a snapshot shares what
/// did not change. A kind of document says with `sameDocument(a, b)` when two are equal.
template <typename Document>
class History {
public:
  explicit History(Document start) { entries_.push_back({std::move(start), {}}); }

  [[nodiscard]] const Document& current() const { return entries_[index_].document; }

  /// Pushes a new state and drops what was undone. A state equal to the current one pushes nothing and
  /// answers false.
  bool push(Document document, std::string label) {
    if (sameDocument(document, current())) {
      return false;
    }
    if (savedIndex_ != never && savedIndex_ > index_) {
      savedIndex_ = never; // the saved state is among what is dropped
    }
    entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(index_) + 1, entries_.end());
    entries_.push_back({std::move(document), std::move(label)});
    ++index_;
    return true;
  }

  [[nodiscard]] bool canUndo() const { return index_ > 0; }
  [[nodiscard]] bool canRedo() const { return index_ + 1 < entries_.size(); }
  /// Label of what undo or redo would take back or bring; empty when there is nothing.
  [[nodiscard]] std::string undoLabel() const { return canUndo() ? entries_[index_].label : std::string(); }
  [[nodiscard]] std::string redoLabel() const {
    return canRedo() ? entries_[index_ + 1].label : std::string();
  }
  bool undo() {
    const bool possible = canUndo();
    index_ -= possible ? 1 : 0;
    return possible;
  }
  bool redo() {
    const bool possible = canRedo();
    index_ += possible ? 1 : 0;
    return possible;
  }

  /// What was done, the first first; entry 0 is the beginning and has no label.
  [[nodiscard]] std::vector<std::string> labels() const {
    std::vector<std::string> all;
    for (const Entry& entry : entries_) {
      all.push_back(entry.label);
    }
    return all;
  }
  /// The state that a label led to.
  [[nodiscard]] const Document& at(std::size_t index) const { return entries_[index].document; }
  /// Index into labels() of what is shown.
  [[nodiscard]] std::size_t position() const { return index_; }
  /// Undoes or redoes as far as there, at most to the last one.
  void goTo(std::size_t position) { index_ = std::min(position, entries_.size() - 1); }

  /// Remembers the current state as the saved one.
  void markSaved() { savedIndex_ = index_; }
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
