// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotTreeModel.h"

#include <QGuiApplication>
#include <QMimeData>
#include <iterator>
#include <map>
#include <string_view>

#include "widgets/Theme.h"
#include "widgets/world/FieldUnits.h"

namespace widgets {
namespace {

QStandardItem* addItem(QStandardItem* parent, const QString& text) {
  auto* item = new QStandardItem(text);
  item->setEditable(false);
  item->setDropEnabled(false);
  item->setDragEnabled(false);
  parent->appendRow(item);
  return item;
}

void addUnit(QStandardItem* item, const QString& unit) {
  if (unit.isEmpty()) return;
  auto* beside = new QStandardItem(unit);
  beside->setEditable(false);
  beside->setDropEnabled(false);
  beside->setDragEnabled(false);
  QStandardItem* parent = item->parent() != nullptr ? item->parent() : item->model()->invisibleRootItem();
  parent->setChild(item->row(), PlotTreeModel::kUnit, beside);
}

/// The folders of the tree by their paths; missing ones are created.
class Folders {
 public:
  explicit Folders(QStandardItem* root) { items_[std::string()] = root; }
  QStandardItem* at(const std::string& path) {
    const auto known = items_.find(path);
    if (known != items_.end()) return known->second;
    const std::size_t slash = path.rfind('/');
    QStandardItem* parent = at(slash == std::string::npos ? std::string() : path.substr(0, slash));
    QStandardItem* item = addItem(parent, QString::fromStdString(lastPart(path)));
    item->setData(QString::fromStdString(path), PlotTreeModel::kPathRole);
    return items_[path] = item;
  }

 private:
  std::map<std::string, QStandardItem*> items_;
};

/// The repeated field "data" of "data[3]" or "data[3].x", and the number of its element; empty: there is
/// none, or its elements have names.
struct ElementOf {
  std::string_view list, number;
};
ElementOf elementOf(std::string_view field) {
  const std::size_t open = field.find('['), close = field.find(']');
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) return {};
  const std::string_view number = field.substr(open + 1, close - open - 1);
  const bool isNumber = !number.empty() && number.find_first_not_of("0123456789") == std::string_view::npos;
  return isNumber ? ElementOf{field.substr(0, open), number} : ElementOf{};
}

/// The rows of long lists by the numbers of the choices that are below them.
class LongLists {
 public:
  explicit LongLists(const std::vector<PlotChoice>& choices) {
    for (std::size_t begin = 0; begin < choices.size();) begin = addList(choices, begin);
  }
  /// The row for a choice's field: that of its list, which is made for the first one, or `stream`.
  QStandardItem* rowFor(std::size_t choice, QStandardItem* stream) {
    const auto after = lists_.upper_bound(choice);
    if (after == lists_.begin()) return stream;
    auto& [begin, list] = *std::prev(after);
    if (choice >= list.end) return stream;
    if (list.row == nullptr) {
      list.row = addItem(stream, list.name);
      list.row->setData(list.path, PlotTreeModel::kPathRole);
    }
    return list.row;
  }

 private:
  struct List {
    /// The position behind the last choice.
    std::size_t end = 0;
    QString name, path;
    QStandardItem* row = nullptr;
  };
  /// Notes the list that begins with a choice if it is a long one. Returns where the next one may begin.
  std::size_t addList(const std::vector<PlotChoice>& choices, std::size_t begin) {
    const PlotSource& first = choices[begin].source;
    const ElementOf from = elementOf(first.field);
    if (from.list.empty()) return begin + 1;
    int elements = 1;
    ElementOf last = from;
    std::size_t end = begin + 1;
    for (; end < choices.size() && choices[end].source.stream == first.stream; ++end) {
      const ElementOf next = elementOf(choices[end].source.field);
      if (next.list != from.list) break;
      if (next.number != last.number) ++elements;
      last = next;
    }
    if (elements <= PlotTreeModel::kMaxElements) return end;
    const QString list = QString::fromStdString(std::string(from.list));
    lists_[begin] = {end,
                     QStringLiteral("%1[%2 … %3]")
                         .arg(list, QString::fromStdString(std::string(from.number)),
                              QString::fromStdString(std::string(last.number))),
                     QString::fromStdString(first.stream + '.') + list, nullptr};
    return end;
  }

  /// Keyed by their first choices.
  std::map<std::size_t, List> lists_;
};

}  // namespace

void PlotTreeModel::setChoices(const std::vector<PlotChoice>& choices, const Explain& explain) {
  clear();
  setColumnCount(kColumns);
  Folders folders(invisibleRootItem());
  const QColor muted = colorOf(Meaning::kMuted, QGuiApplication::palette());
  LongLists lists(choices);
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const auto& [source, missing, isPlottable] = choices[i];
    QStandardItem* item = folders.at(source.stream);
    if (!source.field.empty()) {
      item = addItem(lists.rowFor(i, item), QString::fromStdString(source.field));
      if (const QString more = explain ? explain(source) : QString(); !more.isEmpty())
        item->setText(item->text() + QLatin1Char(' ') + more);
      addUnit(item, unitOf(source.type, source.field));
    }
    item->setToolTip(missing.isEmpty() ? source.text() : source.text() + QLatin1Char('\n') + missing);
    if (!missing.isEmpty()) item->setForeground(muted);
    if (!isPlottable) continue;
    item->setData(source.text(), kSourceRole);
    item->setDragEnabled(true);
  }
}

QStringList PlotTreeModel::mimeTypes() const {
  return {QString::fromLatin1(kMimeType)};
}

QMimeData* PlotTreeModel::mimeData(const QModelIndexList& indexes) const {
  QStringList lines;
  for (const QModelIndex& index : indexes) {
    const QString source = index.data(kSourceRole).toString();
    if (!source.isEmpty()) lines << source;
  }
  auto* data = new QMimeData;
  data->setData(QString::fromLatin1(kMimeType), lines.join(QLatin1Char('\n')).toUtf8());
  data->setText(lines.join(QLatin1Char('\n')));
  return data;
}

}  // namespace widgets
