#include "wood.h"

void sightline::labs::offer(Service& service) {
  service.on("ring", student::ring_number);
  service.on("fraction", student::fraction);
  service.on("noise-point", student::noise_point);
  service.on("grain", student::grain);
  service.on("color", student::color);
  service.on("points", [](const student::Wood& wood, std::vector<Vec3d> points) {
    for (Vec3d& p : points) p = student::noise_point(wood, p);
    return points;
  });
  service.on("colors", [](const student::Wood& wood, const std::vector<Vec3d>& points, const std::vector<double>& noise,
                          const Vec3d& early, const Vec3d& late) {
    std::vector<Vec3d> colors;
    for (std::size_t i = 0; i < points.size(); ++i) {
      colors.push_back(student::color(early, late, student::grain(wood, points[i], noise[i])));
    }
    return colors;
  });
}
