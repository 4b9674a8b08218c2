// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/Deployment.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "app/core/deploy/ResourceFolder.h"
#include "app/core/deploy/RunningPrograms.h"
#include "app/core/platform/JsonOutput.h"
#include "app/core/program/ColorTables.h"
#include "app/core/program/PresetOverrides.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/foxglove/protocol/Base64.h"
#include "robotlink/foxglove/security/Digest.h"
#include "robotlink/process/Layout.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using robotlink::Error;
using robotlink::Errors;
using robotlink::Result;
using State = DeployDifference::State;
using Differences = std::vector<DeployDifference>;

/// The folder of layouts at robots.
constexpr std::string_view kLayouts = "layouts/";

/// Whether the robot has the file as it is here.
bool isThere(const DeployDifference& difference) {
  return difference.state == State::kSame || difference.state == State::kWaiting;
}

/// Reads the files that a robot should have, and notes their problems.
class DeployReader {
 public:
  explicit DeployReader(fs::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& source, const std::string& path) {
    if (!source.empty()) read(at(source), path);
  }
  /// All files with a suffix in a folder.
  void addFolder(const std::string& source, const std::string& suffix, const std::string& to) {
    if (source.empty()) return;
    std::error_code error;
    std::vector<fs::path> found;
    for (fs::directory_iterator file(at(source), error); !error && file != fs::directory_iterator();
         file.increment(error))
      if (robotlink::fileSuffix(file->path()) == suffix) found.push_back(file->path());
    std::ranges::sort(found);
    if (error) return fail(at(source), "the folder cannot be read: " + error.message());
    if (found.empty()) return fail(at(source), "there are no files *" + suffix + " in this folder");
    for (const fs::path& file : found) read(file, to + "/" + file.filename().string());
  }
  /// Notes what a robot could make nothing of.
  void checkContents(const RobotSet::Robot& robot) {
    std::error_code error;
    if (!robot.layout.empty() && fs::exists(at(robot.layout), error)) {
      if (const auto layout = robotlink::readLayout(at(robot.layout)); !layout)
        errors.insert(errors.end(), layout.error().begin(), layout.error().end());
    }
    if (!robot.colorTable.empty() && fs::exists(at(robot.colorTable), error)) {
      if (const auto table = readColorTable(at(robot.colorTable)); !table) errors.push_back(table.error());
    }
    if (!robot.preset.empty() && fs::exists(at(robot.preset), error)) {
      if (const auto preset = presetToStartWith(fs::absolute(at(robot.preset)).string()); !preset)
        errors.insert(errors.end(), preset.error().begin(), preset.error().end());
    }
  }
  fs::path at(const std::string& source) const { return (folder_ / source).lexically_normal(); }

  std::vector<DeployFile> files;
  Errors errors;

 private:
  void fail(const fs::path& file, const std::string& text) {
    errors.push_back({"deploy.file", text, {}, {file.string(), 0, 0}});
  }
  void read(const fs::path& file, const std::string& path) {
    auto contents = robotlink::readFile(file, ResourceFolder::kMaxFileBytes);
    if (!contents) return errors.push_back(contents.error());
    if (const auto allowed = ResourceFolder::check(path); !allowed) return fail(file, allowed.error().text);
    std::string digest = robotlink::websocket::sha256(*contents);
    files.push_back({path, file, *std::move(contents), std::move(digest)});
  }

  const fs::path folder_;
};

/// The name of a folder, also if its path ends with a slash.
std::string folderName(fs::path folder) {
  if (!folder.has_filename()) folder = folder.parent_path();
  return folder.filename().string();
}

/// A robot's answer to deploy/list.
struct RobotFileList {
  /// The checksums of its files, by path.
  std::map<std::string, std::string> digests;
  /// The files that its program has not read yet; and the layout in which it runs, empty if unknown.
  std::set<std::string> waiting;
  std::string layout;

  State stateOf(const DeployFile& file) const {
    const auto found = digests.find(file.path);
    if (found == digests.end()) return State::kMissing;
    if (found->second != file.sha256) return State::kDiffers;
    const bool isOtherLayout =
        !layout.empty() && file.path.starts_with(kLayouts) && file.path.substr(kLayouts.size()) != layout;
    return isOtherLayout || waiting.contains(file.path) ? State::kWaiting : State::kSame;
  }
};

/// Reads what the list says about a robot's program. Older robots say nothing.
void readProgram(const json& answer, const std::string& robot, RobotFileList& list) {
  const auto robots = answer.find("robots");
  if (robot.empty() || robots == answer.end() || !robots->is_array()) return;
  for (const json& one : *robots) {
    if (!one.is_object() || one.value("robot", json()) != json(robot)) continue;
    if (const json layout = one.value("layout", json()); layout.is_string())
      list.layout = layout.get<std::string>();
    for (const json& path : one.value("waiting", json::array()))
      if (path.is_string()) list.waiting.insert(path.get<std::string>());
  }
}

Result<RobotFileList> fileListIn(const std::string& answer, const std::string& robot) {
  const auto object = json::parse(answer, nullptr, false);
  const auto nonsense =
      robotlink::failure("deploy.answer", "the robot's answer to deploy/list is not understood");
  const auto files = object.is_object() ? object.find("files") : object.end();
  if (!object.is_object() || files == object.end() || !files->is_array()) return nonsense;
  RobotFileList list;
  for (const json& file : *files) {
    if (!file.is_object() || !file.value("path", json()).is_string() ||
        !file.value("sha256", json()).is_string())
      return nonsense;
    list.digests[file["path"].get<std::string>()] = file["sha256"].get<std::string>();
  }
  readProgram(object, robot, list);
  return list;
}

}  // namespace

tl::expected<std::vector<DeployFile>, Errors> filesFor(const RobotSet::Robot& robot, const fs::path& folder) {
  DeployReader reader(folder);
  reader.add(robot.layout, "layouts/" + fs::path(robot.layout).filename().string());
  reader.checkContents(robot);
  reader.add(robot.colorTable,
             std::string(kColorTables) + "/" + robot.name + robotlink::fileSuffix(robot.colorTable));
  reader.addFolder(robot.parameters, ".textproto", "parameters/" + folderName(reader.at(robot.parameters)));
  reader.addFolder(robot.motions, ".mof", "motions");
  reader.add(robot.preset, presetPathOf(robot.name));
  if (!reader.errors.empty()) return tl::unexpected(std::move(reader.errors));
  return std::move(reader.files);
}

PendingAnswer::Answer Deployment::ask(const std::string& service, const std::string& argument,
                                      const Progress& progress, double share) {
  auto answer = PendingAnswer(call_, service, argument).wait([&] { return !progress || progress(share); });
  if (!answer) return robotlink::failure("canceled", "canceled");
  return *std::move(answer);
}

Result<Differences> Deployment::check(const std::vector<DeployFile>& files, const Progress& progress) {
  const auto answer = ask("deploy/list", "{}", progress, 0);
  if (!answer) return tl::unexpected(answer.error());
  const auto list = fileListIn(*answer, robot_);
  if (!list) return tl::unexpected(list.error());
  Differences all;
  for (const DeployFile& file : files) all.push_back({file.path, list->stateOf(file)});
  return all;
}

Result<Differences> Deployment::send(const std::vector<DeployFile>& files, const Progress& progress) {
  const auto before = check(files, progress);
  if (!before) return before;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (isThere((*before)[i])) continue;
    const std::string argument =
        jsonMessage(json{{"path", files[i].path},
                         {"sha256", files[i].sha256},
                         {"content", robotlink::websocket::toBase64(files[i].contents)}});
    const double share = static_cast<double>(i) / static_cast<double>(files.size());
    if (const auto sent = ask("deploy/put", argument, progress, share); !sent)
      return tl::unexpected(sent.error());
  }
  auto after = check(files, progress);
  if (!after) return after;
  if (!std::ranges::all_of(*after, isThere))
    return robotlink::failure("deploy.differs", "after sending, " + describe(*after));
  return after;
}

Result<Differences> Deployment::restart(const std::vector<DeployFile>& files, const Progress& progress) {
  auto before = check(files, progress);
  if (!before || !needsRestart(*before)) return before;
  json argument{{"robot", robot_}};
  for (const DeployFile& file : files)
    if (file.path.starts_with(kLayouts)) argument["layout"] = file.path.substr(kLayouts.size());
  if (const auto done = ask("deploy/restart", jsonMessage(argument), progress, 0.5); !done)
    return robotlink::failure(done.error().id, "its program was not restarted: " + done.error().text);
  return check(files, progress);
}

bool needsRestart(const Differences& differences) {
  return std::ranges::any_of(differences, [](const auto& one) { return one.state == State::kWaiting; });
}

std::string describe(const Differences& differences) {
  std::string text;
  int count = 0;
  for (const DeployDifference& one : differences) {
    if (isThere(one)) continue;
    ++count;
    text +=
        (text.empty() ? ": " : ", ") + one.path + (one.state == State::kMissing ? " is missing" : " differs");
  }
  const std::string all = std::to_string(differences.size());
  if (differences.empty()) return "nothing to send";
  if (count > 0) return std::to_string(count) + " of " + all + " files differ" + text;
  const auto waiting =
      std::ranges::count_if(differences, [](const auto& one) { return one.state == State::kWaiting; });
  return "all of " + all + " files are the same" +
         (waiting == 0   ? ""
          : waiting == 1 ? "; 1 takes effect when its program starts again"
                         : "; " + std::to_string(waiting) + " take effect when its program starts again");
}

}  // namespace app
