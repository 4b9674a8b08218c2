// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/far/FarDesk.h"

#include <qtadvanceddocking/DockWidget.h>
#include <QDialog>
#include <QLabel>
#include <QTreeView>

#include "robotcontrol/Debugging.pb.h"

namespace app::test {
namespace {

/// A widget that is seen; null if there is none.
template <typename W>
W* shown(QWidget& window, const char* name) {
  auto* found = window.findChild<W*>(QLatin1String(name));
  return found != nullptr && found->isVisible() ? found : nullptr;
}

}  // namespace

QString FarDesk::meet(const FarRobot& robot) {
  join(robot.url());
  if (!comes([&] { return shown<QDialog>(window, "trustDialog") != nullptr; }))
    return QStringLiteral("nobody is asked to trust %1: %2")
        .arg(QString::fromStdString(robot.url()), state());
  const QString fingerprint = find<QLineEdit>("trustFingerprint").text();
  if (fingerprint != QString::fromStdString(robot.fingerprint()))
    return QStringLiteral("the fingerprint is %1").arg(fingerprint);
  QTest::mouseClick(&find<QPushButton>("trustAccept"), Qt::LeftButton);
  if (!comes([&] { return shown<QDialog>(window, "tokenDialog") != nullptr; }))
    return QStringLiteral("nobody is asked for a token: %1").arg(state());
  QTest::keyClicks(&find<QLineEdit>("tokenField"), QString::fromStdString(robot.token()));
  QTest::mouseClick(&find<QPushButton>("tokenAccept"), Qt::LeftButton);
  if (!comes([&] { return !this->robot().isEmpty(); })) return QStringLiteral("not connected: ") + state();
  return {};
}

void FarDesk::show(const char* view) {
  ads::CDockWidget* dock = window.docks().open(QLatin1String(view));
  dock->setAsCurrentTab();
  window.tick();
}

bool FarDesk::switchKey(const QString& group, const QString& key) {
  show("debug-keys");
  auto& search = find<QLineEdit>("keysSearch");
  search.clear();
  QTest::keyClicks(&search, group + QLatin1Char(' ') + key);
  auto& tree = find<QTreeView>("keysTree");
  if (!comes([&] { return widgets::test::find(tree, key).isValid(); })) return false;
  tree.setCurrentIndex(widgets::test::find(tree, key));
  QTest::keyClick(&tree, Qt::Key_Return);
  search.clear();
  return true;
}

bool FarDesk::choose(const std::string& task, const std::string& solution) {
  show("solutions");
  auto& tree = find<QTreeView>("solutionsTree");
  const auto row = [&] { return widgets::test::find(tree, QString::fromStdString(solution)); };
  if (!comes([&] { return row().isValid(); })) return false;
  widgets::test::clickCell(tree, row());
  return comes([&] {
    const auto* table = newest<robotcontrol::SolutionTable>(robot().toStdString() + "/tables/solutions");
    if (table == nullptr) return false;
    return std::ranges::any_of(
        table->tasks(), [&](const auto& one) { return one.name() == task && one.active() == solution; });
  });
}

bool FarDesk::takeOver() {
  show("motion");
  auto& button = find<QToolButton>("motionTakeOver");
  if (!comes([&] { return button.isEnabled() && !button.isChecked(); })) return false;
  widgets::test::click(button);
  return comes([&] { return button.isChecked(); });
}

void FarDesk::hold(Qt::Key key) {
  auto& pad = find<QWidget>("walkPad");
  pad.setFocus();
  QTest::keyPress(&pad, key);
}

void FarDesk::release(Qt::Key key) {
  QTest::keyRelease(&find<QWidget>("walkPad"), key);
}

const robotlink::RemoteRobot& FarDesk::line() {
  return workbench.session().remoteRobots().begin()->second;
}

std::vector<robotlink::Vector3> FarDesk::track(robotlink::Instant since) {
  std::vector<robotlink::Vector3> places;
  const auto* stream = workbench.session().store().find("transforms");
  if (stream == nullptr) return places;
  for (const robotlink::StreamMessage& message : stream->messages) {
    const auto* transforms = dynamic_cast<const foxglove::FrameTransforms*>(message.value.get());
    if (transforms == nullptr || message.time < since) continue;
    for (const auto& transform : transforms->transforms())
      if (transform.child_frame_id() == workbench.session().selectedRobot())
        places.push_back(robotlink::vector3(transform.translation()));
  }
  return places;
}

std::optional<double> FarDesk::moved() {
  constexpr std::chrono::milliseconds kSpan{400};
  const auto* stream = workbench.session().store().find("transforms");
  if (stream == nullptr || stream->messages.empty()) return std::nullopt;
  const robotlink::Instant newest = stream->messages.back().time;
  if (stream->messages.front().time > newest - kSpan) return std::nullopt;
  const auto places = track(newest - kSpan);
  if (places.size() < 2) return std::nullopt;
  return (places.back() - places.front()).norm();
}

}  // namespace app::test
