#include "app/history.h"

#include <utility>

namespace stretch::app {

History::History(Document start) {
  entries_.push_back({std::move(start), {}});
}

bool History::push(Document document, std::string label) {
  if (sameDocument(document, current())) {
    return false;
  }
  if (savedIndex_ != never && savedIndex_ > index_) {
    savedIndex_ = never; // the saved state is among what is dropped
  }
  entries_.resize(index_ + 1, entries_.front());
  entries_.push_back({std::move(document), std::move(label)});
  ++index_;
  return true;
}

std::string History::undoLabel() const {
  return canUndo() ? entries_[index_].label : std::string();
}

std::string History::redoLabel() const {
  return canRedo() ? entries_[index_ + 1].label : std::string();
}

bool History::undo() {
  if (!canUndo()) {
    return false;
  }
  --index_;
  return true;
}

bool History::redo() {
  if (!canRedo()) {
    return false;
  }
  ++index_;
  return true;
}

void History::markSaved() {
  savedIndex_ = index_;
}

} // namespace stretch::app
