// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motions/MotionEditorView.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>

#include "robotcontrol/Motion.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/motions/KeyFrameModel.h"
#include "widgets/motions/MotionBench.h"
#include "widgets/motions/MotionFiles.h"
#include "widgets/motions/MotionLink.h"
#include "widgets/motions/MotionTextEdit.h"
#include "widgets/motions/MotionTimeLine.h"

namespace widgets {
namespace {

const ViewRegistration kMotionEditorRegistration{
    {"motion-editor", QT_TRANSLATE_NOOP("View", "Motion editor"),
     QT_TRANSLATE_NOOP(
         "View", "Edits key-frame motions as text, as a table and over time, and plays them on the robot."),
     "motion-editor", false, create<MotionEditorView>}};

constexpr std::size_t kErrorsShown = 4;

}  // namespace

MotionEditorView::MotionEditorView(ViewContext& context, QWidget* parent)
    : View(context, parent),
      bench_(motionBench(context)),
      files_(motionFiles(context)),
      link_(motionLink(context)) {
  setObjectName(QStringLiteral("motionEditorView"));
  createFileActions();
  createEditActions();
  createRobotActions();
  createViews();
  connectSignals();
  connectRobot();
  keep("sides", findChild<QSplitter*>(QStringLiteral("motionSides")));
  keep("halves", findChild<QSplitter*>(QStringLiteral("motionHalves")));
  keep("columns", table_->horizontalHeader());
  showTable();
  showState();
}

void MotionEditorView::createFileActions() {
  new_ = makeAction(this, "file-new",
                    {"motionNew", tr("New…"), tr("Starts a motion with the joints of the robot")});
  open_ = makeAction(this, "open",
                     {"motionOpen", tr("Open…"), tr("Opens a motion, or imports another team's (.pos, .mot)"),
                      tr("Ctrl+Alt+O")});
  save_ = makeAction(this, "save",
                     {"motionSave", tr("Save"), tr("Saves the motion to its file"), QKeySequence::Save});
  saveAs_ =
      makeAction(this, "save", {"motionSaveAs", tr("Save as…"), tr("Saves the motion to another file")});
  discard_ = makeAction(this, "reset",
                        {"motionDiscard", tr("Discard changes"), tr("Reloads the motion from its file")});
  undo_ =
      makeAction(this, "undo", {"motionUndo", tr("Undo"), tr("Undoes the last edit"), QKeySequence::Undo});
  redo_ = makeAction(this, "redo", {"motionRedo", tr("Redo"), tr("Redoes the edit"), QKeySequence::Redo});
}

void MotionEditorView::createEditActions() {
  add_ = makeAction(this, "add",
                    {"motionAddFrame", tr("Duplicate key frame"),
                     tr("Adds a key frame like the selected one behind it"), tr("Ctrl+D")});
  remove_ = makeAction(this, "remove",
                       {"motionRemoveFrame", tr("Remove key frame"), tr("Removes the selected key frame"),
                        tr("Ctrl+Backspace")});
  up_ = makeAction(this, "up", {"motionUp", tr("Earlier"), tr("Swaps the key frame with the previous one")});
  down_ = makeAction(this, "down", {"motionDown", tr("Later"), tr("Swaps the key frame with the next one")});
  mirror_ = makeAction(
      this, "mirror",
      {"motionMirror", tr("Mirror"), tr("Mirrors the motion: what the left side did, the right side does")});
  mirrorFrame_ =
      makeAction(this, "mirror",
                 {"motionMirrorFrame", tr("Mirror key frame"), tr("Mirrors only the selected key frame")});
}

void MotionEditorView::createRobotActions() {
  send_ =
      makeAction(this, "send",
                 {"motionSend", tr("Send"),
                  tr("Sends the motion to the robot, whose program plays it from then on, without a restart"),
                  tr("Ctrl+Return")});
  autoSend_ = makeToggle(this, "auto-send",
                         {"motionAutoSend", tr("Send changes"), tr("Sends each change that has no errors")});
  takeBack_ = makeAction(
      this, "cancel-goal",
      {"motionTakeBack", tr("Take back"), tr("Makes the robot play the motion from its own files again")});
  previous_ = makeAction(this, "previous",
                         {"motionPrevious", tr("Previous key frame"),
                          tr("Selects the previous key frame; while you steer, the robot moves to its pose"),
                          tr("Ctrl+Alt+Up")});
  play_ = makeAction(this, "play",
                     {"motionPlay", tr("Play"), tr("Plays the motion once on the robot, while you steer"),
                      tr("Ctrl+Alt+P")});
  next_ = makeAction(
      this, "next",
      {"motionNext", tr("Next key frame"),
       tr("Selects the next key frame; while you steer, the robot moves to its pose"), tr("Ctrl+Alt+Down")});
}

QWidget* MotionEditorView::createTools() {
  QHBoxLayout* row = makeToolRow(this);
  QWidget* parent = row->parentWidget();
  more_ = new QMenu(tr("More"), parent);
  more_->setObjectName(QStringLiteral("motionMoreMenu"));
  more_->setToolTipsVisible(true);
  more_->addActions({saveAs_, discard_});
  ofRobot_ = more_->addMenu(tr("Open from the robot"));
  ofRobot_->setObjectName(QStringLiteral("motionOfRobotMenu"));
  more_->addSeparator();
  more_->addActions({mirrorFrame_, up_, down_});
  more_->addSeparator();
  more_->addAction(takeBack_);
  addButtons(row, {new_, open_, save_, undo_, redo_, add_, remove_, mirror_});
  row->addWidget(makeMenuButton(
      parent, {"motionMore", tr("More"), tr("Save as, motions of the robot, order of key frames, take back")},
      more_));
  row->addSpacing(8);
  addButtons(row, {previous_});
  row->addWidget(makeLabeledButton(parent, play_));
  addButtons(row, {next_});
  row->addWidget(makeLabeledButton(parent, send_));
  addButtons(row, {autoSend_});
  title_ = new QLabel(parent);
  describe(*title_, {"motionTitle", tr("Motion"), {}});
  title_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(title_, 1);
  return parent;
}

QWidget* MotionEditorView::createTable() {
  model_ = new KeyFrameModel(this);
  table_ = makeTable(this, {"motionTable", tr("Key frames"), {}}, model_);
  table_->setSelectionBehavior(QAbstractItemView::SelectItems);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked |
                          QAbstractItemView::AnyKeyPressed);
  table_->verticalHeader()->show();
  new ColumnFit(*table_, ColumnKind::kTitledNumber);
  return table_;
}

void MotionEditorView::createViews() {
  text_ = new MotionTextEdit(bench_, this);
  timeLine_ = new MotionTimeLine(bench_, this);
  auto* layout = makeColumn(this);
  layout->addWidget(createTools());
  QSplitter* sides = makeSplitter(this, "motionSides", Qt::Horizontal, {{text_, 2}, {createTable(), 3}});
  layout->addWidget(makeSplitter(this, "motionHalves", Qt::Vertical, {{sides, 4}, {timeLine_, 1}}), 1);
  hint_ = new EmptyHint(text_->viewport());
  errors_ = makeNote(this, "motionErrors", tr("Errors of the motion"));
  errors_->setContentsMargins(6, 2, 6, 0);
  state_ = makeNote(this, "motionState", tr("The motion and the robot"));
  state_->setContentsMargins(6, 2, 6, 2);
  layout->addWidget(errors_);
  layout->addWidget(state_);
}

void MotionEditorView::connectSignals() {
  connect(new_, &QAction::triggered, this, &MotionEditorView::startAnew);
  connect(open_, &QAction::triggered, this, [this] { openMotion(files_, this); });
  connect(save_, &QAction::triggered, this, [this] { saveMotion(files_, this); });
  connect(saveAs_, &QAction::triggered, this, [this] { saveMotionAs(files_, this); });
  connect(discard_, &QAction::triggered, this, [this] { showFailure(files_.discardChanges()); });
  connect(undo_, &QAction::triggered, &bench_.undoStack(), &QUndoStack::undo);
  connect(redo_, &QAction::triggered, &bench_.undoStack(), &QUndoStack::redo);
  connect(add_, &QAction::triggered, this, [this] { showFailure(bench_.duplicateFrame()); });
  connect(remove_, &QAction::triggered, this, [this] { showFailure(bench_.removeFrame()); });
  connect(up_, &QAction::triggered, this, [this] { showFailure(bench_.moveFrame(-1)); });
  connect(down_, &QAction::triggered, this, [this] { showFailure(bench_.moveFrame(1)); });
  connect(mirror_, &QAction::triggered, this, [this] { showFailure(bench_.mirror(false)); });
  connect(mirrorFrame_, &QAction::triggered, this, [this] { showFailure(bench_.mirror(true)); });
  connect(&bench_, &MotionBench::changed, this, &MotionEditorView::showState);
  connect(&bench_, &MotionBench::robotChanged, this, &MotionEditorView::showState);
  connect(&bench_, &MotionBench::changed, this, &MotionEditorView::showTable);
  connect(&bench_, &MotionBench::robotChanged, this, &MotionEditorView::showTable);
  connect(&bench_, &MotionBench::lineChanged, this, &MotionEditorView::showFrame);
  connect(&bench_.undoStack(), &QUndoStack::indexChanged, this, &MotionEditorView::showState);
  connect(&files_, &MotionFiles::titleChanged, this, &MotionEditorView::showState);
  connect(&files_, &MotionFiles::reported, this, &MotionEditorView::report);
  connect(model_, &KeyFrameModel::durationTyped, this, [this](int frame, qint64 nanoseconds) {
    showFailure(bench_.setDuration(frame, robotlink::Duration(nanoseconds)));
  });
  connect(model_, &KeyFrameModel::interpolationTyped, this, [this](int frame, int interpolation) {
    showFailure(bench_.setInterpolation(frame, interpolation));
  });
  connect(model_, &KeyFrameModel::valueTyped, this, [this](int frame, int joint, const QString& value) {
    showFailure(bench_.setValue(frame, joint, value));
  });
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& now) {
            if (isShowingFrame_ || !now.isValid()) return;
            bench_.setFrame(now.row());
            timeLine_->setColumn(now.column() - KeyFrameModel::kFirstJoint);
          });
}

void MotionEditorView::connectRobot() {
  connect(send_, &QAction::triggered, this, [this] { showFailure(link_.send()); });
  connect(autoSend_, &QAction::triggered, &link_, &MotionLink::setAutoSend);
  connect(takeBack_, &QAction::triggered, this, [this] { showFailure(link_.takeBack()); });
  connect(previous_, &QAction::triggered, this, [this] { showFailure(link_.step(-1)); });
  connect(play_, &QAction::triggered, this, [this] { showFailure(link_.play()); });
  connect(next_, &QAction::triggered, this, [this] { showFailure(link_.step(1)); });
  connect(&link_, &MotionLink::changed, this, &MotionEditorView::showState);
  connect(ofRobot_, &QMenu::aboutToShow, this, &MotionEditorView::fillRobotMenu);
}

void MotionEditorView::askForName(const QString& title, const std::function<void(const QString&)>& use) {
  QInputDialog dialog(this);
  dialog.setObjectName(QStringLiteral("motionNameDialog"));
  dialog.setWindowTitle(title);
  dialog.setLabelText(tr("Name: letters, digits, - and _"));
  if (dialog.exec() == QDialog::Accepted) use(dialog.textValue().trimmed());
}

void MotionEditorView::startAnew() {
  if (!mayLoseMotion(files_, this)) return;
  askForName(tr("New motion"),
             [this](const QString& name) { showFailure(files_.startAnew(name.toStdString())); });
}

void MotionEditorView::fillRobotMenu() {
  ofRobot_->clear();
  const auto* table = bench_.table();
  if (table == nullptr || table->motions().empty()) {
    ofRobot_->addAction(tr("The robot's program plays no motions"))->setEnabled(false);
    return;
  }
  for (const auto& motion : table->motions()) {
    const QString name = QString::fromStdString(motion.name());
    QAction* action = ofRobot_->addAction(motion.sent() ? tr("%1 (sent)").arg(name) : name);
    action->setObjectName(QStringLiteral("ofRobot.") + name);
    connect(action, &QAction::triggered, this, [this, name] {
      if (mayLoseMotion(files_, this)) showFailure(files_.openFromRobot(name.toStdString()));
    });
  }
}

void MotionEditorView::showFailure(const robotlink::Result<void>& done) {
  if (!done) report(QString::fromStdString(done.error().describe()), true);
}

void MotionEditorView::report(const QString& text, bool bad) {
  showOutcome(*state_, text, bad);
}

void MotionEditorView::showTable() {
  model_->show(bench_.motion(), bench_.columns(), bench_.description());
  showFrame();
}

void MotionEditorView::showFrame() {
  const int frame = bench_.frame();
  if (frame < 0 || frame == table_->currentIndex().row() || frame >= model_->rowCount()) return;
  isShowingFrame_ = true;
  const int column = std::max(table_->currentIndex().column(), static_cast<int>(KeyFrameModel::kDuration));
  table_->setCurrentIndex(model_->index(frame, std::min(column, model_->columnCount() - 1)));
  isShowingFrame_ = false;
}

void MotionEditorView::showState() {
  const bool hasMotion = !bench_.isEmpty(), hasFrames = !bench_.frames().empty();
  const bool isGood = bench_.errors().empty();
  const auto state = link_.state();
  const bool hasRobot = hasMotion && state != MotionLink::State::kNone;
  title_->setText(files_.title());
  title_->setToolTip(QString::fromStdString(files_.file().string()));
  undo_->setEnabled(bench_.undoStack().canUndo());
  redo_->setEnabled(bench_.undoStack().canRedo());
  for (QAction* action : {save_, saveAs_, discard_}) action->setEnabled(hasMotion);
  for (QAction* action : {add_, remove_, up_, down_, mirror_, mirrorFrame_, previous_, next_})
    action->setEnabled(hasFrames);
  send_->setEnabled(hasRobot && isGood && state != MotionLink::State::kSame);
  play_->setEnabled(hasRobot && isGood);
  takeBack_->setEnabled(hasRobot && bench_.robotText() && bench_.robotText()->isSent);
  autoSend_->setChecked(link_.autoSend());
  hint_->setHint(hasMotion
                     ? QString()
                     : tr("No motion. Open one, start one with New, or capture a pose in the view Joints."));
  robotlink::Errors shown = bench_.errors();
  const std::size_t more = shown.size() - std::min(shown.size(), kErrorsShown);
  shown.resize(shown.size() - more);
  QStringList lines;
  for (const robotlink::Error& error : shown)
    lines << tr("Line %1: %2").arg(error.where.line).arg(QString::fromStdString(error.text));
  if (more > 0) lines << tr("… and %1 more").arg(more);
  errors_->setVisible(hasMotion && !isGood);
  showOutcome(*errors_, hasMotion ? lines.join(QLatin1Char('\n')) : QString(), true);
  showOutcome(*state_, link_.text(), state == MotionLink::State::kRefused);
  setMeaning(*state_, state == MotionLink::State::kSame      ? std::optional(Meaning::kGood)
                      : state == MotionLink::State::kRefused ? std::optional(Meaning::kBad)
                                                             : std::nullopt);
  const QString title = files_.title();
  Q_EMIT titleChanged(title.isEmpty() ? tr("Motion editor") : tr("Motion editor: %1").arg(title));
}

void MotionEditorView::tick() {
  const auto since = link_.playedSince();
  timeLine_->setPlayed(since ? std::optional(session().timeline().newest() - *since) : std::nullopt);
}

robotlink::Result<void> MotionEditorView::saveTo(const QString& file) {
  if (robotlink::fileSuffix(file.toStdString()) != ".mof") return View::saveTo(file);
  return robotlink::writeFileAtomically(file.toStdString(), bench_.document().text());
}

}  // namespace widgets
