#pragma once
/// From rays to light: one integrator, of which only those parts are compiled that a set of effects needs.
///
/// Rays of a tile travel in waves: all camera rays of some pixels at once, then all that these ask for, one wave a
/// kind of ray, until none is left. So structures get neighbouring rays together, each wave's time and number belong to
/// one effect, and what no effect asks for is no instruction.
///   I1  What a sample adds to its pixel depends on its pixel, its number and the scene: not on the tile, nor on which
///       effects were compiled besides those that are used. What earlier samples of the pixel found (LampsSeen) does
///       too. Draws are by purpose (sampler.h), and waves follow each
///       other in one order, so that sums have one order.
///   I2  Each surface scatters at most what it takes in: mirror, glass and diffuse parts share it by Fresnel's law.
/// Whitted, "An Improved Illumination Model for Shaded Display", 1980; Cook, Porter and Carpenter, "Distributed Ray
/// Tracing", 1984; Kajiya, "The Rendering Equation", 1986; Hall and Greenberg, "A Testbed for Realistic Image
/// Synthesis", 1983.

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "sightline/render/picture_source.h"
#include "sightline/render/render_scene.h"
#include "sightline/render/sampler.h"
#include "sightline/render/scattering.h"
#include "sightline/render/shadow_choice.h"
#include "sightline/render/stage_clock.h"

namespace sightline {

/// A pixel of a tile: where it is in the picture, and in the tile.
struct PixelPlace {
  int x, y;
  std::uint32_t in_tile;
};

/// A ray on its way, and what it stands for.
struct Path {
  Color weight{1};                 ///< Of what it meets, in the pixel.
  std::uint32_t slot = 0;          ///< Of its sample in the wave of the camera.
  std::uint32_t medium = no_item;  ///< Material of what it is in.
  std::uint16_t depth = 0;         ///< Surfaces before.
  bool is_scattered = false;       ///< By a diffuse surface, last.
  float width = 0, spread = 0;     ///< Of what it stands for: at its origin, and for each unit of t.
};

/// The same of a ray from the camera where none goes on from it: then most is known beforehand.
struct FirstPath {
  static constexpr Color weight{1};
  static constexpr std::uint16_t depth = 0;
  static constexpr bool is_scattered = false;
  std::uint32_t slot = 0;
  float width = 0, spread = 0;
};

struct RayWave {
  std::vector<Ray<double>> rays;
  std::vector<Path> paths;
  std::vector<double> densities;  ///< Of their directions, where the sky is asked in two ways; else empty.

  bool is_empty() const { return rays.empty(); }
  void clear() {
    rays.clear();
    paths.clear();
    densities.clear();
  }
  void add(const Ray<double>& ray, const Path& path) {
    rays.push_back(ray);
    paths.push_back(path);
  }
};

/// A ray to an area lamp that was chosen to be sent.
struct AreaRay {
  std::uint32_t lamp;  ///< Among area lamps.
  float guess;         ///< Of what it will find; that is in the pixel already.
  bool is_trial;
};

/// Light that arrives if nothing is in between.
class Sights {
 public:
  struct Light {
    Color color;
    std::uint32_t slot;  ///< As that of a path.
  };

  std::span<const Ray<double>> rays() const { return std::span(rays_).first(count_); }
  std::span<const Light> lights() const { return std::span(lights_).first(count_); }
  void clear() { count_ = 0; }

  /// In place: copying what was just written would wait for it.
  [[gnu::always_inline]] void add(const Vec3d& origin, const Vec3d& direction, double length, const Light& light) {
    if (count_ == rays_.size()) grow();
    Ray<double>& ray = rays_[count_];
    ray.origin = origin, ray.direction = direction, ray.t_max = length;
    lights_[count_++] = light;
  }

 private:
  [[gnu::noinline]] void grow() {
    rays_.resize(std::max<std::size_t>(64, 2 * count_));
    lights_.resize(rays_.size());
  }

  std::size_t count_ = 0;  ///< Of those that are in use: room is made once, and rays keep their t_min.
  std::vector<Ray<double>> rays_;
  std::vector<Light> lights_;
};

/// Whether it is 0, of either sign: as `color == Color(0)`, in half as many instructions.
inline bool is_black(const Color& color) {
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
  return ((bits(color.x) | bits(color.y) | bits(color.z)) << 1) == 0;
}
inline float largest(const Color& color) { return std::max({color.x, color.y, color.z}); }

template <Effects has>
class Integrator {
 public:
  /// `times` may be null.
  Integrator(const RenderScene& scene, RenderCounters& counters, StageTimes* times)
      : scene_(scene), counters_(counters), times_(times) {
    if constexpr (has.has(Effect::environment)) bright_ = scene.sky->distribution();
  }

  /// As PictureSource asks for them.
  void add_samples(TileBuffer& tile, std::span<const std::uint32_t> pixels, SampleRange range, FactsAsked facts);

 private:
  /// Rays that go on, in the order in which their waves follow each other.
  enum Kind : std::size_t { mirrored, spread, passing, scattered, kind_count };
  static constexpr std::array<Effect, kind_count> effects_of_kinds{Effect::mirror, Effect::glossy, Effect::refraction,
                                                                   Effect::interreflection};
  enum Sight : std::size_t { to_point, to_area, to_occluder, to_sky, sight_count };
  static constexpr std::array<Effect, sight_count> effects_of_sights{Effect::hard_shadow, Effect::soft_shadow,
                                                                     Effect::ambient_occlusion, Effect::environment};

  static constexpr bool reflects = has.has(Effect::mirror) || has.has(Effect::glossy);
  static constexpr bool is_specular = reflects || has.has(Effect::refraction);
  /// Whether rays go on from surfaces.
  static constexpr bool has_more_rays = is_specular || has.has(Effect::interreflection);
  /// Whether shading asks how wide rays are where they meet surfaces; paint() finds that out by itself.
  static constexpr bool has_footprints = has.has(Effect::image_texture) || has.has(Effect::normal_map);
  /// Whether glossy surfaces may ask the sky where it is bright, too.
  static constexpr bool has_bright_gloss = has.has(Effect::glossy) && has.has(Effect::environment);
  /// Whether anything asks for lengths along rays, and for directions of unit length.
  static constexpr bool has_lengths =
      is_specular || has_footprints || has.has(Effect::absorption) || has.has(Effect::fog);

  /// Whether all that a path says is known from where it is seen.
  static constexpr bool is_slim = !has_more_rays && !has.has(Effect::fog);
  using AnyPath = std::conditional_t<is_slim, FirstPath, Path>;

  /// Long enough that the few rays that go on make packets; where none does, what one packet needs stays nearest.
  static constexpr std::size_t wave_size = is_slim ? 16 : 128;

  /// What is known of a wave's hit before it is shaded, where functions of space are asked for colors together.
  struct Painted {
    SurfacePoint at;
    std::uint32_t material;  ///< Its number.
    Color color;
  };
  /// Points for one function of space.
  struct Strokes {
    const Texture* function = nullptr;
    std::vector<Vec3d> points;
    std::vector<Footprint> footprints;
    std::vector<std::size_t> places;  ///< In the wave.
    std::vector<Color> colors;
  };

  struct AskedLamp {
    std::uint32_t draw;     ///< Its number among lamps, times 256, and that of the sample.
    std::uint32_t area;     ///< Its number among area lamps, if it is one.
    std::uint32_t samples;  ///< Of its area.
    bool is_area = false;
  };

  /// A hit while it is shaded.
  struct Shade {
    const SurfaceMaterial& material;
    std::uint32_t number;  ///< Of the material.
    const WorldHit& hit;
    const SurfacePoint& at;
    Vec3d to_viewer{0};        ///< Of unit length; only where the integrator has lengths.
    Vec3d side{0}, normal{0};  ///< Of unit length, on the viewer's side.
    double slant =
        0;  ///< The cosine of `outside` to the viewer, times the direction's length where there are no lengths.
    bool is_inside = false;
    bool is_bent = false;  ///< `normal` is another one than `side`.
    Color color{0};
    double eta = 1;            ///< As fresnel() takes it.
    float goes_scattered = 1;  ///< What a scattered path's weight is multiplied by; 0 where it ends.
  };

  // integrator_of.h
  void turn_to(const Moment& moment);
  void look(std::span<const PixelPlace> places);
  [[gnu::always_inline]] inline void aim(std::size_t i, const glm::dvec2& within);
  void focus(Ray<double>& ray, const Sampler& draws);
  void note_facts(TileBuffer& tile, std::span<const PixelPlace> places, FactsAsked facts);
  void follow();
  void trace(RayWave& wave, StageTimes::Clock::duration* time);
  void see();
  void see_areas();
  void recall(const TileBuffer& tile, std::span<const PixelPlace> places);
  void remember(TileBuffer& tile, std::span<const PixelPlace> places) const;
  Color passed(const Ray<double>& ray);
  /// Of a sample of the wave of the camera.
  Sampler sampler(std::uint32_t slot) const {
    const auto row = static_cast<std::uint32_t>(places_[slot].y), column = static_cast<std::uint32_t>(places_[slot].x);
    return {scene_.seed, row * static_cast<std::uint32_t>(moment_->lens.camera.width) + column, sample_};
  }

  /// Not in fog, which dims paths and not rays to lights.
  bool asks_bright_sky(const SurfaceMaterial& material, const AnyPath& path) const {
    return has_bright_gloss && bright_ && material.is_glossy && path.depth < scene_.depth && scene_.fog.density == 0;
  }

  // integrator_painting.h
  void paint(const RayWave& wave);
  void finish_strokes();

  // integrator_shading.h; what is called once goes in line, so that nothing of a hit has to be written to memory
  void shade_miss(const Ray<double>& ray, AnyPath& path, double density);
  [[gnu::always_inline]] inline void shade(const Ray<double>& ray, AnyPath& path, std::size_t place);
  void in_fog(double length, Path& path, Color& light) const;
  [[gnu::always_inline]] inline Color color_at(const Shade& shade, const AnyPath& path, std::size_t place);
  Vec3d normal_at(const Shade& shade, const AnyPath& path, const Vec3d& to_viewer);
  Color share_out(Shade& shade, const Path& path);
  [[gnu::always_inline]] inline void shine(const Shade& shade, const AnyPath& path, const Color& diffuse);
  [[gnu::always_inline]] inline void take_light(const Shade& shade, const AnyPath& path, const Color& diffuse,
                                                const AskedLamp& asked, const LampLight& from);
  void add_area_ray(const Shade& shade, const AnyPath& path, const LampLight& from, Color light, std::uint32_t lamp,
                    std::uint32_t which);
  Color highlight(const Shade& shade, const Vec3d& to_lamp, double cosine) const;
  [[gnu::always_inline]] inline void look_around(const Shade& shade, const AnyPath& path, const Color& diffuse);
  void look_at_sky(const Shade& shade, const AnyPath& path, const Color& diffuse);
  [[gnu::always_inline]] inline void add_sight(Sight sight, const Shade& shade, const Vec3d& direction, double length,
                                               const Color& light, std::uint32_t slot);
  void go_on(Kind kind, const Shade& shade, const Path& path, const Vec3d& direction, const Color& weight);

  const RenderScene& scene_;
  RenderCounters& counters_;
  StageTimes* times_;

  const SkyDistribution* bright_ = nullptr;  ///< Null where only surfaces choose directions to the sky.
  const Moment* moment_ = nullptr;
  Vec3d column_{0}, row_{0};  ///< From a pixel's middle to its edge, at t = 1.
  float pixel_width_ = 0;     ///< At t = 1.
  std::uint32_t sample_ = 0;
  std::span<const PixelPlace> places_;  ///< Of the wave of the camera.
  std::array<Vec3d, wave_size> radiance_{};
  RayWave current_;
  std::array<RayWave, kind_count> next_;
  std::array<Sights, sight_count> sights_;
  std::vector<AreaRay> area_rays_;                     ///< To those of sights_[to_area].
  std::array<LampsSeen, wave_size> known_{}, seen_{};  ///< By earlier samples, and by this one.
  bool is_trial_ = false;                              ///< Whether this one's rays are to tell later ones.
  std::vector<WorldHit> hits_;
  std::vector<Painted> painted_;  ///< As hits_ are.
  Strokes strokes_;
  std::vector<std::uint8_t> is_stopped_;
};

}  // namespace sightline
