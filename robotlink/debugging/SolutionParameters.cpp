// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/SolutionParameters.h"

#include <google/protobuf/descriptor.h>

#include <cmath>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Utf8.h"
#include "robotlink/debugging/ParameterText.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/FieldValues.h"
#include "robotlink/packages/Schema.h"

namespace robotlink {
namespace {

namespace pb = google::protobuf;

bool isSound(const pb::Message& message, const pb::FieldDescriptor& field);

/// Returns the name of the first field with a number that is not finite or with a text that is not UTF-8;
/// empty if there is none.
std::string firstUnsound(const pb::Message& message) {
  std::vector<const pb::FieldDescriptor*> fields;
  message.GetReflection()->ListFields(message, &fields);
  for (const pb::FieldDescriptor* field : fields) {
    if (!isSound(message, *field)) return field->name();
  }
  return {};
}

bool isSound(const pb::Message& message, const pb::FieldDescriptor& field) {
  const pb::Reflection& reflection = *message.GetReflection();
  const int count = field.is_repeated() ? reflection.FieldSize(message, &field) : 1;
  for (int i = 0; i < count; ++i) {
    const bool sound = visitValue(message, field, field.is_repeated() ? i : -1, [&](const auto& value) {
      using Value = std::decay_t<decltype(value)>;
      if constexpr (std::is_floating_point_v<Value>) {
        return std::isfinite(value);
      } else if constexpr (std::is_same_v<Value, pb::Message>) {
        return firstUnsound(value).empty();
      } else if constexpr (std::is_same_v<Value, std::string>) {
        return field.type() != pb::FieldDescriptor::TYPE_STRING || validUtf8(value) == value;
      } else {
        return true;
      }
    });
    if (!sound) return false;
  }
  return true;
}

std::unique_ptr<pb::Message> newOf(const pb::Message& message) {
  return std::unique_ptr<pb::Message>(message.New());
}

std::unique_ptr<pb::Message> copyOf(const pb::Message& message) {
  auto copy = newOf(message);
  copy->CopyFrom(message);
  return copy;
}

}  // namespace

SolutionParameters::SolutionParameters(std::unique_ptr<pb::Message> builtIn, const ParameterRules& rules)
    : builtIn_(std::move(builtIn)), rules_(rules) {
  if (builtIn_ == nullptr) return;
  message_ = copyOf(*builtIn_);
  markSaved();
}
SolutionParameters::SolutionParameters(SolutionParameters&&) noexcept = default;
SolutionParameters& SolutionParameters::operator=(SolutionParameters&&) noexcept = default;
SolutionParameters::~SolutionParameters() = default;

SolutionParameters SolutionParameters::clone() const {
  SolutionParameters result(builtIn_ ? copyOf(*builtIn_) : nullptr, rules_);
  if (message_) result.message_->CopyFrom(*message_);
  result.defaults_ = defaults_;
  result.file_ = file_;
  return result;
}

tl::expected<SolutionParameters, Errors> SolutionParameters::load(const SolutionDescription& solution,
                                                                  const std::filesystem::path& folder,
                                                                  const RobotSetup& robot) {
  if (solution.parameters == nullptr) return SolutionParameters(nullptr, {});
  const ParameterRules& rules = solution.parameterRules;
  SolutionParameters loaded(rules.builtIn ? rules.builtIn(robot) : newOf(*solution.parameters), rules);
  const auto file = folder / (solution.task + "." + solution.name + ".textproto");
  if (!folder.empty()) loaded.file_ = file.string();
  std::error_code error;
  if (folder.empty() || !std::filesystem::exists(file, error)) return loaded;
  const auto text = readFile(file);
  if (!text) return tl::unexpected(Errors{text.error()});
  const auto message = newOf(*solution.parameters);
  if (auto isRead = readParameterText(*text, file.string(), *message); !isRead)
    return tl::unexpected(isRead.error());
  if (const std::string unsound = firstUnsound(*message); !unsound.empty()) {
    return tl::unexpected(Errors{{"parameters.value",
                                  "'" + unsound + "' is not a finite number, or not a text in UTF-8",
                                  {unsound},
                                  {file.string(), 0, 0}}});
  }
  loaded.dropUnreasonable(*message);
  loaded.apply(*message);
  loaded.markSaved();
  return loaded;
}

void SolutionParameters::markSaved() {
  if (!message_) return;
  const auto saved = copyOf(*message_);
  clearControls(*saved);
  defaults_ = saved->SerializeAsString();
}

void SolutionParameters::apply(const pb::Message& wanted) {
  message_->CopyFrom(*builtIn_);
  message_->MergeFrom(wanted);
}

void SolutionParameters::dropUnreasonable(pb::Message& message) const {
  for (const auto& [field, range] : rules_.ranges) {
    const auto number = numberIn(message, field);
    if (number && !range.has(*number)) clearNumber(message, field);
  }
}

Result<std::unique_ptr<pb::Message>> SolutionParameters::parse(const robotcontrol::PackageCopy& value) const {
  if (!message_) return failure("parameters.none", "the solution has no parameters");
  const std::string& type = message_->GetDescriptor()->full_name();
  if (value.type() != type) {
    return failure("parameters.type", "its parameters are a " + type + ", not a '" + value.type() + "'", {},
                   {type, value.type()});
  }
  std::unique_ptr<pb::Message> parsed = newOf(*message_);
  if (!parsed->ParseFromString(value.data())) {
    return failure("parameters.damaged", "the bytes are not a valid " + type, {}, {type});
  }
  if (const std::string field = firstUnsound(*parsed); !field.empty()) {
    return failure("parameters.value", "'" + field + "' is not a finite number, or not a text in UTF-8", {},
                   {field});
  }
  return parsed;
}

Result<void> SolutionParameters::set(const robotcontrol::PackageCopy& value) {
  const auto parsed = parse(value);
  if (!parsed) return tl::unexpected(parsed.error());
  for (const auto& [field, range] : rules_.ranges) {
    const auto number = numberIn(**parsed, field);
    if (!number || range.has(*number)) continue;
    const std::string name = nameOf(*message_, field);
    return failure("parameters.range", "'" + name + "' has to be " + range.describe(), {},
                   {name, range.describe()});
  }
  // A value that a file has already, and that is wrong, does not keep others from being changed.
  if (const std::string wrong = rules_.check ? rules_.check(**parsed) : "";
      !wrong.empty() && wrong != rules_.check(*message_))
    return failure("parameters.value", wrong, {}, {wrong});
  apply(**parsed);
  return {};
}

Result<void> SolutionParameters::restore(const robotcontrol::PackageCopy& value) {
  const auto parsed = parse(value);
  if (!parsed) return tl::unexpected(parsed.error());
  dropUnreasonable(**parsed);
  apply(**parsed);
  return {};
}

void SolutionParameters::describe(robotcontrol::ParameterValues& to) const {
  if (!message_) return;
  to.mutable_value()->set_type(message_->GetDescriptor()->full_name());
  message_->SerializeToString(to.mutable_value()->mutable_data());
  to.mutable_defaults()->set_type(to.value().type());
  to.mutable_defaults()->set_data(defaults_);
  to.set_descriptors(schemaOf(*message_->GetDescriptor()));
  to.set_file(file_);
  to.mutable_built_in()->set_type(to.value().type());
  builtIn_->SerializeToString(to.mutable_built_in()->mutable_data());
  for (const auto& [field, range] : rules_.ranges) {
    auto& limits = *to.add_limits();
    limits.set_path(nameOf(*message_, field));
    limits.set_minimum(range.minimum);
    limits.set_maximum(range.maximum);
    limits.set_above(range.above);
  }
}

}  // namespace robotlink
