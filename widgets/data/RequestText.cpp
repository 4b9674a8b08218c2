// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/RequestText.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>

#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/packages/PackageJson.h"
#include "robotlink/packages/PackageTypes.h"
#include "robotlink/session/Session.h"

namespace widgets {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using robotcontrol::Request;

constexpr int kMaxDepth = 4;
constexpr std::size_t kMaxRequestText = 1U << 20U;  // bytes

/// Whether a text can represent all that a message holds.
bool hasOnlyText(const google::protobuf::Descriptor& type, int depth) {
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    if (field.type() == FieldDescriptor::TYPE_BYTES) return false;
    const bool isMessage = field.type() == FieldDescriptor::TYPE_MESSAGE && depth < kMaxDepth;
    if (isMessage && !hasOnlyText(*field.message_type(), depth + 1)) return false;
  }
  return true;
}

const FieldDescriptor& fieldOf(Request::WhatCase what) {
  return *Request::descriptor()->FindFieldByNumber(what);
}

std::string templateOf(Request::WhatCase what) {
  Request request;
  Message& message = *request.GetReflection()->MutableMessage(&request, &fieldOf(what));
  return robotlink::templateJson(message);
}

/// "set-goal" for "set goal".
std::string wordOf(std::string title) {
  std::ranges::replace(title, ' ', '-');
  return title;
}

tl::unexpected<robotlink::Error> wrong(std::string text) {
  return tl::unexpected(robotlink::Error{"data.request", std::move(text), {}, {}});
}

}  // namespace

std::vector<RequestForm> requestForms() {
  std::vector<RequestForm> forms;
  for (const robotlink::RequestKind& kind : robotlink::requestKinds()) {
    if (!hasOnlyText(*fieldOf(kind.what).message_type(), 0)) continue;
    forms.push_back({kind.what, kind.words, templateOf(kind.what), {}});
  }
  std::ranges::sort(forms, {}, &RequestForm::title);
  return forms;
}

robotlink::Result<Request> readRequest(Request::WhatCase what, const std::string& robot,
                                       const std::string& json) {
  if (json.size() > kMaxRequestText) return wrong("the text is longer than 1 MiB");
  Request request;
  Message& message = *request.GetReflection()->MutableMessage(&request, &fieldOf(what));
  const auto status = google::protobuf::util::JsonStringToMessage(json.empty() ? "{}" : json, &message);
  if (!status.ok()) return wrong(std::string(status.message()));
  using enum robotlink::RequestDoer;
  const auto doer = robotlink::kindOf(request).doer;
  if (doer == kTask || doer == kDebugProcess || doer == kPlatform || request.has_host_program())
    request.set_robot(robot);
  if (std::string reason = robotlink::wrongWith(request); !reason.empty()) return wrong(std::move(reason));
  return request;
}

std::vector<RequestForm> packageForms() {
  std::vector<RequestForm> forms;
  for (const auto& [name, type] : robotlink::ownPackageTypes())
    forms.push_back({Request::kSetPackage, "package " + name, robotlink::packageTemplate(name), name});
  return forms;
}

robotlink::Result<Request> readPackage(const std::string& package, robotcontrol::SetPackage::Mode mode,
                                       const std::string& robot, const std::string& json) {
  Request request;
  request.set_robot(robot);
  request.mutable_set_package()->set_package(package);
  request.mutable_set_package()->set_mode(mode);
  if (mode == robotcontrol::SetPackage::RELEASE) return request;
  auto value = robotlink::packageFromJson(package, json);
  if (!value) return tl::unexpected(value.error());
  *request.mutable_set_package()->mutable_value() = std::move(*value);
  return request;
}

std::vector<std::string> requestWords() {
  std::vector<std::string> words;
  for (const RequestForm& form : requestForms()) words.push_back(wordOf(form.title));
  return words;
}

robotlink::Result<void> publish(robotlink::Session& session, const std::string& kind, const std::string& json,
                                const std::string& robot) {
  const auto forms = requestForms();
  const auto form = std::ranges::find_if(
      forms, [&](const RequestForm& each) { return wordOf(each.title) == wordOf(kind); });
  if (form == forms.end()) {
    return robotlink::failure(
        "data.message", "there is no message " + kind + robotlink::suggestion(wordOf(kind), requestWords()),
        {}, {kind});
  }
  const auto& robots = session.robots();
  if (!robot.empty() && std::ranges::find(robots, robot) == robots.end()) {
    return robotlink::failure(
        "robot.unknown", "there is no robot " + robot + robotlink::suggestion(robot, robots), {}, {robot});
  }
  auto request = readRequest(form->what, robot.empty() ? session.selectedRobot() : robot,
                             json.empty() ? form->json : json);
  if (!request) return tl::unexpected(request.error());
  session.request(std::move(*request));
  return {};
}

}  // namespace widgets
