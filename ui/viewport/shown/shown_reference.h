#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/document.h"
#include "app/reference/image_series.h"
#include "ui/render/scene/backdrop_pass.h"

namespace stretch::ui {

/// Reads an image of a reference. Its longest side is at most 2048 pixels: a larger one is made smaller by a
/// whole number.
[[nodiscard]] Result<Image> readReferenceImage(const std::filesystem::path& file);

/// An image where the reference puts it in the view.
[[nodiscard]] Backdrop backdropOf(const app::ReferenceImages& images, BackdropImage image);

/// Gives the image behind the character at a frame of a clip, where there is one.
using Backdrops = std::function<std::optional<Backdrop>(double frame)>;

/// For pictures without a window: an image is read when it is drawn, and the last one is kept. Empty where
/// the clip refers to none; an error where its series is not there.
[[nodiscard]] Result<Backdrops> backdropsOf(const app::Document& document, int clip);

} // namespace stretch::ui
