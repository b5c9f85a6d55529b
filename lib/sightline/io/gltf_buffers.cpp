#include "sightline/io/gltf_buffers.h"

#include <cstring>

#include "sightline/io/file_bytes.h"

namespace sightline {
namespace {

constexpr std::uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;

std::uint32_t word_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t word;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

std::string decode_base64(const JsonValue& place, std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int digit = base64_digit(c);
    if (digit < 0) place.fail("digits of base64", std::string("'") + c + "'");
    bits = (bits & 0xffffu) << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xffu);
  }
  return bytes;
}

int hex_digit(char c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
         : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                : -1;
}

std::string decode_percent(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 && hex_digit(text[i + 2]) >= 0) {
      decoded += static_cast<char>(16 * hex_digit(text[i + 1]) + hex_digit(text[i + 2]));
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

}  // namespace

std::optional<std::string> gltf_data(const JsonValue& uri) {
  const std::string& text = uri.text();
  if (!text.starts_with("data:")) return std::nullopt;
  constexpr std::string_view mark = ";base64,";
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) uri.fail("data in base64");
  return decode_base64(uri, std::string_view(text).substr(at + mark.size()));
}

std::filesystem::path gltf_file(const JsonValue& uri) {
  const std::string& text = uri.text();
  const std::filesystem::path name = decode_percent(text);
  if (text.empty() || text.find(':') != std::string::npos || name.native().find('\0') != std::string::npos ||
      name.is_absolute()) {
    uri.fail("a file relative to this one");
  }
  return name;
}

GltfParts split_gltf(const std::filesystem::path& path, std::string_view bytes) {
  if (!bytes.starts_with("glTF")) return {bytes, std::nullopt};
  const auto refuse = [&](const std::string& expected, const std::string& found) {
    throw FileError(path, 0, expected, found);
  };
  if (bytes.size() < 20) refuse("20 bytes of header", std::to_string(bytes.size()));
  if (word_at(bytes, 4) != 2) refuse("version 2 of GLB", std::to_string(word_at(bytes, 4)));
  if (word_at(bytes, 8) != bytes.size()) {
    refuse(std::to_string(word_at(bytes, 8)) + " bytes as its header says", std::to_string(bytes.size()));
  }
  GltfParts parts;
  for (std::size_t at = 12; at < bytes.size();) {
    if (bytes.size() - at < 8) refuse("8 bytes of a chunk's header", std::to_string(bytes.size() - at));
    const std::uint32_t length = word_at(bytes, at), type = word_at(bytes, at + 4);
    if (length > bytes.size() - at - 8) {
      refuse("a chunk of " + std::to_string(length) + " bytes", std::to_string(bytes.size() - at - 8));
    }
    const std::string_view content = bytes.substr(at + 8, length);
    if (at == 12) {
      if (type != json_chunk) refuse("JSON in the first chunk", "another type");
      parts.json = content;
    } else if (type == binary_chunk && !parts.binary) {
      parts.binary = content;
    }
    at += 8 + std::size_t{length};
  }
  return parts;
}

std::vector<std::string> read_gltf_buffers(const std::filesystem::path& path, const JsonValue& document,
                                           const std::optional<std::string_view>& binary) {
  std::vector<std::string> buffers;
  const auto list = document.find("buffers");
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const JsonValue buffer = (*list)[i];
    const std::uint64_t length = buffer["byteLength"].whole();
    std::string content;
    if (const auto uri = buffer.find("uri")) {
      const auto data = gltf_data(*uri);
      content = data ? *data : read_bytes(path.parent_path() / gltf_file(*uri));
    } else if (i == 0 && binary) {
      content = *binary;
    } else {
      buffer.fail("a member \"uri\"", "none");
    }
    if (content.size() < length) {
      buffer.fail(std::to_string(length) + " bytes of content", std::to_string(content.size()));
    }
    content.resize(length);
    buffers.push_back(std::move(content));
  }
  return buffers;
}

}  // namespace sightline
