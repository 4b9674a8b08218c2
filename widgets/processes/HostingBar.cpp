// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/HostingBar.h"

#include <QAction>
#include <QBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPlainTextEdit>
#include <QToolButton>

#include "robotcontrol/Hosting.pb.h"
#include "widgets/Controls.h"

namespace widgets {

using robotcontrol::HostingStatus;
using robotcontrol::HostProgram;

namespace {

/// Lines of a stack that are seen at once.
constexpr int kStackLines = 6;

}  // namespace

HostingBar::HostingBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("hostingBar"));
  createActions();
  text_ = makeNote(this, "hostingText", tr("Where the program runs"));
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  stack_ = new QPlainTextEdit(this);
  describe(*stack_, {"hostingStack", tr("Call stack"), {}});
  stack_->setReadOnly(true);
  stack_->setLineWrapMode(QPlainTextEdit::NoWrap);
  stack_->setMaximumHeight(kStackLines * fontMetrics().lineSpacing() + 2 * fontMetrics().height());
  auto* row = makeToolRow(this, 0);
  row->addWidget(text_, 1);
  for (QAction* action : {startAgain_, threads_, own_}) row->addWidget(makeLabeledButton(this, action));
  auto* menu = new QMenu(this);
  menu->addAction(allOwn_);
  menu->addAction(allInside_);
  row->addWidget(makeMenuButton(
      this, {"hostingAll", tr("All robots"), tr("Where the programs of all robots run")}, menu));
  auto* layout = makeColumn(this, {}, 4);
  layout->addWidget(row->parentWidget());
  layout->addWidget(stack_);
  setStatus(nullptr);
}

void HostingBar::createActions() {
  startAgain_ = makeAction(this, "reset",
                           {"hostingStartAgain", tr("Start again"),
                            tr("Restarts the program of this robot; keys, solutions and parameters stay")});
  own_ = makeToggle(this, "processes",
                    {"hostingOwn", tr("Own process"),
                     tr("Runs the program of this robot in its own process: if it crashes or hangs, nothing "
                        "else is harmed")});
  threads_ = makeToggle(this, "processes",
                        {"hostingThreads", tr("Threads"),
                         tr("Gives each process of the programs of all robots a thread, with the priority of "
                            "the layout, in real "
                            "time; otherwise they are executed one after another, and the same input gives "
                            "the same results")});
  allOwn_ = makeAction(this, "processes",
                       {"hostingAllOwn", tr("Each in its own process"),
                        tr("Runs the program of each robot in its own process")});
  allInside_ = makeAction(
      this, "app", {"hostingAllInside", tr("In the workbench"), tr("Runs all programs in the workbench")});
  connect(own_, &QAction::triggered, this, [this](bool own) { choose(own, Robots::kThis); });
  connect(threads_, &QAction::triggered, this, &HostingBar::chooseExecutor);
  connect(allOwn_, &QAction::triggered, this, [this] { choose(true, Robots::kAll); });
  connect(allInside_, &QAction::triggered, this, [this] { choose(false, Robots::kAll); });
  connect(startAgain_, &QAction::triggered, this, [this] {
    HostProgram choice;
    choice.set_start_again(true);
    Q_EMIT chosen(choice, Robots::kThis);
  });
}

void HostingBar::choose(bool own, Robots robots) {
  HostProgram choice;
  choice.set_where(own ? HostProgram::OWN_PROCESS : HostProgram::IN_WORKBENCH);
  Q_EMIT chosen(choice, robots);
}

void HostingBar::chooseExecutor(bool threads) {
  HostProgram choice;
  choice.set_executor(threads ? HostProgram::THREADS : HostProgram::LOCKSTEP);
  Q_EMIT chosen(choice, Robots::kAll);
}

void HostingBar::setStatus(const HostingStatus* status) {
  setVisible(status != nullptr);
  if (status == nullptr) return;
  const bool runs = status->state() == HostingStatus::RUNNING;
  QString text = QString::fromStdString(status->text());
  if (runs) {
    text = status->own_process() ? tr("The program runs in its own process, ID %1. To attach a debugger: gdb "
                                      "-p %1")
                                       .arg(status->pid())
           : status->threads()
               ? tr("The program runs in the workbench, each of its processes in its own thread.")
               : tr("The program runs in the workbench.");
  }
  showOutcome(*text_, text, !runs);
  stack_->setPlainText(QString::fromStdString(status->stack()));
  stack_->setVisible(!status->stack().empty());
  own_->setChecked(status->own_process());
  threads_->setChecked(status->threads());
}

}  // namespace widgets
