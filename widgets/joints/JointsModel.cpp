// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/joints/JointsModel.h"

#include <algorithm>
#include <cmath>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/StreamStore.h"

namespace widgets {
namespace {

using robotlink::StreamStore;

/// The state of a joint, which is mostly at its place in the description; null: there is none.
const foxglove::JointState* jointStateOf(const foxglove::JointStates& states, const std::string& joint,
                                         std::size_t place) {
  const auto index = static_cast<int>(place);
  if (index < states.joints_size() && states.joints(index).name() == joint) return &states.joints(index);
  const auto found = std::ranges::find(states.joints(), joint, &foxglove::JointState::name);
  return found == states.joints().end() ? nullptr : &*found;
}

/// The messages of the last seconds before an instant, oldest first: as many as a history shows.
std::vector<const foxglove::JointStates*> jointHistoryBefore(const StreamStore& store,
                                                             const std::string& path,
                                                             robotlink::Instant time) {
  std::vector<const foxglove::JointStates*> result;
  const auto* stream = store.find(path);
  if (stream == nullptr) return result;
  const auto& all = stream->messages;
  const auto later = [](robotlink::Instant instant, const auto& message) { return instant < message.time; };
  const auto begin = std::upper_bound(all.begin(), all.end(), time - JointsModel::kHistoryTime, later);
  const auto end = std::upper_bound(begin, all.end(), time, later);
  const auto count = static_cast<std::size_t>(end - begin);
  constexpr std::size_t kMaxPoints = JointsModel::kHistoryPoints;
  const std::size_t step = std::max<std::size_t>(1, (count + kMaxPoints - 1) / kMaxPoints);
  // Counted from the newest, so that it is always there.
  for (std::size_t back = 1; back <= count; back += step) {
    const auto& message = *(end - static_cast<std::ptrdiff_t>(back));
    if (const auto* states = dynamic_cast<const foxglove::JointStates*>(message.value.get()))
      result.push_back(states);
  }
  std::ranges::reverse(result);
  return result;
}

/// Sets the measurements of a joint, and those of the last seconds.
void measureJoint(JointRow& row, const foxglove::JointStates* states,
                  const std::vector<const foxglove::JointStates*>& history, std::size_t place) {
  if (const auto* state = states == nullptr ? nullptr : jointStateOf(*states, row.name, place)) {
    if (state->has_position()) row.measured = state->position();
    if (state->has_velocity()) row.speed = state->velocity();
    if (state->has_effort()) row.load = state->effort();
  }
  for (const auto* earlier : history) {
    const auto* state = jointStateOf(*earlier, row.name, place);
    if (state != nullptr && std::isfinite(state->position())) row.history.push_back(state->position());
  }
}

bool isSameJoint(const JointRow& a, const JointRow& b) {
  return a.name == b.name && a.hasLimits == b.hasLimits && a.minimum == b.minimum && a.maximum == b.maximum;
}

QString jointDegreesText(const std::optional<double>& angle) {
  // Adding 0 makes a negative zero positive.
  return angle ? QString::number(std::round(robotlink::degrees(*angle) * 10) / 10 + 0.0, 'f', 1)
               : QStringLiteral("–");
}

}  // namespace

std::optional<double> JointRow::error() const {
  return requested && measured ? std::optional(*requested - *measured) : std::nullopt;
}

JointsModel::JointsModel(QObject* parent)
    : RowModel({tr("Joint"), tr("Requested, °"), tr("Measured, °"), tr("Error, °"), tr("Speed, °/s"),
                tr("Load, N m"), tr("Limits, °"), tr("Position"), tr("Last 5 s")},
               parent) {}

void JointsModel::show(const robotlink::RobotDescription* robot, const std::string& name,
                       const StreamStore& store, robotlink::Instant time,
                       const std::map<std::string, double>& commanded) {
  std::vector<JointRow> rows;
  if (robot != nullptr) {
    const std::string path = name + '/' + robotlink::kJointStates.name;
    const auto* states = store.latestAs<foxglove::JointStates>(path, time);
    const auto* request =
        store.latestAs<robotcontrol::JointRequest>(name + '/' + robotlink::kJointRequest.name, time);
    const auto history = jointHistoryBefore(store, path, time);
    for (std::size_t i = 0; i < robot->joints.size(); ++i) {
      const auto& joint = robot->joints[i];
      JointRow& row = rows.emplace_back();
      row.name = joint.name;
      row.minimum = joint.minimum;
      row.maximum = joint.maximum;
      row.maximumSpeed = joint.maximumSpeed;
      if (const auto wanted = commanded.find(joint.name); wanted != commanded.end())
        row.commanded = wanted->second;
      measureJoint(row, states, history, i);
      const auto index = static_cast<int>(i);
      if (request != nullptr && index < request->positions_size() && std::isfinite(request->positions(index)))
        row.requested = request->positions(index);
    }
  }
  replaceRows(std::move(rows), isSameJoint);
}

void JointsModel::showStream(const StreamStore& store, const std::string& path, robotlink::Instant time) {
  constexpr int kMaxJoints = 1000;
  std::vector<JointRow> rows;
  if (const auto* states = store.latestAs<foxglove::JointStates>(path, time)) {
    const auto history = jointHistoryBefore(store, path, time);
    for (int i = 0; i < std::min(states->joints_size(), kMaxJoints); ++i) {
      JointRow& row = rows.emplace_back();
      row.name = states->joints(i).name();
      row.hasLimits = false;
      measureJoint(row, states, history, static_cast<std::size_t>(i));
    }
  }
  replaceRows(std::move(rows), isSameJoint);
}

void JointsModel::setEditable(bool editable) {
  isEditable_ = editable;
}

int JointsModel::rowOf(const std::string& joint) const {
  const auto found = std::ranges::find(rows_, joint, &JointRow::name);
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

QString JointsModel::text(const JointRow& row, int column) const {
  switch (column) {
    case kName:
      return QString::fromStdString(row.name);
    case kRequested:
      return jointDegreesText(row.requested);
    case kMeasured:
      return jointDegreesText(row.measured);
    case kError:
      return jointDegreesText(row.error());
    case kSpeed:
      return jointDegreesText(row.speed);
    case kLoad:
      return row.load ? QString::number(*row.load + 0.0, 'f', 3) : QStringLiteral("–");
    case kLimits:
      return row.hasLimits
                 ? QStringLiteral("%1 … %2").arg(jointDegreesText(row.minimum), jointDegreesText(row.maximum))
                 : QStringLiteral("–");
    default:
      return {};
  }
}

QVariant JointsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const JointRow& row = this->row(index.row());
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return text(row, index.column());
    case Qt::TextAlignmentRole:
      return index.column() == kName ? QVariant() : QVariant(kNumberAlignment);
    case Qt::ToolTipRole:
      if (index.column() == kRequested && isEditable_)
        return tr("Turns the joint: a double click, or F2, edits the angle in degrees");
      if (index.column() == kLoad && !row.load)
        return tr("The robot does not measure the torque of its joints");
      return index.column() == kSpeed && row.hasLimits
                 ? QVariant(tr("At most %1°/s").arg(robotlink::degrees(row.maximumSpeed), 0, 'f', 0))
                 : QVariant();
    default:
      return {};
  }
}

QVariant JointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::ToolTipRole)
    return RowModel::headerData(section, orientation, role);
  switch (section) {
    case kRequested:
      return tr("The angle that the program requests, degrees (joints/request)");
    case kMeasured:
      return tr("The angle that the robot measures, degrees (joints/states)");
    case kError:
      return tr("Requested minus measured, degrees");
    case kSpeed:
      return tr("Degrees per second");
    case kLoad:
      return tr("Torque, N m, if the robot measures it");
    case kLimits:
      return tr("The software limits, degrees");
    case kPosition:
      return tr("Measured as a bar, requested as a mark, between the limits; drag it while you steer");
    default:
      return {};
  }
}

Qt::ItemFlags JointsModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags usual = RowModel::flags(index);
  return isEditable_ && index.column() == kRequested ? usual | Qt::ItemIsEditable : usual;
}

bool JointsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::EditRole || !flags(index).testFlag(Qt::ItemIsEditable)) return false;
  bool isNumber = false;
  const double degrees = value.toString().trimmed().toDouble(&isNumber);
  if (!isNumber || !std::isfinite(degrees)) return false;
  const JointRow& row = this->row(index.row());
  Q_EMIT angleWanted(QString::fromStdString(row.name),
                     std::clamp(robotlink::radians(degrees), row.minimum, row.maximum));
  return true;
}

}  // namespace widgets
