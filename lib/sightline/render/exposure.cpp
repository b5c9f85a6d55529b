#include "sightline/render/exposure.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>

namespace sightline {
namespace {

/// In the order of the list, whichever thread is free taking the next one.
void expose_tiles(Film& film, const PictureSource& source, const std::vector<TileRect>& tiles,
                  const std::atomic<bool>& stops) {
  std::atomic<std::size_t> next{0};
  tbb::parallel_for(
      0, tbb::this_task_arena::max_concurrency(),
      [&](int) {
        for (std::size_t i = next++; i < tiles.size() && !stops && !tbb::is_current_task_group_canceling();
             i = next++) {
          TileTask task = film.task(tiles[i]);
          RenderCounters counters;
          expose_tile(task, source, counters);
          film.put(task, counters);
        }
      },
      tbb::simple_partitioner());
}

}  // namespace

bool expose(Film& film, const PictureSource& source, const ExposureOptions& options, const std::atomic<bool>& stops) {
  const auto most = static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  tbb::task_arena arena(options.threads > 0 ? std::min(options.threads, most) : tbb::task_arena::automatic);
  while (!stops) {
    const std::vector<TileRect> tiles = film.open_tiles(options.tile_side);
    if (!tiles.empty()) {
      arena.execute([&] { expose_tiles(film, source, tiles, stops); });
    } else if (!film.begin_pass()) {
      return true;
    }
  }
  return false;
}

}  // namespace sightline
