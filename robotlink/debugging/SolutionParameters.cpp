// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/SolutionParameters.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <cmath>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Utf8.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Schema.h"

namespace robotlink {
namespace {

namespace pb = google::protobuf;

class Collector final : public pb::io::ErrorCollector {
 public:
  explicit Collector(std::string file) : file_(std::move(file)) {}
  void AddError(int line, pb::io::ColumnNumber column, const std::string& message) override {
    errors_.push_back({"parameters.text", message, {message}, {file_, line + 1, column + 1}});
  }
  void AddWarning(int line, pb::io::ColumnNumber column, const std::string& message) override {
    AddError(line, column, message);
  }
  const Errors& errors() const { return errors_; }

 private:
  std::string file_;
  Errors errors_;
};

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
    switch (field.cpp_type()) {
      case pb::FieldDescriptor::CPPTYPE_DOUBLE:
        if (!std::isfinite(field.is_repeated() ? reflection.GetRepeatedDouble(message, &field, i)
                                               : reflection.GetDouble(message, &field)))
          return false;
        break;
      case pb::FieldDescriptor::CPPTYPE_FLOAT:
        if (!std::isfinite(field.is_repeated() ? reflection.GetRepeatedFloat(message, &field, i)
                                               : reflection.GetFloat(message, &field)))
          return false;
        break;
      case pb::FieldDescriptor::CPPTYPE_MESSAGE:
        if (!firstUnsound(field.is_repeated() ? reflection.GetRepeatedMessage(message, &field, i)
                                              : reflection.GetMessage(message, &field))
                 .empty())
          return false;
        break;
      case pb::FieldDescriptor::CPPTYPE_STRING: {
        const std::string text = field.is_repeated() ? reflection.GetRepeatedString(message, &field, i)
                                                     : reflection.GetString(message, &field);
        if (field.type() == pb::FieldDescriptor::TYPE_STRING && validUtf8(text) != text) return false;
        break;
      }
      default:
        break;
    }
  }
  return true;
}

}  // namespace

SolutionParameters::SolutionParameters(std::unique_ptr<pb::Message> message)
    : message_(std::move(message)), defaults_(message_ ? message_->SerializeAsString() : std::string()) {}
SolutionParameters::SolutionParameters(SolutionParameters&&) noexcept = default;
SolutionParameters& SolutionParameters::operator=(SolutionParameters&&) noexcept = default;
SolutionParameters::~SolutionParameters() = default;

SolutionParameters SolutionParameters::clone() const {
  std::unique_ptr<pb::Message> copy(message_ ? message_->New() : nullptr);
  if (copy) copy->CopyFrom(*message_);
  SolutionParameters result(std::move(copy));
  result.defaults_ = defaults_;
  return result;
}

tl::expected<SolutionParameters, Errors> SolutionParameters::load(const SolutionDescription& solution,
                                                                  const std::filesystem::path& folder) {
  if (solution.parameters == nullptr) return SolutionParameters(nullptr);
  std::unique_ptr<pb::Message> message(solution.parameters->New());
  const auto file = folder / (solution.task + "." + solution.name + ".textproto");
  std::error_code error;
  if (folder.empty() || !std::filesystem::exists(file, error)) return SolutionParameters(std::move(message));
  const auto text = readFile(file);
  if (!text) return tl::unexpected(Errors{text.error()});
  Collector collector(file.string());
  pb::TextFormat::Parser parser;
  parser.RecordErrorsTo(&collector);
  const bool parsed = parser.ParseFromString(*text, message.get());
  if (!collector.errors().empty()) return tl::unexpected(collector.errors());
  const std::string unsound = firstUnsound(*message);
  if (!parsed || !unsound.empty()) {
    const std::string what = parsed ? "'" + unsound + "' is not a finite number, or not a text in UTF-8"
                                    : "not readable as text of protobuf";
    return tl::unexpected(Errors{{"parameters.value", what, {unsound}, {file.string(), 0, 0}}});
  }
  return SolutionParameters(std::move(message));
}

Result<void> SolutionParameters::set(const robotcontrol::PackageCopy& value) {
  if (!message_) return failure("parameters.none", "the solution has no parameters");
  const std::string& type = message_->GetDescriptor()->full_name();
  if (value.type() != type) {
    return failure("parameters.type", "its parameters are a " + type + ", not a '" + value.type() + "'", {},
                   {type, value.type()});
  }
  const std::unique_ptr<pb::Message> parsed(message_->New());
  if (!parsed->ParseFromString(value.data())) {
    return failure("parameters.damaged", "the bytes are no " + type, {}, {type});
  }
  if (const std::string field = firstUnsound(*parsed); !field.empty()) {
    return failure("parameters.value", "'" + field + "' is not a finite number, or not a text in UTF-8", {},
                   {field});
  }
  message_->CopyFrom(*parsed);
  return {};
}

void SolutionParameters::describe(robotcontrol::ParameterValues& to) const {
  if (!message_) return;
  to.mutable_value()->set_type(message_->GetDescriptor()->full_name());
  message_->SerializeToString(to.mutable_value()->mutable_data());
  to.mutable_defaults()->set_type(to.value().type());
  to.mutable_defaults()->set_data(defaults_);
  to.set_descriptors(schemaOf(*message_->GetDescriptor()));
}

}  // namespace robotlink
