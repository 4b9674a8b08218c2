// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "widgets/RowModel.h"

namespace robotlink {
class StreamStore;
struct RobotDescription;
}  // namespace robotlink

namespace widgets {

/// A joint of a robot: its limits, and what is known of it at an instant. Angles in rad; unset: unknown.
struct JointRow {
  std::string name;
  /// Without limits the following are 0.
  bool hasLimits = true;
  double minimum = 0, maximum = 0;
  double maximumSpeed = 0;  ///< rad/s
  std::optional<double> requested, measured;
  std::optional<double> speed;  ///< rad/s
  std::optional<double> load;   ///< N m
  /// The angle that the user commands; unset: none.
  std::optional<double> commanded;
  /// The measured angles of the last seconds, oldest first, at equal distances in time.
  std::vector<double> history;

  /// The difference from the requested angle, rad; unset: one of them is unknown.
  std::optional<double> error() const;
};

/// All joints of a robot, in the order of its description, at the instant of the timeline: what its platform
/// measures (joints/states) and what its program requests (joints/request). Or those of a stream of another
/// program, of whose robot nothing else is known. Angles are shown in degrees. GUI thread.
class JointsModel final : public RowModel<JointRow> {
  Q_OBJECT
 public:
  enum Column { kName, kRequested, kMeasured, kError, kSpeed, kLoad, kLimits, kPosition, kHistory, kColumns };
  /// The duration of the history of a joint, and its maximum number of angles.
  static constexpr robotlink::Duration kHistoryTime = std::chrono::seconds(5);
  static constexpr std::size_t kHistoryPoints = 100;

  explicit JointsModel(QObject* parent = nullptr);

  /// Shows a robot at an instant; null: no robot with joints. `commanded`: what the user commands, rad.
  void show(const robotlink::RobotDescription* robot, const std::string& name,
            const robotlink::StreamStore& store, robotlink::Instant time,
            const std::map<std::string, double>& commanded);
  /// Shows the joints of any stream of foxglove.JointStates, in the order of its message at an instant,
  /// without limits.
  void showStream(const robotlink::StreamStore& store, const std::string& path, robotlink::Instant time);
  /// Whether requested angles can be edited; edits are emitted as angleWanted().
  void setEditable(bool editable);
  /// The row of a joint; -1: there is none.
  int rowOf(const std::string& joint) const;

  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

 Q_SIGNALS:
  /// The user wants a joint to turn to an angle, rad.
  void angleWanted(const QString& joint, double angle);

 private:
  QString text(const JointRow& row, int column) const;
  bool isEditable_ = false;
};

}  // namespace widgets
