// SPDX-License-Identifier: GPL-3.0-or-later
// Export of images as PNG files.
#include <fmt/format.h>

#include <cctype>
#include <map>
#include <ostream>

#include "foxglove/Image.pb.h"
#include "logplayer/base/Plural.h"
#include "logplayer/export/ExportPass.h"
#include "logplayer/export/LogExport.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/packages/Conversions.h"

namespace logplayer {
namespace {

namespace fs = std::filesystem;
using robotlink::Result;
using robotlink::StreamMessage;

bool isImage(const LogFile::Stream& stream) {
  return stream.holds(foxglove::RawImage::descriptor()->full_name()) ||
         stream.holds(foxglove::CompressedImage::descriptor()->full_name());
}

/// Whether a stream contains images in an unsupported encoding.
bool isUndecodedImage(const LogFile::Stream& stream) {
  return !stream.isDecoded() && (stream.type == foxglove::RawImage::descriptor()->full_name() ||
                                 stream.type == foxglove::CompressedImage::descriptor()->full_name());
}

Result<std::vector<std::uint8_t>> pngOf(const StreamMessage& message) {
  std::shared_ptr<foxglove::RawImage> decoded;
  const auto* raw = dynamic_cast<const foxglove::RawImage*>(message.value.get());
  if (const auto* compressed = dynamic_cast<const foxglove::CompressedImage*>(message.value.get())) {
    auto image = rawImage(*compressed);
    if (!image) return tl::unexpected(image.error());
    decoded = std::move(*image);
    raw = decoded.get();
  }
  if (!raw) return robotlink::failure("image.type", "its type changed in the log");
  const auto view = robotlink::imageView(*raw);
  if (view.empty()) {
    return robotlink::failure("image.encoding",
                              "its encoding '" + raw->encoding() + "' is not known, or does not fit its data",
                              {}, {raw->encoding()});
  }
  return encodePng(view);
}

std::string imageName(const StreamMessage& message, std::uint64_t number) {
  std::string name = message.path;
  for (char& c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '-';
    if (!plain) c = '-';
  }
  if (name.starts_with('.')) name[0] = '-';
  return fmt::format("{}-{:017.6f}-{:05}.png", name, robotlink::seconds(message.time),
                     message.frame > 0 ? message.frame : number);
}

Result<void> writeImage(const fs::path& file, const std::vector<std::uint8_t>& png, bool overwrite) {
  const auto written = exportTo(file, overwrite, [&](std::ostream& out) -> Result<ExportReport> {
    out.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    return ExportReport{};
  });
  if (!written) return tl::unexpected(written.error());
  return {};
}

}  // namespace

Result<ExportReport> exportImages(const std::shared_ptr<LogFile>& log, const StreamFilter& streams,
                                  const fs::path& folder, const ExportOptions& options) {
  const auto paths = chosenStreams(*log, streams, isImage);
  if (paths.empty()) {
    const auto undecoded = chosenStreams(*log, streams, isUndecodedImage);
    const std::string why =
        undecoded.empty() ? "" : "; those of " + undecoded.front() + " are in an unsupported encoding";
    return robotlink::failure("export.images", "no chosen stream holds images" + why,
                              {log->path().string(), 0, 0});
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    return robotlink::failure("file.io", "cannot make the folder: " + error.message(),
                              {folder.string(), 0, 0}, {error.message()});
  }
  ExportReport report;
  std::uint64_t number = 0;
  std::map<std::string, std::uint64_t> failed;
  const auto done =
      forEachMessage(log, paths, options, {}, [&](const StreamMessage& message) -> Result<void> {
        ++number;
        const auto png = pngOf(message);
        if (!png) {
          ++failed[message.path + ": " + png.error().text];
          return {};
        }
        const auto written = writeImage(folder / imageName(message, number), *png, options.overwrite);
        if (written) ++report.written;
        return written;
      });
  if (!done) return tl::unexpected(done.error());
  noteUnread(*done, report);
  for (const auto& [what, count] : failed) report.losses.push_back(plural(count, "image") + " of " + what);
  noteDamage(*log, report);
  return report;
}

}  // namespace logplayer
