// SPDX-License-Identifier: GPL-3.0-or-later
#include <QHeaderView>
#include <QStyleFactory>
#include <QTableView>
#include <QToolButton>
#include <QTreeView>
#include <cmath>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Robot.pb.h"
#include "tests/widgets/Bench.h"
#include "widgets/keys/DebugKeysView.h"
#include "widgets/messages/MessagesView.h"
#include "widgets/motion/MotionView.h"
#include "widgets/plots/PlotsView.h"
#include "widgets/processes/ProcessesView.h"
#include "widgets/solutions/SolutionsView.h"
#include "widgets/timing/TimingView.h"

namespace widgets::test {

using robotcontrol::KeyMode;

namespace {

QPalette darkPalette() {
  QPalette palette;
  const QColor window(0x2b, 0x2e, 0x33), base(0x1f, 0x22, 0x26), text(0xe4, 0xe7, 0xeb);
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, QColor(0x25, 0x28, 0x2d));
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::Button, QColor(0x36, 0x3a, 0x40));
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::Highlight, QColor(0x2f, 0x6f, 0xc4));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, window);
  palette.setColor(QPalette::ToolTipText, text);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, QColor(0x8a, 0x90, 0x98));
  }
  return palette;
}

void pushKeys(Bench& bench) {
  robotcontrol::KeyTable table;
  auto add = [&](const char* name, KeyMode::Kind kind, unsigned n, bool inUse) {
    auto& key = *table.add_keys();
    key.set_name(name);
    key.mutable_mode()->set_kind(kind);
    key.mutable_mode()->set_n(n);
    key.set_in_use(inUse);
  };
  add("ball-percept/circle", KeyMode::ALWAYS, 0, true);
  add("ball-percept/edges", KeyMode::OFF, 0, true);
  add("ball-percept/scan-lines", KeyMode::EVERY_N, 10, true);
  add("ball-model/position", KeyMode::ALWAYS, 0, true);
  add("ball-model/covariance", KeyMode::N_TIMES, 3, true);
  add("landmark-percepts/flags", KeyMode::OFF, 0, true);
  add("package/models/ball", KeyMode::EVERY_MS, 200, true);
  add("package/motion/status", KeyMode::ALWAYS, 0, true);
  add("self-localization/particles", KeyMode::OFF, 0, false);
  add("self-localization/odometry", KeyMode::ALWAYS, 0, true);
  add("timing/tasks", KeyMode::ALWAYS, 0, true);
  bench.push("red1/tables/keys", table, 1);
}

void pushTasks(Bench& bench) {
  robotcontrol::SolutionTable table;
  auto task = [&](const char* name, const char* process, const char* active) -> auto& {
    auto& added = *table.add_tasks();
    added.set_name(name);
    added.set_process(process);
    added.set_active(active);
    return added;
  };
  auto add = [](robotcontrol::SolutionTable::Task& to, const char* name, const char* help,
                const char* unavailable = "") {
    auto& solution = *to.add_solutions();
    solution.set_name(name);
    solution.set_help(help);
    solution.set_unavailable(unavailable);
    solution.set_has_parameters(true);
  };
  auto& ball = task("ball-percept", "cognition", "scan-lines");
  add(ball, "scan-lines", "Fits a circle to the ball's edge on scan lines");
  add(ball, "regions", "Takes the largest orange region for the ball");
  auto& pose = task("self-localization", "cognition", "odometry");
  add(pose, "odometry", "Adds up what the legs did");
  add(pose, "oracle", "Takes the true pose",
      "unavailable because neither the robot nor another task provides the simulator's ground truth "
      "(oracle/world)");
  auto& behavior = task("behavior", "cognition", "obey");
  add(behavior, "go-to-ball", "Searches the ball, walks there and kicks it");
  add(behavior, "stand", "Stands and looks around");
  add(behavior, "obey", "Does what the motion tester asks for");
  auto& motion = task("motion", "motion", "walk-and-play");
  add(motion, "walk-and-play", "Walks by a wheel model of the legs, plays key frames");
  bench.push("red1/tables/solutions", table, 1);
  robotcontrol::SimulationStatus some;
  some.set_time(1.5);
  some.set_speed(0.75);
  some.set_running(true);
  some.set_scene("field2002");
  robotcontrol::ParameterValues values;
  values.set_task("ball-percept");
  values.set_solution("scan-lines");
  values.mutable_value()->set_type("robotcontrol.SimulationStatus");
  values.mutable_value()->set_data(some.SerializeAsString());
  some.set_speed(1);
  values.mutable_defaults()->set_data(some.SerializeAsString());
  bench.push("red1/parameters/ball-percept/scan-lines", values, 1);
}

void pushProcesses(Bench& bench) {
  for (const std::uint64_t n : {std::uint64_t{100}, std::uint64_t{150}}) {
    robotcontrol::ProcessTable table;
    auto add = [&](const char* name, std::uint64_t frames, std::initializer_list<const char*> tasks) {
      auto& process = *table.add_processes();
      process.set_name(name);
      process.set_state("running");
      process.set_frames(frames);
      for (const char* task : tasks) process.add_tasks(task);
    };
    add("platform", 5 * n, {});
    add("sensing", n, {"segmentation", "ball-percept", "landmark-percepts"});
    add("ball", n, {"ball-model"});
    add("localization", n / 2, {"self-localization"});
    add("behavior", n, {"behavior", "head-control"});
    add("motion", 5 * n, {"motion"});
    table.mutable_processes(3)->set_state("failed: the particle set is empty");
    auto link = [&](int from, int to, const char* package, std::uint64_t count, bool blocking,
                    std::uint64_t missed) {
      auto& sender = *table.mutable_processes(from)->add_senders();
      auto& receiver = *table.mutable_processes(to)->add_receivers();
      sender.set_package(package);
      receiver.set_package(package);
      sender.set_count(count);
      receiver.set_count(count - missed);
      receiver.set_missed(missed);
      receiver.set_blocking(blocking);
      receiver.set_peer(table.processes(from).name());
    };
    link(0, 1, "camera/image", n, true, 0);
    link(0, 5, "joints/states", 5 * n, true, 0);
    link(1, 2, "percepts/ball", n, true, 0);
    link(1, 3, "percepts/landmarks", n, true, n / 2);
    link(2, 4, "models/ball", n, true, 0);
    link(3, 4, "models/pose", n / 2, false, 0);
    link(4, 5, "behavior/motion", n, false, n / 10);
    link(4, 5, "behavior/head", n, false, 0);
    link(5, 0, "joints/request", 5 * n, false, 0);
    link(5, 3, "motion/status", 5 * n, false, 4 * n);
    bench.push("red1/tables/processes", table, static_cast<double>(n) / 25);
  }
}

void pushValues(Bench& bench) {
  const char* texts[] = {"ball at 1.24 m, 12 degrees to the left", "no landmark for 2.0 s",
                         "kick-forward played", "the image is 80 ms old", "42 of 100 particles replaced"};
  for (int i = 0; i < 300; ++i) {
    const double t = i * 0.04;
    for (int curve = 0; curve < 3; ++curve) {
      robotcontrol::PlotValue plot;
      plot.set_value(std::sin(t * (curve + 1)) * std::exp(-t / 12) + curve * 0.3);
      plot.set_unit("m");
      bench.push(std::string("red1/plots/ball-model/position/") + "xyz"[curve], plot, t);
    }
    robotcontrol::StopwatchTimes times;
    auto add = [&](const char* task, const char* solution, double seconds) {
      auto& entry = *times.add_entries();
      entry.set_task(task);
      entry.set_solution(solution);
      entry.set_seconds(seconds);
    };
    add("segmentation", "color-table", 0.0011 + 0.0001 * (i % 3));
    add("ball-percept", "scan-lines", 0.0006 + 0.0002 * (i % 5));
    add("landmark-percepts", "regions", 0.0004);
    add("", "", 0.0024 + 0.0002 * (i % 5));
    bench.push("red1/stopwatches/sensing", times, t);
    foxglove::FrameTransforms transforms;
    auto& transform = *transforms.add_transforms();
    transform.set_parent_frame_id("field");
    transform.set_child_frame_id("red1");
    transform.mutable_translation()->set_x(t * 0.09);
    transform.mutable_translation()->set_y(t * 0.03);
    transform.mutable_rotation()->set_w(1);
    bench.push("transforms", transforms, t);
    if (i % 9 != 0) continue;
    foxglove::Log log;
    log.set_level(static_cast<foxglove::Log::Level>(1 + i / 9 % 4));
    log.set_name(i % 2 == 0 ? "cognition/ball-percept" : "motion/walk");
    log.set_message(texts[i / 9 % 5]);
    bench.push(i % 4 == 0 ? "blue1/log" : "red1/log", log, t);
  }
}

/// A whole robot's worth of everything.
void fill(Bench& bench) {
  pushKeys(bench);
  pushTasks(bench);
  pushProcesses(bench);
  pushValues(bench);
}

QImage look(Bench& bench, widgets::View& view) {
  for (int i = 0; i < 7; ++i) bench.tick(view);
  QCoreApplication::processEvents();
  return view.grab().toImage();
}

template <typename V>
void compareLooks(const char* name, QSize size, const std::function<void(V&)>& arrange = {}) {
  Bench bench;
  fill(bench);
  auto view = bench.open<V>(size);
  look(bench, *view);
  if (arrange) arrange(*view);
  const QPalette light = QApplication::palette();
  const QImage day = look(bench, *view);
  QApplication::setPalette(darkPalette());
  const QImage night = look(bench, *view);
  QApplication::setPalette(light);
  keepPicture(day, (std::string(name) + "-light").c_str());
  keepPicture(night, (std::string(name) + "-dark").c_str());
  // Paper is bright by day and dark by night: whoever paints a fixed color behind his texts fails.
  const auto brightness = [](const QImage& image) {
    const QImage one = image.scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    return one.pixelColor(0, 0).lightnessF();
  };
  QVERIFY(brightness(day) > 0.7);
  QVERIFY(brightness(night) < 0.4);
}

bool isEmpty(const QAbstractItemModel& model, int column, const QModelIndex& parent = {}) {
  for (int row = 0; row < model.rowCount(parent); ++row) {
    if (!model.index(row, column, parent).data().toString().isEmpty()) return false;
    if (!isEmpty(model, column, model.index(row, 0, parent))) return false;
  }
  return true;
}

/// What is wrong with the widths of the columns, `names` of which hold what rows are found by.
QString wrongColumns(const QAbstractItemView& items, const QHeaderView& header, std::vector<int> names) {
  const int room = items.viewport()->width();
  for (const int column : names) {
    if (header.sectionSize(column) < std::min(items.sizeHintForColumn(column), room * 3 / 4))
      return QStringLiteral("the name in column %1 is cut").arg(column);
  }
  int sum = 0;
  for (int column = 0; column < header.count(); ++column) {
    sum += header.sectionSize(column);
    if (header.sectionSize(column) > room / 3 && isEmpty(*items.model(), column))
      return QStringLiteral("the empty column %1 is wide").arg(column);
  }
  return sum < room ? QStringLiteral("they leave %1 pixels").arg(room - sum) : QString();
}

template <typename V>
void checkColumns(const char* items, QSize size, const std::vector<int>& names) {
  Bench bench;
  fill(bench);
  auto view = bench.open<V>(size);
  look(bench, *view);
  auto& shown = child<QAbstractItemView>(*view, items);
  const auto* table = qobject_cast<const QTableView*>(&shown);
  const auto* tree = qobject_cast<const QTreeView*>(&shown);
  const QHeaderView& header = table != nullptr ? *table->horizontalHeader() : *tree->header();
  QTRY_COMPARE(wrongColumns(shown, header, names), QString());
}

}  // namespace

/// Every view with realistic contents, in light and dark. With ROBOTCONTROL_TEST_PICTURES=FOLDER the pictures
/// are kept, to be looked at.
class LooksTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(QApplication::style()->standardPalette());
  }

  void namesAreWholeAndEmptyColumnsNarrowInNarrowViews() {
    for (const int width : {300, 380, 640}) {
      checkColumns<widgets::DebugKeysView>("keysTree", {width, 460}, {0});
      checkColumns<widgets::SolutionsView>("solutionsTree", {width, 460}, {0, 1});
      checkColumns<widgets::MessagesView>("messagesTable", {width, 320}, {1, 2, 3});
      checkColumns<widgets::ProcessesView>("processesTable", {width, 460}, {0, 1});
      checkColumns<widgets::TimingView>("timingTable", {width, 260}, {0, 1, 2});
      checkColumns<widgets::PlotsView>("plotsTree", {2 * width, 260}, {0});
    }
  }

  void debugKeysFollowThePalette() { compareLooks<widgets::DebugKeysView>("keys", {380, 460}); }
  void solutionsFollowThePalette() {
    compareLooks<widgets::SolutionsView>("solutions", {460, 560}, [](widgets::SolutionsView& view) {
      click(child<QToolButton>(view, "solutionsParameters"));
      auto& tree = child<QTreeView>(view, "solutionsTree");
      tree.setCurrentIndex(tree.model()->index(0, 0, tree.model()->index(0, 0)));
    });
  }
  void messagesFollowThePalette() { compareLooks<widgets::MessagesView>("messages", {860, 320}); }
  void theMotionTesterFollowsThePalette() { compareLooks<widgets::MotionView>("motion", {640, 560}); }
  void processesFollowThePalette() { compareLooks<widgets::ProcessesView>("processes", {1100, 620}); }
  void timingFollowsThePalette() { compareLooks<widgets::TimingView>("timing", {760, 260}); }
  void plotsFollowThePalette() {
    compareLooks<widgets::PlotsView>("plots", {900, 460}, [](widgets::PlotsView& view) {
      for (const char* curve : {"x", "y", "z"}) {
        view.addCurve(QStringLiteral("red1/plots/ball-model/position/") + QString::fromLatin1(curve));
      }
    });
  }
};

const GuiTest<LooksTest> kLooksTest;

}  // namespace widgets::test

#include "LooksTest.moc"
