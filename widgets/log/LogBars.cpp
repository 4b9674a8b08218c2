// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/LogBars.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "widgets/Controls.h"
#include "widgets/Icon.h"

namespace widgets {
namespace {

QLabel* makeText(QWidget* parent, const char* name) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QToolButton* makeTextButton(QWidget* parent, const ControlText& text) {
  auto* button = new QToolButton(parent);
  describe(*button, text);
  button->setText(text.text);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

QLabel* addSign(QHBoxLayout* layout, const char* iconName) {
  auto* sign = new QLabel(layout->parentWidget());
  sign->setPixmap(icon(iconName).pixmap(16, 16));
  layout->addWidget(sign, 0, Qt::AlignTop);
  return sign;
}

}  // namespace

LogJobBar::LogJobBar(QWidget* parent)
    : QWidget(parent),
      text_(makeText(this, "logJobText")),
      progress_(new QProgressBar(this)),
      cancel_(
          makeTextButton(this, {"logJobCancel", tr("Cancel"), tr("Cancels the job and removes its output")})),
      open_(makeTextButton(this, {"logJobOpen", tr("Open"), tr("Opens the new log instead of this one")})),
      dismiss_(makeTextButton(this, {"logJobDismiss", tr("Dismiss"), tr("Hides this line")})) {
  setObjectName(QStringLiteral("logJobBar"));
  describe(*progress_, {"logJobProgress", tr("Progress"), {}});
  progress_->setRange(0, 1000);
  progress_->setMaximumWidth(260);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  layout->addWidget(text_, 1);
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, cancel_, open_, dismiss_})
    layout->addWidget(widget);
  connect(cancel_, &QToolButton::clicked, this, [this] {
    if (job_ != nullptr) job_->cancel();
    cancel_->setEnabled(false);
  });
  connect(dismiss_, &QToolButton::clicked, this, &QWidget::hide);
  connect(open_, &QToolButton::clicked, this, [this] {
    hide();
    Q_EMIT openWanted(QString::fromStdString(made_.string()));
  });
  hide();
}

LogJobBar::~LogJobBar() = default;

void LogJobBar::start(const QString& title, LogJob::Work work) {
  if (busy()) return;
  job_ = std::make_unique<LogJob>(title, std::move(work));
  text_->setText(title);
  progress_->setValue(0);
  cancel_->setEnabled(true);
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, cancel_}) widget->show();
  for (QWidget* widget : {open_, dismiss_}) widget->hide();
  show();
}

void LogJobBar::tick() {
  if (job_ == nullptr) return;
  progress_->setValue(static_cast<int>(job_->share() * 1000));
  const auto outcome = job_->takeOutcome();
  if (!outcome) return;
  job_.reset();
  showOutcome(*outcome);
}

void LogJobBar::showOutcome(const LogJob::Outcome& outcome) {
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, cancel_}) widget->hide();
  text_->setText(outcome.canceled ? tr("%1: canceled").arg(text_->text())
                 : outcome.done   ? outcome.text
                                  : tr("%1: failed. %2").arg(text_->text(), outcome.text));
  made_ = outcome.log;
  open_->setVisible(outcome.done && !made_.empty());
  dismiss_->show();
}

LogDamageBar::LogDamageBar(QWidget* parent)
    : QWidget(parent),
      text_(makeText(this, "logDamageText")),
      repair_(makeTextButton(
          this, {"logRepair", tr("Repair…"), tr("Writes what can be read into a new, whole file")})) {
  setObjectName(QStringLiteral("logDamageBar"));
  auto* dismiss = makeTextButton(this, {"logDamageDismiss", tr("Dismiss"), tr("Hides this line")});
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  addSign(layout, "warning");
  layout->addWidget(text_, 1);
  layout->addWidget(repair_);
  layout->addWidget(dismiss);
  connect(repair_, &QToolButton::clicked, this,
          [this] { Q_EMIT repairWanted(QString::fromStdString(shown_.log)); });
  connect(dismiss, &QToolButton::clicked, this, [this] {
    dismissed_.insert(shown_.log);
    showFirst();
  });
  hide();
}

void LogDamageBar::setDamages(std::vector<Damage> damages) {
  if (damages == damages_) return;
  damages_ = std::move(damages);
  showFirst();
}

void LogDamageBar::setBusy(bool busy) {
  repair_->setEnabled(!busy);
}

void LogDamageBar::showFirst() {
  for (const Damage& damage : damages_) {
    if (dismissed_.contains(damage.log)) continue;
    shown_ = damage;
    text_->setText(QStringLiteral("%1: %2").arg(
        QString::fromStdString(std::filesystem::path(damage.log).filename().string()), damage.text));
    repair_->setVisible(damage.canRepair);
    show();
    return;
  }
  hide();
}

}  // namespace widgets
