// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/Configuration.h"

#include "robotlink/arcos/ConfigurationFields.h"
#include "robotlink/arcos/WireFields.h"

namespace robotlink::arcos {
namespace {

/// Reads as many fields as there are.
struct PrefixReader {
  FieldReader& reader;
  int count = 0;
  bool ended = false;

  template <typename T>
  void operator()(const char*, T& value, const char* = "") {
    value = T{};
    ended = ended || !reader.take(value);
    if (!ended) ++count;
  }
};

struct PrefixWriter {
  FieldWriter& writer;
  int left;

  template <typename T>
  void operator()(const char* name, const T& value, const char* = "") {
    if (left-- > 0) writer(name, value);
  }
};

}  // namespace

Packet toPacket(const Configuration& configuration) {
  Packet packet{Configuration::kId, {}};
  packet.data.reserve(128);
  FieldWriter writer(packet.data);
  PrefixWriter prefix{writer, configuration.fieldCount};
  visitConfigurationFields(configuration, prefix);
  writer.rest(configuration.rest);
  writer.finish();
  return packet;
}

Result<Configuration> decodeConfiguration(const Packet& packet) {
  if (packet.id != Configuration::kId) {
    return failure("arcos.wrong-packet", "this is no configuration but packet " + std::to_string(packet.id));
  }
  Configuration configuration;
  FieldReader reader(packet.data);
  PrefixReader prefix{reader};
  visitConfigurationFields(configuration, prefix);
  configuration.fieldCount = prefix.count;
  reader.rest(configuration.rest);
  if (prefix.count < 3) {
    return failure("arcos.short-packet", "the robot's configuration ends before its serial number");
  }
  return configuration;
}

}  // namespace robotlink::arcos
