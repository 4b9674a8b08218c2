// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/file/LogImport.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <utility>

#include "logplayer/base/LogWriter.h"
#include "logplayer/file/LogFormat.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/config/RobotUse.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"

namespace logplayer {

using robotcontrol::ProgramSetup;
using robotlink::Result;
using robotlink::StreamMessage;

namespace {

Result<void> readResource(const std::string& name, ProgramSetup::File& to) {
  const auto text = robotlink::readFile(robotlink::resource(name));
  if (!text) return tl::unexpected(text.error());
  to.set_name(name);
  to.set_text(*text);
  return {};
}

/// The setup of the program that replays such a log, after the description of its robot.
Result<std::shared_ptr<ProgramSetup>> setupOf(const LogFormat::Robot& robot, const ImportOptions& options) {
  const auto file = robotlink::resource(robot.description);
  const auto description = robotlink::readRobotDescription(file);
  if (!description) return tl::unexpected(description.error().front());
  const auto use = robotlink::readRobotUse(file);
  if (!use) return tl::unexpected(use.error().front());
  auto setup = std::make_shared<ProgramSetup>();
  setup->set_robot(options.robot);
  setup->set_team(use->teamOf(options.robot));
  setup->set_executor("lockstep");
  std::vector<std::pair<std::string, ProgramSetup::File*>> files{
      {"layouts/" + description->layout + ".yaml", setup->mutable_layout()},
      {robot.description, setup->mutable_description()}};
  if (!use->field.empty()) files.emplace_back("fields/" + use->field + ".yaml", setup->mutable_field());
  for (const auto& [name, to] : files) {
    if (auto read = readResource(name, *to); !read) return tl::unexpected(std::move(read.error()));
  }
  for (const std::string& package : description->offers) setup->add_offered(package);
  if (options.colorTable) setup->add_offered(robotlink::kColorTable.name);
  return setup;
}

/// Writes the setup at the time of the first frame, then the frames.
class ImportWriter {
 public:
  static Result<ImportWriter> create(const std::filesystem::path& file, const LogFormat::Robot& robot,
                                     const ImportOptions& options) {
    ImportWriter writer;
    if (robot.description != nullptr) {
      auto setup = setupOf(robot, options);
      if (!setup) return tl::unexpected(std::move(setup.error()));
      writer.opening_.push_back({options.robot + "/" + robotlink::streams::kProgram, {}, std::move(*setup)});
    }
    if (options.colorTable)
      writer.opening_.push_back({options.robot + "/" + robotlink::kColorTable.name, {}, options.colorTable});
    mcap::Writer::Options writing;
    writing.compression = mcap::Compression::kZstd;
    writing.library = "RobotControl";
    auto log = LogWriter::create(file, writing);
    if (!log) return tl::unexpected(std::move(log.error()));
    writer.log_ = std::move(*log);
    return writer;
  }

  Result<void> write(const std::vector<StreamMessage>& frame) {
    if (!opening_.empty()) {
      for (StreamMessage& message : opening_) message.time = frame.front().time;
      if (auto written = log_->write(opening_); !written) return written;
      opening_.clear();
    }
    return log_->write(frame);
  }

  Result<void> close(const ImportReport& report) {
    mcap::Metadata metadata{"robotcontrol.import",
                            {{"format", report.format}, {"messages", std::to_string(report.messages)}}};
    for (const auto& [kind, count] : report.imported)
      metadata.values["imported " + kind] = std::to_string(count);
    for (const auto& [kind, count] : report.notUnderstood)
      metadata.values["not understood " + kind] = std::to_string(count);
    if (!report.damage.empty()) metadata.values["damage"] = report.damage;
    if (auto added = log_->container().addMetadata(metadata); !added) return added;
    return log_->container().close();
  }

 private:
  std::vector<StreamMessage> opening_;
  std::unique_ptr<LogWriter> log_;
};

/// Returns the format of a file; null if no format reads it.
const LogFormat* formatOf(const std::filesystem::path& file) {
  const auto& formats = registeredLogFormats();
  const auto found =
      std::ranges::find_if(formats, [&](const LogFormat& format) { return format.recognizes(file); });
  return found == formats.end() ? nullptr : &*found;
}

/// "B-Human message queue, folder of pictures or video"
std::string formatsInWords() {
  std::string words;
  const auto& formats = registeredLogFormats();
  for (std::size_t i = 0; i < formats.size(); ++i) {
    if (i > 0) words += i + 1 == formats.size() ? " or " : ", ";
    words += formats[i].name;
  }
  return words;
}

/// A plug-in may throw.
Result<ImportReport> framesOf(const LogFormat& format, const std::filesystem::path& from,
                              const ImportSink& sink, const ImportOptions& options) {
  try {
    return format.import(from, sink, options);
  } catch (const std::exception& thrown) {
    return robotlink::failure("import.thrown", std::string("the import has failed: ") + thrown.what(),
                              {from.string(), 0, 0});
  }
}

Result<ImportReport> convert(const LogFormat& format, const std::filesystem::path& from, ImportWriter& writer,
                             const ImportOptions& options) {
  auto report = framesOf(
      format, from, [&writer](const std::vector<StreamMessage>& frame) { return writer.write(frame); },
      options);
  if (!report) return report;
  if (auto closed = writer.close(*report); !closed) return tl::unexpected(std::move(closed.error()));
  return report;
}

}  // namespace

bool isRobotName(std::string_view name) {
  const auto fits = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), fits);
}

bool canImport(const std::filesystem::path& file) {
  return formatOf(file) != nullptr;
}

Result<ImportReport> importLog(const std::filesystem::path& from, const std::filesystem::path& to,
                               const ImportOptions& options) {
  const LogFormat* format = formatOf(from);
  if (format == nullptr) {
    std::error_code error;
    if (!std::filesystem::exists(from, error))
      return robotlink::failure("log.open", "there is no such file", {from.string(), 0, 0});
    return robotlink::failure("log.unknown-format",
                              "this cannot be imported: it is not a " + formatsInWords(),
                              {from.string(), 0, 0});
  }
  ImportOptions chosen = options;
  if (chosen.robot.empty()) chosen.robot = format->robot().name;
  if (!isRobotName(chosen.robot)) {
    return robotlink::failure(
        "import.robot",
        "'" + chosen.robot +
            "' is not a robot name; use letters, digits, '-', '_' and '.', as in nao or red-1",
        {}, {chosen.robot});
  }
  Result<ImportReport> report;
  {
    auto writer = ImportWriter::create(to, format->robot(), chosen);
    if (!writer) return tl::unexpected(std::move(writer.error()));
    report = convert(*format, from, *writer, chosen);
  }
  if (!report) {
    std::error_code ignored;  // the import's own error says more
    std::filesystem::remove(to, ignored);
  }
  return report;
}

}  // namespace logplayer
