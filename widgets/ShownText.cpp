// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ShownText.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QTableView>
#include <QTextEdit>
#include <QTreeView>
#include <algorithm>
#include <vector>

namespace widgets {
namespace {

/// The largest visible one; null: none.
template <typename Part>
const Part* largest(const QWidget& view) {
  const Part* best = nullptr;
  const auto area = [](const QWidget& part) { return part.width() * part.height(); };
  for (const Part* part : view.findChildren<Part*>())
    if (part->isVisibleTo(&view) && (best == nullptr || area(*part) > area(*best))) best = part;
  return best;
}

const QHeaderView& headerOf(const QAbstractItemView& view) {
  if (const auto* tree = qobject_cast<const QTreeView*>(&view)) return *tree->header();
  return *static_cast<const QTableView&>(view).horizontalHeader();
}

/// Whether a character would begin another cell or another row of a table with tabs.
bool breaksTable(QChar c) {
  return c == QLatin1Char('\n') || c == QLatin1Char('\r') || c == QLatin1Char('\t');
}

bool isFolded(const QAbstractItemView& view, const QModelIndex& row) {
  const auto* tree = qobject_cast<const QTreeView*>(&view);
  return tree == nullptr || !tree->isExpanded(row);
}

bool isRowHidden(const QAbstractItemView& view, int row, const QModelIndex& parent) {
  if (const auto* tree = qobject_cast<const QTreeView*>(&view)) return tree->isRowHidden(row, parent);
  return static_cast<const QTableView&>(view).isRowHidden(row);
}

/// Writes what a table or tree shows, line by line.
class TableWriter {
 public:
  TableWriter(const QAbstractItemView& view, QChar separator)
      : view_(view), model_(*view.model()), separator_(separator) {
    const QHeaderView& header = headerOf(view);
    for (int place = 0; place < header.count(); ++place)
      if (const int column = header.logicalIndex(place); !header.isSectionHidden(column))
        columns_.push_back(column);
  }

  QString write() {
    QStringList titles;
    for (const int column : columns_) titles << model_.headerData(column, Qt::Horizontal).toString();
    add(titles);
    addRows(view_.rootIndex(), 0);
    return text_;
  }

 private:
  void addRows(const QModelIndex& parent, int level) {
    for (int row = 0; row < model_.rowCount(parent); ++row) {
      if (isRowHidden(view_, row, parent)) continue;
      QStringList cells;
      for (const int column : columns_) cells << cell(model_.index(row, column, parent));
      if (!cells.isEmpty()) cells.front().prepend(QString(2 * level, QLatin1Char(' ')));
      add(cells);
      const QModelIndex first = model_.index(row, 0, parent);
      if (!isFolded(view_, first)) addRows(first, level + 1);
    }
  }

  static QString cell(const QModelIndex& index) {
    const QVariant check = index.data(Qt::CheckStateRole);
    const QString text = index.data().toString();
    if (!check.isValid() || !text.isEmpty()) return text;
    return check.toInt() == Qt::Checked ? QStringLiteral("1") : QStringLiteral("0");
  }

  void add(QStringList cells) {
    for (QString& cell : cells) {
      if (separator_ == QLatin1Char('\t')) {
        std::replace_if(cell.begin(), cell.end(), breaksTable, QLatin1Char(' '));
      } else if (cell.contains(QLatin1Char('"')) || cell.contains(separator_) ||
                 cell.contains(QLatin1Char('\n')) || cell.contains(QLatin1Char('\r'))) {
        cell = QLatin1Char('"') + cell.replace(QLatin1String("\""), QLatin1String("\"\"")) + QLatin1Char('"');
      }
    }
    text_ += cells.join(separator_) + QLatin1Char('\n');
  }

  const QAbstractItemView& view_;
  const QAbstractItemModel& model_;
  const QChar separator_;
  /// From left to right.
  std::vector<int> columns_;
  QString text_;
};

std::optional<QString> tableOf(const QWidget& view, QChar separator) {
  const QAbstractItemView* table = largest<QTableView>(view);
  const QAbstractItemView* tree = largest<QTreeView>(view);
  if (table == nullptr || (tree != nullptr && tree->height() > table->height())) table = tree;
  if (table == nullptr || table->model() == nullptr) return std::nullopt;
  return TableWriter(*table, separator).write();
}

}  // namespace

std::optional<QString> shownTable(const QWidget& view) {
  return tableOf(view, QLatin1Char(','));
}

std::optional<QString> shownNumbers(const QWidget& view) {
  return tableOf(view, QLatin1Char('\t'));
}

void TabTable::add(QStringList cells) {
  for (QString& cell : cells) std::replace_if(cell.begin(), cell.end(), breaksTable, QLatin1Char(' '));
  text_ += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
}

std::optional<QString> shownValues(const QWidget& view) {
  TabTable table({QStringLiteral("name"), QStringLiteral("value")});
  bool hasRows = false;
  for (const QWidget* part : view.findChildren<QWidget*>()) {
    if (part->accessibleName().isEmpty() || !part->isVisibleTo(&view)) continue;
    QString value;
    if (const auto* label = qobject_cast<const QLabel*>(part)) value = label->text();
    if (const auto* box = qobject_cast<const QComboBox*>(part)) value = box->currentText();
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(part)) value = box->text();
    if (const auto* slider = qobject_cast<const QAbstractSlider*>(part))
      value = QString::number(slider->value());
    if (value.isEmpty()) continue;
    table.add({part->accessibleName(), value});
    hasRows = true;
  }
  return hasRows ? std::optional(table.text()) : std::nullopt;
}

QString csvOfTabs(const QString& table) {
  QString csv;
  csv.reserve(table.size());
  for (const QString& line : table.split(QLatin1Char('\n'))) {
    if (line.isEmpty()) continue;
    QStringList cells = line.split(QLatin1Char('\t'));
    for (QString& cell : cells)
      if (cell.contains(QLatin1Char(',')) || cell.contains(QLatin1Char('"')))
        cell = QLatin1Char('"') + cell.replace(QLatin1String("\""), QLatin1String("\"\"")) + QLatin1Char('"');
    csv += cells.join(QLatin1Char(',')) + QLatin1Char('\n');
  }
  return csv;
}

QString tabsOfCsv(const QString& csv) {
  QString text;
  bool isQuoted = false;
  for (int i = 0; i < csv.size(); ++i) {
    const QChar c = csv[i];
    if (c == QLatin1Char('"')) {
      // Two quotes in a quoted cell are one.
      const bool isDouble = isQuoted && i + 1 < csv.size() && csv[i + 1] == c;
      if (isDouble) {
        text += c;
        ++i;
      } else {
        isQuoted = !isQuoted;
      }
    } else if (isQuoted) {
      text += breaksTable(c) ? QLatin1Char(' ') : c;
    } else {
      text += c == QLatin1Char(',') ? QLatin1Char('\t') : c;
    }
  }
  return text;
}

std::optional<QString> shownText(const QWidget& view) {
  if (const auto* text = largest<QPlainTextEdit>(view)) return text->toPlainText() + QLatin1Char('\n');
  if (const auto* text = largest<QTextEdit>(view)) return text->toPlainText() + QLatin1Char('\n');
  return tableOf(view, QLatin1Char('\t'));
}

}  // namespace widgets
