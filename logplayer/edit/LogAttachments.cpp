// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/edit/LogAttachments.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <ostream>

#include "logplayer/export/ExportPass.h"
#include "logplayer/file/ContainerFile.h"
#include "logplayer/file/LogImport.h"
#include "logplayer/mcap/read/Reader.h"
#include "logplayer/record/LogAppend.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"

namespace logplayer {
namespace {

namespace fs = std::filesystem;
using robotlink::Result;

constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;

std::string mediaTypeOf(const fs::path& file) {
  static const std::map<std::string, std::string> kTypes{
      {".txt", "text/plain"},        {".md", "text/markdown"},      {".csv", "text/csv"},
      {".json", "application/json"}, {".yaml", "application/yaml"}, {".yml", "application/yaml"},
      {".png", "image/png"},         {".jpg", "image/jpeg"},        {".jpeg", "image/jpeg"},
      {".pdf", "application/pdf"},   {".xml", "text/xml"},          {".zip", "application/zip"},
  };
  const auto found = kTypes.find(robotlink::fileSuffix(file));
  return found == kTypes.end() ? "application/octet-stream" : found->second;
}

/// The modification time of a file in log time.
robotlink::Instant changedAt(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  if (error) return {};
  const auto real = std::chrono::file_clock::to_sys(time).time_since_epoch();
  return robotlink::Instant(std::chrono::duration_cast<robotlink::Duration>(real));
}

Result<std::unique_ptr<mcap::Reader>> opened(const fs::path& log) {
  return mcap::Reader::open(log, {});
}

}  // namespace

Result<std::vector<AttachmentInfo>> attachmentsOf(const fs::path& log) {
  if (canImport(log)) return std::vector<AttachmentInfo>();
  const auto reader = opened(log);
  if (!reader) return tl::unexpected(reader.error());
  std::vector<AttachmentInfo> all;
  for (const std::string& name : (*reader)->attachmentNames()) {
    const auto attachment = (*reader)->attachment(name);
    if (!attachment) return tl::unexpected(attachment.error());
    all.push_back({name, attachment->mediaType, attachment->data.size()});
  }
  return all;
}

Result<void> attach(const fs::path& log, const fs::path& file, const AttachmentOptions& options) {
  if (canImport(log)) {
    return robotlink::failure("attachment.format",
                              "only MCAP files have attachments; 'robotctl log import' makes one of this log",
                              {log.string(), 0, 0});
  }
  mcap::Attachment attachment;
  attachment.name = options.name.empty() ? file.filename().string() : options.name;
  attachment.mediaType = options.mediaType.empty() ? mediaTypeOf(file) : options.mediaType;
  attachment.createTime = changedAt(file);
  {
    const auto reader = opened(log);
    if (!reader) return tl::unexpected(reader.error());
    if (!(*reader)->complete()) {
      return robotlink::failure(
          "attachment.incomplete",
          "it was not closed, so nothing can be added to it; 'robotctl log repair' makes a complete one",
          {log.string(), 0, 0});
    }
    const auto names = (*reader)->attachmentNames();
    if (std::find(names.begin(), names.end(), attachment.name) != names.end()) {
      return robotlink::failure(
          "attachment.exists",
          "there is an attachment " + attachment.name + " in it already; give this one another name (--name)",
          {log.string(), 0, 0}, {attachment.name});
    }
    attachment.logTime = (*reader)->statistics().messageEnd;
  }
  auto data = robotlink::readFile(file, kMaxBytes);
  if (!data) return tl::unexpected(data.error());
  attachment.data = std::move(*data);
  return appendToLog(log, [&](mcap::Writer& writer) { return writer.attach(attachment); });
}

Result<void> extractAttachment(const fs::path& log, const std::string& name, const fs::path& to,
                               bool overwrite) {
  const auto reader = opened(log);
  if (!reader) return tl::unexpected(reader.error());
  const auto names = (*reader)->attachmentNames();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    return robotlink::failure("attachment.none", "there is no attachment " + name + " in it",
                              {log.string(), 0, 0}, {name});
  }
  const auto attachment = (*reader)->attachment(name);
  if (!attachment) return tl::unexpected(attachment.error());
  const auto written = exportTo(to, overwrite, [&](std::ostream& out) -> Result<ExportReport> {
    out.write(attachment->data.data(), static_cast<std::streamsize>(attachment->data.size()));
    return ExportReport{};
  });
  if (!written) return tl::unexpected(written.error());
  return {};
}

}  // namespace logplayer
