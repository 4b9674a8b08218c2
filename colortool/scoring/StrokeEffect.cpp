// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/scoring/StrokeEffect.h"

#include <algorithm>

namespace colortool {
namespace {

constexpr double kMinOfAll = 0.001;
/// So much of a stroke must be uncontested for the rest to be outliers.
constexpr double kMinUncontested = 0.1;

std::size_t indexOf(std::size_t from, std::size_t to) {
  return from * 256 + to;
}

}  // namespace

void StrokeEffect::add(const robotlink::ImageView& image, const PixelArea& area) {
  robotlink::Image was, is;
  before_.classify(image, was);
  after_.classify(image, is);
  for (int y = 0; y < was.height; ++y) {
    const std::uint8_t *from = was.row(y), *to = is.row(y);
    for (int x = 0; x < was.width; ++x) ++counts_[indexOf(from[x], to[x])];
  }
  for (const PixelRun& run : area) {
    if (run.y >= was.height) continue;
    const std::uint8_t *from = was.row(run.y), *to = is.row(run.y);
    for (int x = run.begin; x < std::min(run.end, was.width); ++x) --counts_[indexOf(from[x], to[x])];
  }
}

std::vector<ClassLoss> StrokeEffect::losses(double leastShare) const {
  std::uint64_t all = 0;
  for (const std::uint64_t count : counts_) all += count;
  std::vector<ClassLoss> losses;
  for (std::size_t from = 0; from < 256; ++from) {
    std::uint64_t had = 0;
    for (std::size_t to = 0; to < 256; ++to) had += counts_[indexOf(from, to)];
    for (std::size_t to = 0; to < 256 && had > 0; ++to) {
      const std::uint64_t lost = counts_[indexOf(from, to)];
      const double share = static_cast<double>(lost) / static_cast<double>(had);
      if (from == to || share < leastShare ||
          static_cast<double>(lost) < kMinOfAll * static_cast<double>(all))
        continue;
      losses.push_back({static_cast<std::uint8_t>(from), static_cast<std::uint8_t>(to), lost, share});
    }
  }
  std::ranges::sort(losses, std::ranges::greater(), &ClassLoss::share);
  return losses;
}

PixelArea contestedPixels(const Samples& samples, const Stroke& stroke, const ColorTable& before) {
  const SampleImage* image = samples.image(stroke.image);
  const ColorCorrection correction =
      image == nullptr ? ColorCorrection{} : samples.correctionOf(image->camera);
  PixelArea contested;
  std::size_t at = 0, count = 0;
  for (const PixelRun& run : stroke.area) {
    for (int x = run.begin; x < run.end && at < stroke.colors.size(); ++x, ++at) {
      const robotlink::YCbCr color =
          correction.none() ? stroke.colors[at]
                            : correction.apply(stroke.colors[at], x, run.y, image->width, image->height);
      const std::uint8_t found = before.classOf(color);
      if (found == ColorClasses::kNone || found == stroke.colorClass) continue;
      ++count;
      if (!contested.empty() && contested.back().y == run.y && contested.back().end == x)
        ++contested.back().end;
      else
        contested.push_back({run.y, x, x + 1});
    }
  }
  const double uncontested = static_cast<double>(at - count);
  return uncontested < kMinUncontested * static_cast<double>(at) || stroke.mustNotBe ? PixelArea{}
                                                                                     : contested;
}

}  // namespace colortool
