// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/ShortcutsDialog.h"

#include <QDialogButtonBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"

namespace app {
namespace {

constexpr QSize kWanted{640, 720};
/// The index of a row's shortcut; unset for groups.
constexpr int kIndexRole = Qt::UserRole;

}  // namespace

ShortcutsDialog::ShortcutsDialog(Shortcuts& shortcuts, QWidget* window)
    : QDialog(window), shortcuts_(shortcuts) {
  setObjectName(QStringLiteral("shortcutsDialog"));
  setWindowTitle(tr("Keyboard shortcuts"));
  createWidgets();
  connectSignals();
  fill();
  QString longestKey;
  for (const Shortcut& shortcut : all_) {
    const QString key = shortcut.key.toString(QKeySequence::NativeText);
    if (key.size() > longestKey.size()) longestKey = key;
  }
  auto* fit = new widgets::ColumnFit(*list_, {widgets::ColumnKind::kText, widgets::ColumnKind::kName});
  fit->expect(1, longestKey);
  fitScreen();
}

void ShortcutsDialog::createWidgets() {
  search_ = widgets::makeSearchField(
      this, {"shortcutsSearch", tr("Search"), tr("Shows only entries that contain these words")});
  list_ = new QTreeWidget(this);
  widgets::describe(*list_, {"shortcutsList", tr("Keyboard shortcuts"), {}});
  list_->setHeaderLabels({tr("What it does"), tr("Key")});
  widgets::styleTree(*list_);
  key_ = new QKeySequenceEdit(this);
  widgets::describe(*key_, {"shortcutsKey", tr("New key"), tr("Press the new key here; empty removes it")});
  const auto make = [this](const char* name, const QString& text) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(QLatin1String(name));
    button->setAutoDefault(false);
    return button;
  };
  assign_ = make("shortcutsAssign", tr("&Assign"));
  reset_ = make("shortcutsReset", tr("&Reset"));
  resetAll_ = make("shortcutsResetAll", tr("Reset a&ll"));
  auto* row = new QHBoxLayout;
  row->addWidget(key_, 1);
  for (QPushButton* button : {assign_, reset_, resetAll_}) row->addWidget(button);
  state_ = widgets::makeNote(this, "shortcutsState", tr("Last result"));
  state_->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(search_);
  layout->addWidget(list_, 1);
  layout->addLayout(row);
  layout->addWidget(state_);
  layout->addWidget(buttons);
}

void ShortcutsDialog::connectSignals() {
  connect(search_, &QLineEdit::textChanged, this, &ShortcutsDialog::filter);
  connect(list_, &QTreeWidget::currentItemChanged, this, &ShortcutsDialog::showCurrent);
  connect(assign_, &QPushButton::clicked, this,
          [this] { report(shortcuts_.assign(*current(), key_->keySequence())); });
  connect(reset_, &QPushButton::clicked, this, [this] { report(shortcuts_.reset(*current())); });
  connect(resetAll_, &QPushButton::clicked, this, [this] { report(shortcuts_.resetAll()); });
}

void ShortcutsDialog::fill() {
  const Shortcut* before = current();
  const QString id = before == nullptr ? QString() : before->id;
  const QSignalBlocker silent(list_);
  list_->clear();
  all_ = shortcuts_.all();
  std::vector<QString> views{QString()};
  for (const Shortcut& shortcut : all_) {
    if (std::ranges::find(views, shortcut.view) == views.end()) views.push_back(shortcut.view);
  }
  std::sort(views.begin() + 1, views.end());
  for (const QString& view : views) {
    auto* group =
        new QTreeWidgetItem(list_, {view.isEmpty() ? tr("Everywhere") : tr("In the view %1").arg(view)});
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const Shortcut& shortcut = all_[i];
      if (shortcut.view != view) continue;
      auto* row =
          new QTreeWidgetItem(group, {shortcut.text, shortcut.key.toString(QKeySequence::NativeText)});
      row->setToolTip(0, shortcut.text);
      row->setData(0, kIndexRole, static_cast<int>(i));
      QFont font = list_->font();
      font.setBold(shortcut.key != shortcut.shipped);
      row->setFont(1, font);
      if (!id.isEmpty() && shortcut.id == id) list_->setCurrentItem(row);
    }
  }
  list_->expandAll();
  filter(search_->text());
  showCurrent();
}

const Shortcut* ShortcutsDialog::current() const {
  const QVariant index =
      list_->currentItem() == nullptr ? QVariant() : list_->currentItem()->data(0, kIndexRole);
  return index.isValid() ? &all_[static_cast<std::size_t>(index.toInt())] : nullptr;
}

void ShortcutsDialog::showCurrent() {
  const Shortcut* shortcut = current();
  const bool canChange = shortcut != nullptr && !shortcut->id.isEmpty();
  for (QWidget* widget : std::initializer_list<QWidget*>{key_, assign_}) widget->setEnabled(canChange);
  reset_->setEnabled(canChange && shortcut->key != shortcut->shipped);
  resetAll_->setEnabled(
      std::ranges::any_of(all_, [](const Shortcut& each) { return each.key != each.shipped; }));
  key_->setKeySequence(shortcut == nullptr ? QKeySequence() : shortcut->key);
}

void ShortcutsDialog::report(const robotlink::Result<void>& done) {
  widgets::showOutcome(*state_, done ? QString() : QString::fromStdString(done.error().describe()), !done);
  if (done) fill();
}

void ShortcutsDialog::filter(const QString& text) {
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* group = list_->topLevelItem(i);
    bool some = false;
    for (int j = 0; j < group->childCount(); ++j) {
      QTreeWidgetItem* row = group->child(j);
      const bool fits = (group->text(0) + row->text(0) + row->text(1)).contains(text, Qt::CaseInsensitive);
      row->setHidden(!fits);
      some = some || fits;
    }
    group->setHidden(!some);
  }
}

void ShortcutsDialog::fitScreen() {
  resize(kWanted.boundedTo(parentWidget()->screen()->availableSize() * 0.9));
}

}  // namespace app
