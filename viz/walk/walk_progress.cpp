#include "viz/walk/walk_progress.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "viz/partition_picture.h"
#include "viz/walk/walk_colors.h"

namespace sightline::viz {
namespace {

using Kind = WalkStep::Kind;
using Align = Canvas::Align;

std::vector<std::string> wrapped(const Canvas& canvas, const std::string& text, const Canvas::TextStyle& style,
                                 double width) {
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (!lines.back().empty() && canvas.text_width(longer, style) > width) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
  }
  return lines;
}

void draw_stack(Canvas& canvas, const Panel& p, const WalkModel& model, std::size_t step) {
  const Walk& walk = model.walk;
  const std::vector<std::size_t> pending = walk.pending(step);
  canvas.text({p.x, p.y}, "Put aside: " + std::to_string(pending.size()), {medium, ink, Align::left, true});
  canvas.text({p.x, p.y + 26}, pending.empty() ? "nothing" : "next first: node, entered at t", {small, soft_ink});
  constexpr double line = 23;
  const auto rows = static_cast<std::size_t>(std::max(1.0, (p.height - 40) / line));
  for (std::size_t i = 0; i < pending.size() && i < rows; ++i) {
    const double y = p.y + 51 + double(i) * line;
    if (i + 1 == rows && pending.size() > rows) {
      canvas.text({p.x + 22, y}, "and " + std::to_string(pending.size() - i) + " more", {small, soft_ink});
      break;
    }
    const WalkStep& later = walk.steps[*walk.cells[pending[i]].opened];
    canvas.disc({p.x + 8, y}, 6, color_of(CellState::pending));
    canvas.text({p.x + 22, y}, number_of_node(later.node), {small, ink});
    canvas.text({p.x + 240, y}, text_of_t(later.t), {small, ink, Align::right});
  }
}

/// t of the steps, over the same ticks; the line is the far limit.
void draw_reach(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::span<const Tick> ticks) {
  const Panel& p = layout.reach;
  double lo = 1e300, hi = -1e300;
  for (const WalkStep& step : model.walk.steps) {
    if (step.kind == Kind::candidate && !step.is_crossed) continue;
    if (std::isfinite(step.t)) lo = std::min(lo, step.t), hi = std::max(hi, step.t);
  }
  canvas.text({p.x - 12, p.y + 8}, hi > lo ? text_of_t(hi) : "", {small, soft_ink, Align::right});
  canvas.text({p.x - 12, p.y + 36}, "t", {medium, ink, Align::right, true});
  canvas.text({p.x - 12, p.y + p.height - 8}, hi >= lo ? text_of_t(lo) : "", {small, soft_ink, Align::right});
  if (!(hi > lo)) return;
  const auto height = [&](double t) {
    return p.y + p.height - 6 - (std::clamp(t, lo, hi) - lo) / (hi - lo) * (p.height - 12);
  };
  for (const Tick& tick : ticks) {
    const WalkStep& step = model.walk.steps[tick.shown];
    if (std::isfinite(step.far) && step.far <= hi) {
      canvas.line({tick.x, height(step.far)}, {tick.x + tick.width, height(step.far)}, 2, vermillion);
    }
    if (step.kind == Kind::candidate && !step.is_crossed) continue;
    canvas.disc({tick.x + tick.width / 2, height(step.t)}, std::clamp(0.4 * tick.width, 1.5, 4.5), color_of(step));
  }
}

}  // namespace

void draw_facts(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::size_t step) {
  const Panel& p = layout.facts;
  canvas.rectangle({p.x, p.y}, p.width, p.height, band);
  const Canvas::TextStyle style{medium, ink, Align::left, true};
  double y = p.y + 22;
  const std::string sentence = model.walk.steps.empty() ? "The ray misses the root: there is nothing to walk through."
                                                        : sentence_of(model.walk, step);
  for (const std::string& line : wrapped(canvas, sentence, style, p.width - 28)) {
    canvas.text({p.x + 14, y}, line, style);
    y += 26;
  }
  y = p.y + 94;
  const double far = model.walk.steps.empty() ? double(model.walk.ray.t_max) : model.walk.steps[step].far;
  const TraversalStats stats = statistics_at(model.walk, step), all = model.walk.statistics();
  canvas.text({p.x + 14, y}, "So far, of all", {medium, ink, Align::left, true});
  const auto row = [&](const std::string& name, const std::string& value) {
    y += 25;
    canvas.text({p.x + 14, y}, name, {small, ink});
    canvas.text({p.x + 370, y}, value, {small, ink, Align::right});
  };
  const auto of = [](auto some, auto total) { return with_commas(some) + " of " + with_commas(total); };
  row("far limit, t", text_of_t(far));
  row("nodes opened", of(stats.nodes, all.nodes));
  row("leaves opened", of(stats.leaves, all.leaves));
  row("candidates tested", of(stats.candidates, all.candidates));
  row("culled", of(stats.culled, all.culled));
  const Hit<float> hit = model.walk.steps.empty() ? Hit<float>() : model.walk.hit_at(step);
  row("nearest hit", hit.is_hit() ? "triangle " + std::to_string(hit.prim_id) : "none yet");
  draw_stack(canvas, {p.x + 440, p.y + 94, 380, p.height - 100}, model, step);
}

void draw_timeline(Canvas& canvas, const WalkLayout& layout, const WalkModel& model, std::size_t step) {
  const Panel &p = layout.timeline, &below = layout.reach;
  const std::vector<Tick> ticks = lay_out_timeline(model.walk, p);
  canvas.text({p.x - 12, p.y + 14}, "depth", {medium, ink, Align::right, true});
  for (const Tick& tick : ticks) {
    const bool is_current = tick.first <= step && step <= tick.last;
    if (is_current) {
      canvas.rectangle({tick.x, p.y - 4}, std::max(tick.width, 3.0), below.y + below.height - p.y + 4, orange, 0.3);
    }
    const double gap = tick.width > 4 ? 1.5 : 0;
    canvas.rectangle({tick.x + gap, p.y + p.height - tick.height}, tick.width - 2 * gap, tick.height,
                     color_of(model.walk.steps[tick.shown]), tick.first > step ? 0.4 : 1);
    if (is_current) {
      const Canvas::Point tip{tick.x + tick.width / 2, p.y - 2};
      canvas.arrow_head(tip, std::numbers::pi / 2, 14, ink);
    }
  }
  canvas.line({p.x, p.y + p.height}, {p.x + p.width, p.y + p.height}, 1, faint_ink);
  canvas.line({p.x, below.y + below.height}, {p.x + p.width, below.y + below.height}, 1, faint_ink);
  draw_reach(canvas, layout, model, ticks);
}

}  // namespace sightline::viz
