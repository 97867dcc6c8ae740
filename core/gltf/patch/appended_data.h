#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/gltf/patch/journal.h"

namespace stretch::gltf {

/// New accessors, whose bytes go to the end of the buffer. Each use has a buffer view of its own, since glTF
/// does not let them share one; those of vertices say how far it is from one to the next.
class AppendedData {
public:
  enum class Use { animation, inverseBind, joints, weights };

  /// `buffer` is the index of the buffer that takes the bytes, `start` the first free byte in it, a multiple
  /// of 4.
  AppendedData(Journal& journal, std::size_t buffer, std::size_t start)
      : journal_(journal), buffer_(buffer), start_(start) {}

  /// Index of a new accessor over the values; `withBounds` writes min and max.
  std::size_t add(Use use, const char* type, std::size_t width, const std::vector<float>& values,
                  bool withBounds);

  /// Index of a new accessor over joints, four for each vertex.
  std::size_t addJoints(const std::vector<std::uint16_t>& joints);

  /// Completes the buffer views; answers all bytes, the first of which is `start` of the buffer.
  Bytes finish();

private:
  struct Run {
    std::optional<std::size_t> view;
    Bytes bytes;
  };

  Run& runOf(Use use) { return runs_[static_cast<std::size_t>(use)]; }
  std::size_t place(Use use, const void* values, std::size_t byteCount, Json accessor);
  void complete(Use use, Bytes& all);

  Journal& journal_;
  std::size_t buffer_;
  std::size_t start_;
  std::array<Run, 4> runs_;
};

} // namespace stretch::gltf
