#pragma once

#include <algorithm>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace stretch::app {

/// Bytes that the steps of a history may take: some 16,000 of all kinds mixed (docs/trust.md), hundreds of
/// thousands of small ones, since a snapshot shares what did not change.
inline constexpr std::size_t mostHistoryBytes = std::size_t{256} << 20U;

/// Snapshots of a document with labels; undo and redo move an index. Where the steps take more than
/// `mostBytes` the oldest ones go, down to the last. A kind of document says with `sameDocument(a, b)` when
/// two are equal, and with `bytesBeyond(a, b)` what a takes that it does not share with b.
template <typename Document>
class History {
public:
  explicit History(Document start, std::size_t mostBytes = mostHistoryBytes) : mostBytes_(mostBytes) {
    entries_.push_back({std::move(start), {}, 0});
  }

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
    while (entries_.size() > index_ + 1) {
      bytes_ -= entries_.back().bytes;
      entries_.pop_back();
    }
    const std::size_t bytes = bytesBeyond(document, current());
    entries_.push_back({std::move(document), std::move(label), bytes});
    bytes_ += bytes;
    ++index_;
    forgetOldest();
    return true;
  }

  /// Puts another state in the place of the current one: no step leads there, and what was saved is.
  void replaceCurrent(Document document) { entries_[index_].document = std::move(document); }

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

  /// Labels of what was done, the first first; entry 0 is the beginning and has no label, or what is left of
  /// steps that went and has that of the last of them.
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
  /// The state that was saved last; null where it is not there any more.
  [[nodiscard]] const Document* saved() const {
    return savedIndex_ < entries_.size() ? &entries_[savedIndex_].document : nullptr;
  }

  /// Bytes that the steps take, about.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

private:
  struct Entry {
    Document document;
    std::string label;
    std::size_t bytes = 0; ///< That it does not share with the one before.
  };
  static constexpr std::size_t never = static_cast<std::size_t>(-1);

  // The last step stays: it can always be taken back.
  void forgetOldest() {
    std::size_t gone = 0;
    while (bytes_ > mostBytes_ && gone + 2 < entries_.size()) {
      bytes_ -= entries_[++gone].bytes;
    }
    entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(gone));
    index_ -= gone;
    if (savedIndex_ != never) {
      savedIndex_ = savedIndex_ < gone ? never : savedIndex_ - gone;
    }
  }

  std::size_t mostBytes_;
  std::size_t bytes_ = 0;
  std::deque<Entry> entries_; ///< The oldest go from the front, without the others moving.
  std::size_t index_ = 0;
  std::size_t savedIndex_ = 0;
};

} // namespace stretch::app
