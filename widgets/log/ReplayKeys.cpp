// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/ReplayKeys.h"

#include <QKeyEvent>

#include "widgets/log/ReplayControl.h"

namespace widgets {
namespace {

struct Binding {
  ReplayKey does;
  Qt::Key key;
  Qt::KeyboardModifier modifier = Qt::NoModifier;
};
constexpr Binding kBindings[] = {
    {ReplayKey::kPlayOrPause, Qt::Key_Space},
    {ReplayKey::kFrameBack, Qt::Key_Left},
    {ReplayKey::kFrameOn, Qt::Key_Right},
    {ReplayKey::kTenFramesBack, Qt::Key_Left, Qt::ShiftModifier},
    {ReplayKey::kTenFramesOn, Qt::Key_Right, Qt::ShiftModifier},
    {ReplayKey::kSecondBack, Qt::Key_Left, Qt::ControlModifier},
    {ReplayKey::kSecondOn, Qt::Key_Right, Qt::ControlModifier},
    {ReplayKey::kMessageBack, Qt::Key_Comma},
    {ReplayKey::kMessageOn, Qt::Key_Period},
    {ReplayKey::kStart, Qt::Key_Home},
    {ReplayKey::kEnd, Qt::Key_End},
    {ReplayKey::kRangeStart, Qt::Key_I},
    {ReplayKey::kRangeEnd, Qt::Key_O},
    {ReplayKey::kBookmark, Qt::Key_B, Qt::ControlModifier},
};

}  // namespace

std::optional<ReplayKey> replayKey(const QKeyEvent& event) {
  const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
  for (const Binding& binding : kBindings) {
    if (event.key() == binding.key && modifiers == binding.modifier) return binding.does;
  }
  return std::nullopt;
}

QKeySequence keySequence(ReplayKey key) {
  for (const Binding& binding : kBindings) {
    if (binding.does == key) return {static_cast<int>(binding.modifier) | static_cast<int>(binding.key)};
  }
  return {};
}

void press(ReplayKey key, ReplayControl& replay) {
  constexpr std::chrono::seconds kSecond{1};
  switch (key) {
    case ReplayKey::kPlayOrPause:
      return replay.playOrPause();
    case ReplayKey::kFrameBack:
      return replay.stepFrames(-1);
    case ReplayKey::kFrameOn:
      return replay.stepFrames(1);
    case ReplayKey::kTenFramesBack:
      return replay.stepFrames(-10);
    case ReplayKey::kTenFramesOn:
      return replay.stepFrames(10);
    case ReplayKey::kSecondBack:
      return replay.jumpBy(-kSecond);
    case ReplayKey::kSecondOn:
      return replay.jumpBy(kSecond);
    case ReplayKey::kMessageBack:
      return replay.stepMessages(-1);
    case ReplayKey::kMessageOn:
      return replay.stepMessages(1);
    case ReplayKey::kStart:
      return replay.jumpTo(replay.start());
    case ReplayKey::kEnd:
      return replay.jumpTo(replay.end());
    case ReplayKey::kRangeStart:
      return replay.beginRangeHere();
    case ReplayKey::kRangeEnd:
      return replay.endRangeHere();
    case ReplayKey::kBookmark:
      return;
  }
}

}  // namespace widgets
