#include "sightline/texture/image_texture.h"

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "sightline/io/file_bytes.h"
#include "sightline/io/file_error.h"
#include "sightline/io/srgb.h"

namespace sightline {
namespace {

constexpr const char* path_key = "sightline:path";
constexpr const char* content_key = "sightline:is_color";

std::string first_line(const std::string& message) {
  return message.empty() ? "a failure of OpenImageIO" : message.substr(0, message.find('\n'));
}

std::unique_ptr<OIIO::ImageInput> open_input(const std::string& path) {
  OIIO::ImageSpec wishes;
  wishes.attribute("oiio:UnassociatedAlpha", 1);  // colors are not multiplied by it
  return OIIO::ImageInput::open(path, &wishes);
}

/// An image file as the texture system sees it: all levels it has, in floats, colors linear.
class LinearInput final : public OIIO::ImageInput {
 public:
  const char* format_name() const override { return "sightline"; }
  bool open(const std::string& name, OIIO::ImageSpec& spec) override { return open(name, spec, {}); }
  bool open(const std::string&, OIIO::ImageSpec& spec, const OIIO::ImageSpec& config) override {
    input_ = open_input(config.get_string_attribute(path_key));
    if (!input_) {
      errorfmt("{}", OIIO::geterror());
      return false;
    }
    is_encoded_ =
        config.get_int_attribute(content_key) != 0 && input_->spec().get_string_attribute("oiio:ColorSpace") == "sRGB";
    adopt_spec();
    spec = m_spec;
    return true;
  }
  bool close() override { return !input_ || input_->close(); }
  int current_subimage() const override { return input_->current_subimage(); }
  int current_miplevel() const override { return input_->current_miplevel(); }
  bool seek_subimage(int subimage, int level) override {
    if (!input_->seek_subimage(subimage, level)) return false;
    adopt_spec();
    return true;
  }
  bool read_native_scanline(int subimage, int level, int y, int z, void* data) override {
    return finish(
        input_->read_scanlines(subimage, level, y, y + 1, z, 0, m_spec.nchannels, OIIO::TypeDesc::FLOAT, data), data,
        m_spec.width);
  }
  bool read_native_tile(int subimage, int level, int x, int y, int z, void* data) override {
    return finish(input_->read_tiles(subimage, level, x, x + m_spec.tile_width, y, y + m_spec.tile_height, z, z + 1, 0,
                                     m_spec.nchannels, OIIO::TypeDesc::FLOAT, data),
                  data, std::int64_t{m_spec.tile_width} * m_spec.tile_height);
  }

 private:
  void adopt_spec() {
    m_spec = input_->spec();
    m_spec.set_format(OIIO::TypeDesc::FLOAT);
    m_spec.channelformats.clear();
  }
  bool finish(bool is_read, void* data, std::int64_t pixels) {
    if (!is_read) {
      errorfmt("{}", input_->geterror());
      return false;
    }
    float* value = static_cast<float*>(data);
    for (std::int64_t i = 0; i < pixels && is_encoded_; ++i) {
      for (int channel = 0; channel < m_spec.nchannels; ++channel, ++value) {
        if (channel != m_spec.alpha_channel) *value = decode_srgb(*value);
      }
    }
    return true;
  }

  std::unique_ptr<OIIO::ImageInput> input_;
  bool is_encoded_ = false;
};

OIIO::ImageInput* make_linear_input() { return new LinearInput; }

/// One for all textures, with a cache of its own that no other user of OpenImageIO changes the settings of.
std::shared_ptr<OIIO::TextureSystem> shared_system() {
  static const std::shared_ptr<OIIO::TextureSystem> system = [] {
    std::shared_ptr<OIIO::TextureSystem> made(OIIO::TextureSystem::create(false),
                                              [](OIIO::TextureSystem* s) { OIIO::TextureSystem::destroy(s); });
    made->attribute("max_memory_MB", 1024.0f);
    made->attribute("autotile", 64);
    made->attribute("automip", 1);
    made->attribute("forcefloat", 1);
    made->attribute("deduplicate", 0);  // the same file is another image as data than as color
    return made;
  }();
  return system;
}

/// Throws FileError unless every pixel of every level can be read.
void check_whole(OIIO::ImageInput& input, const std::filesystem::path& path) {
  std::vector<float> row;
  for (int level = 0; input.seek_subimage(0, level); ++level) {
    const OIIO::ImageSpec spec = input.spec();
    const int step = spec.tile_width > 0 ? spec.tile_height : 16;
    for (int y = spec.y; y < spec.y + spec.height; y += step) {
      const int end = std::min(y + step, spec.y + spec.height);
      row.resize(std::size_t(spec.width) * std::size_t(step) * std::size_t(spec.nchannels));
      const bool is_read = spec.tile_width > 0 ? input.read_tiles(0, level, spec.x, spec.x + spec.width, y, end, 0, 1,
                                                                  0, spec.nchannels, OIIO::TypeDesc::FLOAT, row.data())
                                               : input.read_scanlines(0, level, y, end, 0, 0, spec.nchannels,
                                                                      OIIO::TypeDesc::FLOAT, row.data());
      if (is_read) continue;
      throw FileError(
          path, 0, "a whole image of " + std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels",
          "rows " + std::to_string(y - spec.y) + " to " + std::to_string(end - spec.y - 1) +
              " that cannot be read: " + first_line(input.geterror()));
    }
  }
  input.geterror();  // of the level after the last
}

OIIO::TextureOpt::Wrap wrap_of(ImageWrap wrap) {
  constexpr std::array wraps{OIIO::TextureOpt::WrapPeriodic, OIIO::TextureOpt::WrapMirror, OIIO::TextureOpt::WrapClamp,
                             OIIO::TextureOpt::WrapBlack};
  return wraps[static_cast<std::size_t>(wrap)];
}

/// x in the image it is in, or beside it, so that no number is too large for the texture system.
double held(ImageWrap wrap, double x) {
  switch (wrap) {
    case ImageWrap::repeat:
      return fraction(x);
    case ImageWrap::mirror:
      return 2 * fraction(x / 2);
    case ImageWrap::clamp:
    case ImageWrap::black:
      break;
  }
  return std::clamp(x, -1.0, 2.0);
}

/// Where it is finite, at most the whole image.
float held_step(double step) { return static_cast<float>(std::fabs(step) <= 1 ? step : std::copysign(1.0, step)); }

}  // namespace

class ImageTexture::Source {
 public:
  Source(std::filesystem::path file, const ImageTextureOptions& options)
      : path(std::move(file)), settings(options), system_(shared_system()) {
    read_spec();
    static std::atomic<std::uint64_t> count{0};
    name_ = OIIO::ustring(path.string() + "#" + std::to_string(++count));  // a file that has changed is another one
    OIIO::ImageSpec config;
    config.attribute(path_key, path.string());
    config.attribute(content_key, options.content == ImageContent::color ? 1 : 0);
    system_->imagecache()->add_file(name_, make_linear_input, &config);
    handle_ = system_->get_texture_handle(name_);
    options_.swrap = wrap_of(options.wrap_u);
    options_.twrap = wrap_of(options.wrap_v);
    options_.interpmode = is_nearest() ? OIIO::TextureOpt::InterpClosest : OIIO::TextureOpt::InterpBilinear;
    options_.mipmode = options.filter == ImageFilter::anisotropic ? OIIO::TextureOpt::MipModeAniso
                       : options.filter == ImageFilter::trilinear ? OIIO::TextureOpt::MipModeTrilinear
                                                                  : OIIO::TextureOpt::MipModeNoMIP;
  }
  ~Source() { system_->invalidate(name_); }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  Color lookup(const glm::dvec2& uv, const UvFootprint& footprint) const {
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return Color(std::numeric_limits<float>::quiet_NaN());
    double u = held(settings.wrap_u, uv.x), v = held(settings.wrap_v, uv.y);
    if (is_nearest()) {
      u = (std::floor(u * width) + 0.5) / width;
      v = (std::floor(v * height) + 0.5) / height;
    }
    OIIO::TextureOpt options = options_;  // the texture system writes to it
    const int count = channels < 3 ? 1 : 3;
    Color color(0);
    if (!system_->texture(handle_, nullptr, options, static_cast<float>(u), static_cast<float>(1 - v),
                          held_step(footprint.right.x), -held_step(footprint.right.y), held_step(footprint.below.x),
                          -held_step(footprint.below.y), count, &color.x)) {
      throw FileError(path, 0, "an image that can still be read", first_line(system_->geterror()));
    }
    return count == 1 ? Color(color.x) : color;
  }

  std::filesystem::path path;
  ImageTextureOptions settings;
  int width = 0, height = 0, channels = 0;

 private:
  bool is_nearest() const { return settings.filter == ImageFilter::nearest; }

  void read_spec() {
    if (!std::filesystem::is_regular_file(path)) read_bytes(path);  // says what is wrong with it as a file
    const std::unique_ptr<OIIO::ImageInput> input = open_input(path.string());
    if (!input) throw FileError(path, 0, "an image", first_line(OIIO::geterror()));
    const OIIO::ImageSpec& spec = input->spec();
    constexpr int longest = 1 << 16;
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.width > longest || spec.height > longest ||
        std::int64_t{spec.width} * spec.height > (std::int64_t{1} << 28)) {
      throw FileError(path, 0, "an image of at most 2^28 pixels, 65536 to a side",
                      std::to_string(spec.width) + " x " + std::to_string(spec.height));
    }
    width = spec.full_width, height = spec.full_height, channels = spec.nchannels;  // what (u, v) is of
    check_whole(*input, path);
  }

  std::shared_ptr<OIIO::TextureSystem> system_;
  OIIO::ustring name_;
  OIIO::TextureSystem::TextureHandle* handle_ = nullptr;
  OIIO::TextureOpt options_;
};

ImageTexture::ImageTexture(const std::filesystem::path& path, const ImageTextureOptions& options)
    : source_(std::make_unique<Source>(path, options)) {}
ImageTexture::~ImageTexture() = default;
ImageTexture::ImageTexture(ImageTexture&&) noexcept = default;
ImageTexture& ImageTexture::operator=(ImageTexture&&) noexcept = default;

const ImageTextureOptions& ImageTexture::options() const { return source_->settings; }
const std::filesystem::path& ImageTexture::path() const { return source_->path; }
int ImageTexture::width() const { return source_->width; }
int ImageTexture::height() const { return source_->height; }
int ImageTexture::channels() const { return source_->channels; }

Color ImageTexture::operator()(const glm::dvec2& uv, const UvFootprint& footprint) const {
  return source_->lookup(uv, footprint);
}

}  // namespace sightline
