// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "robotlink/base/Image.h"

namespace game {

/// What the camera of a made-up game sees: a NAO walks over a field with two lines to an orange ball, turns
/// its head, and has a blue goal before it. All of it is known: poses, places, and the class of each pixel.
struct View {
  static constexpr int kCount = 12, kWidth = 320, kHeight = 240;
  static constexpr double kBallRadius = 0.043;  ///< m
  /// Full opening angles of the camera, rad.
  static constexpr double kHorizontalAngle = 0.78674, kVerticalAngle = 0.60349;
  /// Numbers of classes, as in tables of B-Human; 0 is what is beyond the field.
  static constexpr std::uint8_t kOrange = 1, kBlue = 3, kWhite = 4, kGreen = 5;
  /// The label of pixels at an edge, which may be of either color.
  static constexpr std::uint8_t kEdge = 255;

  robotlink::Pose3 cameraInRobot = robotlink::Pose3::Identity();
  /// Where the ball lies, m; the last image shows none.
  std::optional<robotlink::Vector2> ballInRobot;
  /// The label of each pixel, kMono8.
  robotlink::Image labels;
  /// The bytes Y0 Cb Y1 Cr of each pixel, as the robots' program had them.
  std::vector<std::uint8_t> quads;

  /// The images of the game, made once.
  static const View& at(int number);
};

/// The colors that the camera sees, without its noise; `label` is a number of a class, or 0.
constexpr robotlink::YCbCr colorOf(std::uint8_t label) {
  switch (label) {
    case View::kOrange:
      return {140, 80, 190};
    case View::kBlue:
      return {90, 165, 100};
    case View::kWhite:
      return {205, 128, 128};
    case View::kGreen:
      return {90, 108, 104};
    default:
      return {115, 126, 132};
  }
}

/// A pixel of an image.
struct PixelPlace {
  int x = 0, y = 0;
};
/// Pixels of a label that have only this label within a distance, spread over the image; at most `count`.
std::vector<PixelPlace> placesInside(const robotlink::Image& labels, std::uint8_t label, int distance,
                                     std::size_t count);

}  // namespace game
