#include "robust.h"

void sightline::labs::offer(Service& service) {
  service.on("difference", student::difference_of_products);
  service.on("box", [](const Ray<float>& ray, const Vec3f& lo, const Vec3f& hi) {
    return static_cast<std::uint8_t>(student::meets_box(ray, lo, hi));
  });
  service.on("sphere", [](const Ray<float>& ray, const Vec3f& center, float radius) {
    const auto chord = student::meet_sphere(ray, center, radius);
    return chord ? std::optional(std::array{chord->enter, chord->leave}) : std::nullopt;
  });
  service.on("exact-edge", student::exact_edge_sign);
  service.on("edge", [](const Ray<float>& ray, const Vec3f& a, const Vec3f& b) {
    long count = 0;
    return student::edge_sign(ray, a, b, count);
  });
  service.on("edge-work", [](const std::vector<Ray<float>>& rays, const Vec3f& a, const Vec3f& b) {
    long count = 0;
    for (const Ray<float>& ray : rays) student::edge_sign(ray, a, b, count);
    return count;
  });
  service.on("triangle", [](const Ray<float>& ray, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    long count = 0;
    return static_cast<std::uint8_t>(student::crosses_triangle(ray, a, b, c, count));
  });
  service.on("leave", student::leave_from);
}
