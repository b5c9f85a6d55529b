#pragma once
/// Any structure of the registry over a triangle mesh, behind one interface: for tools that choose by name at run time.
///
/// The virtual call is paid once a batch. Including this header brings in no structure; their code is compiled once, in
/// tracer_slice.cpp.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sightline/accel/accelerator.h"
#include "sightline/math/level.h"
#include "sightline/shape/mesh.h"

namespace sightline {

template <class T>
class PlacedQuery;

/// Queries in one precision. All are const, thread-safe, and give the same result in whatever order they are asked.
/// `level` says how accurate to be. Float queries know `fast` and `watertight`. Double ones are `precise` at any level
/// below `exact`, at which t of the nearest hit is the double nearest to the true one; u and v, and all_hits(), are as
/// at `precise`. A lazy structure is never less than watertight.
template <class T>
class Queries {
 public:
  virtual ~Queries() = default;

  /// hits[i] becomes the nearest hit of rays[i]. Both spans have the same length.
  virtual void closest_hits(std::span<const Ray<T>> rays, std::span<Hit<T>> hits,
                            Level level = Level::watertight) const = 0;
  /// The same, with the work counted.
  virtual void closest_hits(std::span<const Ray<T>> rays, std::span<Hit<T>> hits, TraversalStats& stats,
                            Level level = Level::watertight) const = 0;

  /// is_hit[i] becomes 1 when rays[i] hits anything, else 0.
  virtual void any_hits(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit,
                        Level level = Level::watertight) const = 0;
  virtual void any_hits(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit, TraversalStats& stats,
                        Level level = Level::watertight) const = 0;

  /// The same hits, for many rays that are at hand together: where the structure knows how to, they are under way side
  /// by side (stream.h); elsewhere one by one.
  virtual void stream_closest_hits(std::span<const Ray<T>> rays, std::span<Hit<T>> hits,
                                   Level level = Level::watertight) const = 0;
  virtual void stream_any_hits(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit,
                               Level level = Level::watertight) const = 0;

  /// Every hit of one ray, nearest first.
  virtual std::vector<Hit<T>> all_hits(const Ray<T>& ray) const = 0;

  /// The nearest hit, with every step of the walk written down.
  virtual Hit<T> record(const Ray<T>& ray, WalkRecorder& walk) const = 0;

  /// Takes a query of instances (placed_query.h) through the mesh where that instance stands.
  virtual void visit(PlacedQuery<T>& query, std::uint32_t instance, Level level) const = 0;
  virtual void visit(PlacedQuery<T>& query, std::uint32_t instance, Level level, TraversalStats& stats) const = 0;
};

class Tracer : public Queries<float>, public Queries<double> {
 public:
  using Queries<float>::closest_hits, Queries<double>::closest_hits;
  using Queries<float>::any_hits, Queries<double>::any_hits;
  using Queries<float>::stream_closest_hits, Queries<double>::stream_closest_hits;
  using Queries<float>::stream_any_hits, Queries<double>::stream_any_hits;
  using Queries<float>::all_hits, Queries<double>::all_hits;
  using Queries<float>::record, Queries<double>::record;
  using Queries<float>::visit, Queries<double>::visit;

  virtual std::string_view name() const = 0;
  virtual const TriangleMesh& mesh() const = 0;
  /// Nodes and leaf order. For a lazy structure: of what has been made so far.
  virtual std::size_t structure_bytes() const = 0;
  /// Copies of the triangles in leaf order.
  virtual std::size_t leaf_bytes() const = 0;
  virtual std::span<const std::uint32_t> leaf_order() const = 0;
  /// Whether queries go on building the structure, so that its cells are those asked for so far.
  virtual bool is_lazy() const = 0;
  virtual void for_each_cell(const std::function<void(const Cell&)>& see) const = 0;
};

struct TracerSettings {
  struct Option {
    std::string name;
    std::string value;
  };
  std::vector<Option> options;  ///< Of the structure; see AcceleratorInfo.
  bool pack_leaves = true;      ///< Copy the triangles into leaf order: faster, at 40 bytes a leaf position.
  int threads = 0;              ///< To build with; 0 for as many as there are. The result is the same.
};

/// \throws std::invalid_argument for an unknown accelerator (the message lists the known ones) or a bad option.
std::unique_ptr<Tracer> make_tracer(std::string_view accelerator, std::shared_ptr<const TriangleMesh> mesh,
                                    const TracerSettings& settings = {});

struct AcceleratorInfo {
  struct Option {
    std::string_view name;
    std::string default_value;
    std::string allowed;
    std::string_view help;
  };
  std::string_view name;
  std::string_view description;
  std::size_t node_bytes;
  bool can_stream;  ///< Many float rays are under way side by side (stream.h).
  std::vector<Option> options;
};

/// The registry, in its order, then what was loaded (structure_plugin.h), which ends what was got before.
std::span<const AcceleratorInfo> accelerator_infos();

}  // namespace sightline
