// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace google::protobuf {
class Message;
}

namespace widgets {

struct FieldPlace;

// Parts of messages as indented JSON, with the fields' original names, as Protobuf writes it.

QString jsonOf(const google::protobuf::Message& message);
/// A value, a list or one element.
QString jsonOf(const FieldPlace& place);

}  // namespace widgets
