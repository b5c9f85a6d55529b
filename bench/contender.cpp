#include "bench/contender.h"

#include <algorithm>
#include <utility>

#include "sightline/math/rounding.h"

namespace sightline::bench {
namespace {

class BuiltStructure final : public Built {
 public:
  BuiltStructure(std::shared_ptr<const Tracer> tracer, const Asking& asking)
      : tracer_(std::move(tracer)), asking_(asking) {}

  void closest_hits(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const override {
    if (asking_.is_stream) return tracer_->stream_closest_hits(rays, hits, asking_.level);
    tracer_->closest_hits(rays, hits, asking_.level);
  }
  void any_hits(std::span<const Ray<float>> rays, std::span<std::uint8_t> is_hit) const override {
    if (asking_.is_stream) return tracer_->stream_any_hits(rays, is_hit, asking_.level);
    tracer_->any_hits(rays, is_hit, asking_.level);
  }
  Bytes bytes() const override { return {tracer_->structure_bytes(), tracer_->leaf_bytes()}; }
  Level level() const override { return tracer_->is_lazy() ? Level::watertight : asking_.level; }
  std::unique_ptr<Built> asked(const Asking& asking) const override {
    return std::make_unique<BuiltStructure>(tracer_, asking);
  }

  std::optional<TraversalStats> count_closest(std::span<const Ray<float>> rays,
                                              std::span<Hit<float>> hits) const override {
    TraversalStats stats;
    tracer_->closest_hits(rays, hits, stats, asking_.level);
    return stats;
  }
  std::optional<TraversalStats> count_any(std::span<const Ray<float>> rays,
                                          std::span<std::uint8_t> is_hit) const override {
    TraversalStats stats;
    tracer_->any_hits(rays, is_hit, stats, asking_.level);
    return stats;
  }

 private:
  std::shared_ptr<const Tracer> tracer_;
  Asking asking_;
};

class Structure final : public Contender {
 public:
  Structure(AcceleratorSpec spec, const Asking& asking) : spec_(std::move(spec)), asking_(asking) {}

  std::string name() const override { return name_of(spec_.label, asking_); }
  Kind kind() const override { return Kind::ours; }
  const AcceleratorSpec* spec() const override { return &spec_; }
  const Asking* asking() const override { return &asking_; }
  double tests_per_ray(std::size_t triangles) const override {
    return spec_.accelerator == oracle_name ? static_cast<double>(triangles) : 0;
  }
  std::unique_ptr<Built> build(const std::shared_ptr<const TriangleMesh>& mesh) const override {
    return std::make_unique<BuiltStructure>(make_tracer(spec_.accelerator, mesh, spec_.settings), asking_);
  }

 private:
  AcceleratorSpec spec_;
  Asking asking_;
};

class BuiltSpoiled final : public Built {
 public:
  explicit BuiltSpoiled(std::unique_ptr<Built> sound) : sound_(std::move(sound)) {}

  void closest_hits(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const override {
    sound_->closest_hits(rays, hits);
    const auto hit = std::find_if(hits.begin(), hits.end(), [](const Hit<float>& h) { return h.is_hit(); });
    if (hit != hits.end()) hit->t = next_up(hit->t);
  }
  void any_hits(std::span<const Ray<float>> rays, std::span<std::uint8_t> is_hit) const override {
    sound_->any_hits(rays, is_hit);
    if (!is_hit.empty()) is_hit[0] = !is_hit[0];
  }
  Bytes bytes() const override { return sound_->bytes(); }
  Level level() const override { return sound_->level(); }
  std::unique_ptr<Built> asked(const Asking& asking) const override { return sound_->asked(asking); }

 private:
  std::unique_ptr<Built> sound_;
};

class Spoiled final : public Contender {
 public:
  explicit Spoiled(std::unique_ptr<Contender> sound) : sound_(std::move(sound)) {}

  std::string name() const override { return sound_->name(); }
  Kind kind() const override { return sound_->kind(); }
  const AcceleratorSpec* spec() const override { return sound_->spec(); }
  const Asking* asking() const override { return sound_->asking(); }
  double tests_per_ray(std::size_t triangles) const override { return sound_->tests_per_ray(triangles); }
  std::unique_ptr<Built> build(const std::shared_ptr<const TriangleMesh>& mesh) const override {
    return std::make_unique<BuiltSpoiled>(sound_->build(mesh));
  }
  std::unique_ptr<Built> share(const Built& built) const override {
    return std::make_unique<BuiltSpoiled>(sound_->share(built));
  }

 private:
  std::unique_ptr<Contender> sound_;
};

}  // namespace

std::unique_ptr<Contender> make_structure(AcceleratorSpec spec, const Asking& asking) {
  return std::make_unique<Structure>(std::move(spec), asking);
}

std::unique_ptr<Contender> spoil(std::unique_ptr<Contender> contender) {
  return std::make_unique<Spoiled>(std::move(contender));
}

}  // namespace sightline::bench
