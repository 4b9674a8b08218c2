// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/color/ColorActions.h"
#include "widgets/color/ColorClassModel.h"

class QAction;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QMenu;
class QToolButton;
class QTreeView;

namespace colortool {
struct ClassPreset;
}

namespace widgets {

class ColorBench;
class ColorFileActions;
class ColorFiles;
class TrainingPanel;

/// The color classes: which there are, the class of the next stroke, and how well the table finds each of
/// them; the actions for the files of the samples; and, below, the options of training. All changes can be
/// undone.
///
/// Registered as "color-classes". GUI thread.
class ColorClassesView final : public View {
  Q_OBJECT
 public:
  explicit ColorClassesView(ViewContext& context, QWidget* parent = nullptr);
  /// Does nothing: the bench signals all changes.
  void tick() override {}

 protected:
  /// Opens the color dialog at a click on the swatch of the current class.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void createActions();
  void createViews();
  /// The table of the classes.
  void createTree();
  /// The buttons for adding, removing and moving classes.
  QWidget* createTools();
  /// The controls for "must not be" and weight of the next stroke.
  QWidget* createMeaning();
  /// Lists the class presets.
  void fillPresetMenu();
  void connectSignals();
  /// Follows the bench's samples.
  void showSamples();
  /// Follows the meaning of the next stroke.
  void showMeaning();
  /// Shows the classes' recalls.
  void showQuality();
  /// Puts the name of the samples' file into the dock's title.
  void showTitle();
  /// Shows a message; `bad`: in the color of an error.
  void say(const QString& text, bool bad);

  /// Adds a class.
  void add();
  /// Removes the current class with its strokes.
  void remove();
  /// Moves the current class; -1 is up.
  void move(int by);
  void rename(int colorClass, const QString& name);
  /// Asks for the color in which a class is shown.
  void pickColor(int colorClass);
  /// Replaces the classes by those of a preset.
  void usePreset(const colortool::ClassPreset& preset);
  QString className(int colorClass) const;

  ColorBench& bench_;
  ColorFiles& files_;
  ColorFileActions* fileActions_;
  ColorClassModel model_;
  /// Undo and redo.
  ColorActions history_;
  QAction* add_ = nullptr;
  QAction* remove_ = nullptr;
  QAction* rename_ = nullptr;
  QAction* up_ = nullptr;
  QAction* down_ = nullptr;
  QAction* mustNotBe_ = nullptr;
  QMenu* presets_ = nullptr;
  QTreeView* tree_ = nullptr;
  QDoubleSpinBox* weight_ = nullptr;
  /// The last message of files or bench.
  QLabel* message_ = nullptr;
  QToolButton* more_ = nullptr;
  /// Method and options of training.
  TrainingPanel* training_ = nullptr;
};

}  // namespace widgets
