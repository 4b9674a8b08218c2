// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "logplayer/mcap/Records.h"
#include "robotlink/base/Error.h"

namespace logplayer::mcap {

/// Writes an MCAP file (https://mcap.dev/spec): messages in chunks with indexes, and a summary at the end.
///
/// A chunk is written as soon as it is complete: when it contains `chunkBytes`, or `chunkAge` of real time
/// after its first message (checked by write() and tick()). A message of `ownChunkBytes` or more gets a chunk
/// of its own. Between beginGroup() and endGroup() chunks stay open, so that related messages (a frame) are
/// written at once: after a crash of the writer, a reader finds a group completely, except that messages with
/// chunks of their own precede the rest.
///
/// The first error of the operating system is stored, ends the file, and is returned by every later call;
/// what was written before remains readable. The file exists under its name from the start; create() fails if
/// it exists already. One thread at a time. Without close() the file lacks its summary, as after a crash; the
/// destructor closes.
class Writer {
 public:
  /// The format of the file.
  struct Options {
    Compression compression = Compression::kNone;
    /// Compression level; 0: the fast mode of lz4, level 1 of zstd.
    int level = 0;
    /// Whether CRCs are computed.
    bool crc = true;
    /// Whether close() blocks until the file is on the disk; not for files that do not outlive the program.
    bool sync = true;
    /// Uncompressed size at which a chunk is written.
    std::size_t chunkBytes = 1U << 20U;
    /// Real time after which an open chunk is written.
    robotlink::Duration chunkAge = std::chrono::seconds(1);
    /// Size from which a message gets a chunk of its own.
    std::size_t ownChunkBytes = 200U << 10U;
    std::string profile;
    /// The software that writes the file.
    std::string library;
    /// The clock for chunkAge, for tests; null: the system's steady clock.
    const robotlink::Clock* clock = nullptr;
  };

  /// Creates the file and writes its header.
  static robotlink::Result<std::unique_ptr<Writer>> create(const std::filesystem::path& file,
                                                           Options options);
  /// Continues a complete file behind its last chunk; close() writes a new summary. After a crash in between,
  /// the file lacks its summary but contains everything that was in it.
  static robotlink::Result<std::unique_ptr<Writer>> append(const std::filesystem::path& file,
                                                           Options options);
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Returns the id of a schema; equal arguments yield the same id. Fails after 65,535 schemas.
  robotlink::Result<std::uint16_t> addSchema(const std::string& name, const std::string& encoding,
                                             const std::string& data);
  /// Returns the id of a channel; equal arguments yield the same id.
  robotlink::Result<std::uint16_t> addChannel(const std::string& topic, std::uint16_t schemaId,
                                              const std::string& messageEncoding,
                                              const std::map<std::string, std::string>& metadata);
  /// Adds a message to the open chunk; its channel must have been added.
  robotlink::Result<void> write(const Message& message);
  /// Groups cannot be nested.
  void beginGroup();
  robotlink::Result<void> endGroup();
  /// Writes the open chunk if it is old enough; call this regularly while no messages arrive.
  robotlink::Result<void> tick();
  /// Writes the open chunk whatever its age; within a group at the end of the group.
  robotlink::Result<void> flush();
  /// Writes the open chunk, then an attachment.
  robotlink::Result<void> attach(const Attachment& attachment);
  /// Writes the open chunk, then a metadata record.
  robotlink::Result<void> addMetadata(const Metadata& metadata);
  /// Writes summary and footer, and calls fsync unless Options::sync is off. Idempotent.
  robotlink::Result<void> close();

  /// The numbers of records so far.
  const Statistics& statistics() const;
  /// Number of bytes passed to the operating system.
  std::uint64_t bytesWritten() const;

 private:
  struct Implementation;
  explicit Writer(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace logplayer::mcap
