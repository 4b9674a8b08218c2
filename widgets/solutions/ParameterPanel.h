// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoStack>
#include <QWidget>
#include <filesystem>
#include <functional>

#include "robotlink/process/Link.h"
#include "widgets/solutions/ParameterModel.h"

class QAction;
class QLabel;
class QTreeView;

namespace robotlink {
class Session;
}

namespace widgets {

class EmptyHint;
class ParameterSlider;

/// Edits the parameters of one solution of a robot. The panel requests the current values, shows them as a
/// tree, and sends the whole message back when a value is entered. Every edit and every reset can be undone.
/// If the robot refuses a value, the reason is shown, the former value is restored and the undo stack is
/// cleared. What was changed can be saved to the solution's file, or to another one if that is elsewhere or
/// cannot be written. GUI thread.
class ParameterPanel final : public QWidget {
  Q_OBJECT
 public:
  /// `session` must outlive the panel.
  explicit ParameterPanel(robotlink::Session& session, QWidget* parent = nullptr);

  /// Requests the parameters of a solution. An empty `solution`, or one without parameters, empties the
  /// panel. Clears the undo stack.
  void show(const std::string& robot, const std::string& task, const std::string& solution,
            bool hasParameters);
  /// Applies the ParameterValues that the robot published since the last tick. A message of the same type
  /// keeps the tree, the undo stack and an open editor.
  void tick();
  /// Undoes or redoes an edit of what is shown. False: there is none.
  bool undo();
  bool redo();

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// Saves to the solution's file, or asks for another one if there is none here.
  void save();
  void saveAs();
  /// Writes a file; `own`: it is the one that the program reads, which is notified.
  void saveTo(const std::filesystem::path& file, bool own);
  /// Enables what can be done, and says what has changed.
  void showChanges();
  /// Requests the parameters; they arrive as a ParameterValues message.
  void askForValues();
  /// Returns a function that says whether the same solution is still shown as now, for answers that come
  /// later.
  std::function<bool()> whetherShown() const;
  /// Shows `value` (a serialized message) and sends it to the robot.
  void apply(const QByteArray& value);

  robotlink::Session& session_;
  ParameterModel model_;
  /// A child object, so that the main window's undo actions find it.
  QUndoStack undo_{this};
  QTreeView* tree_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* state_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* undoAction_ = nullptr;
  QAction* redoAction_ = nullptr;
  QAction* reset_ = nullptr;
  QAction* resetAll_ = nullptr;
  QAction* refresh_ = nullptr;
  QAction* save_ = nullptr;
  QAction* saveAs_ = nullptr;
  ParameterSlider* slider_ = nullptr;
  std::string robot_;
  std::string task_;
  std::string solution_;
  /// The message that is shown; null: none has arrived.
  robotlink::PackagePtr shown_;
};

}  // namespace widgets
