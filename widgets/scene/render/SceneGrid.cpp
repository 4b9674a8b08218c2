// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/SceneGrid.h"

#include <cmath>

namespace widgets {

SceneLines gridLines(const QColor& color) {
  constexpr double kReach = 6, kStep = 0.5;
  SceneLines lines;
  const auto add = [&](double x0, double y0, double x1, double y1, bool main) {
    const double fading = 1 - std::hypot(x0 + x1, y0 + y1) / 2 / kReach;
    if (fading <= 0) return;
    const auto point = [](double x, double y) {
      return std::array{static_cast<float>(x), static_cast<float>(y), -0.03F};
    };
    const auto alpha = static_cast<std::uint8_t>((main ? 150 : 80) * fading);
    lines.segments.push_back(
        {point(x0, y0),
         point(x1, y1),
         {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
          static_cast<std::uint8_t>(color.blue()), alpha},
         1});
  };
  const int count = static_cast<int>(2 * kReach / kStep);
  for (int i = 0; i <= count; ++i) {
    for (int k = 0; k < count; ++k) {
      const double at = i * kStep - kReach, from = k * kStep - kReach;
      add(at, from, at, from + kStep, i % 2 == 0);
      add(from, at, from + kStep, at, i % 2 == 0);
    }
  }
  return lines;
}

}  // namespace widgets
