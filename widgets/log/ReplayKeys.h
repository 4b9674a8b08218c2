// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <optional>

class QKeyEvent;

namespace widgets {

class ReplayControl;

/// The keyboard actions of a replay, with the bindings of video players. Each action has one key; see
/// replayKey() and keySequence().
enum class ReplayKey : std::uint8_t {
  /// Space.
  kPlayOrPause,
  /// Left, Right.
  kFrameBack,
  kFrameOn,
  /// Shift+Left, Shift+Right.
  kTenFramesBack,
  kTenFramesOn,
  /// Ctrl+Left, Ctrl+Right.
  kSecondBack,
  kSecondOn,
  /// Comma, period.
  kMessageBack,
  kMessageOn,
  /// Home, End.
  kStart,
  kEnd,
  /// I, O.
  kRangeStart,
  kRangeEnd,
  /// Ctrl+B.
  kBookmark,
};

/// The action of a key event; unset: none.
std::optional<ReplayKey> replayKey(const QKeyEvent& event);
/// The key of an action, for tooltips and menus.
QKeySequence keySequence(ReplayKey key);
/// Executes the action. Does nothing for kBookmark, which OpenLogs does.
void press(ReplayKey key, ReplayControl& replay);

}  // namespace widgets
