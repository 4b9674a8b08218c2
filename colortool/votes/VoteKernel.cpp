// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/VoteKernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "colortool/table/ColorTable.h"

namespace colortool {
namespace {

constexpr int kChannelCells = ColorTable::kCells;
/// The cell whose lower edge is gray, for Cb and Cr.
constexpr int kGrayCell = kChannelCells / 2;
/// The colors of one thing in all lights converge at this distance below black, in cells: cameras raise dark
/// values.
constexpr double kBlackOffset = 6.5;
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

void CellBox::include(int axis, int from, int to) {
  first[axis] = std::min(first[axis], std::max(from, 0));
  last[axis] = std::max(last[axis], std::min(to, kChannelCells - 1));
}

void CellBox::clear() {
  std::ranges::fill(first, kChannelCells);
  std::ranges::fill(last, -1);
}

VoteKernel::VoteKernel(const Shape& shape) : shape_(shape) {
  const auto reach = [&](double deviation) {
    return std::min(kChannelCells - 1, static_cast<int>(std::ceil(shape.reach * deviation)));
  };
  chromaReach_ = reach(shape.chroma);
  brightnessReach_ = reach(shape.brightness);
  width_ = (2 * chromaReach_ + 1 + kKernelStride - 1) / kKernelStride * kKernelStride;
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

void VoteKernel::setPeak(double peak) {
  values_.clear();
  for (int y = -brightnessReach_; y <= brightnessReach_; ++y) {
    for (int cb = -chromaReach_; cb <= chromaReach_; ++cb) {
      for (int cr = -chromaReach_; cr < width_ - chromaReach_; ++cr) {
        const double squared = (cb * cb + cr * cr) / (shape_.chroma * shape_.chroma) +
                               y * y / (shape_.brightness * shape_.brightness);
        values_.push_back(cr > chromaReach_ ? std::int16_t{0}
                                            : static_cast<std::int16_t>(std::lround(
                                                  peak * shape_.height * std::exp(-0.5 * squared))));
      }
    }
  }
}

void VoteKernel::add(std::span<std::int32_t> votes, std::size_t cell, std::int16_t strength,
                     CellBox& changed) const {
  const int y = static_cast<int>(cell >> 12U), cb = static_cast<int>(cell >> 6U & 63U),
            cr = static_cast<int>(cell & 63U);
  const std::size_t slice =
      (2 * static_cast<std::size_t>(chromaReach_) + 1) * static_cast<std::size_t>(width_);
  changed.include(0, y - brightnessReach_, y + brightnessReach_);
  const int last = std::min(kChannelCells - 1, y + brightnessReach_);
  for (int atY = std::max(0, y - brightnessReach_); atY <= last; ++atY) {
    const auto shaded = [&](int chroma) {
      if (!shape_.shaded) return chroma;
      return chroma + static_cast<int>(std::lround((chroma + 0.5 - kGrayCell) * (shadeRatio(y, atY) - 1)));
    };
    const int atCb = shaded(cb), atCr = shaded(cr);
    changed.include(1, atCb - chromaReach_, atCb + chromaReach_);
    changed.include(2, atCr - chromaReach_, atCr + chromaReach_);
    addSlice(votes.data() + static_cast<std::ptrdiff_t>(atY) * kChannelCells * kChannelCells,
             values_.data() + static_cast<std::size_t>(atY - y + brightnessReach_) * slice, atCb, atCr,
             strength);
  }
}

void VoteKernel::addSlice(std::int32_t* votes, const std::int16_t* slice, int cb, int cr,
                          std::int16_t strength) const {
  const int begin = cr - chromaReach_;
  const bool inside = begin >= 0 && begin + width_ <= kChannelCells;
  const int from = std::max(0, -begin), to = std::min(2 * chromaReach_ + 1, kChannelCells - begin);
  for (int atCb = std::max(0, cb - chromaReach_); atCb <= std::min(kChannelCells - 1, cb + chromaReach_);
       ++atCb) {
    const std::int16_t* kernel = slice + static_cast<std::ptrdiff_t>(atCb - cb + chromaReach_) * width_;
    std::int32_t* row = votes + static_cast<std::ptrdiff_t>(atCb) * kChannelCells + begin;
    if (inside) {
      for (int i = 0; i < width_; i += kKernelStride) addProducts(row + i, kernel + i, strength);
    } else {
      for (int i = from; i < to; ++i) row[i] += strength * kernel[i];
    }
  }
}

}  // namespace colortool
