// SPDX-License-Identifier: GPL-3.0-or-later
// The program robotcontrol: reads the command line, wires the workbench and opens its window.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QMessageBox>
#include <QTimer>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string_view>

#include "app/core/Workbench.h"
#include "app/core/own/OwnProgramMain.h"
#include "app/core/platform/ExitStatus.h"
#include "app/core/platform/FieldOptions.h"
#include "app/core/platform/NumberRange.h"
#include "app/core/platform/PlatformAdapter.h"
#include "app/core/plugins/Plugins.h"
#include "app/core/program/Abandoned.h"
#include "app/core/program/ShippedFiles.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/QuitSignals.h"
#include "app/robotcontrol/StartScript.h"
#include "app/robotcontrol/language/Language.h"
#include "robotlink/base/KeptMemory.h"
#include "robotlink/base/Resources.h"
#include "robotlink/commands/CommandLine.h"
#include "robotlink/commands/CommandSocket.h"
#include "robotlink/foxglove/client/ServerUrl.h"

namespace {

using app::kDone, app::kFailed, app::kUsage;

struct Arguments {
  /// Files, or an address, and URLs of remote robots, as they were given.
  std::vector<std::string> sources;
  /// The files or the address to open, and the URLs of remote robots.
  std::vector<std::string> files, servers;
  std::string token;
  /// The place where the programs of remote robots run: "there", or "here" if only their bodies are there.
  std::string program = "there";
  /// The options that follow from the platforms' forms.
  app::FieldOptions platform;
  bool paused = false;
  std::string perspective;
  std::string preset;
  std::string screenshot;
  double after = 5;
  std::vector<std::string> commands;
  std::string script, junit;
  bool keepOpen = false;
};

/// "A world (.sdf, .world) or ...; or a log file ...": all that the platforms open.
std::string helpOnFiles() {
  std::string help;
  for (const app::PlatformAdapter& adapter : app::platformAdapters())
    help += std::string(help.empty() ? "" : "; or ") + adapter.sources;
  help.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(help.front())));
  return help +
         "; or remote robots (ws://HOST[:PORT]), "
         "in addition to what else is "
         "opened; by default the field of 2002";
}

/// The options about what robots' programs are.
void defineProgramOptions(CLI::App& app, Arguments& arguments) {
  // Joins the values of an option, one per line.
  const auto linesOf = [&](const char* option, const char* value, const char* help) {
    app.add_option_function<std::vector<std::string>>(
           option,
           [&arguments, value](const std::vector<std::string>& texts) {
             std::string lines;
             for (const std::string& text : texts) lines += (lines.empty() ? "" : "\n") + text;
             arguments.platform.values[value] = lines;
           },
           help)
        ->expected(1)
        ->take_all();
  };
  linesOf("--layout", "layout",
          "A process layout: a file, or the name of a shipped one; for a simulation also NAME=LAYOUT for one "
          "robot, team or kind of robots, several times");
  linesOf(
      "--solution", "solution",
      "TASK=SOLUTION to start with in a simulation, instead of the layout's, or NAME/TASK=SOLUTION for one "
      "robot or team; several times");
}

void define(CLI::App& app, Arguments& arguments) {
  app.set_version_flag("--version", ROBOTCONTROL_VERSION);
  app.add_option("files", arguments.sources, helpOnFiles());
  app.add_option("--token", arguments.token, "The token of the robots at these URLs");
  app.add_option("--program", arguments.program,
                 "With a remote robot: whether its program runs there, or here if only its body is there "
                 "(robotctl platform)")
      ->check(CLI::IsMember({"there", "here"}))
      ->capture_default_str();
  defineProgramOptions(app, arguments);
  for (const app::PlatformAdapter& adapter : app::platformAdapters()) {
    for (const app::PlatformField& field : formOf(adapter).fields) {
      if (!field.option.empty()) arguments.platform.addTo(app, field);
    }
  }
  app.add_flag("--paused", arguments.paused, "Do not start the simulation; logs are always opened paused");
  app.add_option("--perspective", arguments.perspective,
                 "The perspective to show: Play, Log, Colour, Motion, Processes, Drive, or one of your own; "
                 "by default Drive for a map or a real robot, Log for logs");
  app.add_option("--preset", arguments.preset,
                 "The preset to load: debug keys, solutions, parameters and views that were saved under this "
                 "name, or the path of its file");
  app.add_option("--command", arguments.commands, "Run a command at the start; may be given several times")
      ->expected(1)
      ->take_all();
  auto* script =
      app.add_option("--script", arguments.script,
                     "Run a script, then quit; the exit status is 1 if a line fails. Works without a display")
          ->check(CLI::ExistingFile);
  app.add_flag("--keep-open", arguments.keepOpen, "Do not quit at the end of the script")->needs(script);
  app.add_option("--junit", arguments.junit, "Write the result of the script to this JUnit XML file")
      ->needs(script);
  app.add_option_function<std::vector<std::string>>(
         "--plugin", [](const auto&) {}, "Also load this plug-in; may be given several times")
      ->expected(1)
      ->take_all();
  app.add_flag_function(
      "--no-plugins", [](auto) {}, "Do not load the plug-ins in the user's folder");
  app.add_option("--screenshot", arguments.screenshot,
                 "Save a picture of the window to this PNG file and quit; works without a display");
  app.add_option("--after", arguments.after, "When to take the picture, in seconds after the start")
      ->check(app::numberFrom(0, 3600))
      ->capture_default_str();
}

bool hasDisplay() {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return set("DISPLAY") || set("WAYLAND_DISPLAY") || set("QT_QPA_PLATFORM");
}

/// The file of a shipped scene if that is what is named, and there is no such file; else the source itself.
std::string fileOf(const std::string& source) {
  std::error_code ignored;
  return std::filesystem::exists(source, ignored) ? source : app::sceneNamed(source).string();
}

/// The files or the address to open; the default scene if none is given.
std::vector<std::string> sourcesOf(const Arguments& arguments) {
  if (!arguments.files.empty()) return arguments.files;
  return {app::defaultSimulation().scene.string()};
}

/// Whether what is opened is a simulation, which is started.
bool simulates(const Arguments& arguments) {
  if (arguments.files.empty() && !arguments.servers.empty()) return false;
  const app::PlatformAdapter* adapter = app::adapterFor(sourcesOf(arguments).front());
  return adapter != nullptr && adapter->time == app::TimeKind::kSimulated;
}

/// Empty: the one that was shown last. Who opens a map, a real robot or a log wants to see what belongs to
/// it.
std::string perspectiveOf(const Arguments& arguments) {
  if (!arguments.perspective.empty() || arguments.files.empty()) return arguments.perspective;
  const std::string& source = arguments.files.front();
  const app::PlatformAdapter* adapter = app::adapterFor(source);
  return adapter != nullptr && adapter->perspective != nullptr ? adapter->perspective(source) : "";
}

/// Loads what the command line asks for. Returns false if that is invalid.
bool load(app::Workbench& workbench, const Arguments& arguments) {
  for (const std::string& url : arguments.servers) {
    const auto connected = workbench.connectRemote(url, arguments.token);
    if (connected) continue;
    std::cerr << "robotcontrol: " << connected.error().describe() << "\n";
    return false;
  }
  if (arguments.files.empty() && !arguments.servers.empty()) return true;
  auto opening = app::openingOf({sourcesOf(arguments), arguments.platform.values});
  if (!opening) {
    std::cerr << "robotcontrol: " << opening.error().describe() << "\n";
    return false;
  }
  workbench.open(std::move(*opening));
  return true;
}

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

/// Whether the tour starts by itself: only with the default scene, and never for scripts and pictures, which
/// it would cover.
bool wantsTour(const app::MainWindow& window, const Arguments& arguments) {
  return window.isFirstStart() && arguments.sources.empty() && arguments.script.empty() &&
         arguments.screenshot.empty() && QGuiApplication::platformName() != QLatin1String("offscreen");
}

int takePicture(app::MainWindow& window, const std::string& file) {
  if (window.grab().save(QString::fromStdString(file))) return kDone;
  std::cerr << file << ": the picture could not be written\n";
  return kFailed;
}

/// Lets other programs of the user run commands here: robotctl do. What it refers to must outlive the window.
void listenForCommands(robotlink::CommandSocket& socket, const robotlink::Clock& clock,
                       app::MainWindow& window) {
  const auto folder = robotlink::commandSocketFolder();
  if (folder.empty()) return;
  if (const auto opened = socket.open(folder); !opened) {
    std::cerr << "robotcontrol: " << opened.error().describe() << "\n";
    return;
  }
  constexpr int kTickMs = 33;
  auto* tick = new QTimer(&window);
  QObject::connect(tick, &QTimer::timeout, &window, [&socket, &clock] { socket.tick(clock.now()); });
  tick->start(kTickMs);
}

int run(const Arguments& arguments) {
  app::QuitSignals quitSignals;  // until the workbench has written the rest of its recording
  app::Workbench workbench(robotlink::userDirectory());
  const robotlink::SteadyClock clock;
  robotlink::CommandSocket socket(app::scriptsOf(workbench));
  // The state that a script leaves behind must not replace that of the user at the next start.
  const bool isOfScript = !arguments.script.empty() && !arguments.keepOpen;
  if (isOfScript) workbench.keepNothing();
  app::MainWindow window(workbench, robotlink::userDirectory(),
                         isOfScript ? app::MainWindow::Owner::kScript : app::MainWindow::Owner::kUser);
  if (const std::string perspective = perspectiveOf(arguments); !perspective.empty()) {
    window.choosePerspective(QString::fromStdString(perspective));
  }
  QObject::connect(&window, &app::MainWindow::closed, &window, [] { QApplication::quit(); });
  QObject::connect(&quitSignals, &app::QuitSignals::received, &window, [&window] {
    window.keep();
    QApplication::quit();
  });
  window.show();
  if (wantsTour(window, arguments)) window.showTour();
  if (!load(workbench, arguments)) return kUsage;
  listenForCommands(socket, clock, window);
  std::vector<std::string> commands = arguments.commands;
  if (!arguments.preset.empty())
    commands.insert(commands.begin(), "preset.load " + robotlink::quotedWord(arguments.preset));
  auto* script = new app::StartScript(workbench,
                                      {.startsSimulation = !arguments.paused && simulates(arguments),
                                       .commands = commands,
                                       .script = arguments.script,
                                       .junit = arguments.junit},
                                      &window);
  QObject::connect(script, &app::StartScript::finished, &window, [&](int status) {
    if (arguments.keepOpen) return;
    window.keep();
    QApplication::exit(status);
  });
  if (!arguments.screenshot.empty()) {
    QTimer::singleShot(static_cast<int>(arguments.after * 1000), &window,
                       [&] { QApplication::exit(takePicture(window, arguments.screenshot)); });
  }
  const int status = QApplication::exec();
  if (const auto kept = workbench.keepKeys(); !kept) std::cerr << kept.error().describe() << "\n";
  return status;
}

/// Says why the program cannot begin: a user who started it from a desktop does not see its output.
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
  const bool isHere = arguments.program == "here";
  if (isHere && !arguments.token.empty()) arguments.platform.values["token"] = arguments.token;
  for (const std::string& source : arguments.sources) {
    const bool isServer = robotlink::websocket::isServerUrl(source) && !isHere;
    (isServer ? arguments.servers : arguments.files).push_back(isServer ? source : fileOf(source));
  }
  if (const auto found = robotlink::checkResources(); !found) {
    return refuse(found.error().describe(), argv);
  }
  if (!hasDisplay()) {
    if (arguments.screenshot.empty() && arguments.script.empty()) {
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
  app::useNumbersWithPoints();
  useFontOfDesktops();
  const app::Translation translation(app::savedLanguage(robotlink::userDirectory() / "window.json"));
  if (!translation.problem().isEmpty())
    std::cerr << "robotcontrol: " << translation.problem().toStdString() << "\n";
  const int status = run(arguments);
  // A module that never returns does not keep the program.
  app::leave(status);
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  if (const auto status = app::ownProgramMain(argc, argv)) return *status;
  robotlink::keepFreedMemory();
  app::loadPlugins(app::pluginOptions(argc, argv));
  try {
    return start(argc, argv);
  } catch (const std::exception& exception) {
    std::cerr << "robotcontrol: " << exception.what() << "\n";
    return kFailed;
  }
}
