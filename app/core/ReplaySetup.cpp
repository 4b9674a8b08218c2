// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ReplaySetup.h"

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"

namespace app {

using robotcontrol::ProgramSetup;
using robotlink::Errors;
using robotlink::FieldDescription;
using robotlink::Layout;
using robotlink::RobotDescription;

namespace {

constexpr char kFieldFile[] = "fields/2002.yaml";
constexpr char kRobotFile[] = "robots/ers210.yaml";

/// The log's, if it has one and no other is wished for, else one on the disk.
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

/// The one that a robot has unless another is chosen.
std::filesystem::path shippedLayout(const ProgramSetup::File& description) {
  const auto robot = robotlink::parseRobotDescription(description.text(), description.name());
  return robotlink::resource("layouts/" + (robot ? robot->layout : RobotDescription().layout) + ".yaml");
}

tl::expected<ProgramSetup, Errors> filesOf(const ProgramSetup* logged, const std::string& robot,
                                           const std::filesystem::path& layout) {
  const auto own = robotlink::resource("robots/" + robot + ".yaml");
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
                              known ? own : robotlink::resource(kRobotFile), files.mutable_description());
  Errors errors = take(logged != nullptr && layout.empty() ? &logged->layout() : nullptr,
                       layout.empty() ? shippedLayout(files.description()) : layout, files.mutable_layout());
  const Errors ofField = take(logged != nullptr ? &logged->field() : nullptr, robotlink::resource(kFieldFile),
                              files.mutable_field());
  errors.insert(errors.end(), ofRobot.begin(), ofRobot.end());
  errors.insert(errors.end(), ofField.begin(), ofField.end());
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return files;
}

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

tl::expected<ReplaySetup, Errors> read(const ProgramSetup* logged, const std::string& robot,
                                       const std::filesystem::path& layoutFile) {
  auto files = filesOf(logged, robot, layoutFile);
  if (!files) return tl::unexpected(files.error());
  auto layout = robotlink::parseLayout(files->layout().text(), files->layout().name());
  if (!layout) return tl::unexpected(layout.error());
  auto description =
      robotlink::parseRobotDescription(files->description().text(), files->description().name());
  if (!description) return tl::unexpected(description.error());
  auto field = FieldDescription::parse(files->field().text(), files->field().name());
  if (!field) return tl::unexpected(field.error());
  ReplaySetup setup;
  setup.layout = std::move(*layout);
  setup.layoutFromLog = layoutFile.empty();
  setup.files = std::move(*files);
  if (logged != nullptr && setup.layoutFromLog) choose(setup.layout, *logged);
  setup.parameters.folder = robotlink::resource("parameters/" + description->name);
  if (logged != nullptr) {
    setup.team = logged->team();
    setup.parameters.recorded.assign(logged->parameters().begin(), logged->parameters().end());
  }
  setup.description = std::make_shared<const RobotDescription>(std::move(*description));
  setup.field = std::make_shared<const FieldDescription>(std::move(*field));
  return setup;
}

}  // namespace

tl::expected<ReplaySetup, Errors> readReplaySetup(const ProgramSetup* logged, const std::string& robot,
                                                  const std::filesystem::path& layoutFile) {
  auto setup = read(logged, robot, layoutFile);
  if (setup || logged == nullptr) return setup;
  auto shipped = read(nullptr, robot, layoutFile);
  if (!shipped) return setup;  // What is wrong with the log is not all that is wrong.
  shipped->notes.push_back(
      "the program's set-up in the log cannot be used; shipped files are taken instead: " +
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
