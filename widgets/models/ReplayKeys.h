// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <optional>

class QKeyEvent;

namespace widgets {

class ReplayControl;

/// What keys do with a replay, as in video players. They are not shortcuts, which would take them from text fields and
/// lists: a window and a time line look at keys that the focus did not want.
enum class ReplayKey : std::uint8_t {
  kPlayOrPause,
  kFrameBack,
  kFrameOn,
  kTenFramesBack,
  kTenFramesOn,
  kSecondBack,
  kSecondOn,
  kMessageBack,
  kMessageOn,
  kStart,
  kEnd,
  kRangeStart,
  kRangeEnd,
  kBookmark,
};

std::optional<ReplayKey> replayKey(const QKeyEvent& event);
QKeySequence keySequence(ReplayKey key);
/// Does it, but for kBookmark, which is no matter of the replay.
void press(ReplayKey key, ReplayControl& replay);

}  // namespace widgets
