#include "sphere.h"

void sightline::labs::offer(Service& service) {
  service.on("camera-ray", student::camera_ray);
  service.on("hit", student::hit_sphere);
  service.on("normal", student::normal_at);
  service.on("shade", student::shade);
  service.on("picture", [](int width, int height) {
    std::vector<double> pixels;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) pixels.push_back(student::pixel(x, y, width, height));
    }
    return pixels;
  });
}
