// SPDX-License-Identifier: GPL-3.0-or-later
// How long it takes to look through all images of the real log; opening it is measured alone, too.
#include <benchmark/benchmark.h>

#include <condition_variable>
#include <mutex>

#include "colortool/table/NamedColorTable.h"
#include "logplayer/file/LogFile.h"
#include "widgets/color/FrameSearch.h"

namespace {

const std::filesystem::path kData = ROBOTCONTROL_SOURCE_DIR "/../shared/data";

void openTheLog(benchmark::State& state) {
  for (auto unused : state) {
    static_cast<void>(unused);
    if (!logplayer::LogFile::open(kData / "logs/bhuman2009.log", {}))
      return state.SkipWithError("the real log is not here");
  }
}
BENCHMARK(openTheLog)->UseRealTime()->Unit(benchmark::kMillisecond);

void searchTheLog(benchmark::State& state) {
  const auto named = colortool::NamedColorTable::load(kData / "colour/bhuman2009/tables/default.c64");
  if (!named) return state.SkipWithError("the real table is not here");
  const auto numbers = classNumbers(named->classes, named->classes);
  const auto table = std::make_shared<const colortool::ColorTable>(
      colortool::ColorTable::translated(named->file.singleClasses(), numbers));
  std::uint64_t images = 0;
  for (auto unused : state) {
    static_cast<void>(unused);
    std::mutex mutex;
    std::condition_variable news;
    bool reported = false;
    widgets::FrameQuery query{widgets::LoggedImages{kData / "logs/bhuman2009.log", "nao/camera/image"},
                              table,
                              {},
                              objectClasses(named->classes)};
    widgets::FrameSearch search(std::move(query), [&] {
      const std::lock_guard lock(mutex);
      reported = true;
      news.notify_one();
    });
    while (!search.progress().ended) {
      std::unique_lock lock(mutex);
      news.wait(lock, [&] { return std::exchange(reported, false); });
    }
    images = search.progress().seen;
  }
  state.counters["images"] = static_cast<double>(images);
}
BENCHMARK(searchTheLog)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
