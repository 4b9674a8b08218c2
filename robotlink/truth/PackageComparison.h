// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace google::protobuf {
class Message;
}
namespace robotcontrol {
class OracleWorld;
}

namespace robotlink {

struct FieldDescription;
struct PackageErrors;

/// The packages that can be compared with the truth.
std::vector<std::string> comparablePackages();

/// Adds how far a package is from the truth of its time. A value of another type than the package's is
/// skipped, as is what needs a field if there is none.
void comparePackage(const std::string& package, const google::protobuf::Message& value,
                    const robotcontrol::OracleWorld& truth, const FieldDescription* field,
                    PackageErrors& errors);

}  // namespace robotlink
