// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/FieldJson.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/util/json_util.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "widgets/data/FieldText.h"

namespace widgets {
namespace {

using google::protobuf::Message;

constexpr int kIndent = 2;

/// Fields without presence are written, too, even if they have the default value.
nlohmann::ordered_json parsedJson(const Message& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  options.always_print_primitive_fields = true;
  std::string text;
  if (!google::protobuf::util::MessageToJsonString(message, &text, options).ok()) return {};
  return nlohmann::ordered_json::parse(text, nullptr, false);
}

QString indented(const nlohmann::ordered_json& json) {
  return QString::fromStdString(json.dump(kIndent, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

QString jsonOf(const Message& message) {
  return indented(parsedJson(message));
}

QString jsonOf(const FieldPlace& place) {
  if (!place.isSet()) return QStringLiteral("null");
  if (const Message* message = place.message()) return jsonOf(*message);
  // The value alone, in a message of its own.
  const std::unique_ptr<Message> copy(place.holder->New());
  copy->CopyFrom(*place.holder);
  for (int i = 0; i < copy->GetDescriptor()->field_count(); ++i) {
    const auto* field = copy->GetDescriptor()->field(i);
    if (field != place.field) copy->GetReflection()->ClearField(copy.get(), field);
  }
  const nlohmann::ordered_json all = parsedJson(*copy);
  const auto found = all.find(place.field->name());
  if (found == all.end()) return QStringLiteral("null");
  const bool isElement = place.element >= 0 && found->is_array();
  return indented(isElement ? found->at(static_cast<std::size_t>(place.element)) : *found);
}

}  // namespace widgets
