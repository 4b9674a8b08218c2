// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/DynamicTypes.h"

#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/duration.pb.h>
#include <google/protobuf/timestamp.pb.h>

namespace robotlink {

void addTimeTypes(google::protobuf::DescriptorPool& pool) {
  SilentErrors silence;
  for (const auto* imported :
       {google::protobuf::Timestamp::descriptor(), google::protobuf::Duration::descriptor()}) {
    google::protobuf::FileDescriptorProto file;
    imported->file()->CopyTo(&file);
    pool.BuildFileCollectingErrors(file, &silence);
  }
}

}  // namespace robotlink
