#pragma once
/// Images as textures: of any size, filtered by footprint.

#include <array>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <string_view>

#include "sightline/texture/color.h"
#include "sightline/texture/uv.h"

namespace sightline {

/// What is beyond the image: itself, turned over every other time, its edge, or black.
enum class ImageWrap { repeat, mirror, clamp, black };
inline constexpr std::array<std::string_view, 4> image_wrap_names{"repeat", "mirror", "clamp", "black"};

/// One texel; four of them; those of the two levels that are next to the footprint's size; and, where it is longer than
/// wide, several of these along it. Only the last two look at the footprint.
enum class ImageFilter { nearest, bilinear, trilinear, anisotropic };
inline constexpr std::array<std::string_view, 4> image_filter_names{"nearest", "bilinear", "trilinear", "anisotropic"};

/// Colors become linear before they are filtered, as read_image's do; data, such as normals and heights, stay as they
/// are in the file.
enum class ImageContent { color, data };

struct ImageTextureOptions {
  ImageWrap wrap_u = ImageWrap::repeat;
  ImageWrap wrap_v = ImageWrap::repeat;
  ImageFilter filter = ImageFilter::anisotropic;
  ImageContent content = ImageContent::color;
};

/// Kept by OpenImageIO's TextureSystem: texels are read when they are asked for, in tiles, and up to a gigabyte of
/// those of all textures stay in memory. Levels that the file does not have are made of the one before, by a box
/// filter. Williams, "Pyramidal Parametrics", 1983; Heckbert, "Survey of Texture Mapping", 1986.
///
/// Price: a lookup takes some 0.2 us, with a footprint the more the longer it is than wide, up to 32 times its width.
///
/// The file has to stay as it is as long as the texture. Immutable, and safe to ask from many threads.
class ImageTexture {
 public:
  /// Reads the file once, so that whatever is wrong with it is said here. Price: that time; memory for some rows.
  /// \throws FileError where it is no image, is not whole, or has more than 2^28 pixels.
  explicit ImageTexture(const std::filesystem::path& path, const ImageTextureOptions& options = {});
  ~ImageTexture();
  ImageTexture(ImageTexture&&) noexcept;
  ImageTexture& operator=(ImageTexture&&) noexcept;

  const ImageTextureOptions& options() const;
  const std::filesystem::path& path() const;
  int width() const;
  int height() const;
  int channels() const;

  /// The image's lower left corner is at (0, 0), its upper right one at (1, 1); gray ones are gray in all components,
  /// and alpha is left out. A texel owns its left and lower edge; with `repeat` u = 1 is u = 0. A footprint that is
  /// not finite is the whole image; NaN where u or v is not. \throws FileError where the file can no longer be read.
  Color operator()(const glm::dvec2& uv, const UvFootprint& footprint = {}) const;

 private:
  class Source;
  std::unique_ptr<Source> source_;
};

}  // namespace sightline
