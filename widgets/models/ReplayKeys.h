// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <optional>

class QKeyEvent;

namespace widgets {

class ReplayControl;

/// What keys do with a replay, as in video players. Those that play and step mean the same wherever the focus
/// is but in a text field; see isEverywhere().
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
/// Whether the key goes before what the focus would do with it. The others are letters, which lists search
/// by.
bool isEverywhere(ReplayKey key);
/// Does it, but for kBookmark, which is no matter of the replay.
void press(ReplayKey key, ReplayControl& replay);

}  // namespace widgets
