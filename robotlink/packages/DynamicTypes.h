// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>

#include <string>

// Types that are built at run time, from what files and servers say about their messages.
namespace robotlink {

/// Discards the errors of a schema that is being built, instead of printing them. A foreign file may
/// hold anything: the failure of building it is sufficient.
class SilentErrors final : public google::protobuf::DescriptorPool::ErrorCollector {
 public:
  void AddError(const std::string&, const std::string&, const google::protobuf::Message*, ErrorLocation,
                const std::string&) override {}
};

/// Builds the files of Timestamp and Duration in a pool, for types that import them.
void addTimeTypes(google::protobuf::DescriptorPool& pool);

}  // namespace robotlink
