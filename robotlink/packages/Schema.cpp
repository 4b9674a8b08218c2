// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/Schema.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>

#include <set>

namespace robotlink {
namespace {

namespace pb = google::protobuf;

void addWithImports(const pb::FileDescriptor& file, pb::FileDescriptorSet& to, std::set<std::string>& seen) {
  if (!seen.insert(file.name()).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) addWithImports(*file.dependency(i), to, seen);
  file.CopyTo(to.add_file());
}

}  // namespace

std::string schemaOf(const pb::Descriptor& type) {
  pb::FileDescriptorSet files;
  std::set<std::string> seen;
  addWithImports(*type.file(), files, seen);
  return files.SerializeAsString();
}

}  // namespace robotlink
