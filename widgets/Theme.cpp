// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/Theme.h"

#include <algorithm>
#include <array>

namespace widgets {
namespace {

/// A hue dark enough for a light background, and light enough for a dark one.
struct Pair {
  QRgb onLight;
  QRgb onDark;
};

constexpr std::array<Pair, 12> kCurves{{{0xff1f6fd0, 0xff62a8ff},
                                        {0xffc8501e, 0xffff9a5c},
                                        {0xff2b8a3e, 0xff6fd283},
                                        {0xffb3265e, 0xffff7fb0},
                                        {0xff7048b6, 0xffb796ff},
                                        {0xff0f8b8d, 0xff4fd6d8},
                                        {0xff8a6d00, 0xffe6c84a},
                                        {0xff5a6472, 0xffb6c0cc},
                                        {0xffd0342c, 0xffff7a72},
                                        {0xff4c6b12, 0xffb4d96a},
                                        {0xff8c4a2f, 0xffd9a384},
                                        {0xffa43fb3, 0xffe58df2}}};

QColor pick(const Pair& pair, const QPalette& palette) {
  return isDark(palette) ? pair.onDark : pair.onLight;
}

}  // namespace

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Base).lightness() < palette.color(QPalette::Text).lightness();
}

bool isHighContrast(const QPalette& palette) {
  return palette.color(QPalette::Base) == Qt::black && palette.color(QPalette::Text) == Qt::white;
}

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto mix = [share](double x, double y) { return x + (y - x) * share; };
  return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()),
                          mix(a.alphaF(), b.alphaF()));
}

QColor colorOf(Meaning meaning, const QPalette& palette) {
  switch (meaning) {
    case Meaning::kGood:
      return pick({0xff23803a, 0xff6fd283}, palette);
    case Meaning::kNote:
      return pick({0xff1f6fd0, 0xff62a8ff}, palette);
    case Meaning::kWarning:
      return pick({0xffa85d00, 0xffffb454}, palette);
    case Meaning::kBad:
      return pick({0xffc62828, 0xffff7a72}, palette);
    case Meaning::kMuted:
      break;
  }
  return mixed(palette.color(QPalette::Text), palette.color(QPalette::Base),
               isHighContrast(palette) ? 0.25 : 0.45);
}

QColor curveColor(int index, const QPalette& palette) {
  return pick(kCurves[static_cast<std::size_t>(index) % kCurves.size()], palette);
}

QColor calmColor(int index, double saturation, const QPalette& palette) {
  constexpr double kLightnessOnLight = 0.5, kLightnessOnDark = 0.64;
  const QColor curve = curveColor(index, palette);
  // A gray curve stays gray; one without any color has no hue, which is -1 then.
  return QColor::fromHslF(std::max(0.0, curve.hslHueF()), std::min(saturation, curve.hslSaturationF()),
                          isDark(palette) ? kLightnessOnDark : kLightnessOnLight);
}

}  // namespace widgets
