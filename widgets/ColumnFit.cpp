// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ColumnFit.h"

#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>
#include <QTableView>
#include <QTreeView>
#include <algorithm>
#include <numeric>

#include "widgets/Controls.h"

namespace widgets {
namespace {

constexpr int kMinTitle = 32;                        // pixels: a sort indicator and two letters
constexpr int kMinNameTitle = 64;                    // pixels
constexpr int kTextWidth = 160, kMinTextWidth = 80;  // pixels
constexpr int kFitInterval = 250;                    // ms between two fits to changed contents
constexpr int kMinWidth = 8, kMaxWidth = 4'000;      // pixels

int totalWidth(const std::vector<int>& widths) {
  return std::accumulate(widths.begin(), widths.end(), 0);
}

int comfortableWidth(const ColumnNeed& column, int room) {
  if (column.pinned > 0) return column.pinned;
  if (column.kind == ColumnKind::kText) return std::max(column.title, kTextWidth);
  const int width = std::max(column.title, column.contents);
  return column.kind == ColumnKind::kName ? std::min(width, std::max(room * 3 / 4, kTextWidth)) : width;
}

int leastWidth(const ColumnNeed& column, int room) {
  if (column.pinned > 0) return column.pinned;
  if (column.kind == ColumnKind::kText) return kMinTextWidth;
  if (column.kind == ColumnKind::kTitledNumber) return comfortableWidth(column, room);
  const int title = column.kind == ColumnKind::kName ? kMinNameTitle : kMinTitle;
  return std::min(std::max(column.contents, std::min(column.title, title)), comfortableWidth(column, room));
}

/// Takes `excess` pixels, or as many as possible, from the columns of a kind, in proportion to what each can
/// spare. Returns what could not be taken.
int shrinkKind(const std::vector<ColumnNeed>& columns, ColumnKind kind, int room, int excess,
               std::vector<int>& widths) {
  int spare = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].kind == kind) spare += widths[i] - leastWidth(columns[i], room);
  }
  const int wanted = std::min(excess, spare);
  for (std::size_t i = 0, left = static_cast<std::size_t>(wanted); i < columns.size() && left > 0; ++i) {
    if (columns[i].kind != kind) continue;
    const int own = widths[i] - leastWidth(columns[i], room);
    // Rounded up, so that all is taken in the end.
    const int taken = std::min({own, static_cast<int>(left), (own * wanted + spare - 1) / spare});
    widths[i] -= taken;
    left -= static_cast<std::size_t>(taken);
  }
  return excess - wanted;
}

/// Distributes the remaining room to the texts, or else to the last name.
void spreadRest(const std::vector<ColumnNeed>& columns, int rest, std::vector<int>& widths) {
  std::vector<std::size_t> takers;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].kind == ColumnKind::kText && columns[i].pinned == 0) takers.push_back(i);
  }
  for (std::size_t i = columns.size(); takers.empty() && i-- > 0;) {
    if (columns[i].kind == ColumnKind::kName && columns[i].pinned == 0) takers.push_back(i);
  }
  for (std::size_t i = 0; i < takers.size(); ++i) {
    const int part = rest / static_cast<int>(takers.size() - i);
    widths[takers[i]] += part;
    rest -= part;
  }
}

}  // namespace

std::vector<int> fittedWidths(const std::vector<ColumnNeed>& columns, int room) {
  std::vector<int> widths;
  for (const ColumnNeed& column : columns) widths.push_back(comfortableWidth(column, room));
  int excess = totalWidth(widths) - room;
  for (const ColumnKind kind : {ColumnKind::kNumber, ColumnKind::kText, ColumnKind::kName}) {
    if (excess > 0) excess = shrinkKind(columns, kind, room, excess, widths);
  }
  if (excess < 0) spreadRest(columns, -excess, widths);
  return widths;
}

ColumnFit::ColumnFit(QTableView& table, std::vector<ColumnKind> kinds)
    : ColumnFit(table, *table.horizontalHeader(), std::move(kinds)) {
  table.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table.setWordWrap(false);
}

ColumnFit::ColumnFit(QTableView& table, ColumnKind all) : ColumnFit(table, std::vector<ColumnKind>()) {
  all_ = all;
}

ColumnFit::ColumnFit(QTreeView& tree, std::vector<ColumnKind> kinds)
    : ColumnFit(tree, *tree.header(), std::move(kinds)) {
  connect(&tree, &QTreeView::expanded, this, &ColumnFit::schedule);
}

ColumnFit::ColumnFit(QAbstractItemView& view, QHeaderView& header, std::vector<ColumnKind> kinds)
    : QObject(&header), view_(view), header_(header), expected_(kinds.size()) {
  for (const ColumnKind kind : kinds) needs_.push_back({kind});
  later_.setSingleShot(true);
  connect(&later_, &QTimer::timeout, this, &ColumnFit::fit);
  header.setStretchLastSection(false);
  header.setHighlightSections(false);
  header.setSectionResizeMode(QHeaderView::Interactive);
  header.setMinimumSectionSize(kMinWidth);
  header.setTextElideMode(Qt::ElideRight);
  header.setResizeContentsPrecision(0);  // what is seen, not all rows
  connect(&header, &QHeaderView::sectionResized, this, [this](int column, int before, int width) {
    if (fitting_) return;
    // From and to 0: it was hidden or shown.
    if (before > 0 && width > 0) pin(column, width);
    schedule();
  });
  connect(&header, &QHeaderView::sectionHandleDoubleClicked, this, [this](int column) { pin(column, 0); });
  connect(view.verticalScrollBar(), &QScrollBar::valueChanged, this, &ColumnFit::schedule);
  view.viewport()->installEventFilter(this);
  followModel();
}

void ColumnFit::followModel() {
  const QAbstractItemModel* model = view_.model();
  connect(model, &QAbstractItemModel::modelReset, this, &ColumnFit::schedule);
  connect(model, &QAbstractItemModel::layoutChanged, this, &ColumnFit::schedule);
  connect(model, &QAbstractItemModel::rowsInserted, this, &ColumnFit::schedule);
  connect(model, &QAbstractItemModel::dataChanged, this, &ColumnFit::schedule);
}

ColumnFit* ColumnFit::of(const QHeaderView& header) {
  return header.findChild<ColumnFit*>(QString(), Qt::FindDirectChildrenOnly);
}

bool ColumnFit::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Show) fit();
  if (event->type() == QEvent::FontChange) {
    for (ColumnNeed& need : needs_) need.contents = 0;
    schedule();
  }
  return QObject::eventFilter(watched, event);
}

void ColumnFit::countColumns() {
  const auto count = static_cast<std::size_t>(header_.count());
  if (!all_ || count == needs_.size()) return;
  needs_.assign(count, {*all_});
  expected_.assign(count, {});
}

void ColumnFit::schedule() {
  if (later_.isActive()) return;
  const qint64 elapsed = sinceFit_.isValid() ? sinceFit_.elapsed() : kFitInterval;
  later_.start(static_cast<int>(std::max<qint64>(0, kFitInterval - elapsed)));
}

int ColumnFit::pinned(int column) const {
  // Columns that were added since it was fitted last, or that it was never fitted with, have the width of
  // none.
  if (column < 0 || column >= static_cast<int>(needs_.size())) return 0;
  return needs_[static_cast<std::size_t>(column)].pinned;
}

void ColumnFit::pin(int column, int width) {
  countColumns();
  if (column < 0 || column >= static_cast<int>(needs_.size())) return;
  needs_[static_cast<std::size_t>(column)].pinned = width <= 0 ? 0 : std::clamp(width, kMinWidth, kMaxWidth);
  schedule();
}

void ColumnFit::expect(int column, const QString& text) {
  expected_.at(static_cast<std::size_t>(column)) = text;
}

void ColumnFit::measure() {
  const bool empty = view_.model()->rowCount() == 0;
  for (std::size_t i = 0; i < needs_.size(); ++i) {
    const int column = static_cast<int>(i);
    ColumnNeed& need = needs_[i];
    need.title = header_.isHidden() ? 0 : header_.sectionSizeHint(column);
    if (need.kind == ColumnKind::kText) continue;
    const int contents = static_cast<const QAbstractItemView&>(view_).sizeHintForColumn(column);
    const int expected = expected_[i].isEmpty() ? 0 : textWidth(view_, expected_[i]);
    need.contents = std::max({empty ? 0 : need.contents, contents + 1, expected});  // 1: for the grid
  }
}

void ColumnFit::fit() {
  later_.stop();
  countColumns();
  if (fitting_ || !view_.isVisible() || header_.count() != static_cast<int>(needs_.size())) return;
  fitting_ = true;
  measure();
  std::vector<ColumnNeed> shown;
  std::vector<int> columns;
  for (int column = 0; column < header_.count(); ++column) {
    if (header_.isSectionHidden(column)) continue;
    columns.push_back(column);
    shown.push_back(needs_[static_cast<std::size_t>(column)]);
  }
  const auto widths = fittedWidths(shown, view_.viewport()->width());
  for (std::size_t i = 0; i < columns.size(); ++i) header_.resizeSection(columns[i], widths[i]);
  fitting_ = false;
  sinceFit_.start();
}

}  // namespace widgets
