#include "sightline/render/bill.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sightline {
namespace {

constexpr int square_side = 16;

/// A line of the table.
struct BillLine {
  std::string effect, asker, count, share;
};

std::string count_text(double count) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, count > 0 && count < 0.995 ? "%.2g" : "%.3g", count);
  return buffer;
}

std::string share_text(StageTimes::Clock::duration part, StageTimes::Clock::duration whole) {
  if (part.count() == 0) return "";
  const double share =
      100.0 * static_cast<double>(part.count()) / static_cast<double>(std::max<std::int64_t>(1, whole.count()));
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, share < 9.95 ? "%.1f %%" : "%.0f %%", share);
  return buffer;
}

std::string names_of(Effects effects) {
  std::string names;
  for (std::size_t i = 0; i < effect_count; ++i) {
    if (effects.has(static_cast<Effect>(i))) names += (names.empty() ? "" : ", ") + std::string(effect_names[i]);
  }
  return names;
}

std::string aligned(const std::vector<BillLine>& lines) {
  std::size_t effect = 0, count = 0, share = 0;
  for (const BillLine& line : lines) {
    effect = std::max(effect, line.effect.size());
    count = std::max(count, line.count.size());
    share = std::max(share, line.share.size());
  }
  std::string text;
  for (const BillLine& line : lines) {
    text += line.effect + std::string(effect - line.effect.size() + 2 + count - line.count.size(), ' ') + line.count +
            std::string(2 + share - line.share.size(), ' ') + line.share + (line.asker.empty() ? "" : "  ") +
            line.asker + '\n';
  }
  return text;
}

/// What trials have spared.
std::string spared_text(const RenderCounters& counters) {
  const std::uint64_t spared = counters.shadow_rays_spared, sent = counters[Effect::soft_shadow];
  if (spared + counters.shadow_trials == 0) return "";
  const double share = 100.0 * static_cast<double>(spared) / static_cast<double>(spared + sent);
  char line[128];
  std::snprintf(line, sizeof line, "soft shadow: %llu rays sent, %llu of them trials; %llu spared (%.0f %%)\n",
                static_cast<unsigned long long>(sent), static_cast<unsigned long long>(counters.shadow_trials),
                static_cast<unsigned long long>(spared), share);
  return line;
}

}  // namespace

Bill sample_bill(const Renderer& renderer, std::uint32_t pixels, std::uint32_t samples) {
  const double all = static_cast<double>(renderer.width()) * renderer.height();
  // Of squares in rows and columns, so many apart.
  const int step = square_side * std::max(1, static_cast<int>(std::sqrt(all / std::max(1u, pixels))));
  const SampleRange range{0, std::min(samples, renderer.samples())};
  Bill bill;
  for (int y = (step - square_side) / 2; y < renderer.height(); y += step) {
    for (int x = (step - square_side) / 2; x < renderer.width(); x += step) {
      TileBuffer tile(
          {x, y, std::min(square_side, renderer.width() - x), std::min(square_side, renderer.height() - y)});
      std::vector<std::uint32_t> places(tile.rect.pixels());
      for (std::uint32_t i = 0; i < places.size(); ++i) places[i] = i;
      renderer.add_samples(tile, places, range, FactsAsked::none, bill.counters, bill.times);
      bill.samples += places.size() * range.last;
    }
  }
  return bill;
}

std::string plan_text(const Renderer& renderer, const Bill& bill) {
  const RenderPlan& plan = renderer.plan();
  const auto whole = bill.times.total();
  const double per_sample = 1.0 / static_cast<double>(std::max<std::uint64_t>(1, bill.samples));
  std::vector<BillLine> lines{{"effect", "asked for by", "a sample", "time"}};
  lines.push_back({"rays of the camera", "", count_text(static_cast<double>(bill.counters.camera_rays) * per_sample),
                   share_text(bill.times.camera, whole)});
  lines.push_back({"shading", "", "", share_text(bill.times.shading, whole)});
  const Effect* last = nullptr;
  for (const EffectRequest& request : plan.analysis.requests) {
    const std::size_t i = index_of(request.effect);
    const bool is_first = !last || *last != request.effect;
    last = &request.effect;
    if (!is_first) {
      lines.push_back({"", request.who, "", ""});
      continue;
    }
    const std::uint64_t count = bill.counters.counts[i];
    lines.push_back({std::string(effect_names[i]), request.who,
                     count == 0 ? "" : count_text(static_cast<double>(count) * per_sample),
                     share_text(bill.times.of_effects[i], whole)});
  }
  std::string text = aligned(lines);
  if (plan.analysis.effects.has(Effect::soft_shadow)) text += spared_text(bill.counters);
  for (const EffectRequest& declined : plan.analysis.declined) {
    text += "not simulated: " + std::string(effect_names[index_of(declined.effect)]) + ", asked for by " +
            declined.who + '\n';
  }
  text += "integrator: " + std::string(plan.integrator);
  text += plan.unused == Effects{} ? ", which knows nothing else\n"
                                   : ", the smallest there is; it also knows " + names_of(plan.unused) + '\n';
  const std::string shadows = names_of(plan.shadows);
  if (!shadows.empty()) text += "rays to lights go through: " + shadows + '\n';
  return text;
}

}  // namespace sightline
