// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drawings/MessageColors.h"

#include <algorithm>

#include "foxglove/Geometry.pb.h"

namespace widgets {

QColor qColor(const foxglove::Color& color) {
  // The order of the arguments makes NaN become 0.
  const auto channel = [](double value) { return std::min(std::max(0.0, value), 1.0); };
  return QColor::fromRgbF(channel(color.r()), channel(color.g()), channel(color.b()), channel(color.a()));
}

}  // namespace widgets
