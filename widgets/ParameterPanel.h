// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoStack>
#include <QWidget>

#include "widgets/models/ParameterModel.h"

class QAction;
class QLabel;
class QTreeView;

namespace robotlink {
class Session;
}

namespace widgets {

class EmptyHint;

/// Edits the parameters of one solution of the selected robot: asks for them, shows them as a tree, sends the
/// whole message back when a value is entered. Every edit and every reset to the default can be undone. What
/// the robot refuses is said and taken back.
class ParameterPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit ParameterPanel(robotlink::Session& session, QWidget* parent = nullptr);

  /// Asks the robot for the parameters; an empty solution empties the panel.
  void show(const std::string& robot, const std::string& task, const std::string& solution,
            bool hasParameters);
  /// Takes what the robot has told since.
  void tick();

 private:
  void createActions();
  void createViews();
  void connectSignals();
  void askForValues();
  void apply(const QByteArray& value);
  void say(const QString& text, bool bad = false);

  robotlink::Session& session_;
  ParameterModel model_;
  QUndoStack undo_{this};  ///< a child, so that the window finds it
  QTreeView* tree_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* state_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* undoAction_ = nullptr;
  QAction* redoAction_ = nullptr;
  QAction* reset_ = nullptr;
  QAction* resetAll_ = nullptr;
  QAction* refresh_ = nullptr;
  std::string robot_;
  std::string task_;
  std::string solution_;
  const void* shown_ = nullptr;  // the message that is shown
};

}  // namespace widgets
