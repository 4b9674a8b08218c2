// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "robotlink/process/Layout.h"

namespace google::protobuf {
class Descriptor;
}

namespace robotlink {

/// The catalog of all registered solutions, for layout checks.
TaskCatalog registeredTasks();

/// The message types of the packages of all registered solutions, for code that creates packages from other
/// sources, such as a log.
std::map<std::string, const google::protobuf::Descriptor*> packageTypes();
/// The types of the packages of all registered tasks and of all packages of Packages.h, for code that passes
/// on what it does not use.
std::map<std::string, const google::protobuf::Descriptor*> allPackageTypes();

}  // namespace robotlink
