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

/// The type that packages of a name have in this program; null: the name is not in Packages.h, and tasks of
/// this program do not use it. Receivers rely on it: packages of this name from other programs have to be of
/// this type.
const google::protobuf::Descriptor* typeOfPackage(const std::string& package);

}  // namespace robotlink
