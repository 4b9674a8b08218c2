// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/recordings/RecordingServices.h"

#include <google/protobuf/util/json_util.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "app/core/platform/JsonOutput.h"
#include "app/core/recordings/ServiceArgument.h"
#include "logplayer/record/Recorder.h"

namespace app {
namespace {

using nlohmann::json;
using robotcontrol::ControlRecording;
using robotlink::Result;
using robotlink::websocket::ServiceAccess;

/// A step of a check takes some 10 ms.
constexpr std::uint64_t kCheckedAtOnce = 32U << 20U;

}  // namespace

RecordingServices::RecordingServices(std::shared_ptr<robotlink::websocket::Server> server,
                                     RecordingFolder folder, logplayer::Recorder& recorder)
    : folder_(std::move(folder)), recorder_(recorder), services_(std::move(server)) {
  recorder_.setFolder(folder_.path());
  const ArgumentMember name{"name"}, offset{"offset", true}, bytes{"bytes", true};
  offer("recordings/list", {}, &RecordingServices::list, ServiceAccess::kAnybody);
  offer("recordings/read", {name, offset, bytes}, &RecordingServices::read, ServiceAccess::kAnybody);
  offer("recordings/check", {name, bytes}, &RecordingServices::check, ServiceAccess::kAnybody);
  offer("recordings/delete", {name}, &RecordingServices::remove);
  offer("recordings/start", {}, &RecordingServices::start);
  offer("recordings/stop", {}, &RecordingServices::stop);
  offer("recordings/status", {}, &RecordingServices::status, ServiceAccess::kAnybody);
}

void RecordingServices::offer(const std::string& name, const std::vector<ArgumentMember>& members,
                              Handler handler, ServiceAccess access) {
  services_.offer(
      name, members,
      [this, handler](const json& argument, const Reply& reply) { (this->*handler)(argument, reply); },
      access);
}

void RecordingServices::list(const json&, const Reply& reply) {
  const auto entries = folder_.list();
  if (!entries) return reply.fail(entries.error().describe());
  const std::string now = recorded();
  json all = json::array();
  for (const auto& entry : *entries) {
    all.push_back({{"name", entry.name},
                   {"bytes", entry.bytes},
                   {"modified", entry.modified},
                   {"recording", entry.name == now},
                   {"whole", entry.isWhole}});
  }
  reply.succeed(jsonMessage(json{{"recordings", std::move(all)}}), kJsonEncoding);
}

void RecordingServices::read(const json& argument, const Reply& reply) {
  const auto piece = folder_.read(textMember(argument, "name"), numberMember(argument, "offset", 0),
                                  numberMember(argument, "bytes", RecordingFolder::kMaxPiece));
  if (!piece) return reply.fail(piece.error().text);
  reply.succeed(*piece, "binary");
}

void RecordingServices::check(const json& argument, const Reply& reply) {
  continueCheck(textMember(argument, "name"), numberMember(argument, "bytes", UINT64_MAX), {}, reply);
}

void RecordingServices::continueCheck(const std::string& name, std::uint64_t bytes,
                                      RecordingFolder::Checksum before, const Reply& reply) {
  const auto checked = folder_.extend(name, before, bytes, kCheckedAtOnce);
  if (!checked) return reply.fail(checked.error().text);
  if (checked->bytes - before.bytes == kCheckedAtOnce) {
    services_.add([this, name, bytes, so = *checked, reply] { continueCheck(name, bytes, so, reply); });
    return;
  }
  reply.succeed(jsonMessage(json{{"bytes", checked->bytes}, {"crc32", checked->crc}}), kJsonEncoding);
}

void RecordingServices::remove(const json& argument, const Reply& reply) {
  const std::string name = textMember(argument, "name");
  if (!name.empty() && name == recorded())
    return reply.fail("'" + name + "' is being recorded; stop the recording first");
  if (const auto removed = folder_.remove(name); !removed) return reply.fail(removed.error().text);
  reply.succeed("{}", kJsonEncoding);
}

void RecordingServices::start(const json& argument, const Reply& reply) {
  ControlRecording control;
  control.set_action(ControlRecording::START);
  if (const auto started = recorder_.control(control); !started)
    return reply.fail(started.error().describe());
  status(argument, reply);
}

void RecordingServices::stop(const json& argument, const Reply& reply) {
  ControlRecording control;
  control.set_action(ControlRecording::STOP);
  if (const auto stopped = recorder_.control(control); !stopped)
    return reply.fail(stopped.error().describe());
  // Finished, so that the recording listed next is complete.
  recorder_.finish();
  status(argument, reply);
}

void RecordingServices::status(const json&, const Reply& reply) {
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  options.always_print_primitive_fields = true;
  std::string text;
  static_cast<void>(google::protobuf::util::MessageToJsonString(recorder_.status(), &text, options));
  reply.succeed(text, kJsonEncoding);
}

std::string RecordingServices::recorded() const {
  const auto status = recorder_.status();
  const std::filesystem::path file = status.path();
  std::error_code error;
  const bool isHere =
      status.recording() && std::filesystem::equivalent(file.parent_path(), folder_.path(), error);
  return isHere ? file.filename().string() : std::string();
}

}  // namespace app
