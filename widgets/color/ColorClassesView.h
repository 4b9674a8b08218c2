// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/color/ColorActions.h"
#include "widgets/models/ColorClassModel.h"

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

/// The colour classes: which there are, which one the next stroke is of, and how good the table finds each;
/// the files of the samples; below, how the table is made of them. All changes can be undone.
class ColorClassesView final : public View {
  Q_OBJECT
 public:
  explicit ColorClassesView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override {}
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void createActions();
  void createViews();
  void createTree();
  QWidget* createTools();
  QWidget* createMeaning();
  void fillPresetMenu();
  void connectSignals();
  void showSamples();
  void showMeaning();
  void showQuality();
  void showTitle();
  void say(const QString& text, bool bad);

  void add();
  void remove();
  void move(int by);
  void rename(int colorClass, const QString& name);
  void pickColor(int colorClass);
  void usePreset(const colortool::ClassPreset& preset);
  QString className(int colorClass) const;

  ColorBench& bench_;
  ColorFiles& files_;
  ColorFileActions* fileActions_;
  ColorClassModel model_;
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
  QLabel* message_ = nullptr;
  QToolButton* more_ = nullptr;
  TrainingPanel* training_ = nullptr;
};

}  // namespace widgets
