// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QMessageBox>
#include <QTimer>
#include <cctype>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "app/core/Workbench.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/QuitSignals.h"
#include "robotlink/base/Resources.h"
#include "simcore/SceneFileKind.h"

namespace {

enum ExitStatus { kDone = 0, kFailed = 1, kUsage = 2 };

struct Arguments {
  std::vector<std::string> files;
  std::string layout;
  std::string map;
  std::string robot;  ///< model of the robots to add; empty: see simcore::RobotsToAdd
  std::string teams = "both";
  int robots = -1;  ///< number of robots to add; negative: one to a map, else none
  bool kinematic = false;
  int port = 0;  ///< TCP port of the first robot; 0: none
  std::uint64_t seed = 1;
  bool paused = false;
  std::string perspective;
  std::string screenshot;
  double after = 5;
  std::vector<std::string> commands;
};

/// "A world (.sdf, .world) or ...; or a log file ...": all that the platforms open.
std::string helpOnFiles() {
  std::string help;
  for (const app::PlatformAdapter& adapter : app::platformAdapters())
    help += std::string(help.empty() ? "" : "; or ") + adapter.sources;
  help.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(help.front())));
  return help + "; the field of 2002 if none is given";
}

/// "burger, ers210, p3at": of those that can be put into a world.
std::string modelNames() {
  std::string names;
  for (const auto& robot : app::Workbench::simulatedRobots())
    names += (names.empty() ? "" : ", ") + robot.name;
  return names;
}

void define(CLI::App& app, Arguments& arguments) {
  app.set_version_flag("--version", ROBOTCONTROL_VERSION);
  app.add_option("files", arguments.files, helpOnFiles());
  app.add_option("--layout", arguments.layout, "A process layout: a file, or the name of a shipped one");
  app.add_option("--robots", arguments.robots, "Simulated robots to add to the world (a map: 1)")
      ->check(CLI::Range(0, 100));
  app.add_option("--robot", arguments.robot,
                 "Their model: " + modelNames() + " (those of the world, if it has any; else " +
                     simcore::RobotsToAdd{}.model + ")");
  app.add_option("--teams", arguments.teams, "Their teams, if they play: both, red or blue")
      ->check(CLI::IsMember({"both", "red", "blue"}))
      ->capture_default_str();
  app.add_flag("--kinematic", arguments.kinematic,
               "Simulated robots on wheels are moved by their odometry, without forces");
  app.add_option(
         "--arcos", arguments.port,
         "The first simulated robot that speaks ARCOS listens at this TCP port, the next at the next one")
      ->check(CLI::Range(1, 65435));
  app.add_option("--map", arguments.map, "Map of where a real robot drives");
  app.add_option("--seed", arguments.seed, "Seed of the simulation's noise")->capture_default_str();
  app.add_flag("--paused", arguments.paused, "Do not start the simulation; logs are always opened paused");
  app.add_option("--perspective", arguments.perspective,
                 "The perspective to show: Play, Log, Colour, Motion, Processes, Drive, or one of your own; "
                 "by default Drive for a map or a real robot, Log for logs");
  app.add_option("--command", arguments.commands, "Run a command at the start; may be given several times")
      ->expected(1)
      ->take_all();
  app.add_option("--screenshot", arguments.screenshot,
                 "Save a picture of the window to this PNG file and quit; works without a display");
  app.add_option("--after", arguments.after, "When to take the picture, seconds after the start")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
}

bool hasDisplay() {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return set("DISPLAY") || set("WAYLAND_DISPLAY") || set("QT_QPA_PLATFORM");
}

/// Whether the first of the files and addresses is of a platform whose time goes so.
bool opens(const Arguments& arguments, app::PlatformTime time) {
  if (arguments.files.empty()) return false;
  const app::PlatformAdapter* adapter = app::adapterFor(arguments.files.front());
  return adapter != nullptr && adapter->time == time;
}

bool connectsRobot(const Arguments& arguments) {
  return opens(arguments, app::PlatformTime::kReal);
}

bool opensLogs(const Arguments& arguments) {
  return opens(arguments, app::PlatformTime::kLogged);
}

/// Empty: the one that was shown last. Who opens a map, a real robot or a log wants to see what belongs to
/// it.
std::string perspectiveOf(const Arguments& arguments) {
  if (!arguments.perspective.empty() || arguments.files.empty()) return arguments.perspective;
  if (opensLogs(arguments)) return "Log";
  return simcore::isMapFile(arguments.files.front()) || connectsRobot(arguments) ? "Drive" : "";
}

app::RunOptions simulationOf(const Arguments& arguments) {
  app::RunOptions options = app::Workbench::defaultOptions();
  if (!arguments.files.empty()) options.scene = arguments.files.front();
  if (!arguments.layout.empty()) options.layout = app::Workbench::layoutNamed(arguments.layout);
  options.world.seed = arguments.seed;
  options.world.kinematic = arguments.kinematic;
  // Whoever names a model wants a robot of it.
  if (arguments.robots >= 0 || !arguments.robot.empty()) {
    options.robots = simcore::RobotsToAdd{.model = arguments.robot,
                                          .count = arguments.robots >= 0 ? arguments.robots : 1,
                                          .seed = arguments.seed,
                                          .teams = app::teamsNamed(arguments.teams)};
  }
  if (arguments.port > 0) {
    options.ports.emplace();
    options.ports->firstPort = static_cast<std::uint16_t>(arguments.port);
  }
  return options;
}

/// Loads what the command line asks for. Returns false if that is invalid.
bool load(app::Workbench& workbench, const Arguments& arguments) {
  if (connectsRobot(arguments)) {
    app::PioneerOptions options{.url = arguments.files.front()};
    if (!arguments.layout.empty()) options.layout = app::Workbench::layoutNamed(arguments.layout);
    options.map = arguments.map;
    workbench.connectRobot(std::move(options));
    return arguments.files.size() == 1;
  }
  if (!opensLogs(arguments)) {
    if (arguments.files.size() > 1) {
      std::cerr << "robotcontrol: one world can be simulated at a time; several files must all be logs\n";
      return false;
    }
    workbench.load(simulationOf(arguments));
    return true;
  }
  std::vector<app::ReplayLog> logs;
  for (const std::string& file : arguments.files) {
    if (const auto* adapter = app::adapterFor(file); adapter->time == app::PlatformTime::kSimulated) {
      std::cerr << "robotcontrol: " << file << " is a world; it cannot be opened together with logs\n";
      return false;
    }
    logs.push_back({file});
  }
  workbench.openLogs(std::move(logs), arguments.layout.empty()
                                          ? std::filesystem::path()
                                          : app::Workbench::layoutNamed(arguments.layout));
  return true;
}

/// Starts the simulation when it is loaded, then runs the commands of the command line one after the other,
/// each after everything that the previous one opens is loaded.
class Script : public QObject {
 public:
  Script(app::Workbench& workbench, const Arguments& arguments, QObject* parent)
      : QObject(parent),
        workbench_(workbench),
        lines_(arguments.commands),
        start_(!arguments.paused && !opensLogs(arguments) && !connectsRobot(arguments)) {
    startTimer(20);
  }

 protected:
  void timerEvent(QTimerEvent* event) override {
    if (workbench_.loading()) return;
    if (start_ && workbench_.loaded() != nullptr) run("simulation.start");
    start_ = false;
    while (next_ < lines_.size() && !workbench_.loading()) run(lines_[next_++]);
    if (next_ == lines_.size()) killTimer(event->timerId());
  }

 private:
  void run(const std::string& line) {
    const auto done = workbench_.commands().runLine(line);
    if (!done) std::cerr << "robotcontrol: " << line << ": " << done.error().describe() << "\n";
  }

  app::Workbench& workbench_;
  const std::vector<std::string> lines_;
  bool start_;
  std::size_t next_ = 0;
};

const char* wordFor(QtMsgType type) {
  switch (type) {
    case QtDebugMsg:
    case QtInfoMsg:
      return "Qt says";
    case QtWarningMsg:
      return "Qt warns";
    case QtCriticalMsg:
    case QtFatalMsg:
      break;
  }
  return "Qt error";
}

/// Prints messages of Qt to stderr, except for warnings about what windows cannot do without a display.
void handleQtMessage(QtMsgType type, const QMessageLogContext& where, const QString& text) {
  if (text.startsWith(QLatin1String("This plugin does not support"))) return;
  std::cerr << "robotcontrol: " << wordFor(type) << ": " << text.toStdString();
  if (where.category != nullptr && std::string_view(where.category) != "default")
    std::cerr << " (" << where.category << ")";
  std::cerr << std::endl;
  if (type == QtFatalMsg) std::abort();
}

/// Sets a usual font size, since the offscreen plugin has no desktop from which to take it.
void useFontOfDesktops() {
  if (QGuiApplication::platformName() != QLatin1String("offscreen")) return;
  QFont font = QApplication::font();
  font.setPointSizeF(9);
  QApplication::setFont(font);
}

int takePicture(app::MainWindow& window, const std::string& file) {
  if (window.grab().save(QString::fromStdString(file))) return kDone;
  std::cerr << file << ": the picture could not be written\n";
  return kFailed;
}

int run(const Arguments& arguments) {
  app::QuitSignals quitSignals;  // until the workbench has written the rest of its recording
  app::Workbench workbench(robotlink::userDirectory());
  app::MainWindow window(workbench, robotlink::userDirectory());
  if (const std::string perspective = perspectiveOf(arguments); !perspective.empty()) {
    window.showPerspective(QString::fromStdString(perspective));
  }
  QObject::connect(&window, &app::MainWindow::closed, &window, [] { QApplication::quit(); });
  QObject::connect(&quitSignals, &app::QuitSignals::received, &window, [&window] {
    window.keep();
    QApplication::quit();
  });
  window.show();
  if (!load(workbench, arguments)) return kUsage;
  new Script(workbench, arguments, &window);
  if (!arguments.screenshot.empty()) {
    QTimer::singleShot(static_cast<int>(arguments.after * 1000), &window,
                       [&] { QApplication::exit(takePicture(window, arguments.screenshot)); });
  }
  const int status = QApplication::exec();
  if (const auto kept = workbench.keepKeys(); !kept) std::cerr << kept.error().describe() << "\n";
  return status;
}

/// Says why the program cannot begin: who started it from a desktop does not see what it prints.
int refuse(const std::string& why, char** argv) {
  std::cerr << "robotcontrol: " << why << "\n";
  if (::isatty(STDERR_FILENO) == 1 || std::getenv("QT_QPA_PLATFORM") != nullptr || !hasDisplay())
    return kFailed;
  int qtArguments = 1;
  QApplication application(qtArguments, argv);
  QMessageBox box(QMessageBox::Critical, QStringLiteral("RobotControl"), QString::fromStdString(why));
  box.setTextFormat(Qt::PlainText);
  box.exec();
  return kFailed;
}

/// The program; its arguments are those of main().
int start(int argc, char** argv) {
  Arguments arguments;
  CLI::App parser("RobotControl, a workbench for debugging the control programs of robots", "robotcontrol");
  define(parser, arguments);
  try {
    parser.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return parser.exit(success);
  } catch (const CLI::ParseError& error) {
    parser.exit(error);
    return kUsage;
  }
  if (const auto found = robotlink::checkResources(); !found) {
    return refuse(found.error().describe(), argv);
  }
  if (!hasDisplay()) {
    if (arguments.screenshot.empty()) {
      std::cerr << "There is no display to open a window on: DISPLAY and WAYLAND_DISPLAY are not set.\n";
      return kUsage;
    }
    ::setenv("QT_QPA_PLATFORM", "offscreen", 1);
  }
  qInstallMessageHandler(handleQtMessage);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  int qtArguments = 1;
  QApplication application(qtArguments, argv);
  QApplication::setApplicationName(QStringLiteral("RobotControl"));
  QApplication::setApplicationVersion(QStringLiteral(ROBOTCONTROL_VERSION));
  useFontOfDesktops();
  return run(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return start(argc, argv);
  } catch (const std::exception& exception) {
    std::cerr << "robotcontrol: " << exception.what() << "\n";
    return kFailed;
  }
}
