// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/StreamChooser.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "logplayer/base/RecordedStreams.h"
#include "widgets/Controls.h"

namespace app {

using robotcontrol::StreamSelection;

namespace {

void removeExact(google::protobuf::RepeatedPtrField<std::string>& patterns, const std::string& path) {
  for (int i = patterns.size() - 1; i >= 0; --i) {
    if (patterns.Get(i) == path) patterns.DeleteSubrange(i, 1);
  }
}

}  // namespace

StreamSelection withStream(const StreamSelection& selection, const std::string& path, bool recorded,
                           const std::vector<std::string>& known) {
  StreamSelection changed = selection;
  removeExact(*(recorded ? changed.mutable_exclude() : changed.mutable_include()), path);
  // Without an include pattern the default selection would apply, not an empty one.
  if (selection.include_size() > 0 && changed.include_size() == 0)
    *changed.mutable_include() = selection.include();
  const auto contains = [&path](const StreamSelection& s) {
    return logplayer::RecordedStreams(s).contains(path);
  };
  if (contains(changed) == recorded) return changed;
  if (!recorded) {
    changed.add_exclude(path);
    return changed;
  }
  if (changed.include_size() > 0) changed.add_include(path);
  if (contains(changed)) return changed;
  // The stream is left out by a pattern, or by default: select everything and exclude each stream that was
  // not recorded.
  const logplayer::RecordedStreams before(selection);
  StreamSelection named;
  named.add_include(std::string(1, '*'));
  for (const std::string& other : known) {
    if (other != path && !before.contains(other)) named.add_exclude(other);
  }
  return named;
}

StreamChooser::StreamChooser(const StreamSelection& selection, std::vector<std::string> streams,
                             QWidget* parent)
    : QDialog(parent), selection_(selection), streams_(std::move(streams)) {
  setObjectName(QStringLiteral("streamChooser"));
  setWindowTitle(tr("What is recorded"));
  createWidgets();
  connectSignals();
  showSelection();
  patterns_->setText(QString::fromStdString(logplayer::textOf(selection_)));
}

void StreamChooser::createWidgets() {
  auto* layout = new QVBoxLayout(this);
  auto* help = new QLabel(tr("Comma-separated stream paths; * matches any text, - excludes. Empty: all that "
                             "a replay needs. The program's setup is always recorded."),
                          this);
  help->setWordWrap(true);
  layout->addWidget(help);
  patterns_ = new QLineEdit(this);
  widgets::describe(*patterns_, {"streamPatterns", tr("Patterns"), {}});
  patterns_->setPlaceholderText(tr("all that a replay needs"));
  patterns_->setToolTip(tr("For example red1/*,-*/transforms"));
  patterns_->setClearButtonEnabled(true);
  layout->addWidget(patterns_);
  problem_ = new QLabel(this);
  problem_->setObjectName(QStringLiteral("streamProblem"));
  problem_->setWordWrap(true);
  layout->addWidget(problem_);
  list_ = new QListWidget(this);
  widgets::describe(*list_, {"streamList", tr("Streams"), tr("Current streams; checked ones are recorded")});
  for (const std::string& path : streams_) list_->addItem(QString::fromStdString(path));
  layout->addWidget(list_, 1);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  layout->addWidget(buttons_);
  resize(520, 480);
}

void StreamChooser::connectSignals() {
  connect(patterns_, &QLineEdit::textChanged, this, &StreamChooser::takePatterns);
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) { takeTick(*item); });
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void StreamChooser::showSelection() {
  const QSignalBlocker blocker(list_);
  const logplayer::RecordedStreams recorded(selection_);
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(recorded.contains(item->text().toStdString()) ? Qt::Checked : Qt::Unchecked);
  }
}

void StreamChooser::takePatterns() {
  auto read = logplayer::readSelection(patterns_->text().toStdString());
  problem_->setText(read ? QString() : QString::fromStdString(read.error().text));
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(read.has_value());
  if (!read) return;
  selection_ = std::move(*read);
  showSelection();
}

void StreamChooser::takeTick(const QListWidgetItem& item) {
  selection_ = withStream(selection_, item.text().toStdString(), item.checkState() == Qt::Checked, streams_);
  patterns_->setText(QString::fromStdString(logplayer::textOf(selection_)));  // this calls takePatterns()
}

}  // namespace app
