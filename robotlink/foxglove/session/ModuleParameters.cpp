// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/ModuleParameters.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/foxglove/session/FieldValue.h"

namespace robotlink::websocket {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::DescriptorPool;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::MessageFactory;
using robotcontrol::Request;

/// Messages that contain themselves end somewhere; and so do lists.
constexpr std::size_t kMaxPath = 8;
constexpr int kMaxElements = 100;

tl::unexpected<Error> wrongParameter(const Parameter& parameter, const std::string& why) {
  return failure("foxglove.parameter", "the value of '" + parameter.name + "' " + why, {}, {parameter.name});
}

std::unique_ptr<Message> messageOf(const robotcontrol::PackageCopy& copy) {
  const Descriptor* type = DescriptorPool::generated_pool()->FindMessageTypeByName(copy.type());
  if (type == nullptr) return nullptr;
  std::unique_ptr<Message> message(MessageFactory::generated_factory()->GetPrototype(type)->New());
  if (!message->ParseFromString(copy.data())) return nullptr;
  return message;
}

}  // namespace

ModuleParameters::ModuleParameters() = default;
ModuleParameters::~ModuleParameters() = default;

void ModuleParameters::collect(const Message& message, const std::string& prefix, Place place,
                               std::map<std::string, Value>& values) {
  if (place.path.size() >= kMaxPath) return;
  const auto& reflection = *message.GetReflection();
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor& field = *message.GetDescriptor()->field(i);
    const std::string name = prefix + "/" + field.name();
    place.path.push_back({&field, -1});
    if (auto value = fieldValue(message, field)) {
      values.emplace(name, *std::move(value));
      places_.insert_or_assign(name, place);
    } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE && !field.is_repeated()) {
      collect(reflection.GetMessage(message, &field), name, place, values);
    } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      const int count = std::min(reflection.FieldSize(message, &field), kMaxElements);
      for (int element = 0; element < count; ++element) {
        place.path.back().element = element;
        collect(reflection.GetRepeatedMessage(message, &field, element), name + "/" + std::to_string(element),
                place, values);
      }
    }
    place.path.pop_back();
  }
}

std::vector<Parameter> ModuleParameters::take(const std::string& robot,
                                              const robotcontrol::ParameterValues& from) {
  const SolutionId id{robot, from.task(), from.solution()};
  std::vector<Parameter> changes;
  auto message = messageOf(from.value());
  if (!message) {
    forget(id, changes);
    return changes;
  }
  std::map<std::string, Value> values;
  for (const auto& [name, value] : solutions_[id].values) places_.erase(name);
  collect(*message, robot + "/parameters/" + from.task() + "/" + from.solution(), {id, {}}, values);
  Known& known = solutions_[id];
  for (const auto& [name, value] : known.values)
    if (!values.contains(name)) changes.push_back({name, std::nullopt});
  for (const auto& [name, value] : values) {
    const auto before = known.values.find(name);
    if (before == known.values.end() || before->second != value) changes.push_back({name, value});
  }
  known = {std::move(message), std::move(values)};
  return changes;
}

void ModuleParameters::forget(const SolutionId& id, std::vector<Parameter>& changes) {
  const auto found = solutions_.find(id);
  if (found == solutions_.end()) return;
  for (const auto& [name, value] : found->second.values) {
    changes.push_back({name, std::nullopt});
    places_.erase(name);
  }
  solutions_.erase(found);
}

std::vector<Parameter> ModuleParameters::keep(const std::string& robot,
                                              const robotcontrol::SolutionTable& table) {
  std::set<SolutionId> wanted;
  for (const auto& task : table.tasks())
    for (const auto& solution : task.solutions())
      if (solution.has_parameters()) wanted.insert({robot, task.name(), solution.name()});
  std::vector<Parameter> changes;
  std::erase_if(tables_, [&](const auto& row) {
    const bool isGone = std::get<0>(row.first) == robot && !wanted.contains(row.first);
    if (isGone) forget(row.first, changes);
    return isGone;
  });
  for (const SolutionId& id : wanted) tables_.emplace(id, false);
  return changes;
}

std::vector<Parameter> ModuleParameters::remove(const std::string& robot) {
  return keep(robot, {});
}

std::optional<Request> ModuleParameters::nextToGet(const std::string& robot) {
  for (auto& [id, isAsked] : tables_) {
    if (isAsked || std::get<0>(id) != robot) continue;
    isAsked = true;
    Request request;
    request.set_robot(robot);
    request.mutable_get_parameters()->set_task(std::get<1>(id));
    request.mutable_get_parameters()->set_solution(std::get<2>(id));
    return request;
  }
  return std::nullopt;
}

void ModuleParameters::expect(const Request& setting) {
  const auto& set = setting.set_parameters();
  const auto found = solutions_.find({setting.robot(), set.task(), set.solution()});
  auto message = messageOf(set.value());
  if (found != solutions_.end() && message) found->second.message = std::move(message);
}

Result<void> ModuleParameters::assign(Message& message, const Place& place, const Parameter& parameter) {
  if (!parameter.value)
    return wrongParameter(parameter, "is missing: parameters of solutions cannot be removed");
  Message* inner = &message;
  for (std::size_t i = 0; i + 1 < place.path.size(); ++i) {
    const Step& step = place.path[i];
    const auto& reflection = *inner->GetReflection();
    if (step.element < 0) {
      inner = reflection.MutableMessage(inner, step.field);
    } else {
      inner = reflection.MutableRepeatedMessage(inner, step.field, step.element);
    }
  }
  const std::string wrong = setFieldValue(*inner, *place.path.back().field, *parameter.value);
  if (!wrong.empty()) return wrongParameter(parameter, wrong);
  return {};
}

Result<std::vector<Request>> ModuleParameters::requestsFor(const std::vector<Parameter>& parameters) const {
  std::map<SolutionId, MessagePtr> changed;
  for (const Parameter& parameter : parameters) {
    const auto place = places_.find(parameter.name);
    if (place == places_.end()) return wrongParameter(parameter, "cannot be set: there is no such parameter");
    const SolutionId& id = place->second.solution;
    MessagePtr& message = changed[id];
    if (!message) {
      const Message& known = *solutions_.at(id).message;
      message.reset(known.New());
      message->CopyFrom(known);
    }
    if (auto assigned = assign(*message, place->second, parameter); !assigned)
      return tl::unexpected(assigned.error());
  }
  std::vector<Request> requests;
  for (const auto& [id, message] : changed) {
    Request& request = requests.emplace_back();
    request.set_robot(std::get<0>(id));
    request.mutable_set_parameters()->set_task(std::get<1>(id));
    request.mutable_set_parameters()->set_solution(std::get<2>(id));
    request.mutable_set_parameters()->mutable_value()->set_type(message->GetTypeName());
    message->SerializeToString(request.mutable_set_parameters()->mutable_value()->mutable_data());
  }
  return requests;
}

}  // namespace robotlink::websocket
