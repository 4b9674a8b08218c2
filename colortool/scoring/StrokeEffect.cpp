// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/scoring/StrokeEffect.h"

#include <algorithm>

#include "colortool/table/CellSet.h"
#include "colortool/training/StrokeCells.h"

namespace colortool {
namespace {

constexpr double kMinOfAll = 0.001;
/// The share of a stroke that must be uncontested for the rest to be outliers.
constexpr double kMinUncontested = 0.1;

std::size_t indexOf(std::size_t from, std::size_t to) {
  return from * 256 + to;
}

/// The pixels of a stroke whose corrected color `wanted` accepts.
template <typename Wanted>
PixelArea pixelsWhere(const Samples& samples, const Stroke& stroke, Wanted wanted) {
  const SampleImage* image = samples.image(stroke.image);
  const ColorCorrection correction =
      image == nullptr ? ColorCorrection{} : samples.correctionOf(image->camera);
  PixelArea found;
  std::size_t at = 0;
  for (const PixelRun& run : stroke.area) {
    for (int x = run.begin; x < run.end && at < stroke.colors.size(); ++x, ++at) {
      const robotlink::YCbCr color =
          correction.none() ? stroke.colors[at]
                            : correction.apply(stroke.colors[at], x, run.y, image->width, image->height);
      if (!wanted(color)) continue;
      if (!found.empty() && found.back().y == run.y && found.back().end == x)
        ++found.back().end;
      else
        found.push_back({run.y, x, x + 1});
    }
  }
  return found;
}

bool leavesEnough(const Stroke& stroke, const PixelArea& contested) {
  const auto all = static_cast<double>(stroke.colors.size());
  return all - static_cast<double>(pixelCount(contested)) >= kMinUncontested * all;
}

/// The cells that strokes of other classes touched, and their neighbors.
CellSet cellsOfOthers(const Samples& samples, const Stroke& stroke) {
  constexpr int kLast = ColorTable::kCells - 1;
  CellSet cells;
  for (const StrokePtr& other : samples.strokes) {
    if (other->colorClass == stroke.colorClass || other->mustNotBe) continue;
    for (const StrokeCell& touched : strokeCells(samples, *other)) {
      const int y = static_cast<int>(touched.cell >> 12U), cb = static_cast<int>(touched.cell >> 6U & 63U),
                cr = static_cast<int>(touched.cell & 63U);
      for (int i = 0; i < 27; ++i) {
        const int atY = std::clamp(y + i / 9 - 1, 0, kLast), atCb = std::clamp(cb + i / 3 % 3 - 1, 0, kLast),
                  atCr = std::clamp(cr + i % 3 - 1, 0, kLast);
        cells.set(static_cast<std::size_t>((atY << 12) | (atCb << 6) | atCr));
      }
    }
  }
  return cells;
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
  if (stroke.mustNotBe) return {};
  const auto ofOthers = [&](const robotlink::YCbCr& color) {
    const std::uint8_t found = before.classOf(color);
    return found != ColorClasses::kNone && found != stroke.colorClass;
  };
  PixelArea contested = pixelsWhere(samples, stroke, ofOthers);
  if (leavesEnough(stroke, contested)) return contested;
  // A table that knows few classes assigns everything to one of them; the cells of strokes tell more.
  const CellSet known = cellsOfOthers(samples, stroke);
  contested = pixelsWhere(samples, stroke, [&](const robotlink::YCbCr& color) {
    return ofOthers(color) && known.contains(ColorTable::cellOf(color));
  });
  return leavesEnough(stroke, contested) ? contested : PixelArea{};
}

}  // namespace colortool
