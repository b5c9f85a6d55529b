// Exits with the number of components, of six, that lost their rounding to float on the way back to double: 0 where the
// compiler is right.

struct Double3 {
  double x, y, z;
};
struct Float3 {
  float x, y, z;
};

[[gnu::noinline]] int count_unrounded(Double3 a, Double3 b) {
  const auto is_unrounded = [](double value) {
    volatile float rounded = static_cast<float>(value);
    return static_cast<double>(rounded) != value;
  };
  return is_unrounded(a.x) + is_unrounded(a.y) + is_unrounded(a.z) + is_unrounded(b.x) + is_unrounded(b.y) +
         is_unrounded(b.z);
}

[[gnu::noinline]] int round_trip(Double3 target, Double3 way, double scale, float* keep) {
  const Double3 start{target.x * scale - way.x * 16., target.y * scale - way.y * 16., target.z * scale - way.z * 16.};
  const Float3 origin{static_cast<float>(start.x), static_cast<float>(start.y), static_cast<float>(start.z)};
  const Float3 direction{static_cast<float>(way.x), static_cast<float>(way.y), static_cast<float>(way.z)};
  const Double3 o{origin.x, origin.y, origin.z}, d{direction.x, direction.y, direction.z};
  keep[0] = origin.x * direction.x + origin.y * direction.y + origin.z * direction.z;
  keep[1] = static_cast<float>(o.x * d.x + o.y * d.y + o.z * d.z);
  return count_unrounded(o, d);
}

int main() {
  float keep[2];
  return round_trip({0.1, 0.2, 0.3}, {0.7, 0.6, 0.5}, 1.1, keep);
}
