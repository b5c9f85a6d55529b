#include "sightline/render/sky.h"

#include <variant>

namespace sightline {

Sky::Sky(const Surroundings& surroundings) : surroundings_(surroundings) {
  const auto* sky = std::get_if<SkyImage>(&surroundings.background);
  if (!sky) return;
  ImageTextureOptions options;
  options.wrap_v = ImageWrap::clamp;
  options.filter = ImageFilter::bilinear;
  image_.emplace(sky->image, options);
}

void Sky::distribute() {
  if (image_) distribution_ = SkyDistribution::of(std::get<SkyImage>(surroundings_.background));
}

bool Sky::is_black() const {
  const auto* color = std::get_if<Color>(&surroundings_.background);
  return surroundings_.intensity == 0 || (color && *color == Color(0));
}

Color Sky::toward(const Vec3d& direction) const {
  Color color(0);
  if (image_) {
    color = (*image_)(std::get<SkyImage>(surroundings_.background).uv_of(direction));
  } else if (const auto* gradient = std::get_if<SkyGradient>(&surroundings_.background)) {
    color = gradient->toward(direction);
  } else {
    color = std::get<Color>(surroundings_.background);
  }
  return static_cast<float>(surroundings_.intensity) * color;
}

}  // namespace sightline
