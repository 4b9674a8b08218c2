// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "widgets/View.h"
#include "widgets/color/ColorActions.h"
#include "widgets/models/StrokeModel.h"

class QAction;
class QLabel;
class QMenu;
class QSortFilterProxyModel;
class QSplitter;
class QTreeView;
class QUndoView;

namespace widgets {

class ColorBench;
class EmptyHint;

/// The strokes of the samples as a list: what each says, where it is from, and whether the others agree with
/// it; beside them the history of all changes, in which one can go back and forth by a click. A double click
/// on a stroke shows its image.
class ColorSamplesView final : public View {
  Q_OBJECT
 public:
  explicit ColorSamplesView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override {}
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createActions();
  void createViews();
  void createTree();
  void createHistory();
  void connectSignals();
  void showSamples();
  /// Lets a stroke stay where it was in the view, though its place in the order is another one.
  void hold(std::uint64_t stroke, int column, int top);
  void showQuality();
  void updateCount();
  void openMenu(const QPoint& at);
  void fillClassMenu(QMenu& menu);

  /// The selected strokes; with `also`, those if it is among them, else that alone.
  std::vector<std::uint64_t> chosen(std::uint64_t also = 0) const;
  void restate(const QString& text, const std::vector<std::uint64_t>& ids,
               const std::function<void(colortool::StrokeMeaning&)>& change);
  void remove();
  void setWeight(const std::vector<std::uint64_t>& ids, double weight);
  void setLighting(const std::vector<std::uint64_t>& ids, const QString& lighting);
  void askLighting();
  void showImage(const colortool::SampleImage& image);

  ColorBench& bench_;
  StrokeModel model_;
  QSortFilterProxyModel* sorted_;
  ColorActions history_;
  QAction* remove_ = nullptr;
  QAction* lighting_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QTreeView* tree_ = nullptr;
  QUndoView* steps_ = nullptr;
  QLabel* count_ = nullptr;
  EmptyHint* hint_ = nullptr;
};

}  // namespace widgets
