// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/training/Suspicion.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace colortool {
namespace {

/// A table that is 1 in the cells of things whose margin is too small.
ColorTable ambiguousCells(const ColorTable& table, std::span<const std::uint8_t> margins,
                          const std::vector<bool>& things, std::uint8_t leastMargin) {
  std::vector<std::uint8_t> cells(ColorTable::kCellCount);
  for (std::size_t i = 0; i < margins.size() && i < cells.size(); ++i)
    cells[i] = things[table.cells()[i]] && margins[i] < leastMargin ? 1 : 0;
  constexpr std::array<std::uint8_t, 2> kSame = {0, 1};
  return ColorTable::translated(cells, kSame);
}

std::vector<bool> ofAllNumbers(std::vector<bool> things) {
  things.resize(256, false);
  return things;
}

}  // namespace

bool isThingColor(robotlink::Rgb shown) {
  const auto [least, most] = std::minmax({shown.r, shown.g, shown.b});
  const int range = most - least;
  if (4 * range < most) return false;
  // Green is a hue from 80 to 160 degrees.
  const int hue = 120 + 60 * (shown.b - shown.r) / std::max(1, range);
  return most != shown.g || hue < 80 || hue > 160;
}

std::vector<bool> objectClasses(const ColorClasses& classes) {
  std::vector<bool> things{false};
  for (const NamedColor& color : classes.colors()) things.push_back(isThingColor(color.rgb));
  return things;
}

SuspicionMeter::SuspicionMeter(const ColorTable& table, std::span<const std::uint8_t> margins,
                               std::vector<bool> things, const SuspicionOptions& options)
    : table_(table),
      things_(ofAllNumbers(std::move(things))),
      classCount_(static_cast<std::size_t>(std::ranges::max(table.cells())) + 1),
      options_(options) {
  things_[ColorClasses::kNone] = false;
  ambiguousTable_ = ambiguousCells(table_, margins, things_, options_.leastMargin);
}

std::uint32_t SuspicionMeter::root(std::uint32_t run) {
  while (runs_[run].parent != run) {
    runs_[run].parent = runs_[runs_[run].parent].parent;
    run = runs_[run].parent;
  }
  return run;
}

void SuspicionMeter::connect(std::size_t aboveBegin, std::size_t begin) {
  std::size_t above = aboveBegin;
  for (std::size_t i = begin; i < runs_.size(); ++i) {
    // Runs that touch at a corner are connected, as in a RegionFinder.
    while (above < begin && runs_[above].end < runs_[i].begin) ++above;
    for (std::size_t j = above; j < begin && runs_[j].begin <= runs_[i].end; ++j) {
      if (runs_[j].colorClass != runs_[i].colorClass) continue;
      // The form of std::minmax() with two arguments would return dangling references.
      const auto [first, second] =
          std::minmax({root(static_cast<std::uint32_t>(i)), root(static_cast<std::uint32_t>(j))});
      runs_[second].parent = first;
    }
  }
}

void SuspicionMeter::findRuns() {
  runs_.clear();
  std::size_t aboveBegin = 0;
  for (int y = 0; y < classes_.height; ++y) {
    const std::size_t begin = runs_.size();
    const std::uint8_t* row = classes_.row(y);
    for (int x = 0; x < classes_.width;) {
      const std::uint8_t colorClass = row[x];
      const int first = x++;
      if (!things_[colorClass]) continue;
      while (x < classes_.width && row[x] == colorClass) ++x;
      runs_.push_back({y, first, x, colorClass, static_cast<std::uint32_t>(runs_.size())});
    }
    connect(aboveBegin, begin);
    aboveBegin = begin;
  }
}

void SuspicionMeter::sumAreas() {
  areas_.assign(runs_.size(), {});
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const std::uint32_t first = root(static_cast<std::uint32_t>(i));
    runs_[i].parent = first;
    areas_[first].pixels += static_cast<std::uint32_t>(runs_[i].end - runs_[i].begin);
  }
}

void SuspicionMeter::lookAround(const Run& run) {
  Area& area = areas_[run.parent];
  if (run.y == 0 || run.y + 1 == classes_.height || run.begin == 0 || run.end == classes_.width) {
    area.open = true;
    return;
  }
  const auto touch = [&](std::uint8_t colorClass) {
    if (colorClass == run.colorClass) return;
    if (area.around == ColorClasses::kNone) area.around = colorClass;
    if (area.around != colorClass || !things_[colorClass]) area.open = true;
  };
  const std::uint8_t* row = classes_.row(run.y);
  touch(row[run.begin - 1]);
  touch(row[run.end]);
  for (const int y : {run.y - 1, run.y + 1}) {
    const std::uint8_t* next = classes_.row(y);
    for (int x = run.begin; x < run.end && !area.open; ++x) touch(next[x]);
  }
}

void SuspicionMeter::countAmbiguous(const Run& run, bool vast, SuspiciousPixels& found) const {
  const std::uint8_t* row = ambiguous_.row(run.y);
  const auto ambiguous = std::accumulate(row + run.begin, row + run.end, std::uint32_t{0});
  found.ambiguous += ambiguous;
  if (vast) found.vast += static_cast<std::uint32_t>(run.end - run.begin) - ambiguous;
}

Suspicion SuspicionMeter::measure(const robotlink::ImageView& image) {
  table_.classify(image, classes_);
  ambiguousTable_.classify(image, ambiguous_);
  findRuns();
  sumAreas();
  const double pixels = static_cast<double>(classes_.width) * classes_.height;
  const auto isSpeck = [&](const Area& area) { return area.pixels < options_.speckArea * pixels; };
  const auto mayBeEnclosed = [&](const Area& area) { return area.pixels < options_.enclosedArea * pixels; };
  for (const Run& run : runs_) {
    const Area& area = areas_[run.parent];
    if (!area.open && !isSpeck(area) && mayBeEnclosed(area)) lookAround(run);
  }
  Suspicion result;
  result.byClass.resize(classCount_);
  for (const Run& run : runs_) {
    const Area& area = areas_[run.parent];
    SuspiciousPixels& found = result.byClass[run.colorClass];
    const auto length = static_cast<std::uint32_t>(run.end - run.begin);
    if (isSpeck(area))
      found.specks += length;
    else if (mayBeEnclosed(area) && !area.open)
      found.enclosed += length;
    else
      countAmbiguous(run, area.pixels > options_.vastArea * pixels, found);
  }
  for (const SuspiciousPixels& found : result.byClass) {
    result.pixels.specks += found.specks;
    result.pixels.enclosed += found.enclosed;
    result.pixels.ambiguous += found.ambiguous;
    result.pixels.vast += found.vast;
  }
  result.score =
      options_.speckWeight * result.pixels.specks + options_.enclosedWeight * result.pixels.enclosed +
      options_.ambiguousWeight * result.pixels.ambiguous + options_.vastWeight * result.pixels.vast;
  return result;
}

}  // namespace colortool
