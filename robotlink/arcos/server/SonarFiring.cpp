// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/SonarFiring.h"

#include <algorithm>

namespace robotlink::arcos {
namespace {

constexpr std::size_t kMaxSequence = 16;  // of one array

}  // namespace

SonarFiring::SonarFiring(int sonars)
    : sonars_(std::clamp(sonars, 0, kMaxArrays * kDiscsOfArray)),
      arrays_((sonars_ + kDiscsOfArray - 1) / kDiscsOfArray) {
  restore();
}

void SonarFiring::restore() {
  period_ = kPeriod;
  for (Array& array : array_) array = {};
  for (int disc = 0; disc < sonars_; ++disc) {
    array_[static_cast<std::size_t>(disc / kDiscsOfArray)].sequence.push_back(disc);
  }
}

void SonarFiring::enable(int argument) {
  const bool on = (argument & 1) != 0;
  const int array = argument >> 1;
  for (int i = 0; i < kMaxArrays; ++i) {
    if (array == 0 || array == i + 1) array_[static_cast<std::size_t>(i)].on = on;
  }
}

void SonarFiring::setSequence(std::string_view discs) {
  for (Array& array : array_) {
    array.sequence.clear();
    array.next = 0;
  }
  for (const char character : discs) {
    const int disc = static_cast<unsigned char>(character) - 1;
    if (disc < 0 || disc >= sonars_) continue;
    auto& sequence = array_[static_cast<std::size_t>(disc / kDiscsOfArray)].sequence;
    if (sequence.size() < kMaxSequence) sequence.push_back(disc);
  }
}

void SonarFiring::setPeriod(Duration period) {
  period_ = std::clamp<Duration>(period, std::chrono::milliseconds(2), std::chrono::milliseconds(120));
}

bool SonarFiring::fires(int array) const {
  const Array& a = array_[static_cast<std::size_t>(array)];
  return a.on && !a.sequence.empty();
}

bool SonarFiring::isOn(int array) const {
  return array >= 0 && array < arrays_ && fires(array);
}

std::vector<int> SonarFiring::due(Instant now) {
  std::vector<int> discs;
  if (now < next_) return discs;
  // Rounds that were missed are skipped: their echoes are gone.
  const auto late = (now - next_) / period_;
  next_ += period_ * (late + 1);
  for (int i = 0; i < arrays_; ++i) {
    if (!fires(i)) continue;
    Array& array = array_[static_cast<std::size_t>(i)];
    array.next %= array.sequence.size();
    discs.push_back(array.sequence[array.next++]);
  }
  return discs;
}

std::vector<int> SonarFiring::all() const {
  std::vector<int> discs;
  for (int i = 0; i < arrays_; ++i) {
    if (!fires(i)) continue;
    const auto& sequence = array_[static_cast<std::size_t>(i)].sequence;
    discs.insert(discs.end(), sequence.begin(), sequence.end());
  }
  std::sort(discs.begin(), discs.end());
  discs.erase(std::unique(discs.begin(), discs.end()), discs.end());
  return discs;
}

}  // namespace robotlink::arcos
