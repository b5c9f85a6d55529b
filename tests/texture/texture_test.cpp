#include "sightline/texture/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/texture/texture_noise.h"

namespace sightline {
namespace {

std::vector<Vec3d> random_points(int count, double reach) {
  std::vector<Vec3d> points(static_cast<std::size_t>(count));
  Random random(1);
  for (Vec3d& p : points) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = reach * (2 * random.uniform_double() - 1);
  }
  return points;
}

double mean_of(const std::vector<Vec3d>& points, const std::function<double(const Vec3d&)>& value) {
  double sum = 0;
  for (const Vec3d& p : points) sum += value(p);
  return sum / static_cast<double>(points.size());
}

TEST(TextureInfos, NameAllTexturesAndTheirOptions) {
  std::set<std::string_view> names;
  for (const TextureInfo& info : texture_infos()) {
    EXPECT_TRUE(names.insert(info.name).second);
    EXPECT_FALSE(info.description.empty());
    std::string all;
    for (const TextureOptionInfo& option : info.options) {
      EXPECT_FALSE(option.help.empty());
      const std::string setting = std::string(option.name) + "=" + option.default_value;
      all += (all.empty() ? ":" : ",") + setting;
      EXPECT_NO_THROW(make_texture(std::string(info.name) + ":" + setting)) << setting;
    }
    // Defaults are what they are said to be.
    const Texture plain = make_texture(std::string(info.name)), told = make_texture(std::string(info.name) + all);
    for (const Vec3d& p : random_points(100, 20)) EXPECT_EQ(plain(p), told(p)) << info.name << all;
  }
  EXPECT_EQ(names, (std::set<std::string_view>{"wood", "marble", "granite", "clouds", "checker"}));
}

TEST(TextureInfos, EveryOptionIsOfUse) {
  const std::vector<Vec3d> points = random_points(300, 3);
  for (const TextureInfo& info : texture_infos()) {
    const Texture plain = make_texture(std::string(info.name));
    for (const TextureOptionInfo& option : info.options) {
      const std::string value = option.name == "noise"                                ? "value"
                                : option.name == "wave"                               ? "sawtooth"
                                : option.default_value.find('/') != std::string::npos ? "0.5/0.25/0.125"
                                : option.default_value == "1"                         ? "2"
                                : option.default_value == "0"                         ? "1"
                                : option.name == "octaves"                            ? "3"
                                                                                      : "0.75";
      const std::string spec =
          std::string(info.name) + ":" + std::string(option.name) + "=" + (option.name == "sharpness" ? "3" : value);
      const Texture changed = make_texture(spec);
      int differ = 0;
      for (const Vec3d& p : points) differ += changed(p) != plain(p);
      EXPECT_GT(differ, 5) << spec;
    }
  }
}

void expect_refusal(const std::string& spec, const std::string& message) {
  try {
    make_texture(spec);
    ADD_FAILURE() << spec << " is refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), message);
  }
}

TEST(TextureInfos, RefuseInOneLine) {
  expect_refusal("wod", "no texture 'wod'; expected one of wood, marble, granite, clouds, checker");
  expect_refusal("wood:", "wood:: expected NAME[:OPTION=VALUE,...], found ''");
  expect_refusal("wood:early", "wood:early: expected NAME[:OPTION=VALUE,...], found 'early'");
  expect_refusal("checker:size=0",
                 "checker: size = 0 is not allowed; expected a number from 9.5367431640625e-07 to 1048576");
  expect_refusal("checker:size=1x",
                 "checker: size = 1x is not allowed; expected a number from 9.5367431640625e-07 to 1048576");
  expect_refusal("checker:sise=1", "checker: sise = 1 is not allowed; expected one of size, even, odd");
  expect_refusal("checker:even=1/0.5",
                 "checker: even = 1/0.5 is not allowed; expected a color R/G/B of numbers from 0 to 1");
  expect_refusal("marble:axis=3", "marble: axis = 3 is not allowed; expected a whole number from 0 to 2");
  expect_refusal("marble:wave=square", "marble: wave = square is not allowed; expected sine, sawtooth or crease");
  expect_refusal("clouds:coverage=nan", "clouds: coverage = nan is not allowed; expected a number from 0 to 1");
  expect_refusal("wood:seed=-1", "wood: seed = -1 is not allowed; expected a whole number from 0 to 2^64 - 1");
  EXPECT_THROW(Marble({.axis = 7}), std::invalid_argument);
  EXPECT_THROW(Granite({.octaves = 0}), std::invalid_argument);
  EXPECT_THROW(Clouds({.sharpness = 0}), std::invalid_argument);
}

TEST(Textures, AreTheSameFromManyThreads) {
  const std::vector<Vec3d> points = random_points(4000, 10);
  for (const TextureInfo& info : texture_infos()) {
    const Texture texture = make_texture(std::string(info.name));
    std::vector<Color> serial, parallel(points.size());
    for (const Vec3d& p : points) serial.push_back(texture(p, Footprint(0.03)));
    std::vector<std::thread> threads;
    for (std::size_t first = 0; first < 4; ++first) {
      threads.emplace_back([&, first] {
        for (std::size_t i = first; i < points.size(); i += 4) parallel[i] = texture(points[i], Footprint(0.03));
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(serial, parallel) << info.name;
  }
}

/// What is seen from afar is the mean of what is seen near by.
TEST(Textures, KeepTheirMeanColorFromAfar) {
  const std::vector<Vec3d> points = random_points(20'000, 200);
  for (const std::string spec :
       {"wood", "marble", "marble:wave=sine", "marble:wave=sawtooth", "granite", "granite:mica=0.4,feldspar=0.2",
        "clouds", "clouds:coverage=0.2,sharpness=100", "clouds:noise=improved,gain=0.9", "checker"}) {
    const Texture texture = make_texture(spec);
    const Color far = texture({0.3, 0.2, 0.1}, Footprint(1e5));
    for (int channel = 0; channel < 3; ++channel) {
      const double near = mean_of(points, [&](const Vec3d& p) { return texture(p)[channel]; });
      EXPECT_NEAR(far[channel], near, 0.02) << spec;
      const double between = mean_of(points, [&](const Vec3d& p) { return texture(p, Footprint(0.1))[channel]; });
      EXPECT_NEAR(between, near, 0.02) << spec;
    }
  }
}

TEST(Textures, AreThemselvesInASmallFootprint) {
  for (const TextureInfo& info : texture_infos()) {
    const Texture texture = make_texture(std::string(info.name));
    for (const Vec3d& p : random_points(500, 10)) {
      EXPECT_EQ(texture(p, Footprint(0)), texture(p));
      const Color near = texture(p, Footprint(0x1p-50));
      for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(near[channel], texture(p)[channel], 1e-6) << info.name;
    }
  }
}

TEST(Clouds, CoverAsMuchAsTheyAreTold) {
  const std::vector<Vec3d> points = random_points(20'000, 500);
  for (const double coverage : {0.0, 0.1, 0.5, 0.8, 1.0}) {
    const Clouds clouds({.coverage = coverage, .sharpness = 8});
    EXPECT_NEAR(mean_of(points, [&](const Vec3d& p) { return clouds.value(p); }), coverage, 0.03);
    EXPECT_NEAR(clouds.value({1, 2, 3}, Footprint(1e6)), coverage, 1e-9);
  }
}

TEST(Granite, HasTheSharesItIsTold) {
  const std::vector<Vec3d> points = random_points(20'000, 100);
  const Granite granite({.feldspar = 0.3, .mica = 0.2});
  EXPECT_NEAR(mean_of(points, [&](const Vec3d& p) { return granite.shares(p).mica; }), 0.2, 0.02);
  EXPECT_NEAR(mean_of(points, [&](const Vec3d& p) { return granite.shares(p).feldspar; }), 0.3 * 0.8, 0.02);
  for (const Vec3d& p : points) {
    const Granite::Shares s = granite.shares(p);
    EXPECT_NEAR(s.quartz + s.feldspar + s.mica, 1, 1e-12);
  }
}

TEST(Marble, HasItsGradientAndLayers) {
  for (const Wave wave : {Wave::sine, Wave::sawtooth, Wave::crease}) {
    const Marble marble({.wave = wave, .axis = 2, .layers = 1.5, .turbulence = 0.5, .octaves = 3});
    int good = 0;
    const std::vector<Vec3d> points = random_points(1000, 5);
    for (const Vec3d& p : points) {
      const NoiseSample<double, 3> s = marble.sample(p);
      EXPECT_EQ(s.value, marble.value(p));
      bool is_good = true;
      for (int axis = 0; axis < 3; ++axis) {
        const double step = 0x1p-22;
        Vec3d ahead = p, back = p;
        ahead[axis] += step, back[axis] -= step;
        const double difference = (marble.value(ahead) - marble.value(back)) / (2 * step);
        is_good &= std::fabs(s.gradient[axis] - difference) < 1e-3;
      }
      good += is_good;
    }
    EXPECT_GE(good, 990) << "all but points at a crease or a jump";
  }
  const Marble layers({.wave = Wave::sawtooth, .axis = 1, .layers = 4, .turbulence = 0});
  EXPECT_EQ(layers.value({7.7, 0.3125, 3.3}), 0.25);
  EXPECT_EQ(layers.value({7.7, 1e9 + 0.3125, 3.3}), 0.25);
  // 0.1 in double is a little more than a tenth, and so is what is left of 3.
  EXPECT_EQ(Marble({.wave = Wave::sawtooth, .layers = 0.1, .turbulence = 0}).value({30, 0, 0}),
            std::fma(0.1, 30, -3.0));
}

/// Turbulence that a footprint takes away has moved layers all the same.
TEST(Marble, FadesByTurbulenceThatIsLost) {
  for (const Wave wave : {Wave::sine, Wave::sawtooth, Wave::crease}) {
    const Marble marble({.wave = wave, .layers = 0, .turbulence = 4, .noise_frequency = 8, .octaves = 2});
    const double mean = mean_of(random_points(20'000, 50), [&](const Vec3d& p) { return marble.value(p); });
    EXPECT_NEAR(marble.value({0.1, 0.2, 0.3}, Footprint(1)), mean, 0.08);
  }
}

TEST(Texture, ColorsManyPointsAsItColorsOne) {
  for (const TextureInfo& info : texture_infos()) {
    const Texture texture = make_texture(std::string(info.name));
    for (const std::size_t count : {0, 1, 5, 64, 65, 300}) {
      for (const int kind : {0, 1, 2}) {  // points alone, footprints of every width, some of both
        const std::vector<Vec3d> points = random_points(static_cast<int>(count), 9);
        std::vector<Footprint> footprints(count);
        for (std::size_t i = 0; i < count; ++i) {
          if (kind == 1 || (kind == 2 && i % 3 == 0)) footprints[i] = Footprint(std::ldexp(1.0, int(i % 16) - 12));
        }
        std::vector<Color> colors(count);
        texture.colors(points, footprints, colors);
        for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(colors[i], texture(points[i], footprints[i])) << info.name;
      }
    }
  }
}

TEST(TextureNoise, KnowsHowFarItSpreads) {
  for (const FractalKind kind : {FractalKind::none, FractalKind::fbm, FractalKind::turbulence, FractalKind::ridged}) {
    const TextureNoise noise({.noise = {}, .fractal = kind, .octaves = 4, .gain = 0.7});
    const std::vector<Vec3d> points = random_points(20'000, 500);
    const double mean = mean_of(points, [&](const Vec3d& p) { return noise.value(p); });
    EXPECT_NEAR(noise.mean(), mean, 0.03);
    for (const double footprint : {0.0, 0.1, 0.3, 100.0}) {
      const double variance = mean_of(points, [&](const Vec3d& p) {
        return (noise.value(p, footprint) - mean) * (noise.value(p, footprint) - mean);
      });
      const double spread = noise.spread(footprint);
      EXPECT_NEAR(std::sqrt(variance + spread * spread) / noise.deviation(), 1, 0.08) << footprint;
    }
  }
  EXPECT_EQ(share_above(0, 0, 0), 1);
  EXPECT_EQ(share_above(0.5, 0, 0), 0);
  for (const double share : {0.01, 0.3, 0.5, 0.9}) EXPECT_NEAR(share_above(threshold_for(share), 0, 1), share, 1e-12);
  EXPECT_EQ(threshold_for(0), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace sightline
