#include "viz/web/web_data.h"

#include <vtkBase64Utilities.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <type_traits>

#include "viz/color_ramp.h"
#include "viz/partition_picture.h"

namespace sightline::viz {
namespace {

using nlohmann::json;
static_assert(std::endian::native == std::endian::little, "arrays are written as they are in memory");

template <class T>
std::string base64(const std::vector<T>& values) {
  const std::size_t bytes = values.size() * sizeof(T);
  std::string text((bytes + 2) / 3 * 4, '=');
  vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(values.data()), bytes,
                             reinterpret_cast<unsigned char*>(text.data()));
  return text;
}

/// Two numbers to an octave: work differs by factors.
std::vector<std::uint32_t> work_edges(const std::vector<WebStructure>& structures) {
  std::uint32_t most = 1;
  for (const WebStructure& structure : structures) {
    for (const std::uint32_t work : structure.work) most = std::max(most, work);
  }
  std::vector<std::uint32_t> edges{0, 1, 2, 3};
  for (std::uint64_t octave = 4; edges.back() <= most; octave *= 2) {
    edges.push_back(static_cast<std::uint32_t>(octave));
    edges.push_back(static_cast<std::uint32_t>(octave + octave / 2));
  }
  return edges;
}

json counts_between(const std::vector<std::uint32_t>& edges, const std::vector<std::uint32_t>& work) {
  std::vector<std::size_t> counts(edges.size() - 1);
  for (const std::uint32_t value : work) {
    const auto after = std::ranges::upper_bound(edges, value);
    ++counts[static_cast<std::size_t>(after - edges.begin() - 1)];
  }
  return counts;
}

json triple(const auto& v) { return {v.x, v.y, v.z}; }

class CellArrays {
 public:
  void add(const Cell& cell) {
    kind_.push_back(static_cast<std::uint8_t>(cell.region.index()));
    depth_.push_back(static_cast<std::uint16_t>(cell.depth));
    leaf_.push_back(cell.is_leaf);
    count_.push_back(cell.range.count);
    node_.push_back(cell.node);
    std::visit([&](const auto& region) { add(region); }, cell.region);
  }

  json data() const {
    return {{"kind_u8", base64(kind_)},    {"depth_u16", base64(depth_)}, {"leaf_u8", base64(leaf_)},
            {"count_u32", base64(count_)}, {"node_u32", base64(node_)},   {"shape_f32", base64(shape_)}};
  }

 private:
  void add(const Aabb& box) { add(box.lo), add(box.hi); }
  void add(const Sphere& sphere) { add(sphere.center), shape_.push_back(sphere.radius); }
  void add(const Cylinder& cylinder) {
    add(cylinder.center), add(cylinder.axis);
    shape_.push_back(cylinder.radius), shape_.push_back(cylinder.half_length);
  }
  void add(const Polyhedron& solid) {
    const auto number = [&](std::size_t value) { shape_.push_back(static_cast<float>(value)); };
    number(solid.vertices.size()), number(solid.faces.size());
    for (const Vec3d& p : solid.vertices) add(Vec3f(p));
    for (const auto& face : solid.faces) {
      number(face.size());
      for (const std::uint32_t corner : face) number(corner);
    }
  }
  void add(const Vec3f& p) { shape_.insert(shape_.end(), {p.x, p.y, p.z}); }

  std::vector<std::uint8_t> kind_, leaf_;
  std::vector<std::uint16_t> depth_;
  std::vector<std::uint32_t> count_, node_;
  std::vector<float> shape_;
};

/// Steps at which cells are on the stack, as Walk::pending tells it: from `since` until before `until`.
struct Waiting {
  explicit Waiting(const Walk& walk) : since(walk.cells.size()), until(walk.cells.size()) {
    std::vector<bool> is_seen(walk.cells.size());
    for (std::size_t step = 0; step < walk.steps.size(); ++step) {
      if (walk.steps[step].kind == WalkStep::Kind::candidate) continue;  // opens nothing
      for (const std::size_t cell : walk.pending(step)) {
        if (is_seen[cell]) continue;
        is_seen[cell] = true;
        since[cell] = static_cast<std::uint32_t>(step);
        until[cell] = static_cast<std::uint32_t>(*walk.cells[cell].opened);
      }
    }
  }

  std::vector<std::uint32_t> since, until;
};

class StepArrays {
 public:
  explicit StepArrays(const TriangleMesh& mesh) : mesh_(mesh) {}

  void skip() { ++skipped_; }

  /// `is_again`: of a cell that was opened before, or stands for one that is not shown.
  void add(const WalkStep& step, std::size_t cell, bool is_again) {
    kind_.push_back(static_cast<std::uint8_t>(step.kind));
    cell_.push_back(static_cast<std::uint32_t>(cell));
    skipped_before_.push_back(std::exchange(skipped_, 0));
    flags_.push_back(static_cast<std::uint8_t>(step.is_crossed + 2 * step.is_hit + 4 * is_again));
    t_.push_back(static_cast<float>(step.t));
    far_.push_back(static_cast<float>(step.far));
    triangle_.push_back(0);
    if (step.kind == WalkStep::Kind::candidate) triangle_.back() = place_of(step.triangle);
  }

  json data() const {
    return {{"kind_u8", base64(kind_)},          {"cell_u32", base64(cell_)}, {"skipped_u32", base64(skipped_before_)},
            {"flags_u8", base64(flags_)},        {"t_f32", base64(t_)},       {"far_f32", base64(far_)},
            {"triangle_u32", base64(triangle_)}, {"id_u32", base64(ids_)},    {"corners_f32", base64(corners_)}};
  }

 private:
  std::uint32_t place_of(std::uint32_t id) {
    const auto [place, is_new] = places_.emplace(id, static_cast<std::uint32_t>(ids_.size()));
    if (is_new) {
      ids_.push_back(id);
      const Triangle triangle = mesh_[id];
      for (const Vec3f& p : {triangle.a, triangle.b, triangle.c}) corners_.insert(corners_.end(), {p.x, p.y, p.z});
    }
    return place->second;
  }

  const TriangleMesh& mesh_;
  std::uint32_t skipped_ = 0;
  std::vector<std::uint8_t> kind_, flags_;
  std::vector<std::uint32_t> cell_, skipped_before_, triangle_, ids_;
  std::vector<float> t_, far_, corners_;
  std::map<std::uint32_t, std::uint32_t> places_;
};

/// Steps that a page keeps, with what it needs to show them; `index` of those left out is that of the next one kept.
json walk_data(const Walk& walk, const TriangleMesh& mesh) {
  StepArrays steps(mesh);
  std::vector<std::uint32_t> index(walk.steps.size() + 1);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    const WalkStep& step = walk.steps[i];
    index[i] = kept;
    const bool is_missed = step.kind == WalkStep::Kind::candidate && !step.is_crossed;
    if (walk.steps.size() > web_steps && is_missed && i + 1 < walk.steps.size()) {
      steps.skip();
      continue;
    }
    const std::size_t cell = walk.cell_of(step.node);
    steps.add(step, cell, step.kind == WalkStep::Kind::visit && walk.cells[cell].opened != i);
    ++kept;
  }
  CellArrays cells;
  std::vector<std::int32_t> parents;
  for (const WalkCell& cell : walk.cells) {
    cells.add(cell.cell);
    parents.push_back(cell.parent ? static_cast<std::int32_t>(*cell.parent) : -1);
  }
  Waiting waiting(walk);
  for (auto* when : {&waiting.since, &waiting.until}) {
    for (std::uint32_t& step : *when) step = index[step];
  }
  json data{{"cells", cells.data()},
            {"parent_i32", base64(parents)},
            {"since_u32", base64(waiting.since)},
            {"until_u32", base64(waiting.until)},
            {"steps", steps.data()},
            {"all_steps", walk.steps.size()}};
  if (walk.hit.is_hit()) data["hit"] = {{"t", walk.hit.t}, {"triangle", walk.hit.prim_id}};
  return data;
}

json structure_data(const WebStructure& structure, const WebModel& model, const std::vector<std::uint32_t>& edges) {
  CellArrays cells;
  for (const Cell& cell : structure.cells) cells.add(cell);
  json depths = json::array(), walks = json::array();
  for (const DepthCount& depth : structure.depths) depths.push_back({depth.inner, depth.leaves});
  for (const Walk& walk : structure.walks) walks.push_back(walk_data(walk, *model.mesh));
  double sum = 0;
  for (const std::uint32_t work : structure.work) sum += work;
  return {{"label", structure.label},
          {"description", structure.description},
          {"bytes", structure.bytes},
          {"cell_count", structure.cell_count()},
          {"depths", depths},
          {"readable_depth", structure.readable_depth},
          {"is_cut", structure.is_cut},
          {"cells", cells.data()},
          {"work", counts_between(edges, structure.work)},
          {"mean_work", sum / double(std::max<std::size_t>(1, structure.work.size()))},
          {"walks", walks}};
}

/// Positions in 65535 steps of the bounds: what a picture shows is coarser.
json mesh_data(const ThinMesh& mesh, const Aabb& bounds) {
  std::vector<std::uint16_t> positions;
  const Vec3d lo(bounds.lo), extent = Vec3d(bounds.hi) - lo;
  for (const Vec3f& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      const double share = extent[axis] > 0 ? (double(p[axis]) - lo[axis]) / extent[axis] : 0;
      positions.push_back(static_cast<std::uint16_t>(std::lround(65535 * std::clamp(share, 0.0, 1.0))));
    }
  }
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : mesh.triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  json data{{"position_u16", base64(positions)}, {"count", mesh.triangles.size()}};
  if (mesh.positions.size() > 65536) {
    data["corner_u32"] = base64(corners);
  } else {
    data["corner_u16"] = base64(std::vector<std::uint16_t>(corners.begin(), corners.end()));
  }
  return data;
}

json ramp_data(double darkest, double lightest) {
  constexpr int steps = 32;
  json colors = json::array();
  for (int i = 0; i <= steps; ++i) colors.push_back(css_color(ramp(double(i) / steps, darkest, lightest)).data());
  return colors;
}

}  // namespace

json web_data(const WebModel& model) {
  const std::vector<std::uint32_t> edges = work_edges(model.structures);
  const Aabb& bounds = model.mesh->bounds();
  json rays = json::array(), structures = json::array();
  for (const WebRay& ray : model.rays) {
    rays.push_back(
        {{"label", ray.label}, {"origin", triple(ray.ray.origin)}, {"direction", triple(ray.ray.direction)}});
  }
  for (const WebStructure& structure : model.structures) {
    structures.push_back(structure_data(structure, model, edges));
  }
  return {{"scene", model.scene},
          {"command", model.command},
          {"triangles", model.mesh->size()},
          {"note", model.shown.note},
          {"bounds", {triple(bounds.lo), triple(bounds.hi)}},
          {"mesh", mesh_data(model.shown, bounds)},
          {"eye", triple(model.camera.eye)},
          {"focus", triple(model.focus)},
          {"up", triple(model.camera.up)},
          {"ramp", {{"light", ramp_data(0.30, 0.76)}, {"dark", ramp_data(0.48, 0.92)}}},
          {"work_edges", edges},
          {"rays", rays},
          {"structures", structures}};
}

}  // namespace sightline::viz
