#include <array>
#include <cstdint>
#include <memory>

#include "sightline/render/solid_tracer.h"
#include "tests/csg/evaluate.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/solid_question.h"

namespace sightline::hard {
namespace {

using Rays = std::array<Ray<double>, 16>;

/// From the same place, and of one octant.
Rays neighbours_of(const Ray<double>& ray, std::size_t place) {
  Rays rays;
  rays.fill(ray);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    for (int axis = 0; i != place && axis < 3; ++axis) {
      rays[i].direction[axis] *= 1 + 0x1p-12 * static_cast<double>((i + 1) * static_cast<std::size_t>(axis + 3) % 13);
    }
  }
  return rays;
}

}  // namespace

bool SolidQuestion::is_primitive() const {
  return solid_.is_bounded() && !solid_.root().is_complement && !solid_.bounds().is_empty();
}

void SolidQuestion::judge_hit(Tally& tally, const Hit<double>& hit, bool is_hit, Level level) const {
  judge_first(tally, hit.is_hit() ? std::optional(hit.t) : std::nullopt, level, &SolidQuestion::verdict_of);
  tally.decide(is_hit == first_end().has_value(), [&] {
    return Example{text_of(tree_) + ", " + text_of(ray_), first_end() ? "a hit" : "no hit",
                   is_hit ? "a hit" : "no hit"};
  });
}

void SolidQuestion::ask_packet(Trial& trial, std::string_view who) const {
  if (!is_primitive()) return;
  const auto solid = std::make_shared<const Solid>(tree_);
  for (const Level level : all_levels) {
    Tally& tally = trial.of(who, level);
    const std::size_t place = tally.asked() / 2 % 16;  // each in turn
    const Rays rays = neighbours_of(ray_, place);
    std::array<Hit<double>, 16> hits;
    std::array<std::uint8_t, 16> is_hit{};
    const auto tracer = make_solid_tracer("bih", {solid}, level);
    tracer->closest_hits(rays, hits);
    tracer->any_hits(rays, is_hit);
    judge_hit(tally, hits[place], is_hit[place] == 1, level);
  }
}

void SolidQuestion::ask_each_structure(Trial& trial) const {
  if (!is_primitive()) return;
  const auto solid = std::make_shared<const Solid>(tree_);
  for (const AcceleratorInfo& info : accelerator_infos()) {
    for (const Level level : all_levels) {
      const auto tracer = make_solid_tracer(info.name, {solid}, level, {.options = {}, .in_packets = false});
      Hit<double> hit;
      std::uint8_t is_hit = 0;
      tracer->closest_hits({&ray_, 1}, {&hit, 1});
      tracer->any_hits({&ray_, 1}, {&is_hit, 1});
      judge_hit(trial.of(info.name, level), hit, is_hit == 1, level);
    }
  }
}

}  // namespace sightline::hard
