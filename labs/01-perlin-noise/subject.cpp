#include "noise.h"

void sightline::labs::offer(Service& service) {
  service.on("fade", student::fade);
  service.on("lattice-hash", student::lattice_hash);
  service.on("gradient-dot", student::gradient_dot);
  service.on("noise", student::noise);
  service.on("fractal-sum", student::fractal_sum);
  service.on("turbulence", student::turbulence);
  service.on("permutation", [] { return student::permutation; });
  service.on("hash-count", [](const Vec3d& p, int octaves) {
    student::hash_count = 0;
    student::fractal_sum(p, octaves);
    return student::hash_count;
  });
  // A square of the plane z = 1/2, row by row from the top, cell by cell of 1/`pixels`.
  service.on("slice", [](int octaves, bool is_turbulent, int size, int pixels) {
    std::vector<double> values;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const Vec3d p((x + 0.5) / pixels, (size - y - 0.5) / pixels, 0.5);
        values.push_back(is_turbulent ? student::turbulence(p, octaves) : student::fractal_sum(p, octaves));
      }
    }
    return values;
  });
}
