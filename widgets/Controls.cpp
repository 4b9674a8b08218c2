// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/Controls.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QShortcut>
#include <QToolButton>
#include <QTreeView>

#include "widgets/Icon.h"

namespace widgets {
namespace {

QString withShortcut(const ControlText& text) {
  if (text.shortcut.isEmpty()) return text.toolTip;
  return QStringLiteral("%1 (%2)").arg(text.toolTip, text.shortcut.toString(QKeySequence::NativeText));
}

}  // namespace

void describe(QWidget& widget, const ControlText& text) {
  widget.setObjectName(QString::fromLatin1(text.name));
  widget.setAccessibleName(text.text);
  widget.setAccessibleDescription(text.toolTip);
  widget.setToolTip(withShortcut(text));
}

QAction* makeAction(QWidget* owner, const char* iconName, const ControlText& text) {
  auto* action = new QAction(icon(iconName), text.text, owner);
  action->setObjectName(QString::fromLatin1(text.name) + QStringLiteral("Action"));
  action->setToolTip(withShortcut(text));
  action->setShortcut(text.shortcut);
  action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  owner->addAction(action);
  return action;
}

QToolButton* makeButton(QWidget* parent, QAction* action) {
  auto* button = new QToolButton(parent);
  button->setDefaultAction(action);
  button->setAutoRaise(true);
  QString name = action->objectName();
  name.chop(static_cast<int>(qstrlen("Action")));
  button->setObjectName(name);
  button->setAccessibleName(action->text());
  button->setAccessibleDescription(action->toolTip());
  return button;
}

QHBoxLayout* makeToolRow(QWidget* parent) {
  auto* layout = new QHBoxLayout(new QWidget(parent));
  layout->setContentsMargins(2, 2, 2, 2);
  layout->setSpacing(1);
  return layout;
}

void addButtons(QHBoxLayout* row, std::initializer_list<QAction*> actions) {
  for (QAction* action : actions) row->addWidget(makeButton(row->parentWidget(), action));
}

QHBoxLayout* makeFooter(QWidget* parent) {
  auto* layout = new QHBoxLayout(new QWidget(parent));
  layout->setContentsMargins(6, 2, 6, 2);
  layout->setSpacing(12);
  return layout;
}

QLabel* addLabel(QHBoxLayout* footer, const char* name, const QString& text) {
  auto* label = new QLabel(footer->parentWidget());
  describe(*label, {name, text, text});
  label->setTextFormat(Qt::PlainText);
  footer->addWidget(label);
  return label;
}

QLineEdit* makeSearchField(QWidget* parent, const ControlText& text) {
  auto* field = new QLineEdit(parent);
  describe(*field, text);
  field->setPlaceholderText(text.text);
  field->setClearButtonEnabled(true);
  field->addAction(icon("search"), QLineEdit::LeadingPosition);
  auto* escape = new QShortcut(QKeySequence(Qt::Key_Escape), field);
  escape->setContext(Qt::WidgetShortcut);
  QObject::connect(escape, &QShortcut::activated, field, &QLineEdit::clear);
  return field;
}

int textWidth(const QWidget& widget, const QString& text) {
  return widget.fontMetrics().horizontalAdvance(text) + 14;
}

void styleTree(QTreeView& tree) {
  tree.setUniformRowHeights(true);
  tree.setAlternatingRowColors(true);
  tree.setAllColumnsShowFocus(true);
  tree.setEditTriggers(QAbstractItemView::NoEditTriggers);
  tree.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  tree.header()->setStretchLastSection(true);
  tree.header()->setHighlightSections(false);
}

}  // namespace widgets
