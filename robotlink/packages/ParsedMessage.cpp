// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/ParsedMessage.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <limits>

namespace robotlink {

std::shared_ptr<google::protobuf::Message> parsedMessage(const std::string& type, std::string_view bytes) {
  const auto* descriptor = google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(type);
  if (descriptor == nullptr || bytes.size() > std::numeric_limits<int>::max()) return nullptr;
  const auto* prototype = google::protobuf::MessageFactory::generated_factory()->GetPrototype(descriptor);
  std::shared_ptr<google::protobuf::Message> message(prototype->New());
  return message->ParseFromArray(bytes.data(), static_cast<int>(bytes.size())) ? message : nullptr;
}

}  // namespace robotlink
