// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/DeployServices.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "app/core/platform/JsonOutput.h"
#include "app/core/recordings/ServiceArgument.h"
#include "robotlink/foxglove/protocol/Base64.h"
#include "robotlink/foxglove/security/Digest.h"

namespace app {
namespace {

using nlohmann::json;
using robotlink::websocket::ServiceAccess;

json objectOf(const ResourceFolder::Entry& entry) {
  return {{"path", entry.path}, {"bytes", entry.bytes}, {"sha256", entry.sha256}};
}

}  // namespace

DeployServices::DeployServices(std::shared_ptr<robotlink::websocket::Server> server, ResourceFolder folder,
                               Written written, Programs programs)
    : folder_(std::move(folder)),
      written_(std::move(written)),
      programs_(std::move(programs)),
      services_(std::move(server)) {
  offer("deploy/list", {}, &DeployServices::list, ServiceAccess::kAnybody);
  offer("deploy/put", {{"path"}, {"content"}, {"sha256"}}, &DeployServices::put, ServiceAccess::kControl);
  if (programs_.restart)
    offer("deploy/restart", {{"robot"}, {"layout"}}, &DeployServices::restart, ServiceAccess::kControl);
}

void DeployServices::offer(const std::string& name, const std::vector<ArgumentMember>& members,
                           Handler handler, ServiceAccess access) {
  services_.offer(
      name, members,
      [this, handler](const json& argument, const Reply& reply) { (this->*handler)(argument, reply); },
      access);
}

void DeployServices::list(const json&, const Reply& reply) {
  const auto entries = folder_.list();
  if (!entries) return reply.fail(entries.error().describe());
  json all = json::array();
  for (const auto& entry : *entries) all.push_back(objectOf(entry));
  json answer{{"files", std::move(all)}};
  if (programs_.list) {
    answer["robots"] = json::array();
    for (const auto& program : programs_.list())
      answer["robots"].push_back(
          {{"robot", program.robot}, {"layout", program.layout}, {"waiting", program.waiting}});
  }
  reply.succeed(jsonMessage(answer), kJsonEncoding);
}

void DeployServices::put(const json& argument, const Reply& reply) {
  const std::string path = textMember(argument, "path");
  const auto contents = robotlink::websocket::fromBase64(textMember(argument, "content"));
  if (!contents) return reply.fail("the content of '" + path + "' is not base64");
  if (robotlink::websocket::sha256(*contents) != textMember(argument, "sha256"))
    return reply.fail("the content of '" + path + "' is not that of its checksum; send it again");
  const auto written = folder_.put(path, *contents);
  if (!written) return reply.fail(written.error().describe());
  if (written_) written_(path);
  reply.succeed(jsonMessage(objectOf(*written)), kJsonEncoding);
}

void DeployServices::restart(const json& argument, const Reply& reply) {
  const std::string robot = textMember(argument, "robot"), layout = textMember(argument, "layout");
  std::filesystem::path file;
  if (!layout.empty()) {
    const auto found = folder_.find("layouts/" + layout);
    if (!found) return reply.fail(found.error().describe());
    std::error_code error;
    if (!std::filesystem::is_regular_file(*found, error))
      return reply.fail("there is no layout '" + layout + "' here; deploy it first");
    file = *found;
  }
  programs_.restart(robot, file, [reply](const std::string& why) {
    why.empty() ? reply.succeed("{}", kJsonEncoding) : reply.fail(why);
  });
}

}  // namespace app
