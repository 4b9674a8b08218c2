// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "logplayer/mcap/read/ReadTypes.h"
#include "robotlink/base/Error.h"

namespace logplayer::mcap {

class Source;
struct FileIndex;
struct ReaderParts;

/// Reads MCAP files (https://mcap.dev/spec) lazily: memory is bounded by the cache of chunks, the index, and
/// `maxRecordBytes`, whatever the file claims.
///
/// A file with a summary is opened by it. A file without one (its writer was killed), or whose summary turns
/// out to be wrong, also later, is scanned from record to record without decompressing; after damage the
/// next plausible chunk is searched; as long as a reader of such a file exists, others share its index.
/// CRCs are checked where there are any. Unreadable data is counted in damage(), also if it is only
/// found later; reading continues behind it. Messages outside of chunks are read, too.
///
/// One thread at a time. See MessageData for the lifetime of message data.
class Reader {
 public:
  using Options = ReadOptions;
  using ChunkInfo = mcap::ChunkInfo;
  using MessageData = mcap::MessageData;

  /// Fails if the file cannot be opened, nothing in it is MCAP, or the scan is canceled.
  static robotlink::Result<std::unique_ptr<Reader>> open(const std::filesystem::path& file, Options options);
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const Header& header() const;
  /// Keyed by id.
  const std::map<std::uint16_t, Schema>& schemas() const;
  /// Keyed by id.
  const std::map<std::uint16_t, Channel>& channels() const;
  /// Counted by the scan if the file contains none.
  const Statistics& statistics() const;
  const std::vector<ChunkInfo>& chunks() const;
  /// Whether the file was closed properly and its summary is consistent.
  bool complete() const;
  /// Returns the damage found so far.
  const std::vector<Damage>& damage() const;
  /// Number of bytes that the file has lost at its end since it was opened; queries the operating system.
  std::uint64_t cutOffBytes() const;

  // Find messages in order of time, whatever their order in the file. They use the message indexes, without
  // decompressing, where there are any; the indexes of some chunks are kept, not those of all. For reading
  // many messages one after the other a MessageCursor is faster.
  /// Returns the newest message of a channel that is not later than `time`.
  std::optional<MessagePosition> latest(std::uint16_t channelId, Instant time);
  /// The first message after, or the last before, a position among the messages of some channels; `than` need
  /// not be the position of a message. Fast when called with its last result.
  std::optional<MessagePosition> next(const MessagePosition& than,
                                      const std::vector<std::uint16_t>& channels);
  std::optional<MessagePosition> previous(const MessagePosition& than,
                                          const std::vector<std::uint16_t>& channels);
  /// The times of all messages of a channel, sorted. Reads the message indexes of all chunks.
  std::vector<Instant> times(std::uint16_t channelId);

  /// Fails if the chunk is damaged, which then is in damage(), too.
  robotlink::Result<MessageData> read(const MessagePosition& position);

  /// Visits all messages in the order of the file, which is the fastest way to read all. Damaged chunks are
  /// skipped. Ends when `visit` returns false.
  void readAll(const std::function<bool(const Message&)>& visit);

  /// In the order of the file; names may occur twice.
  std::vector<std::string> attachmentNames() const;
  /// The first attachment of this name; fails if there is none or it is damaged.
  robotlink::Result<Attachment> attachment(const std::string& name);
  /// All metadata records; read at the first call.
  const std::vector<Metadata>& metadata();

  /// The data that verify() could read.
  struct Readable {
    std::uint64_t messages = 0;
    std::uint64_t chunks = 0;
  };
  /// Reads the whole file, checks all CRCs, and adds what is wrong to damage(). Empty if canceled by the
  /// progress callback.
  std::optional<Readable> verify();

 private:
  friend class MessageCursor;
  static std::unique_ptr<Reader> of(Source source, Options options, FileIndex index,
                                    std::shared_ptr<const FileIndex> known);
  explicit Reader(std::unique_ptr<ReaderParts> parts);
  std::unique_ptr<ReaderParts> parts_;
};

/// The result of repair().
struct RepairReport {
  /// Number of messages in the new file.
  std::uint64_t messages = 0;
  std::uint64_t chunksLost = 0;
  std::uint64_t bytesLost = 0;
  /// The damage of the old file.
  std::vector<Damage> damage;
};

/// Writes everything that can be read from a file into a new, complete one, and verifies the result by
/// reading it again. The new file must not exist; it is removed if anything fails.
robotlink::Result<RepairReport> repair(const std::filesystem::path& from, const std::filesystem::path& to,
                                       const std::function<bool(double)>& progress = {});

}  // namespace logplayer::mcap
