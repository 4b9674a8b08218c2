// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace google::protobuf {
class Message;
}

namespace robotlink {

struct FieldDescription;
struct PackageErrors;

/// The packages that can be compared with the truth.
std::vector<std::string> comparablePackages();

/// The package of the oracle with which a package is compared.
const char* truthOf(std::string_view package);

/// Adds how far a package is from the truth of its time, a package of truthOf(). Values of other types are
/// skipped, as is what needs a field if there is none.
void comparePackage(const std::string& package, const google::protobuf::Message& value,
                    const google::protobuf::Message& truth, const FieldDescription* field,
                    PackageErrors& errors);

}  // namespace robotlink
