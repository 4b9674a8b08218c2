// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotTreeModel.h"

#include <QGuiApplication>
#include <QMimeData>
#include <map>

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

}  // namespace

void PlotTreeModel::setChoices(const std::vector<PlotChoice>& choices, const Explain& explain) {
  clear();
  setColumnCount(kColumns);
  Folders folders(invisibleRootItem());
  const QColor muted = colorOf(Meaning::kMuted, QGuiApplication::palette());
  for (const auto& [source, missing, isPlottable] : choices) {
    QStandardItem* item = folders.at(source.stream);
    if (!source.field.empty()) {
      item = addItem(item, QString::fromStdString(source.field));
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
