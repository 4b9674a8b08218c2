// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "logplayer/mcap/Records.h"
#include "robotlink/base/Error.h"

namespace logplayer::mcap {

/// Writes an MCAP file (https://mcap.dev/spec): messages in chunks with indexes, a summary at the end.
///
/// A chunk is handed to the operating system as soon as it is complete: when it holds `chunkBytes`, or
/// `chunkAge` of real time after its first message (looked at by write() and by tick()). A message of
/// `ownChunkBytes` or more gets a chunk of its own. Between beginGroup() and endGroup() chunks stay open, so
/// that what belongs together (a frame) is written at once: whoever reads a file whose writer was killed
/// finds a group whole, apart from messages with chunks of their own, which come before the rest of it.
///
/// Nothing is silent: the first error of the operating system is kept, ends the file for good, and every
/// later call returns it; what was written before can be read. The file exists under its name from the start
/// and must not have existed. One thread at a time. Without close() the file lacks its summary, as after a
/// crash; the destructor closes.
class Writer {
 public:
  struct Options {
    Compression compression = Compression::kNone;
    int level = 0;  ///< of the compressor; 0: lz4's fast mode, zstd's 1
    bool crc = true;
    std::size_t chunkBytes = 1U << 20U;
    robotlink::Duration chunkAge = std::chrono::seconds(1);
    std::size_t ownChunkBytes = 200U << 10U;
    std::string profile;
    std::string library;  ///< who wrote it
    /// Tells the real time of chunkAge; null: the system's steady clock. For tests.
    const robotlink::Clock* clock = nullptr;
  };

  static robotlink::Result<std::unique_ptr<Writer>> create(const std::filesystem::path& file,
                                                           Options options);
  /// Goes on with a complete file behind its last chunk; its summary is written anew by close(). Whoever is
  /// killed in between leaves a file that lacks its summary, with all that was in it.
  static robotlink::Result<std::unique_ptr<Writer>> append(const std::filesystem::path& file,
                                                           Options options);
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// The same name, encoding and data give the same id. Fails past 65,535.
  robotlink::Result<std::uint16_t> addSchema(const std::string& name, const std::string& encoding,
                                             const std::string& data);
  robotlink::Result<std::uint16_t> addChannel(const std::string& topic, std::uint16_t schemaId,
                                              const std::string& messageEncoding,
                                              const std::map<std::string, std::string>& metadata);
  /// The channel must have been added.
  robotlink::Result<void> write(const Message& message);
  void beginGroup();
  robotlink::Result<void> endGroup();
  /// Writes the open chunk if it is old enough; for when no messages come.
  robotlink::Result<void> tick();
  /// Writes the open chunk whatever its age.
  robotlink::Result<void> flush();
  /// Both close the open chunk.
  robotlink::Result<void> attach(const Attachment& attachment);
  robotlink::Result<void> addMetadata(const Metadata& metadata);
  /// Summary, footer, and fsync. Idempotent.
  robotlink::Result<void> close();

  const Statistics& statistics() const;
  /// Bytes handed to the operating system.
  std::uint64_t bytesWritten() const;
  /// The error that ended the file; null if there was none.
  const robotlink::Error* error() const;

 private:
  struct Implementation;
  explicit Writer(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace logplayer::mcap
