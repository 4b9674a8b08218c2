// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>
#include <filesystem>
#include <optional>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace robotlink {
class Session;
}

namespace widgets {

class ReplayControl;

/// The plan of an export of a view: its picture at equidistant instants, from the first to the last,
/// as a video or as numbered PNG files. A plain value.
struct ExportPlan {
  enum class Kind : std::uint8_t { kVideo, kImages };
  static constexpr double kMinRate = 0.1, kMaxRate = 240;
  static constexpr int kMinSide = 16, kMaxSide = 8192;
  /// The maximum number of frames; more would take days, and file managers cannot handle them.
  static constexpr std::int64_t kMaxFrames = 200'000;

  Kind kind = Kind::kVideo;
  /// The video's file, or the folder of the images, which is created if necessary.
  std::filesystem::path target;
  /// The beginning of the images' names: "field" gives field-00001.png.
  std::string name;
  robotlink::Instant from, to;
  /// Pictures for each second of the session's time; also that of the video.
  double rate = 25;
  /// Pixels.
  QSize size;

  /// The number of pictures: at least one.
  std::int64_t frames() const;
  /// The instant of a picture, from 0.
  robotlink::Instant instant(std::int64_t frame) const;
};

/// Checks all that can be known before: times, rate, size, name of the video, folder.
robotlink::Result<void> check(const ExportPlan& plan);

/// A closed stretch of time.
struct TimeSpan {
  robotlink::Instant from, to;
};
/// All that can be exported now: the open logs, or what is kept of live robots; unset if there is nothing.
std::optional<TimeSpan> exportable(robotlink::Session& session, const ReplayControl& replay);
/// The selected range, within that; without one all of it.
std::optional<TimeSpan> chosenSpan(robotlink::Session& session, const ReplayControl& replay);
/// An instant in words: seconds as views show them; of live robots a negative number counts back from now;
/// "start" and "end" are the ends of chosenSpan().
robotlink::Result<robotlink::Instant> instantOf(const std::string& text, robotlink::Session& session,
                                                const ReplayControl& replay);
/// "1280x720"; empty: `usual`.
robotlink::Result<QSize> sizeOf(const std::string& text, const QSize& usual);

}  // namespace widgets
