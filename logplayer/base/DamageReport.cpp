// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/DamageReport.h"

namespace logplayer {

std::vector<std::string> describeDamage(const std::filesystem::path& file, bool complete,
                                        const std::vector<mcap::Damage>& damage) {
  constexpr std::size_t kMaxListed = 20;
  const std::string name = file.string() + ": ";
  std::vector<std::string> losses;
  if (!complete && damage.empty()) losses.push_back(name + "the file was not closed: its end may be missing");
  for (const mcap::Damage& place : damage) {
    if (losses.size() == kMaxListed) {
      losses.push_back(name + "and " + std::to_string(damage.size() - kMaxListed) + " more damaged places");
      break;
    }
    // Offset 0 means the whole file.
    losses.push_back(name + (place.offset > 0 ? "at byte " + std::to_string(place.offset) + ": " : "") +
                     place.what);
  }
  return losses;
}

}  // namespace logplayer
