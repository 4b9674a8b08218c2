// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "logplayer/mcap/Records.h"
#include "robotlink/base/Error.h"

namespace logplayer::mcap {

class Source;
struct FileIndex;

/// Where in a file something could not be read.
struct Damage {
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;   ///< that were skipped, without zeros at the file's end
  std::string what;          ///< a sentence
  std::uint64_t chunks = 0;  ///< that were lost here, as far as one can tell
};

/// Where a message is: enough to read it, and to put it in order.
struct MessagePosition {
  Instant time;
  std::uint64_t chunkOffset = 0;  ///< in the file
  std::uint64_t offset = 0;       ///< in the chunk's uncompressed records
  std::uint16_t channelId = 0;
  /// Positions are ordered by time, equal times as in the file.
  auto operator<=>(const MessagePosition&) const = default;
};

/// Reads MCAP files (https://mcap.dev/spec) lazily: memory is bounded by the cache of chunks, the index, and
/// `maxRecordBytes`, whatever the file says.
///
/// A file with a summary is opened by it. One without (its writer was killed), or with a summary that turns
/// out to lie, also later, is scanned, hopping from record to record without decompressing; after damage the
/// next plausible chunk is looked for; as long as a reader of such a file exists, others know what it found.
/// CRCs are checked where there are any. What could not be read is counted in damage(), also what is only
/// found later; reading goes on behind it. Messages outside of chunks are read, too.
///
/// One thread at a time. Data of messages is valid as long as what holds it, see MessageData.
class Reader {
 public:
  struct Options {
    std::size_t cacheBytes = 64U << 20U;
    /// No chunk, attachment or record larger than this is read, whatever it says of itself.
    std::size_t maxRecordBytes = 1U << 30U;
    /// Called now and then while a file is scanned, with the share done in [0, 1]; false: give up, with
    /// "log.given-up".
    std::function<bool(double)> progress;
  };
  struct ChunkInfo {
    std::uint64_t offset = 0;  ///< of its record, in the file
    std::uint64_t length = 0;  ///< with opcode and length
    Instant start, end;
    Compression compression = Compression::kNone;
    std::uint64_t compressedBytes = 0;
    std::uint64_t uncompressedBytes = 0;
    std::uint64_t messages = 0;
  };

  /// Fails only if the file cannot be opened or nothing in it is MCAP.
  static robotlink::Result<std::unique_ptr<Reader>> open(const std::filesystem::path& file, Options options);
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const Header& header() const;
  const std::map<std::uint16_t, Schema>& schemas() const;
  const std::map<std::uint16_t, Channel>& channels() const;
  /// As counted where the file does not tell.
  const Statistics& statistics() const;
  const std::vector<ChunkInfo>& chunks() const;
  /// The file ends as it should, with a summary that fits.
  bool complete() const;
  const std::vector<Damage>& damage() const;
  std::uint64_t fileBytes() const;
  /// How many bytes somebody cut off the file's end since it was opened; asks the system.
  std::uint64_t cutOffBytes() const;

  // Where messages are, in order of time, whatever their order in the file. From the message indexes, without
  // decompressing, where there are any; the indexes of some chunks are kept, not those of all. For reading
  // many messages one after the other a MessageCursor is faster.
  /// The newest message of a channel that is not later than `time`.
  std::optional<MessagePosition> latest(std::uint16_t channelId, Instant time);
  /// The first behind, or the last before, a position among the messages of some channels; `than` need not
  /// be that of a message.
  std::optional<MessagePosition> next(const MessagePosition& than,
                                      const std::vector<std::uint16_t>& channels);
  std::optional<MessagePosition> previous(const MessagePosition& than,
                                          const std::vector<std::uint16_t>& channels);
  /// The times of all messages of a channel, sorted. Costs one look at every message index.
  std::vector<Instant> times(std::uint16_t channelId);

  /// A message with a share in the chunk that holds it.
  struct MessageData {
    Message message;
    std::shared_ptr<const std::vector<std::uint8_t>> owner;
  };
  /// Fails if its chunk is damaged; that is then in damage(), too.
  robotlink::Result<MessageData> read(const MessagePosition& position);

  /// All messages in the order of the file, whole chunks at a time; chunks that are damaged are left out.
  /// `visit` returns false to end it.
  void readAll(const std::function<bool(const Message&)>& visit);

  std::vector<std::string> attachmentNames() const;
  robotlink::Result<Attachment> attachment(const std::string& name);
  const std::vector<Metadata>& metadata();

  /// What of a file can be read.
  struct Readable {
    std::uint64_t messages = 0;
    std::uint64_t chunks = 0;
  };
  /// Reads everything and checks all CRCs; what is wrong is added to damage(). Nothing: given up by progress.
  std::optional<Readable> verify();

 private:
  friend class MessageCursor;
  struct Implementation;
  static std::unique_ptr<Reader> of(Source source, Options options, FileIndex index,
                                    std::shared_ptr<const FileIndex> known);
  explicit Reader(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

/// What a repair did.
struct RepairReport {
  std::uint64_t messages = 0;  ///< in the new file
  std::uint64_t chunksLost = 0;
  std::uint64_t bytesLost = 0;
  std::vector<Damage> damage;
};

/// Writes what can be read of a file into a new, complete one, which is read again and compared before this
/// returns. The new file must not exist; if something fails it is removed.
robotlink::Result<RepairReport> repair(const std::filesystem::path& from, const std::filesystem::path& to,
                                       const std::function<bool(double)>& progress = {});

}  // namespace logplayer::mcap
