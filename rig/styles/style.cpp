#include "rig/styles/style.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/base/lower_case.h"

namespace stretch::rig {

namespace {

bool isTorso(LimbKind kind) {
  return isTrunk({kind});
}

// As much exaggeration as `strength` says, within the range.
double within(const ScaleRange& range, double strength) {
  return std::clamp(1.0 + strength * (range.usual - 1.0), range.least, std::max(range.least, range.most));
}

double stretchOf(const StyledLimb& limb) {
  return std::abs(limb.settings.scale - 1.0);
}

// The range of the kinds for which `isMeant` holds; nothing where none of the limbs is of such a kind.
template <typename IsMeant>
std::optional<ScaleRange> rangeOf(const std::vector<StyledLimb>& limbs, const IsMeant& isMeant) {
  std::optional<ScaleRange> range;
  const StyledLimb* strongest = nullptr;
  for (const StyledLimb& limb : limbs) {
    if (!isMeant(limb.kind)) {
      continue;
    }
    const double scale = std::min(limb.settings.scale, largestScale); // more is no style's to ask for
    strongest = strongest == nullptr || stretchOf(limb) > stretchOf(*strongest) ? &limb : strongest;
    range = range.value_or(ScaleRange{1.0, 1.0, 1.0});
    range->least = std::min(range->least, scale);
    range->most = std::max(range->most, scale);
    range->usual = std::min(strongest->settings.scale, largestScale);
  }
  return range;
}

} // namespace

std::string_view originName(StyleOrigin origin) {
  return origin == StyleOrigin::measured ? "measured" : origin == StyleOrigin::ours ? "ours" : "own";
}

const Style* styleNamed(const std::vector<Style>& styles, std::string_view name) {
  const std::string wanted = lowerCase(name);
  const Style* part = nullptr;
  int parts = 0;
  for (auto style = styles.rbegin(); style != styles.rend(); ++style) { // one's own come last
    const std::string own = lowerCase(style->name);
    if (own == wanted) {
      return &*style;
    }
    if (!wanted.empty() && own.find(wanted) != std::string::npos) {
      part = &*style;
      ++parts;
    }
  }
  return parts == 1 ? part : nullptr;
}

const ScaleRange& scalesOf(const Style& style, LimbKind kind) {
  return isTorso(kind)           ? style.torso
         : kind == LimbKind::arm ? style.arm
         : kind == LimbKind::leg ? style.leg
                                 : style.other;
}

double styledScale(const Style& style, LimbKind kind, double strength) {
  return within(scalesOf(style, kind), strength);
}

TrailSettings styledSettings(const TrailSettings& settings, const Style& style, LimbKind kind,
                             double strength) {
  TrailSettings styled = settings;
  styled.scale = styledScale(style, kind, strength);
  styled.axes = {true, style.axes == AxesRule::all, true};
  styled.reference = style.reference;
  styled.bend = kind == LimbKind::arm || kind == LimbKind::leg ? style.bend : settings.bend;
  styled.remap = style.remap;
  styled.easeIn = style.easeIn;
  styled.easeOut = style.easeOut;
  styled.overshoot = std::max(settings.overshoot, style.overshoot);
  styled.volume = style.volume;
  if (style.release) {
    styled.releaseFrames = *style.release * (settings.endFrame - settings.startFrame);
  }
  return styled;
}

namespace {

// Cut between letters, of which the later bytes begin with the bits 10.
std::string shortened(std::string name) {
  std::size_t end = std::min(name.size(), longestStyleName);
  while (end > 0 && end < name.size() && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) {
    --end;
  }
  name.resize(end);
  return name;
}

} // namespace

Style styleOf(const std::vector<StyledLimb>& limbs, std::string name) {
  check(!limbs.empty(), "a style is taken from at least one limb");
  const auto strongest = std::ranges::max_element(limbs, {}, stretchOf);
  const TrailSettings& settings = strongest->settings;
  const auto everything = rangeOf(limbs, [](LimbKind kind) { return !isTorso(kind); });
  Style style;
  style.name = shortened(std::move(name));
  style.torso = rangeOf(limbs, isTorso).value_or(ScaleRange{1.0, 1.0, 1.0});
  const ScaleRange others = everything.value_or(style.torso);
  style.arm = rangeOf(limbs, [](LimbKind kind) { return kind == LimbKind::arm; }).value_or(others);
  style.leg = rangeOf(limbs, [](LimbKind kind) { return kind == LimbKind::leg; }).value_or(others);
  style.other = rangeOf(limbs, [](LimbKind kind) {
                  return !isTorso(kind) && kind != LimbKind::arm && kind != LimbKind::leg;
                }).value_or(others);
  style.axes = settings.axes[1] ? AxesRule::all : AxesRule::level;
  style.reference = settings.reference;
  style.bend = settings.bend;
  style.remap = settings.remap;
  style.easeIn = settings.easeIn;
  style.easeOut = settings.easeOut;
  const double range = settings.endFrame - settings.startFrame;
  if (settings.releaseFrames && range > 0.0) {
    style.release = std::min(*settings.releaseFrames / range, longestStyleRelease);
  }
  style.overshoot = settings.overshoot;
  style.volume = settings.volume;
  return style;
}

} // namespace stretch::rig
