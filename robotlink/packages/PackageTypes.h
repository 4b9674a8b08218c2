// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace google::protobuf {
class Descriptor;
}

namespace robotlink {

/// The types of the packages of Packages.h by their names.
const std::map<std::string, const google::protobuf::Descriptor*>& ownPackageTypes();

/// The type that packages of a name have in this program; null: the name is none of Packages.h, and tasks of
/// this program do not use it. Receivers rely on it: what another program sends under this name has to be of
/// this type.
const google::protobuf::Descriptor* typeOfPackage(const std::string& package);

}  // namespace robotlink
