#pragma once

#include <memory>
#include <utility>

namespace stretch {

/// A leaf of a value document: copies share one immutable object until one of them is edited.
/// `identity()` is the key for caches: equal identities mean equal content (the reverse need not hold).
template <typename T>
class CopyOnWrite {
public:
  CopyOnWrite() : shared_(std::make_shared<const T>()) {}
  CopyOnWrite(T value) : shared_(std::make_shared<const T>(std::move(value))) {}

  const T& operator*() const { return *shared_; }
  const T* operator->() const { return shared_.get(); }
  [[nodiscard]] const void* identity() const { return shared_.get(); }

  /// Replaces the content by `change(copy of it)`; other copies of this leaf keep theirs.
  template <typename Change>
  void edit(Change&& change) {
    T copy = *shared_;
    std::forward<Change>(change)(copy);
    shared_ = std::make_shared<const T>(std::move(copy));
  }

  friend bool operator==(const CopyOnWrite& a, const CopyOnWrite& b) {
    return a.shared_ == b.shared_ || *a.shared_ == *b.shared_;
  }

private:
  std::shared_ptr<const T> shared_;
};

} // namespace stretch
