// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/StreamSelector.h"

#include <algorithm>
#include <optional>

#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/TypedStreams.h"

namespace widgets {
namespace {

/// Whether a camera of the scene has these images; unset: no scene is known. Streams outlive their cameras.
std::optional<bool> isOfScene(robotlink::Session& session, const std::string& path) {
  const auto* world = session.store().latestAs<robotcontrol::WorldObjects>(robotlink::streams::kObjects,
                                                                           session.timeline().newest());
  if (world == nullptr) return std::nullopt;
  return std::ranges::any_of(world->objects(),
                             [&](const auto& object) { return object.port().image_stream() == path; });
}

}  // namespace

StreamSelector::StreamSelector(std::string type, QString choice, QWidget* parent)
    : QComboBox(parent), type_(std::move(type)), initial_(std::move(choice)), choice_(initial_) {
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(14);
  connect(this, QOverload<int>::of(&QComboBox::activated), this,
          [this] { setChoice(currentData().toString()); });
}

bool StreamSelector::refresh(robotlink::Session& session) {
  const auto& store = session.store();
  if (store.listVersion() == listVersion_ && session.selectedRobot() == listedRobot_) return false;
  listVersion_ = store.listVersion();
  listedRobot_ = session.selectedRobot();
  // Without a robot, "*/cam" would be a second "/cam".
  const QString folder =
      listedRobot_.empty() ? QString() : QString::fromStdString(listedRobot_) + QLatin1Char('/');
  QStringList choices, paths;
  for (const auto* stream : store.streams()) {
    if (stream->type != type_) continue;
    const QString path = QString::fromStdString(stream->path);
    paths << path;
    if (!folder.isEmpty() && path.startsWith(folder))
      choices << QStringLiteral("*/") + path.mid(folder.size());
  }
  shown_.clear();
  const QString wanted = QString::fromStdString(path(session));
  shown_ = paths.contains(wanted) ? QString() : substitute(choices, paths, session);
  const QString& current = !shown_.isEmpty()                            ? shown_
                           : folder.isEmpty() && paths.contains(wanted) ? wanted
                                                                        : choice_;
  if (!paths.contains(current) && !choices.contains(current)) choices.prepend(current);
  clear();
  for (const QString& choice : choices + paths) {
    const bool ofSelected = choice.startsWith(QLatin1Char('*'));
    addItem(ofSelected ? tr("Selected robot: %1").arg(choice.mid(2)) : choice, choice);
  }
  setCurrentIndex(findData(current));
  return true;
}

bool StreamSelector::isOfOthers(robotlink::Session& session) const {
  const std::string path = choice_.toStdString(), robot = robotlink::streams::robotOf(path);
  const auto& robots = session.robots();
  if (choice_.startsWith(QLatin1Char('*')) || robot.empty() || robots.empty() ||
      std::ranges::find(robots, robot) != robots.end())
    return false;
  // A camera of the scene sends images once they are requested.
  return !isOfScene(session, path).value_or(false);
}

QString StreamSelector::substitute(const QStringList& ofSelected, const QStringList& paths,
                                   robotlink::Session& session) const {
  const bool isGone = isOfOthers(session);
  if (choice_ != initial_ && !isGone) return {};
  const QString same = QLatin1Char('*') + choice_.mid(choice_.indexOf(QLatin1Char('/')));
  if (ofSelected.contains(same)) return same;
  if (!ofSelected.isEmpty()) return ofSelected.front();
  if (isGone) return initial_;
  const auto& robots = session.robots();
  const auto found = std::ranges::find_if(paths, [&](const QString& each) {
    const std::string path = each.toStdString();
    return std::ranges::find(robots, robotlink::streams::robotOf(path)) == robots.end() &&
           isOfScene(session, path).value_or(true);
  });
  return found == paths.end() ? QString() : *found;
}

std::string StreamSelector::path(const robotlink::Session& session) const {
  QString path = shown_.isEmpty() ? choice_ : shown_;
  if (path.startsWith(QLatin1Char('*'))) path.replace(0, 1, QString::fromStdString(session.selectedRobot()));
  return path.toStdString();
}

void StreamSelector::setChoice(const QString& choice) {
  if (choice.isEmpty()) return;
  choice_ = choice;
  shown_.clear();
  listVersion_ = ~0ULL;  // lists the choice even if it does not exist
  Q_EMIT choiceChanged();
}

}  // namespace widgets
