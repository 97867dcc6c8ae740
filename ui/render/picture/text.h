#pragma once

#include <memory>
#include <string_view>

#include <glm/vec4.hpp>

#include "core/scene/scene.h"

namespace stretch::ui {

/// A face of the interface's typeface (Inter, else what fontconfig offers for sans) that writes into
/// pictures.
class TextFace {
public:
  /// Nothing is written, but nothing fails either, on a system without any font.
  explicit TextFace(int heightPixels);
  TextFace(TextFace&&) noexcept;
  TextFace& operator=(TextFace&&) noexcept;
  ~TextFace();

  /// Writes UTF-8 text, its baseline starting at (x, y) pixels from the top left; what lies outside is cut
  /// off.
  void write(Image& image, int x, int y, std::string_view text, const glm::vec4& colorSrgb) const;
  [[nodiscard]] int widthOf(std::string_view text) const; ///< Pixels.

private:
  struct Library;
  std::unique_ptr<Library> library_;
};

} // namespace stretch::ui
