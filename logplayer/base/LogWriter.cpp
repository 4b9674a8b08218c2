// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/LogWriter.h"

#include <google/protobuf/message.h>

#include <limits>

#include "robotlink/packages/Schema.h"

namespace logplayer {

using google::protobuf::Descriptor;
using robotlink::Result;
using robotlink::StreamMessage;

namespace {

constexpr char kProtobuf[] = "protobuf";

struct ChannelKey {
  std::string path;
  std::string process;
  const Descriptor* type = nullptr;
  auto operator<=>(const ChannelKey&) const = default;
};

}  // namespace

struct LogWriter::Implementation {
  Result<std::uint16_t> schemaFor(const StreamMessage& message);
  Result<std::uint16_t> channelFor(const StreamMessage& message);
  Result<void> writeMessage(const StreamMessage& message, std::uint16_t channel);

  std::unique_ptr<mcap::Writer> writer;
  std::map<const Descriptor*, std::uint16_t> schemas;
  std::map<ChannelKey, std::uint16_t> channels;
  // Dynamic types are destroyed with their last message; these messages keep them alive, so that no other
  // type can get their addresses, which are keys above.
  std::vector<robotlink::PackagePtr> typeOwners;
  std::string buffer;
};

LogWriter::LogWriter(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

LogWriter::~LogWriter() = default;

Result<std::unique_ptr<LogWriter>> LogWriter::create(const std::filesystem::path& file,
                                                     mcap::Writer::Options options) {
  auto writer = mcap::Writer::create(file, std::move(options));
  if (!writer) return tl::unexpected(writer.error());
  auto implementation = std::make_unique<Implementation>();
  implementation->writer = std::move(*writer);
  return std::unique_ptr<LogWriter>(new LogWriter(std::move(implementation)));
}

mcap::Writer& LogWriter::container() {
  return *implementation_->writer;
}

Result<std::uint16_t> LogWriter::Implementation::schemaFor(const StreamMessage& message) {
  const Descriptor* type = message.value->GetDescriptor();
  if (const auto found = schemas.find(type); found != schemas.end()) return found->second;
  const auto added = writer->addSchema(type->full_name(), kProtobuf, robotlink::schemaOf(*type));
  if (!added) return added;
  schemas.emplace(type, *added);
  if (type->file()->pool() != google::protobuf::DescriptorPool::generated_pool()) {
    typeOwners.push_back(message.value);
  }
  return added;
}

Result<std::uint16_t> LogWriter::Implementation::channelFor(const StreamMessage& message) {
  ChannelKey key{message.path, message.process, message.value->GetDescriptor()};
  if (const auto found = channels.find(key); found != channels.end()) return found->second;
  const auto schema = schemaFor(message);
  if (!schema) return schema;
  std::map<std::string, std::string> metadata;
  if (!message.process.empty()) metadata["process"] = message.process;
  const auto added = writer->addChannel(message.path, *schema, kProtobuf, metadata);
  if (added) channels.emplace(std::move(key), *added);
  return added;
}

Result<void> LogWriter::Implementation::writeMessage(const StreamMessage& message, std::uint16_t channel) {
  buffer.clear();
  if (!message.value->SerializeToString(&buffer)) {
    return robotlink::failure("log.message",
                              "a message of " + message.path +
                                  " is larger than the 2 GiB that a package may have; exclude this stream",
                              {}, {message.path});
  }
  mcap::Message record;
  record.channelId = channel;
  record.sequence = static_cast<std::uint32_t>(message.frame & std::numeric_limits<std::uint32_t>::max());
  record.logTime = record.publishTime = message.time;
  record.data = {reinterpret_cast<const std::uint8_t*>(buffer.data()), buffer.size()};
  return writer->write(record);
}

Result<void> LogWriter::write(const std::vector<StreamMessage>& frame) {
  Implementation& self = *implementation_;
  // All errors that are possible occur before anything of the frame is written.
  std::vector<std::uint16_t> channels;
  channels.reserve(frame.size());
  for (const StreamMessage& message : frame) {
    const auto channel = self.channelFor(message);
    if (!channel) return tl::unexpected(channel.error());
    channels.push_back(*channel);
  }
  self.writer->beginGroup();
  Result<void> result;
  for (std::size_t i = 0; i < frame.size() && result; ++i) result = self.writeMessage(frame[i], channels[i]);
  const Result<void> ended = self.writer->endGroup();
  return result ? ended : result;
}

}  // namespace logplayer
