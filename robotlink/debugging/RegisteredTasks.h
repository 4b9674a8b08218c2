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

/// The packages of all registered solutions with their types, for those who make packages otherwise, from a
/// log.
std::map<std::string, const google::protobuf::Descriptor*> packageTypes();

}  // namespace robotlink
