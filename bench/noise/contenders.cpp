#include <array>
#include <bit>
#include <cmath>
#include <memory>

#include "bench/noise/run.h"
#include "bench/peers/noise_peers.h"
#include "bench/verify.h"
#include "sightline/math/random.h"
#include "sightline/noise/noise_field.h"

namespace sightline::bench {
namespace {

/// The same points in float and double, as vectors and axis by axis. Coordinates are floats, so that both are asked
/// the same.
template <int dims>
struct Points {
  template <class T>
  struct In {
    std::vector<glm::vec<dims, T>> vectors;
    std::array<std::vector<T>, dims> lists;
  };
  In<float> floats;
  In<double> doubles;

  template <class T>
  const In<T>& in() const {
    if constexpr (sizeof(T) == 4) {
      return floats;
    } else {
      return doubles;
    }
  }
  template <class T>
  std::array<const T*, dims> lists() const {
    std::array<const T*, dims> pointers;
    for (std::size_t a = 0; a < dims; ++a) pointers[a] = in<T>().lists[a].data();
    return pointers;
  }
  std::size_t size() const { return floats.vectors.size(); }

  void add(const glm::vec<dims, double>& p) {
    const glm::vec<dims, float> rounded(p);
    floats.vectors.push_back(rounded);
    doubles.vectors.emplace_back(rounded);
    for (int a = 0; a < dims; ++a) {
      floats.lists[static_cast<std::size_t>(a)].push_back(rounded[a]);
      doubles.lists[static_cast<std::size_t>(a)].push_back(static_cast<double>(rounded[a]));
    }
  }
};

template <int dims>
std::shared_ptr<const Points<dims>> random_points(std::size_t count, double extent) {
  auto points = std::make_shared<Points<dims>>();
  Random random(1);
  for (std::size_t i = 0; i < count; ++i) {
    glm::vec<dims, double> p;
    for (int axis = 0; axis < dims; ++axis) p[axis] = extent * (2 * random.uniform_double() - 1);
    points->add(p);
  }
  return points;
}

/// As a picture asks: sixteen pixels to a cell, row by row.
template <int dims>
std::shared_ptr<const Points<dims>> grid_points(std::size_t count) {
  auto points = std::make_shared<Points<dims>>();
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  for (std::size_t i = 0; i < side * side; ++i) {
    glm::vec<dims, double> p(0.3);
    p.x = static_cast<double>(i % side) / 16 - 4;
    p.y = static_cast<double>(i / side) / 16 - 4;
    points->add(p);
  }
  return points;
}

template <class T>
bool is_same(T a, T b) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

template <class T>
const char* name_of_type() {
  return sizeof(T) == 4 ? "float" : "double";
}

class Maker {
 public:
  explicit Maker(const NoisePlan& plan) : plan_(plan) {}

  std::vector<NoiseContender> made;

  void add_peers(const std::string& table, const std::shared_ptr<const Points<3>>& points) {
    for (const NoisePeer& peer : noise_peers()) {
      if (!peer.values) continue;
      const auto results = std::make_shared<std::vector<double>>(points->size());
      made.push_back(
          {table, std::string(peer.name),
           [=, values = peer.values] { values(points->lists<double>().data(), points->size(), results->data()); },
           true});
    }
  }

  /// One point after the other, and all together in lists.
  template <class T, int dims>
  void add_noise(const std::string& table, const std::string& name, const NoiseOptions& options,
                 const std::shared_ptr<const Points<dims>>& points) {
    const auto noise = std::make_shared<const Noise>(options);
    const auto single = std::make_shared<std::vector<T>>(points->size());
    const auto batch = std::make_shared<std::vector<T>>(points->size());
    const std::string full = name + ' ' + name_of_type<T>();
    made.push_back({table, full + " scalar", [=] {
                      const auto& at = points->template in<T>().vectors;
                      for (std::size_t i = 0; i < at.size(); ++i) (*single)[i] = (*noise)(at[i]);
                    }});
    const auto one = made.back().pass;
    made.push_back({table, full + " batch", [=] {
                      noise->template function<T, dims>().values(points->template lists<T>(), points->size(),
                                                                 batch->data());
                    }});
    const auto many = made.back().pass;
    one(), many();
    require_same(full, *single, *batch);
  }

  /// Batches of vectors, which are turned into lists first.
  template <class T>
  void add_vectors(const std::string& table, const std::shared_ptr<const Points<3>>& points) {
    const auto noise = std::make_shared<const Noise>();
    const auto results = std::make_shared<std::vector<T>>(points->size());
    made.push_back({table, std::string("perlin ") + name_of_type<T>() + " batch of vectors",
                    [=] { noise->values<3, T>(points->in<T>().vectors, *results); }});
  }

  template <class T>
  void add_octaves(int octaves, const std::shared_ptr<const Points<3>>& points) {
    const auto field =
        std::make_shared<const NoiseField>(FieldOptions{.noise = {}, .fractal = FractalKind::fbm, .octaves = octaves});
    const auto results = std::make_shared<std::vector<T>>(points->size());
    const std::string name = "fbm of " + std::to_string(octaves) + ' ' + name_of_type<T>() + " batch";
    made.push_back({"octaves", name, [=] { field->values<3, T>(points->in<T>().vectors, *results); }});
    made.back().pass();
    std::vector<T> single;
    for (const auto& p : points->in<T>().vectors) single.push_back((*field)(p));
    require_same(name, single, *results);
  }

  template <class T>
  void add_gradients(const std::shared_ptr<const Points<3>>& points) {
    const auto noise = std::make_shared<const Noise>();
    const auto samples = std::make_shared<std::vector<NoiseSample<T, 3>>>(points->size());
    const std::string type = name_of_type<T>();
    made.push_back({"gradients", "analytic " + type + " scalar", [=] {
                      const auto& at = points->in<T>().vectors;
                      for (std::size_t i = 0; i < at.size(); ++i) (*samples)[i] = noise->sample(at[i]);
                    }});
    made.back().pass();
    made.back().error = error_of(*noise, *points, *samples);
    made.push_back(
        {"gradients", "analytic " + type + " batch", [=] { noise->samples<3, T>(points->in<T>().vectors, *samples); }});
    made.back().pass();
    made.back().error = error_of(*noise, *points, *samples);
    // The step at which what is cut off and what rounds are about as large.
    const T step = sizeof(T) == 4 ? T(0x1p-7) : T(0x1p-17);
    made.push_back({"gradients", "central differences " + type + " scalar", [=] {
                      const auto& at = points->in<T>().vectors;
                      for (std::size_t i = 0; i < at.size(); ++i) {
                        (*samples)[i].value = (*noise)(at[i]);
                        for (int axis = 0; axis < 3; ++axis) {
                          auto before = at[i], after = at[i];
                          before[axis] -= step, after[axis] += step;
                          (*samples)[i].gradient[axis] =
                              ((*noise)(after) - (*noise)(before)) / (after[axis] - before[axis]);
                        }
                      }
                    }});
    made.back().pass();
    made.back().error = error_of(*noise, *points, *samples);
  }

 private:
  template <class T>
  void require_same(const std::string& name, const std::vector<T>& single, std::vector<T> batch) const {
    if (plan_.is_spoiled) batch.back() += 1;
    for (std::size_t i = 0; i < single.size(); ++i) {
      if (is_same(single[i], batch[i])) continue;
      throw WrongHits(name + " is wrong, so no times are shown: point " + std::to_string(i) + ": expected " +
                      std::to_string(single[i]) + " as by itself, found " + std::to_string(batch[i]) + " in a batch");
    }
  }

  template <class T>
  static double error_of(const Noise& noise, const Points<3>& points, const std::vector<NoiseSample<T, 3>>& samples) {
    double largest = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto truth = noise.sample(points.doubles.vectors[i]).gradient;
      for (int axis = 0; axis < 3; ++axis) {
        largest = std::fmax(largest, std::fabs(static_cast<double>(samples[i].gradient[axis]) - truth[axis]));
      }
    }
    return largest;
  }

  const NoisePlan& plan_;
};

struct Known {
  glm::dvec3 point;
  double value;
};
/// Perlin's own implementation.
constexpr std::array<Known, 4> reference{{{{.5, .5, .5}, -0.25},
                                          {{3.14, 42, 7}, 0.13691995878400012},
                                          {{-1.1, -2.2, -3.3}, -0.26787526436751358},
                                          {{.1, .2, .3}, 0.35122924878110717}}};

void require_reference() {
  const Noise improved({.kind = NoiseKind::improved});
  for (const Known& known : reference) {
    if (std::fabs(improved(known.point) - known.value) <= 0x1p-47) continue;
    throw WrongHits("improved noise is wrong, so no times are shown: expected " + std::to_string(known.value) +
                    ", found " + std::to_string(improved(known.point)));
  }
}

}  // namespace

std::vector<NoiseContender> make_noise_contenders(const NoisePlan& plan) {
  require_reference();
  Maker maker(plan);
  const auto add_both = [&](const std::string& table, const std::string& name, const NoiseOptions& options,
                            const auto& points) {
    maker.add_noise<float>(table, name, options, points);
    maker.add_noise<double>(table, name, options, points);
  };
  const auto random = random_points<3>(plan.points, 1000), grid = grid_points<3>(plan.points);
  for (const auto& [table, points] :
       {std::pair("random points in space", random), std::pair("a grid in space", grid)}) {
    maker.add_peers(table, points);
    for (const NoiseInfo& info : noise_infos) {
      if (info.kind != NoiseKind::white) add_both(table, std::string(info.name), {.kind = info.kind}, points);
      if (info.kind == NoiseKind::perlin) {
        maker.add_vectors<float>(table, points);
        add_both(table, "perlin quintic", {.kind = info.kind, .ease = Ease::quintic}, points);
      }
    }
  }
  const auto plane = random_points<2>(plan.points, 1000);
  for (const NoiseKind kind : {NoiseKind::perlin, NoiseKind::value}) {
    add_both("random points in the plane", kind == NoiseKind::perlin ? "perlin" : "value", {.kind = kind}, plane);
  }
  for (const int octaves : {1, 2, 4, 8}) {
    maker.add_octaves<float>(octaves, random);
    maker.add_octaves<double>(octaves, random);
  }
  const auto near = random_points<3>(plan.points, 16);
  maker.add_gradients<float>(near);
  maker.add_gradients<double>(near);
  return std::move(maker.made);
}

std::vector<NoiseAccuracy> accuracy_of_floats() {
  std::vector<NoiseAccuracy> lines;
  constexpr std::size_t count = 100'000;
  for (const NoiseInfo& info : noise_infos) {
    if (info.kind == NoiseKind::white) continue;  // of other bits another value
    for (const double distance : {1.0, 1e3, 1e6}) {
      const Noise noise({.kind = info.kind});
      const auto exact = [&](std::string name, const auto& float_at, const auto& double_at) {
        Random random(2);
        NoiseAccuracy line{std::move(name), distance, 0, 0};
        for (std::size_t i = 0; i < count; ++i) {
          glm::dvec3 p;
          for (int axis = 0; axis < 3; ++axis) p[axis] = distance + random.uniform_double();
          const double error = std::fabs(static_cast<double>(float_at(p)) - double_at(p));
          line.largest = std::fmax(line.largest, error);
          line.rms += error * error / count;
        }
        line.rms = std::sqrt(line.rms);
        lines.push_back(line);
      };
      const std::string name(info.name);
      exact(
          name + ", at the float point", [&](const glm::dvec3& p) { return noise(glm::vec3(p)); },
          [&](const glm::dvec3& p) { return noise(glm::dvec3(glm::vec3(p))); });
      exact(
          name + ", at the double point", [&](const glm::dvec3& p) { return noise(glm::vec3(p)); },
          [&](const glm::dvec3& p) { return noise(p); });
    }
  }
  return lines;
}

}  // namespace sightline::bench
