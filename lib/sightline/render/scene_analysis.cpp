#include "sightline/render/scene_analysis.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace sightline {
namespace {

/// What asks for the same thing: the first, and how many more.
struct Askers {
  NodeId first = no_node;
  std::uint64_t count = 0;

  void add(NodeId node) {
    if (count++ == 0) first = node;
  }
  std::string text(const SceneGraph& graph) const {
    std::string text = graph.path(first);
    if (count > 1) text += " and " + std::to_string(count - 1) + " more";
    return text;
  }
};

class Analyzer {
 public:
  Analyzer(const Moment& moment, const MaterialTable& materials) : moment_(moment), materials_(materials) {
    for (std::uint32_t i = 0; i < world().size(); ++i) {
      const SceneOrigin& origin = world().origin(i);
      if (!world().is_solid(i)) {
        meshes_.add(origin.node);
        made_of_[origin.material].add(origin.node);
        continue;
      }
      solids_.add(origin.node);
      std::vector<std::uint32_t> seen;
      const Solid& solid = world().solid(i);
      for (const std::uint32_t primitive : primitives_in(solid)) {
        const std::uint32_t material = moment.surfaces->material(i, solid.primitives()[primitive].material);
        if (std::find(seen.begin(), seen.end(), material) != seen.end()) continue;
        seen.push_back(material);
        made_of_[material].add(origin.node);
      }
    }
  }

  void ask_of_shapes() {
    if (meshes_.count > 0) ask(Effect::meshes, meshes_.text(graph()));
    if (world().has_instances()) {
      ask(Effect::instances, std::to_string(world().instances().triangles()) + " triangles where they stand, of " +
                                 std::to_string(world().instances().size()) + " instances");
    }
    if (solids_.count > 0) ask(Effect::solids, solids_.text(graph()));
  }

  void ask_of_materials() {
    for (std::size_t i = 0; i < effect_count; ++i) {
      for (const auto& [number, askers] : made_of_) {
        if (materials_[number].effects().has(static_cast<Effect>(i))) {
          ask(static_cast<Effect>(i), "material '" + materials_[number].values.name + "' of " + askers.text(graph()));
        }
      }
    }
  }

  void ask_of_lamps() {
    const bool is_lit = has_any([](const SurfaceMaterial& m) { return m.is_diffuse || m.is_glossy; });
    for (const Lamp& lamp : moment_.lamps) {
      const std::string who = lamp.light == no_item
                                  ? "the scene has no light: a lamp beside the camera"
                                  : std::string(kind_names[static_cast<std::size_t>(lamp.kind)]) + " light " +
                                        graph().path(moment_.posed.lights[lamp.light].node);
      if (!is_lit) {
        decline(Effect::direct_light, who + ": nothing is there that scatters light");
        continue;
      }
      ask(Effect::direct_light, who);
      ask(lamp.is_area() ? Effect::soft_shadow : Effect::hard_shadow, who);
    }
  }

  void ask_of_surroundings(const Sky& sky) {
    const bool is_diffuse = has_any([](const SurfaceMaterial& m) { return m.is_diffuse; });
    const Scene& scene = moment_.posed;
    const bool has_interreflection = scene.render.interreflection && is_diffuse;
    if (scene.ambient.color != Color(0)) {
      const bool is_occluded = scene.ambient.occlusion_distance > 0;
      const Effect effect = is_occluded ? Effect::ambient_occlusion : Effect::ambient;
      if (has_interreflection) {
        decline(effect, "the scene's ambient light: interreflection takes its place");
      } else if (is_diffuse) {
        ask(effect, "the scene's ambient light");
      }
    }
    // Of an image, bright spots are looked for where surfaces are glossy, too.
    const bool takes_sky =
        is_diffuse || (sky.is_image() && has_any([](const SurfaceMaterial& m) { return m.is_glossy; }));
    if (scene.surroundings.lights && !sky.is_black() && takes_sky && !has_interreflection) {
      ask(Effect::environment, "the scene's background, which lights");
    }
    if (has_interreflection) {
      ask(Effect::interreflection, "the scene's render settings");
    } else if (scene.render.interreflection) {
      decline(Effect::interreflection, "the scene's render settings: nothing is there that scatters light");
    }
    if (scene.fog.density > 0) ask(Effect::fog, "the scene's fog");
  }

  void ask_of_camera(bool is_moving, std::uint32_t samples) {
    const auto needs_samples = [&](bool is_asked, Effect effect, const std::string& who) {
      if (!is_asked) return;
      if (samples > 1) return ask(effect, who);
      decline(effect, who + ": one sample of a pixel shows no spread");
    };
    if (samples > 1) ask(Effect::antialiasing, std::to_string(samples) + " samples of a pixel");
    needs_samples(moment_.lens.radius > 0, Effect::depth_of_field, "the camera's aperture");
    needs_samples(is_moving, Effect::motion_blur, "the camera's shutter");
  }

  SceneAnalysis finish() {
    std::stable_sort(result_.requests.begin(), result_.requests.end(),
                     [](const EffectRequest& a, const EffectRequest& b) { return a.effect < b.effect; });
    return std::move(result_);
  }

 private:
  static constexpr std::array<std::string_view, 4> kind_names{"point", "directional", "spot", "area"};

  const TraceWorld& world() const { return *moment_.world; }
  const SceneGraph& graph() const { return moment_.posed.graph; }
  template <class Is>
  bool has_any(const Is& is) const {
    return std::any_of(made_of_.begin(), made_of_.end(), [&](const auto& one) { return is(materials_[one.first]); });
  }
  void ask(Effect effect, std::string who) {
    result_.effects.add(effect);
    result_.requests.push_back({effect, std::move(who)});
  }
  void decline(Effect effect, std::string why) { result_.declined.push_back({effect, std::move(why)}); }

  const Moment& moment_;
  const MaterialTable& materials_;
  Askers meshes_, solids_;
  std::map<std::uint32_t, Askers> made_of_;
  SceneAnalysis result_;
};

}  // namespace

SceneAnalysis analyze(const Moment& moment, const MaterialTable& materials, const Sky& sky, bool is_moving,
                      std::uint32_t samples) {
  Analyzer analyzer(moment, materials);
  analyzer.ask_of_shapes();
  analyzer.ask_of_materials();
  analyzer.ask_of_lamps();
  analyzer.ask_of_surroundings(sky);
  analyzer.ask_of_camera(is_moving, samples);
  return analyzer.finish();
}

}  // namespace sightline
