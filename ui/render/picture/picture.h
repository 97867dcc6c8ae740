#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "ui/render/picture/picture_content.h"
#include "ui/render/picture/picture_legend.h"
#include "ui/render/view/camera_view.h"

namespace stretch::ui {

/// One picture of a series.
struct PictureFrame {
  PictureContent content; ///< The measures in its style are taken from the scene instead.
  std::string label = {}; ///< "frame 12", written in the corner; empty for none.
  std::optional<PictureLegend> legend = {};
  std::optional<ThroughCamera> through = {}; ///< Instead of the camera of the series.
};

/// How pictures without a display are made.
struct PictureOptions {
  int widthPixels = 1280; ///< 16..8192.
  int heightPixels = 720;
  ViewDirection view = ViewDirection::threeQuarter;
  double facingYawRadians = 0.0;  ///< Direction that the character faces: 0 is +Z.
  std::optional<Vec3> towardsEye; ///< Direction, unit: instead of `view`, in perspective.
  bool safeFrame = false;         ///< The part that every screen shows is outlined.
  std::optional<Camera> camera;   ///< Instead of a standard view that fits what all frames show.
  int supersampling = 2;          ///< Pixels drawn for each pixel of the picture, along each side; 1..4.
};

/// Draws pictures of one scene, one after the other, with the same camera. Owns its context without a
/// display: use one at a time, on one thread, and not inside a window's frame.
class PictureMaker {
public:
  /// `shown` is what the standard view fits: boxOfPictures of the frames to come. The scene must outlive the
  /// maker.
  [[nodiscard]] static Result<PictureMaker> create(const Scene& scene, const PictureOptions& options,
                                                   const Box& shown);
  PictureMaker(PictureMaker&&) noexcept;
  PictureMaker& operator=(PictureMaker&&) noexcept;
  ~PictureMaker();

  /// Rows from the top, sRGB, opaque.
  [[nodiscard]] Result<Image> draw(const PictureFrame& picture);

private:
  struct Parts;
  explicit PictureMaker(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// Box of what the frames show: the character, its ghosts and the trails.
[[nodiscard]] Box boxOfPictures(const Scene& scene, std::span<const PictureFrame> pictures);

/// A series with one camera; `keep` gets each picture as it is made and may stop the work with an error.
Status renderSeries(const Scene& scene, std::span<const PictureFrame> pictures, const PictureOptions& options,
                    const std::function<Status(std::size_t, const Image&)>& keep);

/// A contact sheet: all pictures on one, row by row, options' size each. `columns` 0: about as wide as high.
/// An error for none, or where the sheet would be over 16384 pixels along a side.
[[nodiscard]] Result<Image> renderSheet(const Scene& scene, std::span<const PictureFrame> pictures,
                                        const PictureOptions& options, int columns = 0);

} // namespace stretch::ui
