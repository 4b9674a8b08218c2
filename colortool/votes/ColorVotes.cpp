// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/ColorVotes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace colortool {
namespace {

constexpr int kCells = ColorTable::kCells;
constexpr std::size_t kCellCount = std::size_t{kCells} * kCells * kCells;
/// Numbers of standard deviations beyond which a vote is 0: of the near kernel, and of the one along the
/// shade.
constexpr double kReach = 3, kShadeReach = 2.3;
/// How much wider the kernel along the shade is in Cb and Cr, and how much longer in Y.
constexpr double kShadeWidth = 1.5, kShadeLength = 2;
/// The number of samples in a cell is raised to this power.
constexpr double kExponent = 0.7;
/// The limit of pixels of one class in one cell; more count as this many.
constexpr std::int64_t kMaxPixels = 1024;
/// The strength of a single pixel.
constexpr double kStrengthScale = 8;
/// The sum of all votes that a cell can get fits 31 bits.
constexpr double kMaxVotes = 2.0e9;
/// The maximum prior of the background, which is added to the votes.
constexpr double kMaxPrior = 1.0e8;
/// The largest vote of a kernel, for a cell's own samples, if the sum allows it.
constexpr double kFinestPeak = 2048;

/// Number of cells that are decided at a time: the compiler vectorizes loops of constant length.
constexpr int kBlock = CellBlocks::kBlock;
constexpr std::array<std::int32_t, kBlock> kNoGuard{};

std::uint32_t keyOf(std::size_t cell, std::uint8_t colorClass) {
  return static_cast<std::uint32_t>(cell) << 8U | colorClass;
}
std::size_t rowOf(int y, int cb) {
  return (static_cast<std::size_t>(y) * kCells + static_cast<std::size_t>(cb)) * kCells;
}

}  // namespace

ColorVotes::ColorVotes(int classes, const VoteOptions& options)
    : votes_(static_cast<std::size_t>(std::clamp(classes, 1, 256)), std::vector<std::int32_t>(kCellCount, 0)),
      guard_(votes_.size()) {
  sampled_.resize(votes_.size());
  touched_.resize(votes_.size());
  things_.resize(votes_.size(), false);
  setOptions(options);
}

void ColorVotes::makeKernels() {
  const double chroma = options_.radius / ColorTable::kCellSize;
  const double brightness = chroma / options_.brightnessWeight;
  near_ = NearKernels({chroma, brightness, kReach, false, 1});
  shade_ = VoteKernel({kShadeWidth * chroma, kShadeLength * brightness, kShadeReach, true, options_.shading});
  const double strongest = kStrengthScale * std::pow(static_cast<double>(kMaxPixels), kExponent);
  const double sum = near_.largestSum() + shade_.largestSum();
  const double peak = std::min(kFinestPeak, kMaxVotes / (sum * strongest));
  near_.setPeak(peak);
  shade_.setPeak(peak);
  priorVotes_ = static_cast<std::int32_t>(std::min(kMaxPrior, options_.rejection * peak * kStrengthScale));
  guard_.setHeight(options_.grayGuard * peak * kStrengthScale, GrayGuard::kStroke * kStrengthScale);
}

void ColorVotes::setThings(std::vector<bool> things) {
  things.resize(votes_.size(), false);
  if (things == things_) return;
  things_ = std::move(things);
  changed_.includeAll();
}

void ColorVotes::setOptions(const VoteOptions& options) {
  options_ = options;
  options_.radius = std::clamp(options.radius, VoteOptions::kMinRadius, VoteOptions::kMaxRadius);
  options_.brightnessWeight = std::clamp(options.brightnessWeight, VoteOptions::kMinBrightnessWeight, 1.0);
  options_.rejection = std::max(options.rejection, 0.0);
  options_.backgroundWeight = std::clamp(options.backgroundWeight, 0.0, VoteOptions::kMaxBackgroundWeight);
  options_.shading = std::clamp(options.shading, 0.0, VoteOptions::kMaxShading);
  options_.grayGuard = std::max(options.grayGuard, 0.0);
  makeKernels();
  for (auto& votes : votes_) std::ranges::fill(votes, 0);
  for (CellBlocks& touched : touched_) touched.clear();
  guard_.clearStrengths();
  for (auto& [key, sample] : samples_) {
    const auto colorClass = static_cast<std::uint8_t>(key & 255U);
    sample.strength = strengthOf(sample.pixels, colorClass);
    vote(key >> 8U, colorClass, 0, sample.strength);
  }
  changed_.includeAll();
}

std::int32_t ColorVotes::strengthOf(std::int64_t pixels, std::uint8_t colorClass) const {
  const double count =
      static_cast<double>(std::min(std::abs(pixels), kMaxPixels * kUnit)) / static_cast<double>(kUnit);
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
  if (strength != sample.strength) vote(cell, colorClass, sample.strength, strength);
  sample.strength = strength;
  sampled_[colorClass].set(cell, sample.pixels > 0);
  guard_.setPixels(colorClass, cell, static_cast<double>(sample.pixels) / double{kUnit}, changed_);
  if (sample.pixels == 0) samples_.erase(entry);
}

void ColorVotes::vote(std::size_t cell, std::uint8_t colorClass, std::int32_t before, std::int32_t strength) {
  CellBlocks touched;
  // The differences fit: strengths are those of kMaxPixels at most.
  near_.at(cell).add(votes_[colorClass], cell, static_cast<std::int16_t>(strength - before), touched);
  // A sample that excludes a class says nothing about other light.
  const std::int32_t shaded = std::max(strength, 0) - std::max(before, 0);
  if (shaded != 0 && options_.shading > 0)
    shade_.add(votes_[colorClass], cell, static_cast<std::int16_t>(shaded), touched);
  if (shaded != 0) guard_.addStrength(colorClass, shaded);
  touched_[colorClass].include(touched);
  changed_.include(touched);
}

const ColorTable& ColorVotes::update() {
  for (std::size_t i = 0; i < votes_.size(); ++i) {
    if (things_[i] && guard_.update(static_cast<std::uint8_t>(i)))
      GrayGuard::includeGray(touched_[i], changed_);
  }
  for (int y = 0; y < kCells; ++y) {
    for (int cb = 0; cb < kCells; ++cb) {
      for (unsigned blocks = changed_.row(static_cast<std::size_t>(y * kCells + cb)); blocks != 0;
           blocks &= blocks - 1)
        decide(y, cb, std::countr_zero(blocks));
    }
  }
  changed_.clear();
  return table_;
}

void ColorVotes::decide(int y, int cb, int block) {
  std::array<std::int32_t, kBlock> best;
  std::array<std::int32_t, kBlock> winner{};
  const std::size_t begin = rowOf(y, cb) + static_cast<std::size_t>(block * kBlock);
  const std::int32_t* background = votes_[0].data() + begin;
  for (std::size_t i = 0; i < kBlock; ++i) best[i] = std::max(background[i], 0) + priorVotes_;
  for (std::size_t colorClass = 1; colorClass < votes_.size(); ++colorClass) {
    if ((touched_[colorClass].row(begin / kCells) >> static_cast<unsigned>(block) & 1U) == 0) continue;
    const std::int32_t* votes = votes_[colorClass].data() + begin;
    const auto number = static_cast<std::int32_t>(colorClass);
    const std::int32_t* guard = kNoGuard.data();
    if (things_[colorClass] && guard_.covers(cb))
      guard = guard_.votesOfRow(static_cast<std::uint8_t>(colorClass), y, cb) + block * kBlock;
    for (std::size_t i = 0; i < kBlock; ++i) {
      const std::int32_t has = votes[i] - guard[i];
      const bool better = has > best[i];
      winner[i] = better ? number : winner[i];
      best[i] = better ? has : best[i];
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

std::int32_t ColorVotes::votesOf(std::size_t colorClass, std::size_t cell) const {
  const std::int32_t votes = votes_[colorClass][cell];
  if (colorClass == ColorClasses::kNone) return std::max(votes, 0) + priorVotes_;
  if (!things_[colorClass]) return votes;
  return votes - guard_.votes(static_cast<std::uint8_t>(colorClass), cell);
}

double ColorVotes::margin(std::size_t cell) const {
  const std::uint8_t winner = table_.cells()[cell];
  const std::int32_t best = votesOf(winner, cell);
  if (best <= 0) return winner == ColorClasses::kNone ? 1 : 0;
  std::int32_t second = 0;
  for (std::size_t other = 0; other < votes_.size(); ++other) {
    if (other != winner) second = std::max(second, votesOf(other, cell));
  }
  return static_cast<double>(best - second) / static_cast<double>(best);
}

std::uint16_t ColorVotes::classesOf(std::size_t cell, double share) const {
  const std::uint8_t winner = table_.cells()[cell];
  if (winner == ColorClasses::kNone) return 0;
  const double enough = share * static_cast<double>(votesOf(winner, cell));
  unsigned mask = 0;
  for (std::size_t other = 1; other < std::min<std::size_t>(votes_.size(), 17); ++other) {
    if (votesOf(other, cell) > 0 && static_cast<double>(votesOf(other, cell)) >= enough)
      mask |= 1U << (other - 1);
  }
  return static_cast<std::uint16_t>(mask);
}

}  // namespace colortool
