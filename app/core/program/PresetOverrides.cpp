// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/PresetOverrides.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/message.h>
#include <google/protobuf/text_format.h>

#include <map>
#include <memory>

#include "robotlink/base/Resources.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/ParsedMessage.h"
#include "robotlink/session/KeyModes.h"

namespace app {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using robotcontrol::Request;
using robotlink::Errors;
using robotlink::failure;
using robotlink::Preset;
using robotlink::Result;

/// "walking/gait step.height" in its parts.
struct ParameterName {
  std::string task, solution, path;
};

ParameterName parameterNameOf(const std::string& name) {
  const auto space = name.find(' ');
  const std::string of = name.substr(0, space);
  const auto slash = of.find('/');
  return {of.substr(0, slash), slash == std::string::npos ? "" : of.substr(slash + 1),
          space == std::string::npos ? "" : name.substr(space + 1)};
}

/// A value as Protobuf's text format has it.
std::string textFor(const FieldDescriptor& field, const std::string& value) {
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_BOOL)
    return value == "on" ? "true" : value == "off" ? "false" : value;
  if (field.cpp_type() != FieldDescriptor::CPPTYPE_STRING) return value;
  std::string quoted = "\"";
  for (const char each : value) {
    if (each == '"' || each == '\\') quoted += '\\';
    quoted += each;
  }
  return quoted + "\"";
}

/// Ignores messages that are printed elsewhere: the answer says that a text is wrong.
class NoMessages final : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int, google::protobuf::io::ColumnNumber, const std::string&) override {}
};

/// Sets a field by its path, "step.height". Fails if there is no such field, if it belongs to a list, or if
/// the value does not fit.
Result<void> setField(Message& message, const std::string& path, const std::string& value) {
  const auto wrong = [&](const std::string& why) {
    return failure("preset.parameter", "the parameter " + path + " " + why, {}, {path});
  };
  const google::protobuf::Descriptor* type = message.GetDescriptor();
  std::string text, ends;
  for (std::size_t at = 0;;) {
    const std::size_t dot = path.find('.', at);
    const std::string name = path.substr(at, dot == std::string::npos ? dot : dot - at);
    const FieldDescriptor* field = type == nullptr ? nullptr : type->FindFieldByName(name);
    if (name.find('[') != std::string::npos || (field != nullptr && field->is_repeated()))
      return wrong("belongs to a list, which a preset cannot set at the start");
    if (field == nullptr) return wrong("does not exist");
    type = field->message_type();
    if (dot == std::string::npos) {
      if (type != nullptr) return wrong("is a group; name one of its fields in the preset");
      text += name + ": " + textFor(*field, value);
      break;
    }
    text += name + " { ";
    ends += " }";
    at = dot + 1;
  }
  google::protobuf::TextFormat::Parser parser;
  NoMessages silent;
  parser.RecordErrorsTo(&silent);
  return parser.MergeFromString(text + ends, &message) ? Result<void>() : wrong("cannot be '" + value + "'");
}

Request keyRequest(const std::string& key, const std::string& mode) {
  Request request;
  request.mutable_set_key()->set_name(key);
  if (const auto known = robotlink::keyModeOf(mode)) *request.mutable_set_key()->mutable_mode() = *known;
  return request;
}

const Preset::Values& valuesOf(const Preset& preset, Preset::Part part) {
  static const Preset::Values kNone;
  return preset.parts[part] ? *preset.parts[part] : kNone;
}

Result<void> checkSolution(const std::string& task, const std::string& solution) {
  if (robotlink::SolutionRegistry::find(task, solution) != nullptr) return {};
  std::vector<std::string> all;
  for (const auto& known : robotlink::SolutionRegistry::all()) {
    if (known.task == task) all.push_back(known.name);
  }
  return failure("preset.solution",
                 all.empty()
                     ? "there is no task " + task
                     : "task " + task + " has no solution " + solution + robotlink::suggestion(solution, all),
                 {}, {task, solution});
}

Result<void> checkParameter(const std::string& name, const std::string& value) {
  const ParameterName parameter = parameterNameOf(name);
  if (auto known = checkSolution(parameter.task, parameter.solution); !known) return known;
  const auto* solution = robotlink::SolutionRegistry::find(parameter.task, parameter.solution);
  if (solution->parameters == nullptr)
    return failure("preset.parameter", parameter.task + "/" + parameter.solution + " has no parameters", {},
                   {name});
  const std::unique_ptr<Message> message(solution->parameters->New());
  auto set = setField(*message, parameter.path, value);
  if (!set) set.error().text = parameter.task + "/" + parameter.solution + ": " + set.error().text;
  return set;
}

Errors problemsOf(const Preset& preset) {
  Errors errors;
  const auto note = [&](const Result<void>& checked) {
    if (!checked) errors.push_back(checked.error());
  };
  for (const auto& [key, mode] : valuesOf(preset, Preset::kKeys)) {
    if (std::string wrong = robotlink::wrongWith(keyRequest(key, mode)); !wrong.empty())
      errors.push_back({"preset.key", std::move(wrong), {key}, {}});
  }
  for (const auto& [task, solution] : valuesOf(preset, Preset::kSolutions))
    note(checkSolution(task, solution));
  for (const auto& [name, value] : valuesOf(preset, Preset::kParameters)) note(checkParameter(name, value));
  return errors;
}

}  // namespace

tl::expected<Preset, Errors> presetToStartWith(const std::string& nameOrFile) {
  const bool isFile = nameOrFile.find('/') != std::string::npos || nameOrFile.ends_with(".json");
  auto preset = isFile ? robotlink::Presets::loadFile(nameOrFile)
                       : robotlink::Presets(robotlink::userDirectory() / "presets").load(nameOrFile);
  if (!preset) return tl::unexpected(Errors{preset.error()});
  Errors errors = problemsOf(*preset);
  for (auto& error : errors) error.text = "preset " + nameOrFile + ": " + error.text;
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return *preset;
}

std::shared_ptr<const Preset> withShadows(std::shared_ptr<const Preset> preset,
                                          const std::vector<robotlink::ShadowName>& shadows) {
  if (shadows.empty()) return preset;
  Preset all = preset ? *preset : Preset();
  auto& keys = all.parts[Preset::kKeys];
  if (!keys) keys.emplace();
  for (const auto& shadow : shadows)
    keys->emplace(robotlink::shadowKey(shadow.task, shadow.solution), "always");
  return std::make_shared<const Preset>(std::move(all));
}

std::vector<Request> requestsOf(const Preset& preset,
                                const std::vector<robotcontrol::ParameterValues>& parameters) {
  std::vector<Request> requests;
  for (const auto& [key, mode] : valuesOf(preset, Preset::kKeys)) requests.push_back(keyRequest(key, mode));
  for (const auto& values : parameters) {
    const auto message = robotlink::parsedMessage(values.value().type(), values.value().data());
    bool isChanged = false;
    for (const auto& [name, value] : valuesOf(preset, Preset::kParameters)) {
      const ParameterName parameter = parameterNameOf(name);
      if (message == nullptr || parameter.task != values.task() || parameter.solution != values.solution())
        continue;
      isChanged |= setField(*message, parameter.path, value).has_value();
    }
    if (!isChanged) continue;
    auto& set = *requests.emplace_back().mutable_set_parameters();
    set.set_task(values.task());
    set.set_solution(values.solution());
    set.mutable_value()->set_type(values.value().type());
    set.mutable_value()->set_data(message->SerializeAsString());
  }
  for (const auto& [task, solution] : valuesOf(preset, Preset::kSolutions)) {
    auto& select = *requests.emplace_back().mutable_select_solution();
    select.set_task(task);
    select.set_solution(solution);
  }
  return requests;
}

}  // namespace app
