#pragma once
/// Small valid files of every format: a pyramid of 5 vertices and 6 triangles.

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace sightline {

struct MeshSeed {
  std::string extension, bytes;
  std::size_t vertices = 5, triangles = 6;
};

template <class T>
void append_bytes(std::string& bytes, T value, bool big_endian = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big_endian) {
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  }
  bytes.append(raw, sizeof(T));
}

inline constexpr std::array<std::array<float, 3>, 5> pyramid_points = {
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5f}, {0.5f, 0.5f, 1.25f}}};
inline constexpr std::array<std::array<std::uint16_t, 3>, 6> pyramid_faces = {
    {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};

inline std::string coordinates(const std::array<float, 3>& p) {
  return std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
}

inline std::string ply_seed(const std::string& format) {
  std::string bytes = "ply\nformat " + format +
                      " 1.0\ncomment seed\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                      "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
  const bool is_text = format == "ascii", big = format == "binary_big_endian";
  for (const auto& p : pyramid_points) {
    if (is_text) bytes += coordinates(p);
    for (const float x : p) {
      if (!is_text) append_bytes(bytes, x, big);
    }
  }
  for (const auto& face : pyramid_faces) {
    bytes += is_text ? std::string("3") : std::string(1, '\3');
    for (const std::uint16_t index : face) {
      if (is_text) {
        bytes += " " + std::to_string(index);
      } else {
        append_bytes(bytes, std::int32_t{index}, big);
      }
    }
    if (is_text) bytes += '\n';
  }
  return bytes;
}

inline std::string obj_seed() {
  std::string bytes = "# seed\nmtllib none.mtl\no pyramid\n";
  for (const auto& p : pyramid_points) bytes += "v " + coordinates(p);
  bytes +=
      "vn 0 0 1\nvt 0 0\nusemtl b\nf 1 2 3\nf 1/1/1 3/1/1 4//1\nusemtl a\nf 1/1 2/1 5/1\nf -4 -3 -1\nf 3 4 \\\n5\nf 4 "
      "1 5\n";
  return bytes;
}

inline std::string off_seed() {
  std::string bytes = "OFF # seed\n5 6 0\n";
  for (const auto& p : pyramid_points) bytes += coordinates(p);
  for (const auto& f : pyramid_faces) {
    bytes += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + " 255 0 0\n";
  }
  return bytes;
}

inline std::string stl_seed(bool is_text) {
  std::string bytes = is_text ? "solid a pyramid\n" : std::string(80, ' ');
  if (!is_text) append_bytes(bytes, std::uint32_t{6});
  for (const auto& face : pyramid_faces) {
    bytes += is_text ? "facet normal 0 0 1\nouter loop\n" : std::string(12, '\0');
    for (const std::uint16_t index : face) {
      if (is_text) bytes += "vertex " + coordinates(pyramid_points[index]);
      for (const float x : pyramid_points[index]) {
        if (!is_text) append_bytes(bytes, x);
      }
    }
    bytes += is_text ? "endloop\nendfacet\n" : std::string(2, '\0');
  }
  return is_text ? bytes + "endsolid a pyramid\n" : bytes;
}

/// Positions, then indices: 60 and 36 bytes.
inline std::string gltf_buffer() {
  std::string bytes;
  for (const auto& p : pyramid_points) {
    for (const float x : p) append_bytes(bytes, x);
  }
  for (const auto& face : pyramid_faces) {
    for (const std::uint16_t index : face) append_bytes(bytes, index);
  }
  return bytes;
}

/// Two nodes place the pyramid. `uri` of the buffer, with its quotes; empty for GLB.
inline std::string gltf_json(const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0,"translation":[1,2,3],"children":[1]},{"mesh":0,"scale":[2,2,-2]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":18,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":60},{"buffer":0,"byteOffset":60,"byteLength":36}],
"buffers":[{"byteLength":96)" +
         (uri.empty() ? "" : ",\"uri\":" + uri) + "}]}";
}

inline std::string base64(const std::string& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) {
    const auto at = [&](std::size_t k) { return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k])); };
    const std::uint32_t bits = at(0) << 16 | at(1) << 8 | at(2);
    for (int shift = 18; shift >= 0; shift -= 6) text += digits[bits >> shift & 63];
  }
  return text;
}

inline std::string gltf_seed() {
  return gltf_json("\"data:application/octet-stream;base64," + base64(gltf_buffer()) + "\"");
}

inline std::string glb_seed() {
  std::string json = gltf_json("");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = gltf_buffer();
  std::string bytes = "glTF";
  append_bytes(bytes, std::uint32_t{2});
  append_bytes(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
  append_bytes(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append_bytes(bytes, static_cast<std::uint32_t>(buffer.size()));
  return bytes + std::string("BIN\0", 4) + buffer;
}

inline std::vector<MeshSeed> mesh_seeds() {
  return {{".obj", obj_seed()},
          {".off", off_seed()},
          {".ply", ply_seed("ascii")},
          {".ply", ply_seed("binary_little_endian")},
          {".ply", ply_seed("binary_big_endian")},
          {".stl", stl_seed(true)},
          {".stl", stl_seed(false)},
          {".gltf", gltf_seed(), 10, 12},
          {".glb", glb_seed(), 10, 12}};
}

}  // namespace sightline
