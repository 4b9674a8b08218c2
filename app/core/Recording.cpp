// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/Recording.h"

#include <cstdlib>
#include <fstream>
#include <random>

#include "foxglove/Event.pb.h"
#include "logplayer/base/RecordedStreams.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"

namespace app {

using robotcontrol::ControlRecording;
using robotlink::Result;

namespace {

/// Names of the settings.
constexpr char kStreams[] = "streams", kImages[] = "images", kCompression[] = "compression", kKeep[] = "keep",
               kTrigger[] = "trigger", kFolder[] = "folder";

/// Options of a recorder whose warnings go into a queue.
logplayer::Recorder::Options recorderOptions(robotlink::BoundedQueue<std::string>& warnings) {
  logplayer::Recorder::Options options;
  options.software = "robotcontrol " ROBOTCONTROL_VERSION;
  options.warn = [&warnings](const std::string& text) { warnings.push(text); };
  return options;
}

/// Seconds that are kept in memory unless the user chooses otherwise, so that something unexpected can be
/// saved after it has happened. They take at most logplayer::Recorder::Options::keptBytes.
constexpr double kKeptByDefault = 30;

/// A random id that is unique across files, so that logs can be merged, and small enough for numbers in JSON.
std::uint64_t newBookmarkId() {
  std::random_device device;
  return (std::uint64_t{device()} << 32U | device()) & ((std::uint64_t{1} << 53U) - 1);
}

}  // namespace

Recording::Recording(const std::filesystem::path& userFolder)
    : settings_(userFolder / "recording.json"), recorder_(recorderOptions(warnings_)) {
  if (const auto loaded = settings_.load(); !loaded) problems_.push_back(loaded.error());
  recorder_.setFolder(folder());
  restore();
}

void Recording::restore() {
  ControlRecording control;
  if (auto selection = logplayer::readSelection(settings_.text(kStreams, ""))) {
    *control.mutable_selection() = std::move(*selection);
  } else {
    problems_.push_back(selection.error());
  }
  ControlRecording::ImageCoding images = ControlRecording::AS_IS;
  ControlRecording::ImageCoding_Parse(settings_.text(kImages, ""), &images);
  control.set_image_coding(images);
  ControlRecording::Compression compression = ControlRecording::NONE;
  ControlRecording::Compression_Parse(settings_.text(kCompression, ""), &compression);
  control.set_compression(compression);
  control.set_keep_last(settings_.number(kKeep, kKeptByDefault));
  control.set_trigger(settings_.text(kTrigger, ""));
  if (const auto done = recorder_.control(control); !done) problems_.push_back(done.error());
}

Result<void> Recording::control(const ControlRecording& control) {
  auto done = recorder_.control(control);
  if (done) remember(control);
  return done;
}

void Recording::remember(const ControlRecording& control) {
  if (control.has_selection()) settings_.set(kStreams, logplayer::textOf(control.selection()));
  if (control.has_image_coding())
    settings_.set(kImages, ControlRecording::ImageCoding_Name(control.image_coding()));
  if (control.has_compression())
    settings_.set(kCompression, ControlRecording::Compression_Name(control.compression()));
  if (control.has_keep_last()) settings_.set(kKeep, control.keep_last());
  if (control.has_trigger()) settings_.set(kTrigger, control.trigger());
  if (const auto saved = settings_.save(); !saved) problems_.push_back(saved.error());
}

std::filesystem::path Recording::folder() const {
  const std::string chosen = settings_.text(kFolder, "");
  return chosen.empty() ? documentsFolder() : std::filesystem::path(chosen);
}

Result<void> Recording::setFolder(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    return robotlink::failure("recording.folder", "recordings cannot be written to this folder",
                              {folder.string(), 0, 0}, {folder.string()});
  }
  settings_.set(kFolder, std::filesystem::absolute(folder, error).string());
  recorder_.setFolder(this->folder());
  return settings_.save();
}

Result<void> Recording::bookmark(const std::string& text, robotlink::Instant time) {
  const robotcontrol::RecordingStatus status = recorder_.status();
  if (!status.recording() && status.kept_bytes() == 0) {
    return robotlink::failure("recording.none",
                              "nothing is being recorded or kept in memory; start a recording first");
  }
  auto event = std::make_shared<foxglove::Event>();
  robotlink::assign(*event->mutable_start_time(), time);
  *event->mutable_end_time() = event->start_time();
  const auto add = [&](const char* key, const std::string& value) {
    auto& pair = *event->add_metadata();
    pair.set_key(key);
    pair.set_value(value);
  };
  add("id", std::to_string(newBookmarkId()));
  add("text", text);
  recorder_.add({{robotlink::streams::kBookmarks, time, std::move(event)}});
  // A recording contains the mark; otherwise the last seconds are saved with it.
  if (status.recording()) return {};
  ControlRecording control;
  control.set_action(ControlRecording::SAVE_LAST);
  return this->control(control);
}

robotlink::Errors Recording::takeWarnings() {
  robotlink::Errors warnings = std::exchange(problems_, {});
  for (std::string& text : warnings_.drain())
    warnings.push_back({"recording.warning", std::move(text), {}, {}});
  return warnings;
}

std::filesystem::path documentsFolder() {
  const char* home = std::getenv("HOME");
  const std::string homeFolder = home != nullptr ? home : ".";
  std::error_code error;
  std::ifstream userFolders(robotlink::userDirectory().parent_path() / "user-dirs.dirs");
  const std::string wanted = "XDG_DOCUMENTS_DIR=\"";
  for (std::string line; std::getline(userFolders, line);) {
    if (!line.starts_with(wanted)) continue;
    std::string folder = line.substr(wanted.size(), line.rfind('"') - wanted.size());
    if (folder.starts_with("$HOME")) folder.replace(0, 5, homeFolder);
    if (std::filesystem::is_directory(folder, error)) return folder;
  }
  const std::filesystem::path documents = std::filesystem::path(homeFolder) / "Documents";
  return std::filesystem::is_directory(documents, error) ? documents : std::filesystem::path(homeFolder);
}

}  // namespace app
