// SPDX-License-Identifier: GPL-3.0-or-later
// The controls of plots.
#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QToolButton>
#include <QTreeView>

#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/plots/PathCanvas.h"
#include "widgets/plots/PlotCanvas.h"
#include "widgets/plots/PlotsView.h"
#include "widgets/plots/SpectrumCanvas.h"

namespace widgets {
namespace {

constexpr int kWindows[] = {1, 2, 5, 10, 30, 60, 300};  // s

}  // namespace

void PlotsView::createActions() {
  showTree_ = makeToggle(
      this, "filter",
      {"plotsShowTree", tr("Values"), tr("Shows the tree of what can be plotted"), tr("Ctrl+Shift+V")}, true);
  showTree_->setIcon({});
  add_ = makeAction(this, "add",
                    {"plotsAdd", tr("Add"), tr("Adds the selected values as curves"), tr("Ctrl+Return")});
  remove_ = makeAction(
      this, "remove", {"plotsRemove", tr("Remove"), tr("Removes the selected curves"), QKeySequence::Delete});
  follow_ =
      makeToggle(this, "follow",
                 {"plotsFollow", tr("Follow"), tr("Keeps the newest values in view"), tr("Ctrl+E")}, true);
  pause_ = makeToggle(this, "pause",
                      {"plotsPause", tr("Pause"), tr("Freezes the plot; nothing is lost"), tr("Ctrl+T")});
  wholeLog_ = makeToggle(
      this, "time-line",
      {"plotsWholeLog", tr("Whole log"), tr("Reads the curves of the whole log, without playing it")}, true);
  fit_ = makeAction(this, "fit", {"plotsFit", tr("Fit"), tr("Shows all points of the curves"), tr("Ctrl+0")});
  csv_ = makeAction(this, "save",
                    {"plotsCsv", tr("Export CSV"), tr("Writes all points to a table"),
                     QKeySequence(QStringLiteral("Ctrl+Shift+E"))});
  png_ = makeAction(this, "camera", {"plotsPng", tr("Export PNG"), tr("Writes the picture to a file")});
  svg_ = makeAction(this, "export", {"plotsSvg", tr("Export SVG"), tr("Writes the drawing to a file")});
  copy_ = makeAction(this, "copy",
                     {"plotsCopy", tr("Copy picture"), tr("Copies the picture"), QKeySequence::Copy});
  undo_ = makeAction(this, "undo",
                     {"plotsUndo", tr("Previous view"), tr("Shows the previous section"),
                      QKeySequence(QStringLiteral("Alt+Left"))});
  redo_ = makeAction(
      this, "redo",
      {"plotsRedo", tr("Next view"), tr("Redoes the zoom"), QKeySequence(QStringLiteral("Alt+Right"))});
  link_ = makeToggle(this, "lock",
                     {"plotsLink", tr("Link"), tr("Keeps the same time range as the other linked plots")});
  cursors_ = makeToggle(this, "select-area",
                        {"plotsCursors", tr("Cursors"),
                         tr("Shows what is at and between two cursors; a click sets A, Shift+click sets B")});
  right_ = makeAction(
      this, "two-pictures",
      {"plotsRight", tr("Other axis"), tr("Moves the selected curves to the axis on the right, or back")});
  createLookActions();
}

void PlotsView::createLookActions() {
  strip_ = makeAction(this, "streams",
                      {"plotsStrip", tr("As states"),
                       tr("Shows the selected curves as strips of states, or as curves again")});
  across_ =
      makeAction(this, "plots",
                 {"plotsAcross", tr("Over each other"),
                  tr("Plots the lower of two selected curves over the upper one, instead of over time")});
  for (QAction* action : {strip_, across_}) action->setIcon({});
  equal_ = makeToggle(this, "fit",
                      {"plotsEqual", tr("Equal axes"),
                       tr("Uses the same scale on both axes of plots of one value over another")});
  equal_->setIcon({});
  showSpectrum_ = makeToggle(this, "plots",
                             {"plotsSpectrum", tr("Spectrum"),
                              tr("Shows the spectrum of the selected curves, or of all, of the shown times "
                                 "or between the cursors")});
  mark_ = makeAction(this, "bookmark",
                     {"plotsMark", tr("Mark texts…"), tr("Marks the times of matching messages")});
  previousChange_ = makeAction(this, "previous",
                               {"plotsPreviousChange", tr("Previous change"),
                                tr("Shows when the selected curve changed before"), tr("Ctrl+,")});
  nextChange_ = makeAction(
      this, "next",
      {"plotsNextChange", tr("Next change"), tr("Shows when the selected curve changes next"), tr("Ctrl+.")});
  spectrumCsv_ = makeAction(
      this, "save", {"plotsSpectrumCsv", tr("Export the spectrum"), tr("Writes the amplitudes to a table")});
}

void PlotsView::createTree() {
  treePanel_ = new QWidget(this);
  search_ = makeSearchField(
      treePanel_, {"plotsSearch", tr("Search values"), tr("Shows the values whose path contains this")});
  tree_ = new QTreeView(treePanel_);
  styleTree(*tree_);
  describe(*tree_, {"plotsTree", tr("Values that can be plotted"),
                    tr("Double click, Enter or drag into the plot to add a curve")});
  filter_->setSourceModel(&sources_);
  filter_->setRecursiveFilteringEnabled(true);
  filter_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  filter_->setFilterRole(PlotTreeModel::kSourceRole);
  tree_->setModel(filter_);
  tree_->setHeaderHidden(true);
  new ColumnFit(*tree_, {ColumnKind::kName, ColumnKind::kNumber});
  tree_->setTextElideMode(Qt::ElideRight);
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setDragEnabled(true);
  tree_->setDragDropMode(QAbstractItemView::DragOnly);
  expression_ = new QLineEdit(treePanel_);
  describe(
      *expression_,
      {"plotsExpression", tr("Expression"),
       tr("A formula over values, as in sqrt(models/ball.position.x^2 + models/ball.position.y^2); Enter "
          "adds it as a curve. Manual: Expressions.")});
  expression_->setPlaceholderText(tr("Formula over values, Enter adds it"));
  expression_->setClearButtonEnabled(true);
  auto* layout = makeColumn(treePanel_, {}, 4);
  layout->addWidget(search_);
  layout->addWidget(tree_, 1);
  layout->addWidget(expression_);
}

void PlotsView::createLegend() {
  legend_ = new QTreeView(this);
  styleTree(*legend_);
  describe(*legend_, {"plotsLegend", tr("Curves"), {}});
  legend_->setModel(&curves_);
  legend_->setRootIsDecorated(false);
  legend_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  new ColumnFit(*legend_, {ColumnKind::kName, ColumnKind::kNumber, ColumnKind::kNumber, ColumnKind::kNumber});
  // Curves differ at the end of their names; tips have them whole.
  legend_->setTextElideMode(Qt::ElideLeft);
}

void PlotsView::createStatistics() {
  statistics_ = new QTreeView(this);
  styleTree(*statistics_);
  describe(*statistics_, {"plotsStatistics", tr("Between the cursors"), {}});
  statistics_->setModel(&between_);
  statistics_->setRootIsDecorated(false);
  std::vector<ColumnKind> columns(CursorModel::kColumns, ColumnKind::kNumber);
  columns.front() = ColumnKind::kName;
  new ColumnFit(*statistics_, std::move(columns));
  statistics_->setTextElideMode(Qt::ElideLeft);
  statistics_->hide();
}

QWidget* PlotsView::createTools() {
  auto* top = makeToolRow(this, 0);
  const auto addTexts = [&](std::initializer_list<QAction*> actions) {
    for (QAction* action : actions) {
      auto* button = makeButton(this, action);
      button->setToolButtonStyle(Qt::ToolButtonTextOnly);
      top->addWidget(button);
    }
  };
  addTexts({showTree_});
  for (QAction* action : {add_, remove_, right_}) top->addWidget(makeButton(this, action));
  top->addWidget(makeMenuButton(
      this, {"plotsCompute", tr("Compute"), tr("Adds a curve computed from the selected ones")},
      createFilterMenu()));
  top->addSpacing(8);
  top->addWidget(window_);
  for (QAction* action : {follow_, pause_, fit_, undo_, redo_, link_, cursors_, wholeLog_})
    top->addWidget(makeButton(this, action));
  addTexts({showSpectrum_, equal_});
  findChild<QToolButton*>(QStringLiteral("plotsEqual"))->hide();
  for (QAction* action : {mark_, previousChange_, nextChange_}) top->addWidget(makeButton(this, action));
  top->addWidget(state_, 1);
  for (QAction* action : {copy_, csv_, png_, svg_}) top->addWidget(makeButton(this, action));
  return top->parentWidget();
}

void PlotsView::createViews() {
  canvas_ = new PlotCanvas(curves_, this);
  paths_ = new PathCanvas(curves_, this);
  paths_->hide();
  spectrum_ = new SpectrumCanvas(this);
  spectrum_->addTool(*spectrumCsv_);
  spectrum_->hide();
  hint_ = new EmptyHint(canvas_);
  window_ = new QComboBox(this);
  describe(*window_,
           {"plotsWindow", tr("Time window"), tr("What is shown while following: the last seconds, or all")});
  for (const int seconds : kWindows) window_->addItem(tr("%1 s").arg(seconds), seconds);
  window_->addItem(tr("all"), 0);
  window_->setCurrentIndex(window_->findData(kUsualWindow));
  state_ = new QLabel(this);
  describe(*state_, {"plotsState", tr("State of the plots"), {}});
  QWidget* tools = createTools();
  auto* beside = makeSplitter(this, "plotsPathSplitter", Qt::Horizontal, {{canvas_, 1}, {paths_, 1}});
  area_ = makeSplitter(this, "plotsArea", Qt::Vertical, {{beside, 3}, {spectrum_, 2}});
  auto* right =
      makeSplitter(this, "plotsLegendSplitter", Qt::Vertical, {{area_, 4}, {legend_, 1}, {statistics_, 1}});
  right->setSizes({400, 100, 100});
  splitter_ = makeSplitter(this, "plotsSplitter", Qt::Horizontal, {{treePanel_, 1}, {right, 3}});
  splitter_->setSizes({260, 640});
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(tools);
  layout->addWidget(splitter_, 1);
}

}  // namespace widgets
