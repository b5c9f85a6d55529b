#include "viz/csg_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sightline::viz {
namespace {

constexpr double operation_height = 54, other_height = 31, axis_height = 50;
constexpr double largest_section = 440, smallest_section = 90, smallest_scale = 0.66, largest_scale = 1.25;
constexpr double good_section = 270, good_scale = 0.9;

double height_of(const LadderRow& row) {
  return row.kind == SolidTree::Kind::operation ? operation_height : other_height;
}

/// Rows by their place in the ladder, in its order; those whose ancestors are not shown hang on the nearest that is.
class Choice {
 public:
  explicit Choice(const Ladder& ladder) : ladder_(ladder), is_shown_(ladder.rows.size(), true) {}

  /// Leaves out what the ray misses, and the pairs of a fold that this leaves alone.
  void hide_missed(LadderLayout& layout) {
    const auto& rows = ladder_.rows;
    std::vector<int> shown_operands(rows.size(), 0);
    for (std::size_t i = rows.size(); i-- > 1;) {
      const bool is_pair = rows[i].is_fold && shown_operands[i] < 2;
      is_shown_[i] = !rows[i].is_empty() && !is_pair;
      if (rows[i].is_empty() && rows[i].kind == SolidTree::Kind::primitive) ++layout.missed;
      const int count = is_pair ? shown_operands[i] : is_shown_[i];
      shown_operands[static_cast<std::size_t>(rows[i].parent)] += count;
    }
  }

  std::vector<ShownRow> rows() const {
    std::vector<ShownRow> shown;
    std::vector<int> place(ladder_.rows.size(), -1);
    for (std::size_t i = 0; i < ladder_.rows.size(); ++i) {
      if (!is_shown_[i]) continue;
      int parent = ladder_.rows[i].parent;
      char role = ladder_.rows[i].role;
      for (; parent >= 0 && !is_shown_[static_cast<std::size_t>(parent)];) {
        role = ladder_.rows[static_cast<std::size_t>(parent)].role;
        parent = ladder_.rows[static_cast<std::size_t>(parent)].parent;
      }
      const int above = parent < 0 ? -1 : place[static_cast<std::size_t>(parent)];
      const int depth = above < 0 ? 0 : shown[static_cast<std::size_t>(above)].depth + 1;
      place[i] = static_cast<int>(shown.size());
      shown.push_back({i, depth, role, above, 0, height_of(ladder_.rows[i])});
    }
    return shown;
  }

 private:
  const Ladder& ladder_;
  std::vector<bool> is_shown_;
};

double total(const std::vector<ShownRow>& rows) {
  double sum = 0;
  for (const ShownRow& row : rows) sum += row.height;
  return sum;
}

/// All that the ray meets, and its origin unless that is far off.
void choose_range(LadderLayout& layout, const Ladder& ladder, const LadderSolid& solid) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double lo = infinity, hi = -infinity;
  for (const LadderRow& row : ladder.rows) {
    for (const Boundary& boundary : row.boundaries) lo = std::min(lo, boundary.t), hi = std::max(hi, boundary.t);
  }
  const double length = glm::length(ladder.ray.direction);
  if (!(hi > lo)) {
    const Aabb& extent = solid.plain().extent();
    Vec3d middle(0);
    double reach = 1;
    if (!extent.is_empty()) {
      middle = 0.5 * (Vec3d(extent.lo) + Vec3d(extent.hi));
      reach = 0.5 * glm::length(Vec3d(extent.hi) - Vec3d(extent.lo));
    }
    const double nearest = hi == lo ? lo : glm::dot(middle - ladder.ray.origin, ladder.ray.direction) / length / length;
    lo = nearest - reach / length, hi = nearest + reach / length;
  }
  const double width = hi - lo;
  layout.has_origin = lo - 1.2 * width <= 0 && hi + 1.2 * width >= 0;
  if (layout.has_origin) lo = std::min(lo, 0.0), hi = std::max(hi, 0.0);
  layout.t_min = lo - 0.07 * (hi - lo), layout.t_max = hi + 0.07 * (hi - lo);
}

}  // namespace

CsgLayout::CsgLayout(int width, int height)
    : unit_(std::min(width / 1600.0, height / 900.0)), width_(width / unit_), height_(height / unit_) {}

SolidPanel CsgLayout::panel() const {
  const auto pixels = [&](double units) { return static_cast<int>(std::lround(units * unit_)); };
  return {pixels(margin), pixels(top), pixels(panel_width()), pixels(height_ - top - bottom)};
}

LadderLayout lay_out(const CsgLayout& layout, const Ladder& ladder, const LadderSolid& solid) {
  LadderLayout rows;
  choose_range(rows, ladder, solid);
  Choice choice(ladder);
  rows.rows = choice.rows();
  const double room = layout.height() - CsgLayout::top - CsgLayout::bottom - axis_height;
  if (total(rows.rows) * smallest_scale > room - smallest_section) {
    choice.hide_missed(rows);
    rows.rows = choice.rows();
  }
  const double needed = total(rows.rows);
  const double gap = 14;
  // Rows that are hard to read cost more than a lower section.
  const double roomy = (room - gap - good_section) / needed, tight = (room - gap - smallest_section) / needed;
  rows.scale = std::clamp(std::max(roomy, std::min(tight, good_scale)), smallest_scale, largest_scale);
  rows.section_height = std::clamp(room - gap - needed * rows.scale, smallest_section, largest_section);
  double left = room - gap - rows.section_height;
  rows.rows_top = CsgLayout::top + rows.section_height + gap;
  double y = rows.rows_top;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    ShownRow& row = rows.rows[i];
    row.height *= rows.scale;
    if (row.height > left + 1) {  // but for rounding
      rows.cut = rows.rows.size() - i;
      rows.rows.resize(i);
      break;
    }
    row.y = y;
    y += row.height, left -= row.height;
  }
  rows.rows_bottom = y;
  return rows;
}

}  // namespace sightline::viz
