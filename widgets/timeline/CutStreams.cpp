// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/CutStreams.h"

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

CutStreams::CutStreams(std::vector<std::string> paths, QWidget* parent)
    : QDialog(parent), paths_(std::move(paths)) {
  setObjectName(QStringLiteral("cutStreamsDialog"));
  setWindowTitle(tr("Streams of the new log"));
  createWidgets();
  connectSignals();
  showFilter();
}

void CutStreams::createWidgets() {
  auto* layout = new QVBoxLayout(this);
  auto* help = new QLabel(
      tr("Comma-separated stream paths; * matches any text, - excludes. Empty: all streams."), this);
  help->setWordWrap(true);
  layout->addWidget(help);
  patterns_ = new QLineEdit(this);
  describe(*patterns_, {"cutPatterns", tr("Patterns"), tr("For example red1/*,-*/camera/image")});
  patterns_->setPlaceholderText(tr("all streams"));
  patterns_->setClearButtonEnabled(true);
  layout->addWidget(patterns_);
  problem_ = new QLabel(this);
  problem_->setObjectName(QStringLiteral("cutProblem"));
  problem_->setWordWrap(true);
  layout->addWidget(problem_);
  list_ = new QListWidget(this);
  describe(*list_, {"cutStreamList", tr("Streams"), tr("Checked streams are written into the new log")});
  for (const std::string& path : paths_) {
    auto* item = new QListWidgetItem(QString::fromStdString(path), list_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  }
  layout->addWidget(list_, 1);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  layout->addWidget(buttons_);
  resize(520, 480);
}

void CutStreams::connectSignals() {
  connect(patterns_, &QLineEdit::textChanged, this, &CutStreams::takePatterns);
  connect(list_, &QListWidget::itemChanged, this, &CutStreams::takeChecks);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void CutStreams::takePatterns() {
  const auto read = logplayer::readSelection(patterns_->text().toStdString());
  QString problem = read ? QString() : QString::fromStdString(read.error().text);
  if (read) {
    filter_ = {{read->include().begin(), read->include().end()},
               {read->exclude().begin(), read->exclude().end()}};
    showFilter();
    const auto isIn = [this](const std::string& path) { return filter_.has(path); };
    if (std::ranges::none_of(paths_, isIn)) problem = tr("No stream is left.");
  }
  problem_->setText(problem);
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(problem.isEmpty());
}

void CutStreams::takeChecks() {
  QStringList in, out;
  for (int row = 0; row < list_->count(); ++row) {
    const QListWidgetItem& item = *list_->item(row);
    if (item.checkState() == Qt::Checked)
      in << item.text();
    else
      out << QLatin1Char('-') + item.text();
  }
  // The shorter list, of what is in or of what is not.
  const QStringList& names = !in.isEmpty() && in.size() < out.size() ? in : out;
  patterns_->setText(names.join(QLatin1Char(',')));  // this calls takePatterns()
}

void CutStreams::showFilter() {
  const QSignalBlocker blocker(list_);
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    item->setCheckState(filter_.has(item->text().toStdString()) ? Qt::Checked : Qt::Unchecked);
  }
}

}  // namespace widgets
