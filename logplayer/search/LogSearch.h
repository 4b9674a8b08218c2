// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "logplayer/export/ExportOptions.h"
#include "logplayer/file/LogFile.h"
#include "logplayer/search/Computation.h"
#include "logplayer/search/ConditionMatcher.h"
#include "logplayer/search/MessageSource.h"

namespace logplayer {

/// The result of a search.
struct SearchReport {
  std::uint64_t hits = 0;
  /// The streams that the log lacks, and that its robots' programs have computed for the search.
  std::set<std::string> computed = {};
  /// The parts that could not be searched, one sentence each; empty if everything was searched.
  std::vector<std::string> losses;
};

/// Searches a log, without playing it, for where an expression (robotlink/expressions/EXPRESSIONS.md) becomes
/// true, for each robot. Messages of the same time count together, but texts (foxglove.Log) are hits one by
/// one. Values that were published before the range count, too. `found` is called in order of the time at
/// which a hit is complete, and ends the search by returning false. Fails if the expression does not fit the
/// log, or with "log.given-up" if the progress callback returns false. `options.overwrite` has no meaning.
///
/// If the expression names streams that the log lacks, they are `computed` from the whole log up to the end
/// of the range, which takes as long as the programs do; memory is bounded.
robotlink::Result<SearchReport> searchLog(const std::shared_ptr<LogFile>& log, std::string_view expression,
                                          const ExportOptions& options,
                                          const std::function<bool(const SearchHit&)>& found,
                                          const ComputedStreams& computed = {});

/// The same for all messages of a source that is not open yet, such as the history of live robots; `robots`
/// are those whose streams are in it. Nothing is computed.
robotlink::Result<SearchReport> searchMessages(MessageSource& source, std::string_view expression,
                                               const std::vector<std::string>& robots,
                                               const Progress& progress,
                                               const std::function<bool(const SearchHit&)>& found);

}  // namespace logplayer
