// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/remote/DialogParts.h"

#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "widgets/Icon.h"

namespace app {

QTreeWidget* makeList(QWidget* parent, const widgets::ControlText& text,
                      const std::vector<ListColumn>& columns, int lines) {
  auto* list = new QTreeWidget(parent);
  widgets::describe(*list, text);
  QStringList titles;
  std::vector<widgets::ColumnKind> kinds;
  for (const ListColumn& column : columns) {
    titles << column.title;
    kinds.push_back(column.kind);
  }
  list->setHeaderLabels(titles);
  list->setRootIsDecorated(false);
  widgets::styleTree(*list);
  auto* fit = new widgets::ColumnFit(*list, std::move(kinds));
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (!columns[i].widest.isEmpty()) fit->expect(static_cast<int>(i), columns[i].widest);
  list->setMinimumHeight((lines + 1) * 3 * parent->fontMetrics().lineSpacing() / 2);
  return list;
}

void setRowCount(QTreeWidget& list, int count) {
  while (list.topLevelItemCount() > count) delete list.takeTopLevelItem(count);
  while (list.topLevelItemCount() < count) new QTreeWidgetItem(&list);
}

QPushButton* makePushButton(QWidget* parent, const widgets::ControlText& text, const char* icon) {
  auto* button = new QPushButton(text.text, parent);
  if (icon != nullptr) button->setIcon(widgets::icon(icon));
  widgets::describe(*button, {text.name, QString(text.text).remove(QLatin1Char('&')), text.toolTip});
  return button;
}

void addLabeled(QHBoxLayout* row, const QString& label, QWidget* widget) {
  auto* shown = new QLabel(label, widget->parentWidget());
  shown->setBuddy(widget);
  row->addWidget(shown);
  row->addWidget(widget, 1);
}

QLabel* makeState(QWidget* parent, const char* name, int lines) {
  QLabel* state = widgets::makeNote(parent, name, QLabel::tr("State"));
  state->setMinimumHeight(lines * parent->fontMetrics().lineSpacing());
  state->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  return state;
}

void hideInPlace(QWidget& widget) {
  QSizePolicy keepsPlace = widget.sizePolicy();
  keepsPlace.setRetainSizeWhenHidden(true);
  widget.setSizePolicy(keepsPlace);
  widget.hide();
}

}  // namespace app
