#pragma once

#include <atomic>

#include "sightline/render/film.h"

namespace sightline {

struct ExposureOptions {
  int threads = 0;  ///< 0: as many as there are. The picture is the same.
  int tile_side = 32;
};

/// Exposes a film until it is done: tiles of a pass are handed out to threads one by one. True then; false where
/// `stops` became true, once the tiles under way were put on the film: another call goes on.
///   E1  Ends with the same film for any options, and however often it was stopped (F1).
/// \throws what the source does; the film keeps the tiles that were done.
bool expose(Film& film, const PictureSource& source, const ExposureOptions& options, const std::atomic<bool>& stops);

}  // namespace sightline
