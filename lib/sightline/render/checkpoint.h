#pragma once
/// A film as a file, to go on with what was stopped.

#include <cstdint>
#include <filesystem>

#include "sightline/render/film.h"

namespace sightline {

/// Writes it whole or not at all. `fingerprint` is that of the source. \throws FileError
void write_checkpoint(const std::filesystem::path& path, const FilmState& film, std::uint64_t fingerprint);

/// \throws FileError where the file is not a whole checkpoint, or not one of a film that began as `blank`, of a source
/// with this fingerprint: then another picture would come of it.
FilmState read_checkpoint(const std::filesystem::path& path, const FilmState& blank, std::uint64_t fingerprint);

}  // namespace sightline
