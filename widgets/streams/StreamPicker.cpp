// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/streams/StreamPicker.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "logplayer/base/RecordedStreams.h"
#include "widgets/Controls.h"

namespace widgets {

using Selection = StreamPicker::Selection;

namespace {

void removeExact(google::protobuf::RepeatedPtrField<std::string>& patterns, const std::string& path) {
  for (int i = patterns.size() - 1; i >= 0; --i) {
    if (patterns.Get(i) == path) patterns.DeleteSubrange(i, 1);
  }
}

/// Returns the selection without its include patterns, if that selects the same streams.
Selection shortened(const Selection& selection, const std::vector<std::string>& known,
                    const StreamPicker::Contains& contains) {
  Selection shorter = selection;
  shorter.clear_include();
  const auto isSame = [&](const std::string& path) {
    return contains(shorter, path) == contains(selection, path);
  };
  return std::ranges::all_of(known, isSame) ? shorter : selection;
}

}  // namespace

Selection withStream(const Selection& selection, const std::string& path, bool isWanted,
                     const std::vector<std::string>& known, const StreamPicker::Contains& contains) {
  Selection changed = selection;
  removeExact(*(isWanted ? changed.mutable_exclude() : changed.mutable_include()), path);
  // Without an include pattern the default selection would apply, not an empty one.
  if (selection.include_size() > 0 && changed.include_size() == 0)
    *changed.mutable_include() = selection.include();
  if (contains(changed, path) == isWanted) return changed;
  if (!isWanted) {
    changed.add_exclude(path);
    return changed;
  }
  if (changed.include_size() > 0) changed.add_include(path);
  if (contains(changed, path)) return changed;
  // The stream is left out by a pattern, or by default: select everything and exclude each stream that was
  // not selected.
  Selection named;
  named.add_include(std::string(1, '*'));
  for (const std::string& other : known) {
    if (other != path && !contains(selection, other)) named.add_exclude(other);
  }
  return shortened(named, known, contains);
}

StreamPicker::StreamPicker(const Texts& texts, const Selection& selection, std::vector<std::string> streams,
                           Contains contains, QWidget* parent)
    : QDialog(parent),
      nothing_(texts.nothing),
      contains_(std::move(contains)),
      selection_(selection),
      streams_(std::move(streams)) {
  setObjectName(QLatin1String(texts.dialog));
  setWindowTitle(texts.title);
  createWidgets(texts);
  connectSignals();
  showSelection();
  patterns_->setText(QString::fromStdString(logplayer::textOf(selection_)));
}

void StreamPicker::createWidgets(const Texts& texts) {
  auto* layout = new QVBoxLayout(this);
  auto* help = new QLabel(texts.help, this);
  help->setWordWrap(true);
  layout->addWidget(help);
  patterns_ = new QLineEdit(this);
  describe(*patterns_, {texts.patterns, texts.patternsName, texts.example});
  patterns_->setPlaceholderText(texts.placeholder);
  patterns_->setClearButtonEnabled(true);
  layout->addWidget(patterns_);
  problem_ = new QLabel(this);
  problem_->setObjectName(QLatin1String(texts.problem));
  problem_->setWordWrap(true);
  layout->addWidget(problem_);
  list_ = new QListWidget(this);
  describe(*list_, {texts.list, texts.listName, texts.listTip});
  for (const std::string& path : streams_) {
    auto* item = new QListWidgetItem(QString::fromStdString(path), list_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  }
  layout->addWidget(list_, 1);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  layout->addWidget(buttons_);
  resize(520, 480);
}

void StreamPicker::connectSignals() {
  connect(patterns_, &QLineEdit::textChanged, this, &StreamPicker::takePatterns);
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) { takeTick(*item); });
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void StreamPicker::showSelection() {
  const QSignalBlocker blocker(list_);
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    item->setCheckState(contains_(selection_, item->text().toStdString()) ? Qt::Checked : Qt::Unchecked);
  }
}

void StreamPicker::takePatterns() {
  auto read = logplayer::readSelection(patterns_->text().toStdString());
  QString problem = read ? QString() : QString::fromStdString(read.error().text);
  if (read) {
    selection_ = std::move(*read);
    showSelection();
    const auto isIn = [this](const std::string& path) { return contains_(selection_, path); };
    if (std::ranges::none_of(streams_, isIn)) problem = nothing_;
  }
  problem_->setText(problem);
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(problem.isEmpty());
}

void StreamPicker::takeTick(const QListWidgetItem& item) {
  selection_ = withStream(selection_, item.text().toStdString(), item.checkState() == Qt::Checked, streams_,
                          contains_);
  patterns_->setText(QString::fromStdString(logplayer::textOf(selection_)));  // this calls takePatterns()
}

}  // namespace widgets
