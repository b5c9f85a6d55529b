#include "tests/hard_cases/leaks/packet_tracer.h"

#include <optional>
#include <utility>

#include "sightline/accel/registry.h"
#include "sightline/query/packets.h"
#include "sightline/query/primitives_of.h"

namespace sightline::hard {
namespace {

template <Accelerator A>
class PacketTracerOf final : public PacketTracer {
 public:
  PacketTracerOf(std::shared_ptr<const TriangleMesh> mesh, A accel) : mesh_(std::move(mesh)), accel_(std::move(accel)) {
    if (accel_.is_order_final()) blocks_.emplace(*mesh_, accel_);
  }

  void closest_hits(std::span<const Ray<float>> rays, std::span<Hit<float>> hits, Level level) const override {
    closest(rays, hits, level);
  }
  void closest_hits(std::span<const Ray<double>> rays, std::span<Hit<double>> hits, Level level) const override {
    closest(rays, hits, level);
  }
  void any_hits(std::span<const Ray<float>> rays, std::span<std::uint8_t> is_hit, Level level) const override {
    any(rays, is_hit, level);
  }
  void any_hits(std::span<const Ray<double>> rays, std::span<std::uint8_t> is_hit, Level level) const override {
    any(rays, is_hit, level);
  }

 private:
  template <class T>
  void closest(std::span<const Ray<T>> rays, std::span<Hit<T>> hits, Level level) const {
    NoProbe probe;
    with_leaves<T>(level, [&](const auto& leaves) { packet_closest_hits(accel_, leaves, rays, hits, probe); });
  }
  template <class T>
  void any(std::span<const Ray<T>> rays, std::span<std::uint8_t> is_hit, Level level) const {
    NoProbe probe;
    with_leaves<T>(level, [&](const auto& leaves) { packet_any_hits(accel_, leaves, rays, is_hit, probe); });
  }

  template <class T, class Use>
  void with_leaves(Level level, Use&& use) const {
    if (!blocks_) return use(IndexedLeaves(*mesh_, accel_.leaf_order()));
    if constexpr (std::is_same_v<T, float>) {
      if (level == Level::fast) return use(PackedLeaves<Level::fast>(*mesh_, *blocks_));
    }
    use(PackedLeaves<Level::watertight>(*mesh_, *blocks_));
  }

  std::shared_ptr<const TriangleMesh> mesh_;
  A accel_;
  std::optional<TriangleBlocks> blocks_;
};

}  // namespace

std::unique_ptr<PacketTracer> make_packet_tracer(std::string_view accelerator,
                                                 const std::shared_ptr<const TriangleMesh>& mesh,
                                                 const TracerSettings& settings) {
  std::unique_ptr<PacketTracer> tracer;
  Accelerators::for_each([&]<class A>(auto) {
    if constexpr (PacketAccelerator<A, float> && PacketAccelerator<A, double>) {
      if (A::name != accelerator) return;
      typename A::Options options;
      for (const auto& [name, value] : settings.options) set_option(A::name, options, name, value);
      tracer = std::make_unique<PacketTracerOf<A>>(mesh, A::build(PrimitivesOf(*mesh), options));
    }
  });
  return tracer;
}

}  // namespace sightline::hard
