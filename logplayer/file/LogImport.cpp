// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/file/LogImport.h"

#include <algorithm>
#include <cctype>

#include "logplayer/base/LogWriter.h"
#include "logplayer/bhuman/MessageQueueReader.h"
#include "logplayer/bhuman/QueueImport.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"

namespace logplayer {

using robotcontrol::ProgramSetup;
using robotlink::Result;
using robotlink::StreamMessage;

namespace {

constexpr char kLayout[] = "layouts/perception.yaml";
constexpr char kRobot[] = "robots/nao.yaml";
constexpr char kField[] = "fields/2009.yaml";

Result<void> readResource(const std::string& name, ProgramSetup::File& to) {
  const auto text = robotlink::readFile(robotlink::resource(name));
  if (!text) return tl::unexpected(text.error());
  to.set_name(name);
  to.set_text(*text);
  return {};
}

/// The setup of the program that replays such a log.
Result<std::shared_ptr<ProgramSetup>> setupOf(const ImportOptions& options) {
  auto setup = std::make_shared<ProgramSetup>();
  setup->set_robot(options.robot);
  setup->set_team("red");
  setup->set_executor("lockstep");
  for (const auto& [name, file] : {std::pair{kLayout, setup->mutable_layout()},
                                   {kRobot, setup->mutable_description()},
                                   {kField, setup->mutable_field()}}) {
    if (auto read = readResource(name, *file); !read) return tl::unexpected(std::move(read.error()));
  }
  for (const char* package :
       {robotlink::kCameraImage.name, robotlink::kCameraPose.name, robotlink::kJointStates.name,
        robotlink::kBodySensors.name, robotlink::kBodyReadings.name, robotlink::kMotionStatus.name})
    setup->add_offered(package);
  if (options.colorTable) setup->add_offered(robotlink::kColorTable.name);
  return setup;
}

/// Writes the setup at the time of the first frame, then the frames.
class ImportWriter {
 public:
  static Result<ImportWriter> create(const std::filesystem::path& file, const ImportOptions& options) {
    auto setup = setupOf(options);
    if (!setup) return tl::unexpected(std::move(setup.error()));
    ImportWriter writer;
    writer.opening_.push_back({options.robot + "/" + robotlink::streams::kProgram, {}, std::move(*setup)});
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

  Result<void> write(const bhuman::FrameConverter::Frame& frame) {
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

Result<ImportReport> convert(bhuman::ByteSource& bytes, ImportWriter& writer, const ImportOptions& options) {
  auto report = bhuman::importQueue(
      bytes, options.robot,
      [&writer](const bhuman::FrameConverter::Frame& frame) { return writer.write(frame); },
      options.progress);
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
  const auto bytes = bhuman::openFile(file);
  return bytes && bhuman::MessageQueueReader::recognizes(**bytes);
}

Result<ImportReport> importLog(const std::filesystem::path& from, const std::filesystem::path& to,
                               const ImportOptions& options) {
  if (!isRobotName(options.robot)) {
    return robotlink::failure(
        "import.robot",
        "'" + options.robot +
            "' is not a robot name; use letters, digits, '-', '_' and '.', as in nao or red-1",
        {}, {options.robot});
  }
  const auto bytes = bhuman::openFile(from);
  if (!bytes) return tl::unexpected(bytes.error());
  if (!bhuman::MessageQueueReader::recognizes(**bytes))
    return robotlink::failure("log.unknown-format",
                              "this log cannot be imported: it does not begin with a B-Human message queue",
                              {from.string(), 0, 0});
  Result<ImportReport> report;
  {
    auto writer = ImportWriter::create(to, options);
    if (!writer) return tl::unexpected(std::move(writer.error()));
    report = convert(**bytes, *writer, options);
  }
  if (!report) {
    std::error_code ignored;  // the import's own error says more
    std::filesystem::remove(to, ignored);
  }
  return report;
}

}  // namespace logplayer
