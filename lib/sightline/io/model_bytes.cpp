#include "sightline/io/model_bytes.h"

#include <cstring>
#include <type_traits>

#include "sightline/io/file_error.h"

namespace sightline {
namespace {

/// Appends what see() is shown.
class Writer {
 public:
  template <class T>
  void operator()(const T& value) {
    if constexpr (std::is_same_v<T, std::string>) {
      count(value.size());
      bytes_ += value;
    } else if constexpr (requires { typename T::allocator_type; }) {
      count(value.size());
      if constexpr (std::is_trivially_copyable_v<typename T::value_type>) {
        append(value.data(), value.size() * sizeof(typename T::value_type));
      } else {
        for (const auto& each : value) see(*this, each);
      }
    } else {
      static_assert(std::is_trivially_copyable_v<T>);
      append(&value, sizeof value);
    }
  }
  std::string take() { return std::move(bytes_); }

 private:
  void count(std::uint64_t number) { append(&number, sizeof number); }
  void append(const void* data, std::size_t size) {
    if (size > 0) bytes_.append(static_cast<const char*>(data), size);
  }

  std::string bytes_;
};

/// Fills what see() is shown.
class Reader {
 public:
  Reader(const std::filesystem::path& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_same_v<T, std::string>) {
      value = std::string(take(count(1)));
    } else if constexpr (requires { typename T::allocator_type; }) {
      using Element = typename T::value_type;
      if constexpr (std::is_trivially_copyable_v<Element>) {
        value.resize(count(sizeof(Element)));
        const std::string_view taken = take(value.size() * sizeof(Element));
        if (!taken.empty()) std::memcpy(static_cast<void*>(value.data()), taken.data(), taken.size());
      } else {
        value.resize(count(1));
        for (auto& each : value) see(*this, each);
      }
    } else if constexpr (std::is_same_v<T, bool>) {
      value = take(1).front() != 0;
    } else {
      std::memcpy(static_cast<void*>(&value), take(sizeof value).data(), sizeof value);
    }
  }
  bool is_at_end() const { return bytes_.empty(); }

 private:
  /// As many elements as there are bytes for.
  std::size_t count(std::size_t size) {
    std::uint64_t number = 0;
    (*this)(number);
    if (number > bytes_.size() / size) throw FileError(path_, 0, "a model", "more than its reader told");
    return number;
  }
  std::string_view take(std::size_t size) {
    if (bytes_.size() < size) throw FileError(path_, 0, "a model", "less than its reader told");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }

  const std::filesystem::path& path_;
  std::string_view bytes_;
};

// ---- What there is to see, written once for both ways

template <class F, class T>
concept Is = std::is_same_v<std::remove_const_t<F>, T>;

void see(auto& io, Is<std::string> auto& text) { io(text); }
void see(auto& io, Is<ModelNode> auto& node) {
  io(node.name), io(node.parent), io(node.local), io(node.meshes), io(node.camera), io(node.light);
}
void see(auto& io, Is<ModelMesh> auto& mesh) {
  io(mesh.name), io(mesh.material), io(mesh.positions), io(mesh.triangles), io(mesh.normals), io(mesh.uvs);
}
void see(auto& io, Is<ModelMaterial> auto& m) {
  io(m.name), io(m.color), io(m.emission), io(m.absorption), io(m.roughness), io(m.metallic), io(m.transmission);
  io(m.refractive_index), io(m.normal_strength), io(m.color_image), io(m.normal_image);
}
void see(auto& io, Is<ModelLight> auto& light) {
  io(light.name), io(light.kind), io(light.color), io(light.intensity), io(light.inner_angle), io(light.outer_angle);
  io(light.width), io(light.height);
}
void see(auto& io, Is<ModelCamera> auto& camera) { io(camera.name), io(camera.field_of_view); }
void see(auto& io, Is<ModelTrack> auto& track) {
  io(track.node), io(track.part), io(track.is_step), io(track.times), io(track.values);
}
void see(auto& io, Is<ModelAnimation> auto& animation) { io(animation.name), io(animation.tracks); }

void see(Writer& io, const ModelImage& image) {
  const auto* file = std::get_if<std::filesystem::path>(&image.source);
  io(image.name), io(image.is_data), io(file != nullptr);
  io(file ? file->string() : std::get<std::string>(image.source));
}
void see(Reader& io, ModelImage& image) {
  bool is_file = false;
  std::string source;
  io(image.name), io(image.is_data), io(is_file), io(source);
  if (is_file) {
    image.source = std::filesystem::path(source);
  } else {
    image.source = std::move(source);
  }
}

void see(auto& io, Is<Model> auto& model) {
  io(model.nodes), io(model.meshes), io(model.materials), io(model.images), io(model.lights), io(model.cameras);
  io(model.animations), io(model.warnings);
}

}  // namespace

std::string bytes_of(const Model& model) {
  Writer writer;
  see(writer, model);
  return writer.take();
}

Model model_of(const std::filesystem::path& path, std::string_view bytes) {
  Reader reader(path, bytes);
  Model model;
  see(reader, model);
  if (!reader.is_at_end()) throw FileError(path, 0, "a model", "more bytes than it has");
  check_model(path, model);
  return model;
}

}  // namespace sightline
