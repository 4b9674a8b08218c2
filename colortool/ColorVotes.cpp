// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/ColorVotes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace colortool {
namespace {

constexpr int kCells = ColorTable::kCells;
constexpr std::size_t kCellCount = std::size_t{kCells} * kCells * kCells;
/// Past this many standard deviations a vote is none.
constexpr double kReach = 3;
/// Of the number of samples in a cell.
constexpr double kExponent = 0.7;
/// More pixels than that of one class in one cell count as that many.
constexpr std::int64_t kMostPixels = 4096;
/// Of a single pixel's strength.
constexpr double kStrengthScale = 16;
/// The sum of all votes that a cell can get fits 31 bits.
constexpr double kMostVotes = 2.0e9;
/// What background is given beforehand, at most: it comes on top of the votes.
constexpr double kMostPrior = 1.0e8;
/// The largest vote of the kernel, for a cell's own samples, if the sum allows it.
constexpr double kFinestPeak = 1024;

/// So many cells of a row are decided at a time: loops of a known length are vectorised.
constexpr int kBlock = 16;
/// Votes are added to so many cells at a time, where the row is long enough.
constexpr int kStride = 8;

std::uint32_t keyOf(std::size_t cell, std::uint8_t colorClass) {
  return static_cast<std::uint32_t>(cell) << 8U | colorClass;
}
std::array<int, 3> placeOf(std::size_t cell) {
  return {static_cast<int>(cell >> 12U), static_cast<int>(cell >> 6U & 63U), static_cast<int>(cell & 63U)};
}
std::size_t rowOf(int y, int cb) {
  return (static_cast<std::size_t>(y) * kCells + static_cast<std::size_t>(cb)) * kCells;
}

void addProducts(std::int32_t* __restrict votes, const std::int16_t* __restrict kernel, std::int16_t factor) {
  for (int i = 0; i < kStride; ++i) votes[i] += factor * kernel[i];
}

}  // namespace

void ColorVotes::Box::include(int axis, int from, int to) {
  first[axis] = std::min(first[axis], std::max(from, 0));
  last[axis] = std::max(last[axis], std::min(to, kCells - 1));
}

ColorVotes::ColorVotes(int classes, const VoteOptions& options)
    : votes_(static_cast<std::size_t>(std::clamp(classes, 1, 256)),
             std::vector<std::int32_t>(kCellCount, 0)) {
  sampled_.resize(votes_.size());
  setOptions(options);
}

void ColorVotes::makeKernel() {
  const double chroma = options_.radius / ColorTable::kCellSize;
  const double brightness = chroma / options_.brightnessWeight;
  chromaReach_ = std::min(kCells - 1, static_cast<int>(std::ceil(kReach * chroma)));
  brightnessReach_ = std::min(kCells - 1, static_cast<int>(std::ceil(kReach * brightness)));
  std::vector<double> shape;
  double sum = 0;
  for (int y = -brightnessReach_; y <= brightnessReach_; ++y) {
    for (int cb = -chromaReach_; cb <= chromaReach_; ++cb) {
      for (int cr = -chromaReach_; cr <= chromaReach_; ++cr) {
        const double squared = (cb * cb + cr * cr) / (chroma * chroma) + y * y / (brightness * brightness);
        shape.push_back(std::exp(-0.5 * squared));
        sum += shape.back();
      }
    }
  }
  const double strongest = kStrengthScale * std::pow(static_cast<double>(kMostPixels), kExponent);
  const double peak = std::min(kFinestPeak, kMostVotes / (sum * strongest));
  const std::size_t width = 2 * static_cast<std::size_t>(chromaReach_) + 1;
  kernelWidth_ = static_cast<int>((width + kStride - 1) / kStride * kStride);
  kernel_.assign(shape.size() / width * static_cast<std::size_t>(kernelWidth_), 0);
  for (std::size_t i = 0; i < shape.size(); ++i) {
    kernel_[i / width * static_cast<std::size_t>(kernelWidth_) + i % width] =
        static_cast<std::int16_t>(std::lround(peak * shape[i]));
  }
  priorVotes_ = static_cast<std::int32_t>(std::min(kMostPrior, options_.rejection * peak * kStrengthScale));
}

void ColorVotes::setOptions(const VoteOptions& options) {
  options_ = options;
  options_.radius = std::clamp(options.radius, VoteOptions::kLeastRadius, VoteOptions::kMostRadius);
  options_.brightnessWeight = std::clamp(options.brightnessWeight, VoteOptions::kLeastBrightnessWeight, 1.0);
  options_.rejection = std::max(options.rejection, 0.0);
  options_.backgroundWeight = std::clamp(options.backgroundWeight, 0.0, 1.0);
  makeKernel();
  for (auto& votes : votes_) std::ranges::fill(votes, 0);
  for (auto& [key, sample] : samples_) {
    const auto colorClass = static_cast<std::uint8_t>(key & 255U);
    sample.strength = strengthOf(sample.pixels, colorClass);
    vote(key >> 8U, colorClass, sample.strength);
  }
  for (int axis = 0; axis < 3; ++axis) changed_.include(axis, 0, kCells - 1);
}

std::int32_t ColorVotes::strengthOf(std::int64_t pixels, std::uint8_t colorClass) const {
  const double count =
      static_cast<double>(std::min(std::abs(pixels), kMostPixels * kUnit)) / static_cast<double>(kUnit);
  const double weight = colorClass == ColorClasses::kNone ? options_.backgroundWeight : 1;
  const long strength = std::lround(weight * kStrengthScale * std::pow(count, kExponent));
  return static_cast<std::int32_t>(pixels < 0 ? -strength : strength);
}

void ColorVotes::add(std::size_t cell, std::uint8_t colorClass, std::int64_t pixels) {
  if (colorClass >= votes_.size() || cell >= kCellCount) return;
  const auto entry = samples_.try_emplace(keyOf(cell, colorClass)).first;
  Sample& sample = entry->second;
  sample.pixels += pixels;
  const std::int32_t strength = strengthOf(sample.pixels, colorClass);
  if (strength != sample.strength) vote(cell, colorClass, strength - sample.strength);
  sample.strength = strength;
  sampled_[colorClass].set(cell, sample.pixels > 0);
  if (sample.pixels == 0) samples_.erase(entry);
}

void ColorVotes::vote(std::size_t cell, std::uint8_t colorClass, std::int32_t strength) {
  if (strength == 0) return;
  const auto [y, cb, cr] = placeOf(cell);
  changed_.include(0, y - brightnessReach_, y + brightnessReach_);
  changed_.include(1, cb - chromaReach_, cb + chromaReach_);
  changed_.include(2, cr - chromaReach_, cr + chromaReach_);
  const auto factor = static_cast<std::int16_t>(strength);  // kMostPixels fewer or more, at most: that fits
  const int begin = cr - chromaReach_, width = 2 * chromaReach_ + 1;
  const bool inside = begin >= 0 && begin + kernelWidth_ <= kCells;
  const int from = std::max(0, -begin), to = std::min(width, kCells - begin);
  for (int atY = std::max(0, y - brightnessReach_); atY <= std::min(kCells - 1, y + brightnessReach_);
       ++atY) {
    for (int atCb = std::max(0, cb - chromaReach_); atCb <= std::min(kCells - 1, cb + chromaReach_); ++atCb) {
      const std::int16_t* kernel =
          kernel_.data() +
          (static_cast<std::ptrdiff_t>(atY - y + brightnessReach_) * width + (atCb - cb + chromaReach_)) *
              kernelWidth_;
      std::int32_t* votes = votes_[colorClass].data() + rowOf(atY, atCb);
      if (inside) {
        for (int i = 0; i < kernelWidth_; i += kStride) addProducts(votes + begin + i, kernel + i, factor);
      } else {
        for (int i = from; i < to; ++i) votes[begin + i] += factor * kernel[i];
      }
    }
  }
}

const ColorTable& ColorVotes::update() {
  if (!changed_.empty()) {
    for (int y = changed_.first[0]; y <= changed_.last[0]; ++y) {
      for (int cb = changed_.first[1]; cb <= changed_.last[1]; ++cb) {
        for (int block = changed_.first[2] / kBlock; block <= changed_.last[2] / kBlock; ++block)
          decide(y, cb, block);
      }
    }
    changed_.clear();
  }
  return table_;
}

void ColorVotes::decide(int y, int cb, int block) {
  std::array<std::int32_t, kBlock> best;
  std::array<std::int32_t, kBlock> winner{};
  const std::size_t begin = rowOf(y, cb) + static_cast<std::size_t>(block * kBlock);
  const std::int32_t* background = votes_[0].data() + begin;
  for (std::size_t i = 0; i < kBlock; ++i) best[i] = std::max(background[i], 0) + priorVotes_;
  for (std::size_t colorClass = 1; colorClass < votes_.size(); ++colorClass) {
    const std::int32_t* votes = votes_[colorClass].data() + begin;
    const auto number = static_cast<std::int32_t>(colorClass);
    for (std::size_t i = 0; i < kBlock; ++i) {
      const bool better = votes[i] > best[i];
      winner[i] = better ? number : winner[i];
      best[i] = better ? votes[i] : best[i];
    }
  }
  for (int i = 0; i < kBlock; ++i) {
    table_.setCell(y, cb, block * kBlock + i, static_cast<std::uint8_t>(winner[static_cast<std::size_t>(i)]));
  }
}

std::vector<CellSamples> ColorVotes::samples() const {
  std::vector<CellSamples> all;
  for (const auto& [key, sample] : samples_) {
    if (sample.pixels <= 0) continue;
    all.push_back({key >> 8U, static_cast<std::uint8_t>(key & 255U),
                   static_cast<double>(sample.pixels) / static_cast<double>(kUnit)});
  }
  std::ranges::sort(all, {}, [](const CellSamples& s) { return std::pair(s.cell, s.colorClass); });
  return all;
}

double ColorVotes::margin(std::size_t cell) const {
  const auto votesOf = [&](std::size_t colorClass) {
    const std::int32_t votes = votes_[colorClass][cell];
    return colorClass == ColorClasses::kNone ? std::max(votes, 0) + priorVotes_ : votes;
  };
  const std::uint8_t winner = table_.cells()[cell];
  const std::int32_t best = votesOf(winner);
  if (best <= 0) return winner == ColorClasses::kNone ? 1 : 0;
  std::int32_t second = 0;
  for (std::size_t other = 0; other < votes_.size(); ++other) {
    if (other != winner) second = std::max(second, votesOf(other));
  }
  return static_cast<double>(best - second) / static_cast<double>(best);
}

std::uint16_t ColorVotes::classesOf(std::size_t cell, double share) const {
  const std::uint8_t winner = table_.cells()[cell];
  if (winner == ColorClasses::kNone) return 0;
  const double enough = share * static_cast<double>(votes_[winner][cell]);
  unsigned mask = 0;
  for (std::size_t other = 1; other < std::min<std::size_t>(votes_.size(), 17); ++other) {
    if (votes_[other][cell] > 0 && static_cast<double>(votes_[other][cell]) >= enough)
      mask |= 1U << (other - 1);
  }
  return static_cast<std::uint16_t>(mask);
}

}  // namespace colortool
