// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/RecordOptions.h"

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>

#include "logplayer/base/RecordedStreams.h"

namespace app {

using robotcontrol::ControlRecording;

std::optional<ControlRecording::ImageCoding> imageCodingNamed(const std::string& name) {
  if (name == "as-is") return ControlRecording::AS_IS;
  if (name == "jpeg") return ControlRecording::JPEG;
  return name == "png" ? std::optional(ControlRecording::PNG) : std::nullopt;
}

std::optional<ControlRecording::Compression> compressionNamed(const std::string& name) {
  if (name == "none") return ControlRecording::NONE;
  if (name == "lz4") return ControlRecording::LZ4;
  return name == "zstd" ? std::optional(ControlRecording::ZSTD) : std::nullopt;
}

void RecordOptions::addTo(CLI::App& command) {
  auto* record = command.add_option("--record", file, "Records into this log file, which must not exist");
  command
      .add_option("--streams", streams,
                  "What to record: comma-separated paths, * matches any text, - excludes (red1/*,-*/log); "
                  "all that a replay needs if not given")
      ->check([](const std::string& text) {
        const auto read = logplayer::readSelection(text);
        return read ? std::string() : read.error().text;
      })
      ->needs(record);
  command.add_option("--images", images, "How images are recorded: as-is, jpeg or png")
      ->check(CLI::IsMember({"as-is", "jpeg", "png"}))
      ->capture_default_str()
      ->needs(record);
  command.add_option("--compression", compression, "Compression of the log file: none, lz4 or zstd")
      ->check(CLI::IsMember({"none", "lz4", "zstd"}))
      ->capture_default_str()
      ->needs(record);
}

robotlink::Result<std::unique_ptr<logplayer::Recorder>> RecordOptions::start() const {
  if (file.empty()) return nullptr;
  auto selection = logplayer::readSelection(streams);
  if (!selection) return tl::unexpected(selection.error());
  logplayer::Recorder::Options options;
  options.software = "robotctl " ROBOTCONTROL_VERSION;
  options.warn = [](const std::string& text) { std::cerr << text << "\n"; };
  auto recorder = std::make_unique<logplayer::Recorder>(std::move(options));
  ControlRecording control;
  control.set_action(ControlRecording::START);
  control.set_path(file);
  *control.mutable_selection() = std::move(*selection);
  control.set_image_coding(*imageCodingNamed(images));
  control.set_compression(*compressionNamed(compression));
  if (const auto started = recorder->control(control); !started) return tl::unexpected(started.error());
  return recorder;
}

ExitStatus finishRecording(logplayer::Recorder& recorder, std::ostream& out) {
  ControlRecording control;
  control.set_action(ControlRecording::STOP);
  const auto stopped = recorder.control(control);
  recorder.finish();
  const robotcontrol::RecordingStatus status = recorder.status();
  if (!status.failure().empty()) return kFailed;  // the failure was already printed by `warn`
  if (!stopped) {
    out << stopped.error().describe() << "\n";
    return kFailed;
  }
  out << status.path() << ": " << status.messages() << " messages, " << std::fixed << std::setprecision(1)
      << 1e-6 * static_cast<double>(status.bytes()) << " MB";
  if (status.dropped_messages() > 0) out << ", " << status.dropped_messages() << " messages were dropped";
  out << "\n";
  return status.dropped_messages() > 0 ? kDoneWithLosses : kDone;
}

}  // namespace app
