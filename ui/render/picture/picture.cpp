#include "ui/render/picture/picture.h"

#include <algorithm>

#include "ui/render/gl/offscreen_context.h"
#include "ui/render/picture/image_edits.h"
#include "ui/render/picture/text.h"
#include "ui/render/picture/viewport_renderer.h"

namespace stretch::ui {

namespace {

constexpr int smallestSide = 16;
constexpr int largestSide = 8192;

Camera cameraFor(const PictureOptions& options, const Viewport& viewport, const Box& shown) {
  if (options.camera) {
    return *options.camera;
  }
  Camera camera = lookFrom({}, options.view, options.facingYawRadians);
  if (options.towardsEye) {
    camera = lookingFrom(camera, *options.towardsEye);
  }
  return fitted(camera, viewport, shown, 0.045);
}

int labelHeight(const PictureOptions& options) {
  return std::clamp(options.heightPixels / 24, 11, 26);
}

Status checkSize(const PictureOptions& options) {
  const auto fits = [](int side) { return side >= smallestSide && side <= largestSide; };
  if (fits(options.widthPixels) && fits(options.heightPixels)) {
    return Success{};
  }
  return Error{"pictures are 16 to 8192 pixels along a side", "size", "choose a size in that range"};
}

} // namespace

// The context comes first, so that it goes last.
struct PictureMaker::Parts {
  OffscreenContext context;
  ViewportRenderer renderer;
  RenderTarget target;
  TextFace face;
  const Scene* scene = nullptr;
  SceneMeasures measures;
  PictureOptions options;
  View view;
  int scale = 1;
};

PictureMaker::PictureMaker(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
PictureMaker::PictureMaker(PictureMaker&&) noexcept = default;
PictureMaker& PictureMaker::operator=(PictureMaker&&) noexcept = default;
PictureMaker::~PictureMaker() = default;

Result<PictureMaker> PictureMaker::create(const Scene& scene, const PictureOptions& options,
                                          const Box& shown) {
  if (const Status size = checkSize(options); !size) {
    return size.error();
  }
  Result<OffscreenContext> context = OffscreenContext::create();
  if (!context) {
    return context.error();
  }
  Result<ViewportRenderer> renderer = ViewportRenderer::create();
  if (!renderer) {
    return renderer.error();
  }
  const int largest = std::max(options.widthPixels, options.heightPixels);
  const int scale = std::clamp(options.supersampling, 1, std::clamp(largestSide / largest, 1, 4));
  const Viewport viewport{static_cast<double>(options.widthPixels * scale),
                          static_cast<double>(options.heightPixels * scale), static_cast<double>(scale)};
  auto parts = std::make_unique<Parts>(Parts{std::move(context).value(),
                                             std::move(renderer).value(),
                                             {},
                                             TextFace(labelHeight(options)),
                                             &scene,
                                             measuresOf(scene, BoundsSampler(scene)),
                                             options,
                                             makeView(cameraFor(options, viewport, shown), viewport),
                                             scale});
  parts->renderer.setScene(scene);
  return PictureMaker(std::move(parts));
}

Result<Image> PictureMaker::draw(const PictureFrame& picture) {
  Parts& parts = *parts_;
  const PictureContent& content = picture.content;
  SceneStyle style = content.style;
  style.measures = parts.measures;
  if (style.backdrop) {
    if (const auto image = style.backdrop->image(); !image) {
      return image.error();
    }
  }
  if (content.shape) {
    parts.renderer.reshape(content.shape());
  }
  const View view = picture.through ? viewThrough(*picture.through, parts.view.viewport) : parts.view;
  const Overlay overlay = overlayOf(*parts.scene, view, content);
  const Status drawn =
      parts.renderer.draw(parts.target, view, {content.frame, content.ghosts, overlay, style});
  if (!drawn) {
    return drawn.error();
  }
  Image image = reduced(parts.target.readPixels(), parts.scale);
  makeOpaque(image);
  const int margin = labelHeight(parts.options);
  parts.face.write(image, margin, 2 * margin, picture.label, style.palette.label);
  if (parts.options.safeFrame) {
    const Viewport size{static_cast<double>(image.width), static_cast<double>(image.height)};
    const auto aspect = picture.through ? picture.through->lens.aspect : std::nullopt;
    outline(image, frameIn(size, aspect, safeFrame), glm::vec3(style.palette.label));
  }
  if (picture.legend) {
    drawLegend(image, parts.face, margin, *picture.legend, style.palette.label);
  }
  return image;
}

Box boxOfPictures(const Scene& scene, std::span<const PictureFrame> pictures) {
  const BoundsSampler bounds(scene);
  Box box;
  for (const PictureFrame& picture : pictures) {
    box.add(bounds.boxOf(scene, picture.content.frame));
    for (const Ghost& ghost : picture.content.ghosts) {
      box.add(bounds.boxOf(scene, ghost.frame));
    }
    for (const StyledTrail& trail : picture.content.trails) {
      for (const std::vector<Vec3>* path : {&trail.path.original, &trail.path.exaggerated}) {
        std::for_each(path->begin(), path->end(), [&](const Vec3& point) { box.add(point); });
      }
    }
  }
  return box;
}

Status renderSeries(const Scene& scene, std::span<const PictureFrame> pictures, const PictureOptions& options,
                    const std::function<Status(std::size_t, const Image&)>& keep) {
  Result<PictureMaker> maker = PictureMaker::create(scene, options, boxOfPictures(scene, pictures));
  if (!maker) {
    return maker.error();
  }
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Result<Image> image = maker->draw(pictures[i]);
    if (!image) {
      return image.error();
    }
    if (Status kept = keep(i, *image); !kept) {
      return kept;
    }
  }
  return Success{};
}

Result<Image> renderSheet(const Scene& scene, std::span<const PictureFrame> pictures,
                          const PictureOptions& options, int columns) {
  const SheetLayout layout = layOutSheet(pictures.size(), options.widthPixels, options.heightPixels, columns);
  if (const Status fits = checkSheet(layout, pictures.size()); !fits) {
    return fits.error();
  }
  Image sheet = filled(layout.widthPixels, layout.heightPixels,
                       pictures.front().content.style.palette.backgroundBottom);
  const Status made = renderSeries(scene, pictures, options, [&](std::size_t index, const Image& picture) {
    paste(sheet, picture, layout.left(index), layout.top(index));
    return Status(Success{});
  });
  if (!made) {
    return made.error();
  }
  return sheet;
}

} // namespace stretch::ui
