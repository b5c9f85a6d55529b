#include "sightline/scene/gltf_buffer.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "sightline/io/output_file.h"

namespace sightline {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

template <class T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

void append_word(std::string& to, std::size_t word) {
  const auto narrow = static_cast<std::uint32_t>(word);
  to.append(reinterpret_cast<const char*>(&narrow), sizeof narrow);
}

}  // namespace

std::size_t GltfBuffer::add_view(std::string_view bytes) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
  document_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}});
  bytes_ += bytes;
  return document_["bufferViews"].size() - 1;
}

std::size_t GltfBuffer::add_floats(std::span<const float> values, const char* type, std::size_t width,
                                   bool has_bounds) {
  nlohmann::json accessor{{"bufferView", add_view(bytes_of(values))},
                          {"componentType", 5126},
                          {"count", values.size() / width},
                          {"type", type}};
  for (std::size_t k = 0; k < width && has_bounds; ++k) {
    float lowest = values[k], highest = values[k];
    for (std::size_t i = k; i < values.size(); i += width) {
      lowest = std::min(lowest, values[i]);
      highest = std::max(highest, values[i]);
    }
    accessor["min"].push_back(lowest);
    accessor["max"].push_back(highest);
  }
  document_["accessors"].push_back(std::move(accessor));
  return document_["accessors"].size() - 1;
}

std::size_t GltfBuffer::add_indices(std::span<const std::uint32_t> values) {
  document_["accessors"].push_back({{"bufferView", add_view(bytes_of(values))},
                                    {"componentType", 5125},
                                    {"count", values.size()},
                                    {"type", "SCALAR"}});
  return document_["accessors"].size() - 1;
}

void GltfBuffer::write(const std::filesystem::path& path) {
  const bool is_binary = path.extension() == ".glb";
  if (!is_binary && path.extension() != ".gltf") {
    throw FileError(path, 0, "the extension .glb or .gltf",
                    path.extension().empty() ? "none" : path.extension().string());
  }
  bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
  if (!bytes_.empty()) {
    nlohmann::json buffer{{"byteLength", bytes_.size()}};
    if (!is_binary) buffer["uri"] = "data:application/octet-stream;base64," + base64(bytes_);
    document_["buffers"] = nlohmann::json::array({std::move(buffer)});
  }
  std::string text = document_.dump(is_binary ? -1 : 1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (!is_binary) return write_text(path, text + "\n");
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t size = 12 + 8 + text.size() + (bytes_.empty() ? 0 : 8 + bytes_.size());
  if (size > std::numeric_limits<std::uint32_t>::max()) throw FileError(path, 0, "less than 4 GiB to write", "more");
  std::string file = "glTF";
  for (const std::size_t word : {std::size_t{2}, std::size_t{size}, text.size()}) append_word(file, word);
  file += "JSON" + text;
  if (!bytes_.empty()) {
    append_word(file, bytes_.size());
    file += std::string("BIN\0", 4) + bytes_;
  }
  write_text(path, file);
}

}  // namespace sightline
