// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "widgets/View.h"
#include "widgets/color/ColorActions.h"
#include "widgets/color/samples/StrokeModel.h"

class QAction;
class QLabel;
class QMenu;
class QSplitter;
class QTreeView;
class QUndoView;

namespace widgets {

class ColorBench;
class EmptyHint;
class StrokeOrder;

/// The strokes of the samples as a list: what each says, its image, and whether the other strokes agree with
/// it; next to it the history of all changes, where a click goes back and forth. A double click on a stroke
/// shows its image.
///
/// Registered as "color-samples". GUI thread.
class ColorSamplesView final : public View {
  Q_OBJECT
 public:
  explicit ColorSamplesView(ViewContext& context, QWidget* parent = nullptr);
  /// Does nothing: the bench signals all changes.
  void tick() override {}

 protected:
  /// While the mouse is over the strokes their order is frozen, so that the one that is changed stays under
  /// it.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void createActions();
  void createViews();
  /// The list of the strokes.
  void createTree();
  /// The list of the undo stack's steps.
  void createHistory();
  void connectSignals();
  /// Follows the bench's samples.
  void showSamples();
  /// Keeps a stroke at its place in the viewport although its row in the sorted list has changed.
  void hold(std::uint64_t stroke, int column, int top);
  /// Shows with how many of their pixels the others agree.
  void showQuality();
  void updateCount();
  /// Context menu of the strokes.
  void openMenu(const QPoint& at);
  /// Adds an entry per class, which restates the chosen strokes.
  void fillClassMenu(QMenu& menu);

  /// Ids of the selected strokes. If the stroke `also` is not among them, its id alone.
  std::vector<std::uint64_t> chosen(std::uint64_t also = 0) const;
  /// Changes the meaning of strokes as one step of the history.
  void restate(const QString& text, const std::vector<std::uint64_t>& ids,
               const std::function<void(colortool::StrokeMeaning&)>& change);
  /// Removes the selected strokes.
  void remove();
  void setWeight(const std::vector<std::uint64_t>& ids, double weight);
  /// Sets the lighting of the strokes' images.
  void setLighting(const std::vector<std::uint64_t>& ids, const QString& lighting);
  /// Asks for the lighting of the selected strokes' images.
  void askLighting();
  /// Shows the image of a stroke: the collected one, the file, or by moving the timeline.
  void showImage(const colortool::SampleImage& image);

  ColorBench& bench_;
  StrokeModel model_;
  StrokeOrder* sorted_;
  ColorActions history_;
  QAction* remove_ = nullptr;
  QAction* lighting_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QTreeView* tree_ = nullptr;
  /// The history.
  QUndoView* steps_ = nullptr;
  QLabel* count_ = nullptr;
  EmptyHint* hint_ = nullptr;
};

}  // namespace widgets
