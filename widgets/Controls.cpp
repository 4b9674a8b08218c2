// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/Controls.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>

#include "widgets/Icon.h"
#include "widgets/controls/ToolRow.h"

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

QAction* makeToggle(QWidget* owner, const char* iconName, const ControlText& text, bool on) {
  QAction* action = makeAction(owner, iconName, text);
  action->setCheckable(true);
  action->setChecked(on);
  return action;
}

QToolButton* makeButton(QWidget* parent, QAction* action) {
  auto* button = new RowButton(parent);
  button->setDefaultAction(action);
  QString name = action->objectName();
  name.chop(static_cast<int>(qstrlen("Action")));
  button->setObjectName(name);
  button->setAccessibleName(action->text());
  button->setAccessibleDescription(action->toolTip());
  return button;
}

QToolButton* makeLabeledButton(QWidget* parent, QAction* action) {
  QToolButton* button = makeButton(parent, action);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  return button;
}

QToolButton* makeMenuButton(QWidget* parent, const ControlText& text, QMenu* menu) {
  auto* button = new RowButton(parent);
  describe(*button, text);
  button->setText(text.text);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setMenu(menu);
  return button;
}

QHBoxLayout* makeToolRow(QWidget* parent, int margin) {
  auto* layout = new QHBoxLayout(new QWidget(parent));
  layout->setContentsMargins(margin, margin, margin, margin);
  layout->setSpacing(1);
  new ToolRow(*layout);
  return layout;
}

void addButtons(QHBoxLayout* row, std::initializer_list<QAction*> actions) {
  // Else the row would be as wide at first as all of its buttons.
  const bool mayLeaveOut =
      row->parentWidget()->findChild<ToolRow*>(QString(), Qt::FindDirectChildrenOnly) != nullptr;
  for (QAction* action : actions) {
    QToolButton* button = makeButton(row->parentWidget(), action);
    row->addWidget(button);
    if (auto* inRow = qobject_cast<RowButton*>(button); inRow != nullptr && mayLeaveOut)
      inRow->setInToolRow();
  }
}

QVBoxLayout* makeColumn(QWidget* widget, const QMargins& margins, int spacing) {
  auto* layout = new QVBoxLayout(widget);
  layout->setContentsMargins(margins);
  layout->setSpacing(spacing);
  return layout;
}

QSplitter* makeSplitter(QWidget* parent, const char* name, Qt::Orientation orientation,
                        std::initializer_list<SplitterPart> parts) {
  auto* splitter = new QSplitter(orientation, parent);
  splitter->setObjectName(QString::fromLatin1(name));
  for (const SplitterPart& part : parts) {
    splitter->addWidget(part.widget);
    splitter->setStretchFactor(splitter->count() - 1, part.stretch);
  }
  return splitter;
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

QScrollArea* makeScrollArea(QWidget* parent, QWidget* content) {
  auto* area = new QScrollArea(parent);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidget(content);
  return area;
}

QLabel* makeNote(QWidget* parent, const char* name, const QString& text) {
  auto* label = new QLabel(parent);
  describe(*label, {name, text, {}});
  label->setWordWrap(true);
  return label;
}

void setMeaning(QLabel& label, std::optional<Meaning> meaning) {
  const QPalette usual = label.parentWidget()->palette();
  QPalette colors;
  if (meaning) colors.setColor(QPalette::WindowText, colorOf(*meaning, usual));
  label.setPalette(colors);
}

void showOutcome(QLabel& label, const QString& text, bool bad) {
  setMeaning(label, bad ? std::optional(Meaning::kBad) : std::nullopt);
  label.setText(text);
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

QLineEdit* makeFilterField(QWidget* parent, const ControlText& text, QSortFilterProxyModel& filtered,
                           QAbstractItemModel& source) {
  filtered.setSourceModel(&source);
  filtered.setFilterCaseSensitivity(Qt::CaseInsensitive);
  QLineEdit* search = makeSearchField(parent, text);
  QObject::connect(search, &QLineEdit::textChanged, &filtered, &QSortFilterProxyModel::setFilterFixedString);
  return search;
}

int textWidth(const QWidget& widget, const QString& text) {
  return widget.fontMetrics().horizontalAdvance(text) + 14;
}

QTreeView* makeTree(QWidget* parent, const ControlText& text, QAbstractItemModel* model) {
  auto* tree = new QTreeView(parent);
  styleTree(*tree);
  describe(*tree, text);
  tree->setToolTip({});
  tree->setModel(model);
  return tree;
}

QTableView* makeTable(QWidget* parent, const ControlText& text, QAbstractItemModel* model) {
  auto* table = new QTableView(parent);
  describe(*table, text);
  table->setToolTip({});
  table->setModel(model);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setAlternatingRowColors(true);
  table->setShowGrid(false);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 6);
  return table;
}

QTableView* makeEventTable(QWidget* parent, const ControlText& text, QAbstractItemModel* model) {
  auto* table = makeTable(parent, text, model);
  table->setTabKeyNavigation(false);
  table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table->verticalHeader()->setDefaultSectionSize(parent->fontMetrics().height() + 4);
  table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  return table;
}

void followEnd(QTableView& table, QAction& follow) {
  const QScrollBar* bar = table.verticalScrollBar();
  QObject::connect(bar, &QScrollBar::actionTriggered, &follow,
                   [bar, &follow] { follow.setChecked(bar->sliderPosition() >= bar->maximum()); });
}

void copyRows(const QTableView& table, const RowTexts& texts) {
  QModelIndexList rows = table.selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end());
  QStringList lines;
  for (const QModelIndex& row : rows) lines << texts(row).join(QLatin1Char('\t'));
  if (!lines.isEmpty()) QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

QStringList firstTexts(const QModelIndex& row, int columns) {
  QStringList texts;
  for (int column = 0; column < columns; ++column) texts << row.siblingAtColumn(column).data().toString();
  return texts;
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
