#include "tests/hard_cases/families/ask_solid.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "sightline/render/solid_tracer.h"
#include "tests/csg/exact_solid.h"
#include "tests/csg/random_solid.h"
#include "tests/hard_cases/families/any_points.h"

namespace sightline::hard {
namespace {

constexpr double share_of(Level level) {
  switch (level) {
    case Level::fast:
      return 0x1p-18;
    case Level::watertight:
      return 0x1p-46;
    default:
      return 0x1p-52;
  }
}

Verdict verdict_of(const TrueEnds& truth, const Spans& spans, Level level) {
  if (spans.begins_inside != truth.begins_inside || spans.boundaries.size() != truth.ends.size()) return Verdict::wrong;
  Verdict worst = Verdict::exact;
  for (std::size_t i = 0; i < truth.ends.size(); ++i) {
    worst = std::max(worst, verdict_of(truth.ends[i], spans.boundaries[i].t, level));
  }
  return worst;
}

std::string text_of(const Spans& spans) {
  std::string text = spans.begins_inside ? "inside at first, then" : "";
  for (const Boundary& boundary : spans.boundaries) text += " " + text_of_number(boundary.t);
  return text.empty() ? "nothing" : text;
}

std::string inputs_of(const SolidTree& tree, const Ray<double>& ray) {
  return sightline::text_of(tree) + ", " + text_of(ray);
}

Verdict verdict_of_first(const TrueEnds& truth, const Hit<double>& hit, Level level) {
  const TrueEnd* first = truth.first();
  if (!first) return hit.is_hit() ? Verdict::wrong : Verdict::exact;
  return hit.is_hit() ? verdict_of(*first, hit.t, level) : Verdict::wrong;
}

}  // namespace

const TrueEnd* TrueEnds::first() const {
  const auto found = std::ranges::find(ends, true, &TrueEnd::is_ahead);
  return found == ends.end() ? nullptr : &*found;
}

TrueEnds true_spans(const SolidTree& tree, const Ray<double>& ray) {
  const oracle::ExactSpans exact = oracle::exact_spans(tree, ray);
  TrueEnds truth{exact.begins_inside, {}};
  for (const oracle::Root& root : exact.ends) {
    truth.ends.push_back({[root](double t) { return oracle::is_nearest(root, t); },
                          [root](double t, double bound) { return oracle::is_within(root, t, oracle::Binary(bound)); },
                          root.compare(0.0) > 0});
  }
  return truth;
}

Verdict verdict_of(const TrueEnd& truth, double t, Level level) {
  if (!std::isfinite(t)) return Verdict::wrong;
  if (truth.is_nearest(t)) return Verdict::exact;
  if (level == Level::exact) return Verdict::wrong;
  return truth.is_within(t, share_of(level) * std::fabs(t)) ? Verdict::within_bound : Verdict::wrong;
}

void ask_lists(const SolidTree& tree, const std::vector<AskedRay>& questions, Trial& trial) {
  const Solid solid(tree);
  for (const Level level : all_levels) {
    Tally& tally = trial.of("solid", level);
    for (const auto& [ray, truth] : questions) {
      const Spans spans = spans_of(solid, ray, level);
      tally.add(verdict_of(truth, spans, level), [&, &ray = ray, &truth = truth] {
        return Example{inputs_of(tree, ray), std::to_string(truth.ends.size()) + " boundaries", text_of(spans)};
      });
    }
  }
}

void ask_structures(const SolidTree& tree, const std::vector<AskedRay>& questions, Trial& trial) {
  const auto solid = std::make_shared<const Solid>(tree);
  std::vector<Ray<double>> rays;
  for (const AskedRay& question : questions) rays.push_back(question.ray);
  std::vector<Hit<double>> hits(rays.size());
  for (const AcceleratorInfo& info : accelerator_infos()) {
    for (const Level level : all_levels) {
      Tally& tally = trial.of(info.name, level);
      make_solid_tracer(info.name, {solid}, level)->closest_hits(rays, hits);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        tally.add(verdict_of_first(questions[i].truth, hits[i], level), [&] {
          return Example{inputs_of(tree, rays[i]), questions[i].truth.first() ? "a hit" : "no hit",
                         hits[i].is_hit() ? "t = " + text_of_number(hits[i].t) : "no hit"};
        });
      }
    }
  }
}

}  // namespace sightline::hard
