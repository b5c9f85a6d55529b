#pragma once
/// Rays by the million at edges and vertices of closed meshes, through every structure and by every kind of query.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/io/progress.h"
#include "sightline/math/level.h"
#include "sightline/query/accelerator_spec.h"

namespace sightline::hard {

/// How a ray is asked about.
struct LeakWay {
  enum class How { single, stream, packet };
  How how;
  bool is_any;     ///< Else the closest hit.
  bool is_double;  ///< Else rays of float.
  int share;       ///< Of so many batches, beside the others. Most rays are of the kind that takes least time.
  std::string_view name;
};
inline constexpr std::array<LeakWay, 12> leak_ways{{
    {LeakWay::How::single, false, false, 3, "closest, float"},
    {LeakWay::How::single, true, false, 18, "any, float"},
    {LeakWay::How::stream, false, false, 3, "stream closest, float"},
    {LeakWay::How::stream, true, false, 18, "stream any, float"},
    {LeakWay::How::packet, false, false, 3, "packet closest, float"},
    {LeakWay::How::packet, true, false, 18, "packet any, float"},
    {LeakWay::How::single, false, true, 1, "closest, double"},
    {LeakWay::How::single, true, true, 1, "any, double"},
    {LeakWay::How::stream, false, true, 1, "stream closest, double"},
    {LeakWay::How::stream, true, true, 1, "stream any, double"},
    {LeakWay::How::packet, false, true, 1, "packet closest, double"},
    {LeakWay::How::packet, true, true, 1, "packet any, double"},
}};

struct LeakPlan {
  std::uint64_t rays = 1'000'000;           ///< In all; structures share them evenly.
  std::vector<AcceleratorSpec> structures;  ///< None: all of the registry.
  Level level = Level::watertight;          ///< Or `fast`, at which rays of double are asked as well as ever.
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0 for as many as there are.
  std::filesystem::path data_dir;
};

/// What a structure has let through.
struct LeakRow {
  struct Count {
    std::uint64_t rays = 0, leaks = 0;
  };
  std::string structure;
  std::array<Count, leak_ways.size()> ways{};
  double seconds = 0;      ///< Of processors, for queries and for making rays.
  std::string first_leak;  ///< All that is needed to ask again.

  std::uint64_t rays() const;
  std::uint64_t leaks() const;
};

struct LeakReport {
  std::uint64_t seed = 0;
  Level level = Level::watertight;
  std::vector<std::string> meshes;
  std::uint64_t triangles = 0;  ///< Of all meshes.
  int threads = 0;
  std::vector<LeakRow> rows;

  std::uint64_t rays() const;
  std::uint64_t leaks() const;
};

/// \throws std::invalid_argument for an unknown structure or option, for no rays, and for a level that triangles do not
/// know.
LeakReport hunt_leaks(const LeakPlan& plan, Progress& progress);

}  // namespace sightline::hard
