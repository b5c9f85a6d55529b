#include "sightline/io/embedded_image.h"

#include <array>
#include <atomic>
#include <fstream>
#include <string>
#include <utility>

#include "sightline/io/file_error.h"

namespace sightline {
namespace {

std::filesystem::path next_path(std::string_view bytes) {
  static std::atomic<unsigned> count = 0;
  const std::string name = "sightline-texture-" + std::to_string(count++) + std::string(image_extension(bytes));
  return std::filesystem::temp_directory_path() / name;
}

}  // namespace

EmbeddedImage::EmbeddedImage(std::string_view bytes) : file_(next_path(bytes)) {
  std::ofstream out(path(), std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw FileError(path(), 0, "a temporary file that can be written", "a failure on the way");
}

std::string_view image_extension(std::string_view bytes) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> starts{{{"\x89PNG", ".png"},
                                                                                 {"\xff\xd8\xff", ".jpg"},
                                                                                 {"BM", ".bmp"},
                                                                                 {"GIF8", ".gif"},
                                                                                 {"II*", ".tif"},
                                                                                 {"MM", ".tif"}}};
  for (const auto& [start, extension] : starts) {
    if (bytes.starts_with(start)) return extension;
  }
  return {};
}

std::shared_ptr<const EmbeddedImage> keep_image(std::string_view bytes) {
  return std::make_shared<const EmbeddedImage>(bytes);
}

}  // namespace sightline
