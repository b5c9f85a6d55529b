#pragma once
/// From a scene to pictures: what it calls for is found, and that alone is simulated.

#include <memory>
#include <string>
#include <vector>

#include "sightline/render/integrators.h"
#include "sightline/render/picture_source.h"
#include "sightline/render/render_scene.h"
#include "sightline/render/render_settings.h"
#include "sightline/render/scene_analysis.h"

namespace sightline {

/// Which effects are simulated, for whom, and by what.
struct RenderPlan {
  SceneAnalysis analysis;
  std::string_view integrator;
  Effects unused;   ///< What the integrator knows besides: compiled in, and never used.
  Effects shadows;  ///< What rays to lights need: solids, meshes, and refraction where something is transparent.
};

class Renderer final : public PictureSource {
 public:
  /// Builds all structures. \throws std::invalid_argument for a camera that the scene does not have, bad settings, and
  /// what instances_of() and solids_of() refuse; FileError for an image that cannot be read.
  Renderer(std::shared_ptr<const Scene> scene, const RenderSettings& settings);

  const RenderPlan& plan() const { return plan_; }
  const RenderScene& scene() const { return ready_; }
  const RenderSettings& settings() const { return settings_; }

  int width() const override { return settings_.width; }
  int height() const override { return settings_.height; }
  std::uint32_t samples() const override { return settings_.samples; }
  std::uint64_t fingerprint() const override { return fingerprint_; }
  void add_samples(TileBuffer& tile, std::span<const std::uint32_t> pixels, SampleRange range, FactsAsked facts,
                   RenderCounters& counters) const override {
    integrator_->run(ready_, tile, pixels, range, facts, counters, nullptr);
  }
  /// The same, with where the time goes; which takes some.
  void add_samples(TileBuffer& tile, std::span<const std::uint32_t> pixels, SampleRange range, FactsAsked facts,
                   RenderCounters& counters, StageTimes& times) const {
    integrator_->run(ready_, tile, pixels, range, facts, counters, &times);
  }

 private:
  RenderSettings settings_;
  RenderScene ready_;
  RenderPlan plan_;
  const CompiledIntegrator* integrator_;
  std::uint64_t fingerprint_;
};

/// As PictureSource::fingerprint() is defined.
std::uint64_t fingerprint_of(const RenderScene& scene, const RenderSettings& settings);

}  // namespace sightline
