#include "ui/batch/film.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/core.h>

#include "app/reference/reference_edits.h"
#include "app/schema/parse_text.h"
#include "core/anim/frames.h"
#include "core/base/file.h"
#include "core/base/file_series.h"
#include "ui/render/picture/image_edits.h"

namespace stretch::ui {

namespace {

constexpr int gap = 2; // pixels between two sides

// Draws some pictures of a side into their place on the whole ones.
Status drawPart(const FilmSide& side, const PictureOptions& options, const Box& shown, std::size_t begin,
                int left, std::span<Image> whole) {
  Result<PictureMaker> maker = PictureMaker::create(*side.scene, options, shown);
  if (!maker) {
    return maker.error();
  }
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const Result<Image> picture = maker->draw(side.pictures[begin + i]);
    if (!picture) {
      return picture.error();
    }
    paste(whole[i], *picture, left, 0);
  }
  return Success{};
}

// Only one side can be drawn at a time: a few pictures of the one, then as many of the other.
Status drawBeside(const Film& film, const PictureOptions& options,
                  const std::function<Status(std::size_t, const Image&)>& keep) {
  constexpr std::size_t mostBytes = 256U << 20U;
  const auto pixels =
      static_cast<std::size_t>(options.widthPixels) * static_cast<std::size_t>(options.heightPixels);
  const std::size_t atOnce = std::clamp<std::size_t>(mostBytes / (4 * pixels), 1, 32);
  PictureOptions half = options;
  half.widthPixels = (options.widthPixels - gap) / 2;
  Box shown;
  for (const FilmSide& side : film.sides) {
    shown.add(boxOfPictures(*side.scene, side.pictures));
  }
  const auto& ground = film.sides.front().pictures.front().content.style.palette.backgroundBottom;
  for (std::size_t begin = 0; begin < film.frames.size(); begin += atOnce) {
    const std::size_t count = std::min(atOnce, film.frames.size() - begin);
    std::vector<Image> whole(count, filled(options.widthPixels, options.heightPixels, ground));
    for (std::size_t side = 0; side < film.sides.size(); ++side) {
      const int left = side == 0 ? 0 : options.widthPixels - half.widthPixels;
      if (Status drawn = drawPart(film.sides[side], half, shown, begin, left, whole); !drawn) {
        return drawn;
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (Status kept = keep(begin + i, whole[i]); !kept) {
        return kept;
      }
    }
  }
  return Success{};
}

} // namespace

std::filesystem::path numberedName(const std::filesystem::path& path, double frame) {
  std::filesystem::path name = path;
  const std::string number = frame == std::round(frame) ? fmt::format("{:04d}", static_cast<int>(frame))
                                                        : fmt::format("{:08.3f}", frame);
  name.replace_filename(path.stem().string() + "-" + number + path.extension().string());
  return name;
}

Result<std::vector<double>> parseFrames(const std::string& text) {
  const std::size_t first = text.find(':');
  const std::size_t second = first == std::string::npos ? first : text.find(':', first + 1);
  const Result<Vec2> range = app::parseRange(text.substr(0, second), "--frames");
  if (!range) {
    return range.error();
  }
  const Result<double> step = second == std::string::npos
                                  ? Result<double>(1.0)
                                  : app::parseNumber(text.substr(second + 1), "--frames");
  if (!step || *step <= 0.0) {
    return Error{"the step has to be above 0", "--frames", "give A:B:STEP, such as 0:60:5"};
  }
  constexpr double mostPictures = 100000.0;
  const double count = std::floor((range->y - range->x) / *step + 1e-9);
  if (count > mostPictures) {
    return Error{fmt::format("{:.0f} pictures are too many", count + 1.0), "--frames",
                 "give a larger step: 100000 pictures at most"};
  }
  std::vector<double> frames;
  for (double i = 0.0; i <= count; i += 1.0) {
    frames.push_back(range->x + i * *step);
  }
  return frames;
}

Status checkFrames(const app::Document& document, int clip, const std::vector<double>& frames) {
  if (clip < 0) {
    return Success{};
  }
  const Clip& shown = app::clipOf(document, clip);
  const double last = std::max(lastFrame(shown), endInFrames(shown));
  const auto outside =
      std::ranges::find_if(frames, [&](double frame) { return !(frame >= 0.0 && frame <= last + 1e-6); });
  return outside == frames.end() ? Status(Success{})
                                 : Status(Error{fmt::format("there is no frame {:g}", *outside), shown.name,
                                                fmt::format("give frames from 0 to {:g}", last)});
}

Result<std::optional<FilmSound>> filmSoundOf(const app::Document& document, int clip,
                                             const std::vector<double>& frames) {
  const app::ReferenceSound sound = app::referenceOf(document, clip).sound;
  if (sound.file.empty() || sound.volume <= 0.0 || frames.empty()) {
    return std::optional<FilmSound>();
  }
  std::error_code failed;
  if (!std::filesystem::is_regular_file(sound.file, failed)) {
    return Error{"the sound of the reference is not there", sound.file, "choose it again, or take it off"};
  }
  const double rate = app::clipOf(document, clip).framesPerSecond;
  return std::optional(FilmSound{sound.file, (frames.front() - sound.startFrame) / rate, sound.volume});
}

Status drawFilm(const Film& film, const PictureOptions& options,
                const std::function<Status(std::size_t, const Image&)>& keep) {
  return film.sides.size() == 1
             ? renderSeries(*film.sides.front().scene, film.sides.front().pictures, options, keep)
             : drawBeside(film, options, keep);
}

Status writeFilm(const Film& film, const PictureOptions& options, const std::filesystem::path& path,
                 const FilmProgress& progress) {
  std::optional<VideoWriter> video;
  std::optional<FileSeries> series;
  if (isVideoName(path)) {
    Result<VideoWriter> opened = VideoWriter::open(
        {path, options.widthPixels, options.heightPixels, film.framesPerSecond, film.sound});
    if (!opened) {
      return opened.error();
    }
    video.emplace(std::move(opened).value());
  } else {
    series.emplace(path.parent_path());
  }
  const auto count = static_cast<double>(film.frames.size());
  Status drawn = drawFilm(film, options, [&](std::size_t index, const Image& picture) {
    if (progress && !progress(static_cast<double>(index) / count)) {
      return Status(Error{"was stopped", path.string(), "start it again"});
    }
    if (video) {
      return video->add(picture);
    }
    const Result<Bytes> png = encodePng(picture);
    return png ? series->add(numberedName(path, film.frames[index]), *png) : Status(png.error());
  });
  if (drawn) {
    drawn = video ? video->finish() : series->finish();
  }
  if (progress) {
    progress(1.0);
  }
  return drawn;
}

} // namespace stretch::ui
