#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/gltf/journal.h"

namespace stretch::gltf {

/// New accessors of floats, whose bytes go to the end of the buffer: one buffer view for the animations, one
/// for the inverse bind matrices (glTF does not let them share one), neither strided nor targeted.
class AppendedData {
public:
  enum class Use { animation, inverseBind };

  /// `buffer` is the index of the buffer that takes the bytes, `start` the first free byte in it, a multiple
  /// of 4.
  AppendedData(Journal& journal, std::size_t buffer, std::size_t start)
      : journal_(journal), buffer_(buffer), start_(start) {}

  /// Index of a new accessor over the values; `withBounds` writes min and max.
  std::size_t add(Use use, const char* type, std::size_t width, const std::vector<float>& values,
                  bool withBounds);

  /// Completes the buffer views; answers all bytes, the first of which is `start` of the buffer.
  Bytes finish();

private:
  struct Run {
    std::optional<std::size_t> view;
    Bytes bytes;
  };

  Run& runOf(Use use) { return use == Use::animation ? animation_ : inverseBind_; }
  void complete(const Run& run, Bytes& all);

  Journal& journal_;
  std::size_t buffer_;
  std::size_t start_;
  Run animation_;
  Run inverseBind_;
};

} // namespace stretch::gltf
