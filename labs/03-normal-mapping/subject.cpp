#include "normal_map.h"

void sightline::labs::offer(Service& service) {
  service.on("decode", student::decode);
  service.on("tangent", student::tangent_of);
  service.on("bitangent", student::bitangent_of);
  service.on("to-world", student::to_world);
  service.on("heights", student::normal_of_heights);
  service.on("facing", student::facing);
  // A map of heights in the light, seen from above.
  service.on("picture", [](const std::vector<double>& heights, int width) {
    const Vec3d light = glm::normalize(Vec3d(-1, 1, 1)), t(1, 0, 0), n(0, 0, 1);
    std::vector<double> pixels;
    for (int i = 0; i < static_cast<int>(heights.size()); ++i) {
      const Vec3d local = student::normal_of_heights(heights, width, i % width, i / width);
      const Vec3d world = student::to_world(local, t, student::bitangent_of(n, t, false), n);
      pixels.push_back(std::max(0.0, glm::dot(student::facing(world, n), light)));
    }
    return pixels;
  });
}
