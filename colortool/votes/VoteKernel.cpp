// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/VoteKernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "colortool/table/ColorTable.h"

namespace colortool {
namespace {

constexpr int kChannelCells = ColorTable::kCells;
/// The cell whose lower edge is gray, for Cb and Cr.
constexpr int kGrayCell = kChannelCells / 2;
/// The colors of one thing in all lights converge at this distance below black, in cells: cameras raise dark
/// values.
constexpr double kBlackOffset = 6.5;
/// Smallest standard deviation across the direction of a kernel, in cells.
constexpr double kMinAcross = 0.5;
/// Number of cells to which votes are added at a time, where the row is long enough.
constexpr int kKernelStride = 8;

void addProducts(std::int32_t* __restrict votes, const std::int16_t* __restrict kernel, std::int16_t factor) {
  for (int i = 0; i < kKernelStride; ++i) votes[i] += factor * kernel[i];
}

/// The ratio of the distances from gray at brightness `to` and at brightness `from`.
double shadeRatio(int from, int to) {
  return (to + kBlackOffset) / (from + kBlackOffset);
}

}  // namespace

VoteKernel::VoteKernel(const Shape& shape) : shape_(shape) {
  const auto reach = [&](double deviation) {
    return std::min(kChannelCells - 1, static_cast<int>(std::ceil(shape.reach * deviation)));
  };
  chromaReach_ = reach(shape.chroma * std::max(shape.along, shape.across));
  brightnessReach_ = reach(shape.brightness);
}

double VoteKernel::largestSum() const {
  // The sum of the votes of one brightness in one cell; where it is darker, the votes of more colors meet.
  const double plane = 2 * std::numbers::pi * shape_.chroma * shape_.chroma;
  double sum = 0;
  for (int y = -brightnessReach_; y <= brightnessReach_; ++y) {
    const double ratio = shape_.shaded ? std::min(1.0, shadeRatio(std::abs(y), 0)) : 1;
    const double off = y / shape_.brightness;
    sum += std::exp(-0.5 * off * off) *
           std::min(plane / (ratio * ratio) + 1, double{kChannelCells} * kChannelCells);
  }
  return shape_.height * sum;
}

std::vector<double> VoteKernel::chromaWeights() const {
  const double cosine = std::cos(shape_.direction), sine = std::sin(shape_.direction);
  const double along = shape_.chroma * shape_.along;
  // A narrower one would hardly reach the next cell, and depend on how it lies in the grid.
  const double across = std::max(shape_.chroma * shape_.across, std::min(shape_.chroma, kMinAcross));
  std::vector<double> weights;
  for (int cb = -chromaReach_; cb <= chromaReach_; ++cb) {
    for (int cr = -chromaReach_; cr <= chromaReach_; ++cr) {
      const double a = (cb * cosine + cr * sine) / along, b = (cr * cosine - cb * sine) / across;
      weights.push_back(std::exp(-0.5 * (a * a + b * b)));
    }
  }
  return weights;
}

void VoteKernel::setPeak(double peak) {
  slices_.clear();
  begins_.clear();
  values_.clear();
  const std::vector<double> weights = chromaWeights();
  for (int y = -brightnessReach_; y <= brightnessReach_; ++y) {
    const double off = y / shape_.brightness;
    makeSlice(weights, peak * shape_.height * std::exp(-0.5 * off * off));
  }
}

void VoteKernel::makeSlice(const std::vector<double>& weights, double height) {
  const auto side = static_cast<std::size_t>(2 * chromaReach_ + 1);
  std::vector<std::int16_t> all(weights.size());
  std::ranges::transform(weights, all.begin(), [height](double weight) {
    return static_cast<std::int16_t>(height * weight + 0.5);
  });
  Slice slice{.left = static_cast<int>(side), .row = begins_.size(), .value = values_.size()};
  // A Gaussian has no empty rows between others.
  for (std::size_t row = 0; row < side; ++row) {
    const std::span<const std::int16_t> votes = std::span(all).subspan(row * side, side);
    const auto begin = std::ranges::find_if(votes, [](std::int16_t vote) { return vote != 0; });
    if (begin == votes.end()) continue;
    const auto end = std::ranges::find_if(votes.rbegin(), votes.rend(), [](auto vote) { return vote != 0; });
    if (slice.rows++ == 0) slice.first = static_cast<int>(row);
    begins_.push_back(static_cast<std::int16_t>(begin - votes.begin()));
    slice.left = std::min<int>(slice.left, begins_.back());
    slice.right = std::max<int>(slice.right, begins_.back());
    const int length = static_cast<int>(end.base() - begin);
    slice.width = std::max(slice.width, (length + kKernelStride - 1) / kKernelStride * kKernelStride);
  }
  for (int i = 0; i < slice.rows; ++i) {
    const auto begin = static_cast<std::size_t>(begins_[slice.row + static_cast<std::size_t>(i)]);
    const std::size_t row = static_cast<std::size_t>(slice.first + i) * side;
    for (std::size_t at = begin; at < begin + static_cast<std::size_t>(slice.width); ++at)
      values_.push_back(at < side ? all[row + at] : std::int16_t{0});
  }
  slices_.push_back(slice);
}

void VoteKernel::add(std::span<std::int32_t> votes, std::size_t cell, std::int16_t strength,
                     CellBlocks& touched) const {
  const int y = static_cast<int>(cell >> 12U), cb = static_cast<int>(cell >> 6U & 63U),
            cr = static_cast<int>(cell & 63U);
  const int last = std::min(kChannelCells - 1, y + brightnessReach_);
  for (int atY = std::max(0, y - brightnessReach_); atY <= last; ++atY) {
    const auto shaded = [&](int chroma) {
      if (!shape_.shaded) return chroma;
      return chroma + static_cast<int>(std::lround((chroma + 0.5 - kGrayCell) * (shadeRatio(y, atY) - 1)));
    };
    addSlice(votes, slices_[static_cast<std::size_t>(atY - y + brightnessReach_)], atY, shaded(cb),
             shaded(cr), strength, touched);
  }
}

void VoteKernel::addSlice(std::span<std::int32_t> votes, const Slice& slice, int y, int cb, int cr,
                          std::int16_t strength, CellBlocks& touched) const {
  const int bottom = cb - chromaReach_ + slice.first, origin = cr - chromaReach_;
  const int left = std::max(0, origin + slice.left),
            right = std::min(kChannelCells, origin + slice.right + slice.width);
  if (left >= right) return;
  const unsigned blocks = CellBlocks::blocksOf(left, right - 1);
  const bool inside = origin + slice.left >= 0 && origin + slice.right + slice.width <= kChannelCells;
  const int first = std::max(0, -bottom), last = std::min(slice.rows, kChannelCells - bottom);
  if (first >= last) return;
  const auto row = [&](int i) { return static_cast<std::size_t>(y * kChannelCells + bottom + i); };
  touched.includeBlocks(row(first), row(last), blocks);
  for (int i = first; i < last; ++i) {
    const int begin = origin + begins_[slice.row + static_cast<std::size_t>(i)];
    const std::int16_t* kernel = values_.data() + slice.value + static_cast<std::ptrdiff_t>(i) * slice.width;
    std::int32_t* const cells = votes.data() + row(i) * kChannelCells;
    if (inside) {
      for (int at = 0; at < slice.width; at += kKernelStride)
        addProducts(cells + begin + at, kernel + at, strength);
    } else {
      const int to = std::min(slice.width, kChannelCells - begin);
      for (int at = std::max(0, -begin); at < to; ++at) cells[begin + at] += strength * kernel[at];
    }
  }
}

}  // namespace colortool
