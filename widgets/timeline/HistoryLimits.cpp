// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/HistoryLimits.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>

#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/log/TimeScale.h"

namespace widgets {
namespace {

int mibOf(std::uint64_t bytes) {
  return static_cast<int>(std::min<std::uint64_t>(bytes >> 20U, 1U << 20U));
}

}  // namespace

HistoryLimits::HistoryLimits(robotlink::Session& session, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("historyLimitsDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("How much is kept"));
  const auto* archive = session.history().archive();
  memory_ = makeBox("historyMemory", tr("In memory"),
                    tr("History of the robots is kept in memory up to this size; older history goes to disk"),
                    64, mibOf(session.store().limits().bytes));
  disk_ = makeBox(
      "historyDisk", tr("On disk"),
      tr("History that no longer fits into memory is kept in the folder for temporary files up to this size, "
         "until the program ends; older history is dropped. 0: none"),
      0, archive != nullptr ? mibOf(archive->limit()) : 0);
  disk_->setEnabled(archive != nullptr);
  auto* used = new QLabel(usedText(session), this);
  used->setObjectName(QStringLiteral("historyUsed"));
  used->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QFormLayout(this);
  layout->addRow(tr("In &memory:"), memory_);
  layout->addRow(tr("On &disk:"), disk_);
  layout->addRow(used);
  layout->addRow(buttons);
}

QSpinBox* HistoryLimits::makeBox(const char* name, const QString& text, const QString& tip, int least,
                                 int value) {
  auto* box = new QSpinBox(this);
  describe(*box, {name, text, tip});
  box->setRange(least, 1 << 20);
  box->setSingleStep(256);
  box->setSuffix(tr(" MiB"));
  box->setValue(value);
  return box;
}

QString HistoryLimits::usedText(robotlink::Session& session) const {
  const auto* archive = session.history().archive();
  const auto kept = session.history().kept();
  return tr("Now %1 in memory and %2 on disk, %3 s back. The view Streams has the share of each stream.")
      .arg(bytesText(session.store().bytes()), bytesText(archive != nullptr ? archive->bytes() : 0),
           timeText(session.timeline().newest() - kept.front().from, std::chrono::milliseconds(100)));
}

int HistoryLimits::memoryMib() const {
  return memory_->value();
}

int HistoryLimits::diskMib() const {
  return disk_->value();
}

}  // namespace widgets
