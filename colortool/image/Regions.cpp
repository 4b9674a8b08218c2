// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/Regions.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <tuple>

namespace colortool {

using robotlink::ImageView;

namespace {

/// The end of the run that begins at `begin`: the first pixel of another class. Compares eight pixels at a
/// time, since most runs are long.
int endOfRun(const std::uint8_t* pixels, int begin, int count) {
  const std::uint64_t same = 0x0101'0101'0101'0101U * std::uint64_t{pixels[begin]};
  int at = begin + 1;
  for (; at + 8 <= count; at += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, pixels + at, sizeof eight);
    if (eight == same) continue;
    const int equalBits = std::endian::native == std::endian::little ? std::countr_zero(eight ^ same)
                                                                     : std::countl_zero(eight ^ same);
    return at + equalBits / 8;
  }
  while (at < count && pixels[at] == pixels[begin]) ++at;
  return at;
}

}  // namespace

void RegionFinder::beginImage() {
  runs_.clear();
  regions_.clear();
}

void RegionFinder::addLine(int line, const std::uint8_t* pixels, int count, std::ptrdiff_t stride) {
  for (int begin = 0; begin < count;) {
    const std::uint8_t colorClass = pixels[static_cast<std::ptrdiff_t>(begin) * stride];
    int end = begin + 1;
    if (stride == 1)
      end = endOfRun(pixels, begin, count);
    else
      while (end < count && pixels[static_cast<std::ptrdiff_t>(end) * stride] == colorClass) ++end;
    if (colorClass != ColorClasses::kNone)
      runs_.push_back({line, begin, end, static_cast<int>(runs_.size()), colorClass});
    begin = end;
  }
}

int RegionFinder::root(int run) {
  const auto at = [this](int i) -> Run& { return runs_[static_cast<std::size_t>(i)]; };
  while (at(run).parent != run) {
    at(run).parent = at(at(run).parent).parent;
    run = at(run).parent;
  }
  return run;
}

void RegionFinder::connectLines(std::size_t previousBegin, std::size_t previousEnd) {
  std::size_t above = previousBegin;
  for (std::size_t i = previousEnd; i < runs_.size(); ++i) {
    // Runs that touch at a corner are connected, too.
    while (above < previousEnd && runs_[above].end < runs_[i].begin) ++above;
    for (std::size_t j = above; j < previousEnd && runs_[j].begin <= runs_[i].end; ++j) {
      if (runs_[j].colorClass != runs_[i].colorClass) continue;
      const int a = root(static_cast<int>(i)), b = root(static_cast<int>(j));
      runs_[static_cast<std::size_t>(std::max(a, b))].parent = std::min(a, b);
    }
  }
}

const std::vector<Region>& RegionFinder::findInRows(const ImageView& classes) {
  beginImage();
  std::size_t previous = 0;
  for (int y = 0; y < classes.height && !classes.empty(); ++y) {
    const std::size_t begin = runs_.size();
    addLine(y, classes.row(y), classes.width, 1);
    connectLines(previous, begin);
    previous = begin;
  }
  collect(1, false, classes.height);
  return regions_;
}

const std::vector<Region>& RegionFinder::findInColumns(const ImageView& classes, int spacing) {
  beginImage();
  spacing = std::max(1, spacing);
  std::size_t previous = 0;
  for (int line = 0; !classes.empty() && line * spacing + spacing / 2 < classes.width; ++line) {
    const std::size_t begin = runs_.size();
    const int column = line * spacing + spacing / 2;
    addLine(line, classes.data + column, classes.height, classes.step);
    connectLines(previous, begin);
    previous = begin;
  }
  collect(spacing, true, classes.width);
  return regions_;
}

void RegionFinder::collect(int spacing, bool vertical, int lineLimit) {
  all_.clear();
  regionOfRun_.assign(runs_.size(), -1);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[i];
    int& index = regionOfRun_[static_cast<std::size_t>(root(static_cast<int>(i)))];
    const int lineBegin = run.line * spacing, lineEnd = std::min(lineLimit, lineBegin + spacing);
    const int left = vertical ? lineBegin : run.begin, right = vertical ? lineEnd : run.end;
    const int top = vertical ? run.begin : lineBegin, bottom = vertical ? run.end : lineEnd;
    if (index < 0) {
      index = static_cast<int>(all_.size());
      all_.push_back({run.colorClass, 0, left, top, right, bottom, 0, 0});
    }
    Region& region = all_[static_cast<std::size_t>(index)];
    const int area = (right - left) * (bottom - top);
    region.area += area;
    region.left = std::min(region.left, left);
    region.top = std::min(region.top, top);
    region.right = std::max(region.right, right);
    region.bottom = std::max(region.bottom, bottom);
    region.centerX += area * 0.5 * (left + right);
    region.centerY += area * 0.5 * (top + bottom);
  }
  select();
}

void RegionFinder::select() {
  std::erase_if(all_, [this](const Region& region) { return region.area < options_.minimumArea; });
  std::ranges::sort(all_, {},
                    [](const Region& r) { return std::tuple(r.colorClass, -r.area, r.top, r.left); });
  int colorClass = -1, count = 0;
  for (Region& region : all_) {
    count = region.colorClass == colorClass ? count + 1 : 1;
    colorClass = region.colorClass;
    if (count > options_.maximumPerClass) continue;
    region.centerX /= region.area;
    region.centerY /= region.area;
    regions_.push_back(region);
  }
}

}  // namespace colortool
