// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"

class QLabel;
class QMenu;
class QTableView;

namespace widgets {

class EmptyHint;
class KeyFrameModel;
class MotionBench;
class MotionFiles;
class MotionLink;
class MotionTextEdit;
class MotionTimeLine;

/// The motion that is edited, as text with its errors underlined, as a table of key frames, and over time;
/// with files, undo, mirroring, and the robot: sending, playing, stepping.
///
/// Registered as "motion-editor". GUI thread.
class MotionEditorView final : public View {
  Q_OBJECT
 public:
  explicit MotionEditorView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;
  /// Also saves the text as .mof; it still counts as unsaved.
  robotlink::Result<void> saveTo(const QString& file) override;

 private:
  void createFileActions();
  void createEditActions();
  void createRobotActions();
  QWidget* createTools();
  QWidget* createTable();
  void createViews();
  void connectSignals();
  void connectRobot();

  void startAnew();
  void askForName(const QString& title, const std::function<void(const QString&)>& use);
  /// Reports a failure.
  void showFailure(const robotlink::Result<void>& done);
  void report(const QString& text, bool bad);
  void showTable();
  /// Selects the row of the bench's key frame.
  void showFrame();
  void showState();
  void fillRobotMenu();

  MotionBench& bench_;
  MotionFiles& files_;
  MotionLink& link_;
  QAction *new_ = nullptr, *open_ = nullptr, *save_ = nullptr, *saveAs_ = nullptr, *discard_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr;
  QAction *add_ = nullptr, *remove_ = nullptr, *up_ = nullptr, *down_ = nullptr, *mirror_ = nullptr,
          *mirrorFrame_ = nullptr;
  QAction *send_ = nullptr, *autoSend_ = nullptr, *takeBack_ = nullptr, *previous_ = nullptr,
          *play_ = nullptr, *next_ = nullptr;
  QMenu* more_ = nullptr;
  QMenu* ofRobot_ = nullptr;
  QLabel *title_ = nullptr, *state_ = nullptr, *errors_ = nullptr;
  MotionTextEdit* text_ = nullptr;
  QTableView* table_ = nullptr;
  KeyFrameModel* model_ = nullptr;
  MotionTimeLine* timeLine_ = nullptr;
  EmptyHint* hint_ = nullptr;
  bool isShowingFrame_ = false;
};

}  // namespace widgets
