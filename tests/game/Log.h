// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <filesystem>

#include "robotlink/base/Clock.h"
#include "tests/game/View.h"
#include "tests/logplayer/bhuman/QueueBuilder.h"

namespace game {

/// A whole log in the format of 2009, of the game of View: each image with its camera's pose and optics,
/// two frames of motion before the first image and behind each, a text, and two images whose pose cannot be
/// relied on.
struct Log {
  static constexpr int kMotionFrames = 2 + 2 * View::kCount;
  static constexpr std::uint64_t kFrames = View::kCount + kMotionFrames;
  /// 6 in a frame of motion, 5 in one of cognition, and the text.
  static constexpr std::uint64_t kMessages = 6 * kMotionFrames + 5 * View::kCount + 1;
  static constexpr int kFirstUncertain = 5, kUncertain = 2;
  static constexpr char kText[] = "the game begins";

  /// ms since the robot's start.
  static constexpr std::uint32_t imageMs(int image) {
    return static_cast<std::uint32_t>(20'000 + 100 * image);
  }
  static constexpr std::uint32_t motionMs(int frame) {
    return static_cast<std::uint32_t>(frame < 2 ? 19'800 + 100 * frame
                                                : 20'000 + 100 * ((frame - 2) / 2) + 33 + 33 * (frame % 2));
  }
  static robotlink::Instant imageTime(int image) {
    return robotlink::Instant(std::chrono::milliseconds(imageMs(image)));
  }
  /// How far the robot has walked, mm.
  static double walkedMm(int motionFrame) { return 12.5 * motionFrame; }

  static logplayer::bhuman::QueueBuilder queue();
  /// The bytes of the file, made once.
  static const std::vector<std::uint8_t>& bytes();
  static void write(const std::filesystem::path& file);
};

}  // namespace game
