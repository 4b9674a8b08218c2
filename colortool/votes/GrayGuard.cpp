// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/GrayGuard.h"

#include <algorithm>
#include <cmath>

namespace colortool {
namespace {

constexpr int kGuardCells = ColorTable::kCells;
/// Standard deviation of the guard, in cells of Cb and Cr.
constexpr double kGuardWidth = 2;
/// The most votes that can be needed; no class ever has more.
constexpr double kMaxGuard = 1.0e9;
/// A cell is claimed by this many pixels: single ones may be from the edge of a thing. Its reach in
/// Y, and in Cb and Cr.
constexpr double kClaimingPixels = 3;
constexpr int kClaimedBrightness = 4, kClaimedChroma = 1;

}  // namespace

void GrayGuard::setHeight(double votes, double stroke) {
  stroke_ = stroke;
  for (int cb = kFirst; cb <= kLast; ++cb) {
    for (int cr = kFirst; cr <= kLast; ++cr) {
      // Gray is the common corner of four cells.
      const double blue = cb + 0.5 - kGuardCells / 2.0, red = cr + 0.5 - kGuardCells / 2.0;
      const double squared = (blue * blue + red * red) / (kGuardWidth * kGuardWidth);
      ofStroke_[static_cast<std::size_t>(cb * kGuardCells + cr)] =
          static_cast<std::int32_t>(std::min(kMaxGuard, votes * std::exp(-0.5 * squared)));
    }
  }
  for (OfClass& one : byClass_) one.changed = true;
}

void GrayGuard::addStrength(std::uint8_t colorClass, std::int64_t strength) {
  byClass_[colorClass].strength += strength;
  byClass_[colorClass].changed = true;
}

void GrayGuard::clearStrengths() {
  for (OfClass& one : byClass_) {
    one.strength = 0;
    one.changed = true;
  }
}

void GrayGuard::setPixels(std::uint8_t colorClass, std::size_t cell, double pixels, CellBlocks& changed) {
  const int y = static_cast<int>(cell >> 12U), cb = static_cast<int>(cell >> 6U & 63U),
            cr = static_cast<int>(cell & 63U);
  OfClass& one = byClass_[colorClass];
  const bool claims = pixels >= kClaimingPixels;
  if (!covers(cb) || cr < kFirst || cr > kLast || claims == one.claims.contains(cell)) return;
  one.claims.set(cell, claims);
  const int last = std::min(kGuardCells - 1, y + kClaimedBrightness);
  for (int atY = std::max(0, y - kClaimedBrightness); atY <= last; ++atY) {
    for (int atCb = cb - kClaimedChroma; atCb <= cb + kClaimedChroma; ++atCb) {
      const auto row = static_cast<std::size_t>(atY * kGuardCells + atCb);
      one.close.row(row) = one.closeToClaims(atY, atCb);
      changed.includeBlocks(row, CellBlocks::blocksOf(cr - kClaimedChroma, cr + kClaimedChroma));
    }
  }
}

bool GrayGuard::update(std::uint8_t colorClass) {
  OfClass& one = byClass_[colorClass];
  if (!one.changed) return false;
  one.changed = false;
  one.votes.assign(ofStroke_.size(), 0);
  const double strokes = static_cast<double>(one.strength) / stroke_;
  for (int cb = kFirst; cb <= kLast; ++cb) {
    for (int cr = kFirst; cr <= kLast; ++cr) {
      const auto at = static_cast<std::size_t>(cb * kGuardCells + cr);
      one.votes[at] = static_cast<std::int32_t>(std::min(kMaxGuard, strokes * ofStroke_[at]));
    }
  }
  return true;
}

void GrayGuard::includeGray(const CellBlocks& of, CellBlocks& changed) {
  const unsigned gray = CellBlocks::blocksOf(kFirst, kLast);
  for (int y = 0; y < kGuardCells; ++y) {
    for (int cb = kFirst; cb <= kLast; ++cb) {
      const auto row = static_cast<std::size_t>(y * kGuardCells + cb);
      changed.includeBlocks(row, of.row(row) & gray);
    }
  }
}

CellSet::Row GrayGuard::OfClass::closeToClaims(int y, int cb) const {
  CellSet::Row cells = 0;
  const int last = std::min(kGuardCells - 1, y + kClaimedBrightness);
  for (int atY = std::max(0, y - kClaimedBrightness); atY <= last; ++atY) {
    for (int atCb = cb - kClaimedChroma; atCb <= cb + kClaimedChroma; ++atCb)
      cells |= claims.row(static_cast<std::size_t>(atY * kGuardCells + atCb));
  }
  return cells | cells << 1U | cells >> 1U;
}

std::int32_t GrayGuard::votes(std::uint8_t colorClass, std::size_t cell) const {
  const OfClass& one = byClass_[colorClass];
  const std::size_t chroma = cell % CellBlocks::kRows;
  const int cb = static_cast<int>(chroma / kGuardCells);
  if (one.votes.empty() || !covers(cb)) return 0;
  return one.close.contains(cell) ? std::min(ofStroke_[chroma], one.votes[chroma]) : one.votes[chroma];
}

const std::int32_t* GrayGuard::votesOfRow(std::uint8_t colorClass, int y, int cb) {
  const OfClass& one = byClass_[colorClass];
  const std::int32_t* const votes = one.votes.data() + static_cast<std::ptrdiff_t>(cb) * kGuardCells;
  const CellSet::Row close = one.close.row(static_cast<std::size_t>(y * kGuardCells + cb));
  if (close == 0) return votes;
  std::copy_n(votes, kGuardCells, row_.begin());
  for (std::size_t cr = kFirst; cr <= kLast; ++cr) {
    if ((close >> cr & 1U) != 0)
      row_[cr] = std::min(row_[cr], ofStroke_[static_cast<std::size_t>(cb) * kGuardCells + cr]);
  }
  return row_.data();
}

}  // namespace colortool
