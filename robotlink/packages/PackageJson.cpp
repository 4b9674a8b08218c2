// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/PackageJson.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/util/json_util.h>

#include <memory>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/packages/PackageTypes.h"

namespace robotlink {
namespace {

using google::protobuf::FieldDescriptor;

constexpr int kMaxDepth = 4;
constexpr std::size_t kMaxText = 1U << 20U;  // bytes

/// Sets the messages within a message, so that their fields are printed.
void fill(google::protobuf::Message& message, int depth) {
  const auto& type = *message.GetDescriptor();
  for (int i = 0; i < type.field_count() && depth < kMaxDepth; ++i) {
    const FieldDescriptor& field = *type.field(i);
    const auto* alternatives = field.real_containing_oneof();
    const bool isFirst = alternatives == nullptr || alternatives->field(0) == &field;
    if (field.type() != FieldDescriptor::TYPE_MESSAGE || field.is_repeated() || !isFirst) continue;
    fill(*message.GetReflection()->MutableMessage(&message, &field), depth + 1);
  }
}

/// Null if there is no such package.
std::unique_ptr<google::protobuf::Message> newPackage(const std::string& package) {
  const auto found = ownPackageTypes().find(package);
  if (found == ownPackageTypes().end()) return nullptr;
  const auto* prototype = google::protobuf::MessageFactory::generated_factory()->GetPrototype(found->second);
  return std::unique_ptr<google::protobuf::Message>(prototype->New());
}

}  // namespace

std::string templateJson(google::protobuf::Message& message) {
  fill(message, 0);
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string json;
  if (!google::protobuf::util::MessageToJsonString(message, &json, options).ok()) return "{}";
  while (json.ends_with('\n')) json.pop_back();
  return json;
}

std::string packageTemplate(const std::string& package) {
  const auto message = newPackage(package);
  return message ? templateJson(*message) : "{}";
}

Result<robotcontrol::PackageCopy> packageFromJson(const std::string& package, const std::string& json) {
  const auto message = newPackage(package);
  if (!message) {
    std::vector<std::string> all;
    for (const auto& [name, type] : ownPackageTypes()) all.push_back(name);
    return failure("package.unknown", "there is no package " + package + suggestion(package, all), {},
                   {package});
  }
  if (json.size() > kMaxText) return failure("package.json", "the text is longer than 1 MiB");
  const auto status = google::protobuf::util::JsonStringToMessage(json.empty() ? "{}" : json, message.get());
  if (!status.ok()) return failure("package.json", std::string(status.message()));
  robotcontrol::PackageCopy copy;
  copy.set_type(message->GetDescriptor()->full_name());
  copy.set_data(message->SerializeAsString());
  return copy;
}

}  // namespace robotlink
