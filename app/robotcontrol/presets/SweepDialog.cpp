// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/presets/SweepDialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QTableWidget>

#include "robotlink/base/AtomicFile.h"
#include "widgets/Controls.h"
#include "widgets/solutions/ParameterEdits.h"
#include "widgets/solutions/ParameterSweep.h"

namespace app {
namespace {

void fillBox(QComboBox& box, const std::vector<std::string>& texts) {
  const QString before = box.currentText();
  box.clear();
  for (const std::string& text : texts) box.addItem(QString::fromStdString(text));
  if (!before.isEmpty()) box.setCurrentText(before);
}

}  // namespace

SweepDialog::SweepDialog(widgets::ParameterSweep& sweep, widgets::ParameterEdits& parameters, QWidget* parent)
    : QDialog(parent), sweep_(sweep), parameters_(parameters) {
  setObjectName(QStringLiteral("sweepDialog"));
  setWindowTitle(tr("Sweep a parameter"));
  createWidgets();
  connectSignals();
  fillBox(*task_, parameters_.solutions());
  showProgress();
  resize(620, 460);
}

void SweepDialog::createWidgets() {
  task_ = new QComboBox(this);
  path_ = new QComboBox(this);
  values_ = new QLineEdit(this);
  figure_ = new QLineEdit(this);
  seconds_ = new QDoubleSpinBox(this);
  task_->setEditable(true);
  path_->setEditable(true);
  widgets::describe(*task_,
                    {"sweepTask", tr("Solution"), tr("A task (for its active solution), or TASK/SOLUTION")});
  widgets::describe(*path_, {"sweepPath", tr("Parameter"), {}});
  widgets::describe(*values_, {"sweepValues", tr("Values"), tr("A list 1,2,5 or a range from:to:step")});
  widgets::describe(*figure_,
                    {"sweepFigure", tr("Figure"), tr("An expression over streams, measured at each value")});
  widgets::describe(*seconds_,
                    {"sweepSeconds", tr("Seconds"), tr("Duration of the measurement at each value")});
  values_->setPlaceholderText(QStringLiteral("0.1:0.5:0.1"));
  figure_->setPlaceholderText(QStringLiteral("models/ball.position.x"));
  seconds_->setRange(0.01, 3600);
  seconds_->setValue(5);
  auto* form = new QFormLayout;
  form->addRow(tr("S&olution:"), task_);
  form->addRow(tr("&Parameter:"), path_);
  form->addRow(tr("&Values:"), values_);
  form->addRow(tr("&Figure:"), figure_);
  form->addRow(tr("S&econds each:"), seconds_);
  table_ = new QTableWidget(0, 6, this);
  widgets::describe(*table_, {"sweepTable", tr("Results"), {}});
  table_->setHorizontalHeaderLabels(
      {tr("Value"), tr("Count"), tr("Mean"), tr("Deviation"), tr("Minimum"), tr("Maximum")});
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  state_ = widgets::makeNote(this, "sweepState", tr("State of the sweep"));
  state_->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  start_ = buttons->addButton(tr("&Start"), QDialogButtonBox::ActionRole);
  start_->setObjectName(QStringLiteral("sweepStart"));
  save_ = buttons->addButton(tr("Save &table…"), QDialogButtonBox::ActionRole);
  save_->setObjectName(QStringLiteral("sweepSave"));
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(table_, 1);
  layout->addWidget(state_);
  layout->addWidget(buttons);
}

void SweepDialog::connectSignals() {
  connect(&sweep_, &widgets::ParameterSweep::progressed, this, &SweepDialog::showProgress);
  connect(start_, &QPushButton::clicked, this, &SweepDialog::start);
  connect(save_, &QPushButton::clicked, this, &SweepDialog::save);
  connect(task_, &QComboBox::currentTextChanged, this, [this](const QString& task) {
    // Paths that the robot has not reported yet are offered when it has.
    parameters_.requestValue(task.toStdString(), {}, [guard = QPointer(this), task](const auto&) {
      if (guard && guard->task_->currentText() == task)
        fillBox(*guard->path_, guard->parameters_.paths(task.toStdString()));
    });
  });
}

void SweepDialog::start() {
  if (sweep_.isRunning()) return sweep_.stop();
  auto values = widgets::ParameterSweep::valuesIn(values_->text().toStdString());
  const auto begun =
      !values ? robotlink::Result<void>(tl::unexpected(values.error()))
              : sweep_.begin({task_->currentText().toStdString(), path_->currentText().toStdString(),
                              std::move(*values), figure_->text().toStdString(), seconds_->value()});
  showProgress();
  if (!begun) widgets::showOutcome(*state_, QString::fromStdString(begun.error().describe()), true);
}

void SweepDialog::save() {
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Save table"), QStringLiteral("sweep.csv"), tr("Tables (*.csv)"));
  if (file.isEmpty()) return;
  const auto saved =
      robotlink::writeFileAtomically(file.toStdString(), widgets::ParameterSweep::csv(sweep_.rows()));
  widgets::showOutcome(
      *state_, saved ? tr("Saved: %1").arg(file) : QString::fromStdString(saved.error().describe()), !saved);
}

void SweepDialog::showProgress() {
  const auto& rows = sweep_.rows();
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < table_->rowCount(); ++i) {
    const auto& row = rows[static_cast<std::size_t>(i)];
    const auto number = [&](double value) {
      return row.count > 0 ? QString::number(value, 'g', 6) : QString();
    };
    const QStringList texts{
        QString::fromStdString(row.value), QString::number(row.count), number(row.mean),
        number(row.deviation()),           number(row.minimum),        number(row.maximum)};
    for (int column = 0; column < texts.size(); ++column)
      table_->setItem(i, column, new QTableWidgetItem(texts[column]));
  }
  start_->setText(sweep_.isRunning() ? tr("&Stop") : tr("&Start"));
  save_->setEnabled(!rows.empty() && !sweep_.isRunning());
  const auto& failed = sweep_.failed();
  const QString progress = sweep_.isRunning()
                               ? tr("Measuring %1 of %2…").arg(rows.size()).arg(sweep_.plan().values.size())
                           : rows.empty() ? QString()
                                          : tr("Done; the parameter was set back to its previous value.");
  widgets::showOutcome(*state_, failed ? QString::fromStdString(failed->describe()) : progress,
                       failed.has_value());
}

}  // namespace app
