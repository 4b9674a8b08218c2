// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/GamepadDialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTableWidget>
#include <QVBoxLayout>

#include "robotlink/commands/CommandTable.h"
#include "widgets/Controls.h"
#include "widgets/motion/GamepadSettings.h"

namespace widgets {
namespace {

enum AxisColumn { kPadAxis, kPadUse, kPadDeadZone, kPadScale, kPadAxisColumns };
enum ButtonColumn { kPadButton, kPadCommand, kPadButtonColumns };

QTableWidget* makePadTable(QWidget* parent, const ControlText& text, int rows, const QStringList& titles) {
  auto* table = new QTableWidget(rows, titles.size(), parent);
  describe(*table, text);
  table->setHorizontalHeaderLabels(titles);
  table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  table->verticalHeader()->hide();
  return table;
}

/// A cell that is only read.
QTableWidgetItem* padNameCell(const char* name) {
  auto* cell = new QTableWidgetItem(QString::fromLatin1(name));
  cell->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  return cell;
}

QDoubleSpinBox* makeShareBox(QWidget* parent, double low, double high, double value) {
  auto* box = new QDoubleSpinBox(parent);
  box->setRange(low, high);
  box->setSingleStep(0.05);
  box->setValue(value);
  return box;
}

}  // namespace

GamepadDialog::GamepadDialog(GamepadSettings& settings, const robotlink::CommandTable& commands,
                             QWidget* parent)
    : QDialog(parent), settings_(settings), commands_(commands) {
  setObjectName(QStringLiteral("gamepadDialog"));
  setWindowTitle(tr("Gamepad"));
  createWidgets();
  fillAxes();
  fillButtons();
  connect(buttons_, &QTableWidget::itemChanged, this, &GamepadDialog::apply);
}

void GamepadDialog::createWidgets() {
  axes_ = makePadTable(this, {"gamepadAxes", tr("Axes"), {}}, static_cast<int>(GamepadReading::kAxes.size()),
                       {tr("Axis"), tr("What it does"), tr("Dead zone"), tr("Scale")});
  buttons_ = makePadTable(this, {"gamepadButtons", tr("Buttons"), {}},
                          static_cast<int>(GamepadReading::kButtons.size()),
                          {tr("Button"), tr("Command that it runs")});
  auto* note = makeNote(this, "gamepadNote", tr("What an empty command means"));
  note->setText(
      tr("Commands are those of the console. By default, a kicks and b is STOP; a single - does nothing. "
         "They work while the Motion tester is visible."));
  result_ = makeNote(this, "gamepadResult", tr("Last result"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  QPushButton* reset = buttons->addButton(tr("&Reset all"), QDialogButtonBox::ResetRole);
  reset->setObjectName(QStringLiteral("gamepadReset"));
  connect(reset, &QPushButton::clicked, this, &GamepadDialog::reset);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(axes_, 2);
  layout->addWidget(buttons_, 3);
  layout->addWidget(note);
  layout->addWidget(result_);
  layout->addWidget(buttons);
  resize(520, 620);
}

void GamepadDialog::fillAxes() {
  const QScopedValueRollback filling(isFilling_, true);
  for (int row = 0; row < axes_->rowCount(); ++row) {
    const auto index = static_cast<std::size_t>(row);
    const GamepadBindings::Axis& axis = settings_.bindings().axes[index];
    axes_->setItem(row, kPadAxis, padNameCell(GamepadReading::kAxes[index]));
    auto* use = new QComboBox(axes_);
    use->addItems({tr("nothing"), tr("walks forwards"), tr("walks to the left"), tr("turns to the left")});
    use->setCurrentIndex(static_cast<int>(axis.use));
    auto* deadZone = makeShareBox(axes_, 0, GamepadBindings::kMaxDeadZone, axis.deadZone);
    auto* scale = makeShareBox(axes_, -GamepadBindings::kMaxScale, GamepadBindings::kMaxScale, axis.scale);
    scale->setToolTip(tr("Value at full deflection; negative: reversed"));
    axes_->setCellWidget(row, kPadUse, use);
    axes_->setCellWidget(row, kPadDeadZone, deadZone);
    axes_->setCellWidget(row, kPadScale, scale);
    connect(use, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &GamepadDialog::apply);
    for (QDoubleSpinBox* box : {deadZone, scale})
      connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &GamepadDialog::apply);
  }
}

void GamepadDialog::fillButtons() {
  const QScopedValueRollback filling(isFilling_, true);
  const auto& bound = settings_.bindings().buttons;
  for (int row = 0; row < buttons_->rowCount(); ++row) {
    const char* name = GamepadReading::kButtons[static_cast<std::size_t>(row)];
    const auto found = bound.find(name);
    const QString command = found == bound.end()    ? QString()
                            : found->second.empty() ? QStringLiteral("-")
                                                    : QString::fromStdString(found->second);
    buttons_->setItem(row, kPadButton, padNameCell(name));
    buttons_->setItem(row, kPadCommand, new QTableWidgetItem(command));
  }
}

QString GamepadDialog::problemOf(const QString& command) const {
  const QString name = command.section(QLatin1Char(' '), 0, 0);
  if (commands_.find(name.toStdString()) != nullptr) return {};
  return tr("There is no command %1.").arg(name);
}

void GamepadDialog::apply() {
  if (isFilling_) return;
  GamepadBindings bindings;
  QString problem;
  for (int row = 0; row < axes_->rowCount(); ++row) {
    GamepadBindings::Axis& axis = bindings.axes[static_cast<std::size_t>(row)];
    axis.use = static_cast<GamepadBindings::Axis::Use>(
        static_cast<QComboBox*>(axes_->cellWidget(row, kPadUse))->currentIndex());
    axis.deadZone = static_cast<QDoubleSpinBox*>(axes_->cellWidget(row, kPadDeadZone))->value();
    axis.scale = static_cast<QDoubleSpinBox*>(axes_->cellWidget(row, kPadScale))->value();
  }
  for (int row = 0; row < buttons_->rowCount(); ++row) {
    const QString command = buttons_->item(row, kPadCommand)->text().trimmed();
    if (command.isEmpty()) continue;
    const bool isNothing = command == QLatin1String("-");
    if (problem.isEmpty() && !isNothing) problem = problemOf(command);
    bindings.buttons[GamepadReading::kButtons[static_cast<std::size_t>(row)]] =
        isNothing ? std::string() : command.toStdString();
  }
  const auto kept = settings_.set(std::move(bindings));
  if (!kept) problem = QString::fromStdString(kept.error().describe());
  showOutcome(*result_, problem, !problem.isEmpty());
}

void GamepadDialog::reset() {
  const auto kept = settings_.set({});
  showOutcome(*result_, kept ? QString() : QString::fromStdString(kept.error().describe()), !kept);
  fillAxes();
  fillButtons();
}

}  // namespace widgets
