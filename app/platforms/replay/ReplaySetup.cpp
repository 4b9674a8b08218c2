// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplaySetup.h"

#include "app/core/program/RobotFiles.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/config/RobotUse.h"

namespace app {

using robotcontrol::ProgramSetup;
using robotlink::Errors;
using robotlink::FieldDescription;
using robotlink::Layout;
using robotlink::RobotDescription;

namespace {

/// The kind of robot that is assumed for logs that do not say.
constexpr char kRobotOfOldLogs[] = "ers210";

/// Returns the logged file, if there is one, otherwise the one on disk.
tl::expected<ProgramSetup::File, Errors> fileOf(const ProgramSetup::File* logged,
                                                const std::filesystem::path& file) {
  if (logged != nullptr && !logged->text().empty()) return *logged;
  auto text = robotlink::readFile(file);
  if (!text) return tl::unexpected(Errors{text.error()});
  ProgramSetup::File read;
  read.set_name(file.string());
  read.set_text(std::move(*text));
  return read;
}

/// A description that cannot be read is reported later; the default takes its place.
RobotDescription described(const ProgramSetup::File& description) {
  auto robot = robotlink::parseRobotDescription(description.text(), description.name());
  return robot ? std::move(*robot) : RobotDescription();
}

/// Returns where a robot is used, as its description says. Descriptions in older logs do not; then that of
/// the shipped robot of this name counts, if there is one.
robotlink::RobotUse useOf(const ProgramSetup::File& description, const std::string& kind) {
  auto use = robotlink::parseRobotUse(description.text(), description.name());
  const bool says = use && (!use->teams.empty() || !use->field.empty());
  if (!says) use = readUse(kind);
  return use ? std::move(*use) : robotlink::RobotUse();
}

/// Returns the texts of layout, description and field.
tl::expected<ProgramSetup, Errors> filesOf(const ProgramSetup* logged, const std::string& robot,
                                           const std::filesystem::path& layout) {
  const auto own = descriptionFile(robot);
  std::error_code error;
  const bool known = robot.find('/') == std::string::npos && std::filesystem::exists(own, error);
  ProgramSetup files;
  const auto take = [&](const ProgramSetup::File* from, const std::filesystem::path& file,
                        ProgramSetup::File* to) {
    auto read = fileOf(from, file);
    if (read) *to = std::move(*read);
    return read ? Errors{} : read.error();
  };
  const Errors ofRobot = take(logged != nullptr ? &logged->description() : nullptr,
                              known ? own : descriptionFile(kRobotOfOldLogs), files.mutable_description());
  const RobotDescription kind = described(files.description());
  Errors errors = take(logged != nullptr && layout.empty() ? &logged->layout() : nullptr,
                       layout.empty() ? layoutFile(kind) : layout, files.mutable_layout());
  const std::filesystem::path field = fieldFile(useOf(files.description(), kind.name).field);
  const bool loggedField = logged != nullptr && !logged->field().text().empty();
  // An empty list if there is no field at all.
  Errors ofField;
  if (loggedField || !field.empty())
    ofField = take(loggedField ? &logged->field() : nullptr, field, files.mutable_field());
  errors.insert(errors.end(), ofRobot.begin(), ofRobot.end());
  errors.insert(errors.end(), ofField.begin(), ofField.end());
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return files;
}

/// Chooses the solutions that were active in the recording.
void choose(Layout& layout, const ProgramSetup& logged) {
  for (const auto& choice : logged.solutions()) {
    for (auto& process : layout.processes) {
      for (auto& task : process.tasks) {
        if (task.task == choice.task()) task.solution = choice.solution();
      }
    }
  }
}

bool sameFile(const ProgramSetup::File& one, const ProgramSetup::File& other) {
  return one.name() == other.name() && one.text() == other.text();
}

/// Reads a setup; fails if a logged part cannot be used.
tl::expected<ReplaySetup, Errors> read(const ProgramSetup* logged, const std::string& robot,
                                       const std::filesystem::path& layoutFile) {
  auto files = filesOf(logged, robot, layoutFile);
  if (!files) return tl::unexpected(files.error());
  auto layout = robotlink::parseLayout(files->layout().text(), files->layout().name());
  if (!layout) return tl::unexpected(layout.error());
  auto description =
      robotlink::parseRobotDescription(files->description().text(), files->description().name());
  if (!description) return tl::unexpected(description.error());
  const bool hasField = !files->field().text().empty();
  auto field = hasField ? FieldDescription::parse(files->field().text(), files->field().name())
                        : tl::expected<FieldDescription, Errors>(FieldDescription());
  if (!field) return tl::unexpected(field.error());
  ReplaySetup setup;
  setup.layout = std::move(*layout);
  setup.layoutFromLog = layoutFile.empty();
  setup.files = std::move(*files);
  if (logged != nullptr && setup.layoutFromLog) choose(setup.layout, *logged);
  setup.robot.name = robot;
  if (logged != nullptr) {
    setup.robot.team = logged->team();
    setup.parameters.assign(logged->parameters().begin(), logged->parameters().end());
  }
  if (setup.robot.team.empty())
    setup.robot.team = useOf(setup.files.description(), description->name).teamOf(robot);
  setup.robot.description = std::make_shared<const RobotDescription>(std::move(*description));
  setup.robot.field = std::make_shared<const FieldDescription>(std::move(*field));
  return setup;
}

}  // namespace

tl::expected<ReplaySetup, Errors> readReplaySetup(const ProgramSetup* logged, const std::string& robot,
                                                  const std::filesystem::path& layoutFile) {
  auto setup = read(logged, robot, layoutFile);
  if (setup || logged == nullptr) return setup;
  auto shipped = read(nullptr, robot, layoutFile);
  // The log is not all that is wrong; report its errors.
  if (!shipped) return setup;
  shipped->notes.push_back("the program's setup in the log cannot be used; shipped files are used instead: " +
                           robotlink::describe(setup.error()));
  return shipped;
}

Layout emptyLayout(const Layout& instead) {
  Layout layout;
  layout.name = instead.name;
  layout.file = instead.file;
  Layout::Process debug;
  debug.name = "debug";
  debug.debug = true;
  debug.period = std::chrono::milliseconds(16);
  layout.processes.push_back(std::move(debug));
  return layout;
}

bool isAnotherProgram(const ProgramSetup& one, const ProgramSetup& other) {
  return !sameFile(one.layout(), other.layout()) || !sameFile(one.description(), other.description()) ||
         !sameFile(one.field(), other.field());
}

}  // namespace app
