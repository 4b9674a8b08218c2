// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/ColorSpaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace colortool {
namespace {

constexpr float kTurn = 2 * std::numbers::pi_v<float>;
/// Colors closer to gray than this have no meaningful angle.
constexpr float kGray = 1e-6F;

/// Converts an angle from radians to turns in [0, 1).
float turns(float angle) {
  const float turn = angle / kTurn;
  const float fraction = turn - std::floor(turn);
  return fraction < 1 ? fraction : 0;
}

UnitColor unitRgb(const ColorValue& yCbCr) {
  return (rgbOf(yCbCr) / 255).cwiseMax(0.F).cwiseMin(1.F);
}

}  // namespace

const char* nameOf(ColorSpace space) {
  switch (space) {
    case ColorSpace::kRgb:
      return "RGB";
    case ColorSpace::kHsi:
      return "HSI";
    case ColorSpace::kTsl:
      return "TSL";
    case ColorSpace::kYCbCr:
      break;
  }
  return "YCbCr";
}

std::array<const char*, 3> channelNames(ColorSpace space) {
  switch (space) {
    case ColorSpace::kRgb:
      return {"R", "G", "B"};
    case ColorSpace::kHsi:
      return {"H", "S", "I"};
    case ColorSpace::kTsl:
      return {"T", "S", "L"};
    case ColorSpace::kYCbCr:
      break;
  }
  return {"Y", "Cb", "Cr"};
}

ColorValue rgbOf(const ColorValue& yCbCr) {
  const float y = yCbCr[0], cb = yCbCr[1] - 128, cr = yCbCr[2] - 128;
  return {y + 1.402F * cr, y - 0.344136F * cb - 0.714136F * cr, y + 1.772F * cb};
}

bool hasRgb(const ColorValue& yCbCr, float tolerance) {
  const ColorValue rgb = rgbOf(yCbCr);
  return rgb.minCoeff() >= -tolerance && rgb.maxCoeff() <= 255 + tolerance;
}

UnitColor hsiOf(const UnitColor& rgb) {
  const float intensity = rgb.sum() / 3;
  if (intensity < kGray) return {0, 0, intensity};
  const float saturation = std::max(0.F, 1 - rgb.minCoeff() / intensity);
  // The book's arc cosine as an arc tangent, which is accurate near red and its opposite, too.
  const float along = rgb[0] - (rgb[1] + rgb[2]) / 2;
  const float across = std::sqrt(3.F) / 2 * (rgb[1] - rgb[2]);
  const bool gray = std::hypot(along, across) < kGray;
  return {gray ? 0 : turns(std::atan2(across, along)), saturation, intensity};
}

UnitColor tslOf(const UnitColor& rgb) {
  const float sum = rgb.sum();
  const float lightness = 0.299F * rgb[0] + 0.587F * rgb[1] + 0.114F * rgb[2];
  if (sum < kGray) return {0, 0, lightness};
  const float red = rgb[0] / sum - 1.F / 3, green = rgb[1] / sum - 1.F / 3;
  const float chroma = std::hypot(red, green);
  if (chroma < kGray) return {0, 0, lightness};
  return {turns(std::atan2(red, green) + kTurn / 4), std::min(1.F, std::sqrt(1.8F) * chroma), lightness};
}

UnitColor channelsIn(ColorSpace space, const ColorValue& yCbCr) {
  switch (space) {
    case ColorSpace::kRgb:
      return unitRgb(yCbCr);
    case ColorSpace::kHsi:
      return hsiOf(unitRgb(yCbCr));
    case ColorSpace::kTsl:
      return tslOf(unitRgb(yCbCr));
    case ColorSpace::kYCbCr:
      break;
  }
  return (yCbCr / 255).cwiseMax(0.F).cwiseMin(1.F);
}

Eigen::Vector3f placeIn(ColorSpace space, const ColorValue& yCbCr) {
  const UnitColor channels = channelsIn(space, yCbCr);
  if (isCylinder(space)) {
    const float angle = kTurn * channels[0], radius = 0.5F * channels[1];
    return {radius * std::cos(angle), radius * std::sin(angle), channels[2] - 0.5F};
  }
  const Eigen::Vector3f corner =
      space == ColorSpace::kYCbCr ? Eigen::Vector3f(channels[1], channels[2], channels[0]) : channels;
  return corner - Eigen::Vector3f::Constant(0.5F);
}

}  // namespace colortool
