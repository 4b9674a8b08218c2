// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/joints/JointsView.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/TypedStreams.h"
#include "widgets/image/StreamSelector.h"
#include "widgets/joints/JointSlider.h"
#include "widgets/joints/SparklineDelegate.h"
#include "widgets/motion/ManualSteering.h"
#include "widgets/motions/PoseCapture.h"
#include "widgets/steering/SteeringBar.h"

namespace widgets {
namespace {

const ViewRegistration kJointsViewRegistration{
    {"joints", QT_TRANSLATE_NOOP("View", "Joints"),
     QT_TRANSLATE_NOOP("View",
                       "Shows all joints of a robot, turns single ones, and captures poses for motions."),
     "joints", false, create<JointsView>}};

constexpr char kJointsType[] = "foxglove.JointStates";
constexpr int kUsualDurationMs = 500, kLongestDurationMs = 60'000;

}  // namespace

JointsView::JointsView(ViewContext& context, QWidget* parent)
    : View(context, parent), manual_(manualSteering(context)) {
  setObjectName(QStringLiteral("jointsView"));
  createActions();
  createViews();
  connectSignals();
  keep("columns", table_->horizontalHeader());
  keep("source", source_);
  keep("stream", streams_);
  keep(
      "duration", [this] { return QJsonValue(duration_->value()); },
      [this](const QJsonValue& value) { duration_->setValue(value.toInt(kUsualDurationMs)); });
}

void JointsView::createActions() {
  take_ =
      makeToggle(this, "take-over",
                 {"jointsTakeOver", tr("Take over"), tr("Switches the behavior to obeying you, and back")});
  limp_ = makeToggle(this, "limp",
                     {"jointsLimp", tr("Limp"),
                      tr("Releases all joints, to pose the robot by hand; click again to hold them")});
  stand_ = makeAction(
      this, "halt",
      {"jointsStand", tr("Stand"), tr("Makes the robot stand, and releases the joints you turned")});
  capture_ =
      makeAction(this, "camera",
                 {"jointsCapture", tr("Capture"),
                  tr("Adds this pose to the motion in the editor, as a key frame"), tr("Ctrl+Return")});
}

QWidget* JointsView::createTop() {
  QHBoxLayout* row = makeToolRow(this);
  QWidget* parent = row->parentWidget();
  robotName_ = new QLabel(parent);
  describe(*robotName_,
           {"jointsRobot", tr("Robot whose joints are shown"), tr("It is chosen in the toolbar")});
  QFont bold = robotName_->font();
  bold.setBold(true);
  robotName_->setFont(bold);
  streams_ = new StreamSelector(kJointsType, QStringLiteral("*/joints/states"), parent);
  describe(*streams_, {"jointsStream", tr("Joints"), tr("Which joints of another program are shown")});
  streams_->hide();
  state_ = makeNote(parent, "jointsState", tr("Who steers"));
  row->addWidget(robotName_);
  row->addWidget(streams_);
  for (QAction* action : {take_, limp_, stand_}) row->addWidget(makeLabeledButton(parent, action));
  row->addWidget(state_, 1);
  return parent;
}

QWidget* JointsView::createTeaching() {
  QHBoxLayout* row = makeToolRow(this);
  QWidget* parent = row->parentWidget();
  source_ = new QComboBox(parent);
  describe(*source_, {"jointsSource", tr("Angles of the pose"), tr("Which angles become a key frame")});
  source_->addItems({tr("measured"), tr("requested")});
  duration_ = new QSpinBox(parent);
  describe(*duration_,
           {"jointsDuration", tr("Duration"), tr("How long the motion takes to reach this pose")});
  duration_->setRange(1, kLongestDurationMs);
  duration_->setSingleStep(100);
  duration_->setSuffix(tr(" ms"));
  duration_->setValue(kUsualDurationMs);
  outcome_ = makeNote(parent, "jointsOutcome", tr("Result of capturing"));
  row->addWidget(new QLabel(tr("Teach in:"), parent));
  row->addWidget(source_);
  row->addWidget(duration_);
  row->addWidget(makeLabeledButton(parent, capture_));
  row->addWidget(outcome_, 1);
  return parent;
}

void JointsView::createViews() {
  table_ = makeTable(this, {"jointsTable", tr("Joints"), {}}, &model_);
  table_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  table_->setItemDelegateForColumn(JointsModel::kHistory, new SparklineDelegate(model_, table_));
  using enum ColumnKind;
  new ColumnFit(*table_, {kName, kNumber, kNumber, kNumber, kNumber, kNumber, kNumber, kText, kText});
  hint_ = new EmptyHint(table_);
  steering_ = new SteeringBar(context().commands, this);
  auto* layout = makeColumn(this);
  layout->addWidget(createTop());
  layout->addWidget(steering_);
  layout->addWidget(table_, 1);
  layout->addWidget(createTeaching());
}

void JointsView::connectSignals() {
  connect(take_, &QAction::triggered, this, [this](bool on) {
    // An obstacle to that is shown next to the button.
    static_cast<void>(manual_.takeOver(on));
    showState();
  });
  connect(limp_, &QAction::triggered, this, [this](bool on) {
    if (const auto done = manual_.setLimp(on); !done)
      showOutcome(*outcome_, QString::fromStdString(done.error().text), true);
    showState();
  });
  connect(stand_, &QAction::triggered, this, [this] { static_cast<void>(manual_.stand()); });
  connect(capture_, &QAction::triggered, this, &JointsView::capture);
  connect(streams_, &StreamSelector::choiceChanged, this, &JointsView::tick);
  connect(&model_, &JointsModel::angleWanted, this, &JointsView::turn);
  connect(&model_, &QAbstractItemModel::modelReset, this, &JointsView::createSliders);
}

void JointsView::createSliders() {
  sliders_.clear();
  for (int row = 0; row < model_.rowCount(); ++row) {
    const JointRow& joint = model_.row(row);
    if (!joint.hasLimits) return;  // nothing is turned there
    auto* slider = new JointSlider(joint, table_);
    const QString name = QString::fromStdString(joint.name);
    const QByteArray objectName = "joint-" + name.toLatin1();
    describe(*slider, {objectName.constData(), name, tr("Turns %1 while you steer").arg(name)});
    connect(slider, &JointSlider::angleWanted, this, [this, name](double angle) { turn(name, angle); });
    table_->setIndexWidget(model_.index(row, JointsModel::kPosition), slider);
    sliders_.push_back(slider);
  }
}

void JointsView::turn(const QString& joint, double angle) {
  const auto done = manual_.setJoint(joint.toStdString(), angle);
  showOutcome(*outcome_, done ? QString() : QString::fromStdString(done.error().text), !done);
}

void JointsView::capture() {
  const auto source = source_->currentIndex() == 0 ? PoseSource::kMeasured : PoseSource::kRequested;
  const auto done = capturePose(context(), source, std::chrono::milliseconds(duration_->value()));
  showOutcome(*outcome_, done ? *done : QString::fromStdString(done.error().text), !done);
}

bool JointsView::isOfRobot() const {
  const auto& description = manual_.description();
  return description != nullptr && !description->joints.empty();
}

QString JointsView::hint() const {
  if (model_.rowCount() > 0) return {};
  if (manual_.robot().empty() && hasForeignStreams(session().store()))
    return tr(
        "The log has no joints up to this time. Its contents are shown in the views Data, Plots, "
        "Field and Scene.");
  if (manual_.robot().empty())
    return tr("No robot. Start a simulation or connect to a robot, and choose it in the toolbar.");
  const QString name = QString::fromStdString(manual_.robot());
  if (manual_.description() == nullptr) return tr("The kind of robot %1 is not known yet.").arg(name);
  return manual_.description()->joints.empty() ? tr("%1 has no joints.").arg(name) : QString();
}

void JointsView::showState() {
  const bool hasJoints = isOfRobot() && model_.rowCount() > 0;
  const bool isTaken = manual_.isTaken();
  const auto state = manual_.control().state();
  take_->setEnabled(hasJoints && state != ManualControl::State::kUnknown &&
                    state != ManualControl::State::kUnavailable);
  take_->setChecked(isTaken);
  limp_->setEnabled(isTaken && hasJoints);
  limp_->setChecked(manual_.commander().limp());
  stand_->setEnabled(isTaken && hasJoints && manual_.commander().turnsJoints());
  capture_->setEnabled(hasJoints);
  state_->setText(!hasJoints                   ? QString()
                  : manual_.commander().limp() ? tr("All joints are limp: pose the robot by hand.")
                  : isTaken && !manual_.commander().turnsJoints() ? tr("You steer the robot: drag a slider.")
                                                                  : manual_.control().text());
}

void JointsView::showJoints() {
  const auto& store = session().store();
  if (streams_->refresh(session())) {
    hasStreams_ =
        std::ranges::any_of(store.streams(), [](const auto* stream) { return stream->type == kJointsType; });
  }
  const bool isOfRobot = this->isOfRobot();
  streams_->setVisible(hasStreams_ && !isOfRobot);
  model_.setEditable(isOfRobot && manual_.isTaken());
  if (isOfRobot) {
    model_.show(manual_.description().get(), manual_.robot(), store, session().timeline().shown(),
                manual_.commander().joints());
  } else {
    model_.showStream(store, streams_->path(session()), session().timeline().shown());
  }
}

void JointsView::tick() {
  manual_.follow();
  const std::string& robot = manual_.robot();
  if (!robot.empty())
    subscription_.want(session(), robot, {robotlink::kJointStates.name, robotlink::kJointRequest.name});
  robotName_->setText(QString::fromStdString(robot));
  showJoints();
  for (std::size_t i = 0; i < sliders_.size(); ++i) {
    sliders_[i]->setEnabled(manual_.isTaken());
    sliders_[i]->showJoint(model_.row(static_cast<int>(i)));
  }
  steering_->refresh(session(), robot);
  showState();
  hint_->setHint(hint());
}

robotlink::Result<void> JointsView::saveTo(const QString& file) {
  if (robotlink::fileSuffix(file.toStdString()) != ".csv") return View::saveTo(file);
  std::string text = "joint,requested_deg,measured_deg,error_deg,speed_deg_s,load_nm\n";
  for (int row = 0; row < model_.rowCount(); ++row) {
    for (int column = JointsModel::kName; column <= JointsModel::kLoad; ++column) {
      const QString cell = model_.index(row, column).data().toString();
      text += (column > 0 ? "," : "") + (cell == QStringLiteral("–") ? std::string() : cell.toStdString());
    }
    text += '\n';
  }
  return robotlink::writeFileAtomically(file.toStdString(), text);
}

}  // namespace widgets
