// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"

namespace google::protobuf {
class Message;
}
namespace robotcontrol {
class PackageCopy;
}

// Messages as JSON that a person fills in, with the fields' original names. Any thread.
namespace robotlink {

/// All of a message's fields with the values that they have by default, indented; of alternatives the first
/// one. Sets the messages within the message.
std::string templateJson(google::protobuf::Message& message);
/// The same for a package of Packages.h; "{}" for others.
std::string packageTemplate(const std::string& package);
/// The value of a package from the fields in a text; an empty text is all fields as by default. Fails if
/// there is no such package, if the text is longer than 1 MiB, or if it is no such JSON: the error then has
/// the path of the field that is unknown or of another type.
Result<robotcontrol::PackageCopy> packageFromJson(const std::string& package, const std::string& json);

}  // namespace robotlink
