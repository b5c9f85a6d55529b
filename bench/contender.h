#pragma once
/// What is measured: anything that can be built over a mesh and asked for hits, ours or a peer.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "bench/asking.h"
#include "sightline/accel/probe.h"
#include "sightline/math/ray.h"
#include "sightline/query/accelerator_spec.h"

namespace sightline::bench {

/// Ready for queries, which run on the calling thread.
class Built {
 public:
  struct Bytes {
    std::size_t structure = 0;          ///< Nodes and leaf order; a peer's leaves as well.
    std::optional<std::size_t> leaves;  ///< Copies of the triangles, where they are counted apart.
    std::size_t total() const { return structure + leaves.value_or(0); }
  };

  virtual ~Built() = default;
  virtual void closest_hits(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const = 0;
  virtual void any_hits(std::span<const Ray<float>> rays, std::span<std::uint8_t> is_hit) const = 0;
  virtual Bytes bytes() const = 0;

  /// How accurate the hits of ours are: those of a lazy structure are watertight whatever was asked for.
  virtual Level level() const { return Level::watertight; }
  /// The same structure, not copied, asked otherwise; null of a peer.
  virtual std::unique_ptr<Built> asked(const Asking&) const { return nullptr; }

  /// The same queries with the work counted; nothing from a peer that does not count.
  virtual std::optional<TraversalStats> count_closest(std::span<const Ray<float>>, std::span<Hit<float>>) const {
    return std::nullopt;
  }
  virtual std::optional<TraversalStats> count_any(std::span<const Ray<float>>, std::span<std::uint8_t>) const {
    return std::nullopt;
  }
};

class Contender {
 public:
  enum class Kind { ours, peer };

  virtual ~Contender() = default;
  virtual std::string name() const = 0;
  virtual Kind kind() const = 0;
  /// What was asked for, of ours; null of a peer.
  virtual const AcceleratorSpec* spec() const { return nullptr; }
  /// How; null of a peer.
  virtual const Asking* asking() const { return nullptr; }
  /// Of one that is too slow to be asked all rays: about how many tests of a triangle take as long as one ray does. It
  /// is asked as many rays, picked at random, as Plan::few_tests allows. Else 0.
  virtual double tests_per_ray([[maybe_unused]] std::size_t triangles) const { return 0; }
  virtual std::unique_ptr<Built> build(const std::shared_ptr<const TriangleMesh>& mesh) const = 0;
  /// What build() would give, out of what another of ours with the same spec has built.
  virtual std::unique_ptr<Built> share(const Built& built) const { return built.asked(*asking()); }
};

inline constexpr std::string_view oracle_name = "brute-force";

/// A structure of the registry with options of its own.
std::unique_ptr<Contender> make_structure(AcceleratorSpec spec, const Asking& asking = {});

/// `contender` with its first hit one unit in the last place too far and its first any-hit answer turned round: what
/// the verification has to catch.
std::unique_ptr<Contender> spoil(std::unique_ptr<Contender> contender);

}  // namespace sightline::bench
