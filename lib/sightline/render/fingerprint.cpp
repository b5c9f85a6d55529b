#include <cstring>
#include <filesystem>
#include <type_traits>
#include <variant>

#include "sightline/math/random.h"
#include "sightline/render/renderer.h"

namespace sightline {
namespace {

/// Takes in numbers and texts, in their order.
class Fingerprint {
 public:
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void add(T value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(value));
    state_ = Random::hash(state_ ^ bits) + 0x9e37'79b9'7f4a'7c15u;
  }
  template <glm::length_t n, class T>
  void add(const glm::vec<n, T>& v) {
    for (glm::length_t i = 0; i < n; ++i) add(v[i]);
  }
  template <class T, std::size_t n>
  void add(const std::array<T, n>& list) {
    for (const T& item : list) add(item);
  }
  template <class T>
  void add(const std::vector<T>& list) {
    add(list.size());
    for (const T& item : list) add(item);
  }
  void add(const std::string& text) {
    add(text.size());
    for (const char c : text) add(c);
  }
  void add(const Affine& map) { add(map.rows); }

  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

void add(Fingerprint& print, const SolidShape& shape) {
  print.add(shape.index());
  std::visit(
      [&](const auto& one) {
        using S = std::remove_cvref_t<decltype(one)>;
        if constexpr (std::is_same_v<S, std::shared_ptr<const ClosedMesh>>) {
          print.add(one->vertices());
          print.add(one->triangles());
        } else {
          // Shapes are nothing but doubles.
          static_assert(std::is_trivially_copyable_v<S> && sizeof(S) % sizeof(double) == 0);
          std::array<double, sizeof(S) / sizeof(double)> numbers;
          std::memcpy(numbers.data(), &one, sizeof(S));
          print.add(numbers);
        }
      },
      shape);
}

void add(Fingerprint& print, const TraceWorld& world) {
  print.add(world.size());
  for (const auto& mesh : world.instances().meshes()) {
    print.add(mesh->positions());
    print.add(mesh->triangles());
  }
  for (const Placement& placement : world.instances().placements()) {
    print.add(placement.mesh());
    print.add(placement.to_world());
  }
  for (std::uint32_t i = 0; i < world.size(); ++i) {
    print.add(world.origin(i).material);
    if (!world.is_solid(i)) continue;
    const Solid& solid = world.solid(i);
    for (const Primitive& primitive : solid.primitives()) {
      add(print, primitive.shape);
      if (const Frame* frame = solid.frame_of(primitive)) print.add(*frame);
      print.add(solid.materials()[primitive.material]);
    }
    for (const SolidNode& node : solid.nodes()) {
      print.add(node.is_primitive);
      print.add(node.operation);
      print.add(node.is_complement);
      print.add(node.primitive);
      for (const std::uint32_t child : solid.children(node)) print.add(child);
    }
  }
}

void add(Fingerprint& print, const Material& m) {
  print.add(m.color);
  print.add(m.color_texture);
  print.add(m.normal_map);
  print.add(m.normal_strength);
  print.add(m.dents.has_value());
  if (m.dents) {
    const FieldOptions& field = m.dents->field;
    print.add(m.dents->height);
    for (const double value : {field.frequency, field.lacunarity, field.gain, field.warp}) print.add(value);
    print.add(field.octaves);
    print.add(field.noise.seed);
    print.add(field.noise.kind);
    print.add(field.noise.ease);
    print.add(field.fractal);
  }
  for (const double value : {m.roughness, m.metallic, m.transmission, m.refractive_index}) print.add(value);
  print.add(m.absorption);
  print.add(m.emission);
}

/// An image is known by its name and size, and by when it was written.
void add(Fingerprint& print, const std::filesystem::path& image) {
  std::error_code ignored;
  print.add(image.string());
  print.add(std::filesystem::file_size(image, ignored));
  print.add(std::filesystem::last_write_time(image, ignored).time_since_epoch().count());
}

void add(Fingerprint& print, const Surroundings& surroundings) {
  print.add(surroundings.intensity);
  print.add(surroundings.lights);
  print.add(surroundings.background.index());
  if (const auto* color = std::get_if<Color>(&surroundings.background)) print.add(*color);
  if (const auto* sky = std::get_if<SkyGradient>(&surroundings.background)) {
    for (const Color& color : {sky->zenith, sky->horizon, sky->ground}) print.add(color);
  }
  if (const auto* sky = std::get_if<SkyImage>(&surroundings.background)) {
    add(print, sky->image);
    print.add(sky->rotation);
  }
}

void add(Fingerprint& print, const Lamp& lamp) {
  print.add(lamp.kind);
  for (const Vec3d& v : {lamp.position, lamp.axis, lamp.right, lamp.up}) print.add(v);
  print.add(lamp.strength);
  print.add(lamp.cos_inner);
  print.add(lamp.cos_outer);
}

void add(Fingerprint& print, const Lens& lens) {
  const Camera& camera = lens.camera;
  for (const Vec3d& v : {camera.eye, camera.forward, camera.right, camera.up}) print.add(v);
  print.add(lens.radius);
  print.add(lens.focus_distance);
}

}  // namespace

std::uint64_t fingerprint_of(const RenderScene& scene, const RenderSettings& settings) {
  Fingerprint print;
  for (const int size : {settings.width, settings.height}) print.add(size);
  for (const std::uint32_t number : {settings.samples, settings.light_samples, scene.depth}) print.add(number);
  for (const double number : {settings.error_bound, scene.cut_off, scene.shadow_error2}) print.add(number);
  print.add(settings.seed);
  print.add(settings.level);
  print.add(settings.filters_textures);
  for (const auto& moment : scene.moments) {
    add(print, *moment->world);
    add(print, moment->lens);
    for (const Lamp& lamp : moment->lamps) add(print, lamp);
  }
  const Scene& posed = scene.moments[0]->posed;
  for (const Geometry& geometry : posed.geometries) {
    const auto* mesh = std::get_if<MeshGeometry>(&geometry.shape);
    if (!mesh) continue;
    print.add(mesh->normals);
    print.add(mesh->uvs);
  }
  for (const Material& material : posed.materials) add(print, material);
  for (const TextureSource& texture : posed.textures) {
    print.add(texture.is_data);
    if (const auto* spec = std::get_if<std::string>(&texture.source)) {
      print.add(*spec);
    } else {
      add(print, std::get<std::filesystem::path>(texture.source));
    }
  }
  add(print, posed.surroundings);
  for (const Color& color : {posed.ambient.color, posed.fog.color}) print.add(color);
  for (const double number : {posed.ambient.occlusion_distance, posed.fog.density}) print.add(number);
  print.add(scene.effects.bits);
  return print.value();
}

}  // namespace sightline
