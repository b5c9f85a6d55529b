#pragma once
/// Pictures of films.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "sightline/io/layered_image.h"
#include "sightline/render/film.h"

namespace sightline {

/// What a picture may tell of its pixels beside their colors (arbitrary output variables).
enum class Aov : std::uint8_t { depth, normal, id, cost, samples };

struct AovInfo {
  Aov aov;
  std::string_view name;
  std::array<std::string_view, 3> channels;  ///< Those not used are empty.
  std::string_view help;
};
inline constexpr std::array<AovInfo, 5> aov_infos{{
    {Aov::depth, "depth", {"Z"}, "from the camera along the ray; infinite where nothing is"},
    {Aov::normal, "normal", {"N.X", "N.Y", "N.Z"}, "in the world, of unit length; 0 where nothing is"},
    {Aov::id, "id", {"id"}, "number of the element in the scene; -1 where nothing is"},
    {Aov::cost, "cost", {"cost"}, "nodes, leaves and candidates that the camera's ray examined"},
    {Aov::samples, "samples", {"samples"}, "samples that the pixel got"},
}};
constexpr const AovInfo& info_of(Aov aov) { return aov_infos[static_cast<std::size_t>(aov)]; }

/// What a film has to be asked to record for them.
FactsAsked facts_for(std::span<const Aov> aovs);

/// Means of the samples in channels R, G and B, multiplied by 2^exposure, and behind them channels as AovInfo names
/// them. Pixels that have no sample are black, with nothing there.
LayeredImage picture_of(const FilmState& film, double exposure, std::span<const Aov> aovs = {});

/// The channels of one of them alone.
LayeredImage picture_of(const FilmState& film, Aov aov);

}  // namespace sightline
