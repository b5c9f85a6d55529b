#include "viz/web/web_model.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <type_traits>

#include "viz/partition_picture.h"
#include "viz/traced_picture.h"

namespace sightline::viz {
namespace {

constexpr std::size_t many_parts = 130;  // children of a root, as suit_filter() has it

/// Of the picture whose work is counted. Brute force does the same for every ray, and takes its time.
int coarse_width(const Tracer& tracer) { return tracer.name() == "brute-force" ? 32 : 200; }

/// What a cell takes in the page or, where that is more, in the browser, which draws round ones from many lines.
std::size_t bytes_of(const Cell& cell) {
  constexpr std::size_t header = 11;
  return header + std::visit(
                      [](const auto& region) -> std::size_t {
                        using Region = std::decay_t<decltype(region)>;
                        if constexpr (std::is_same_v<Region, Polyhedron>) {
                          std::size_t numbers = 2 + 3 * region.vertices.size();
                          for (const auto& face : region.faces) numbers += 1 + face.size();
                          return numbers * sizeof(float);
                        }
                        return std::is_same_v<Region, Aabb> ? 24 : 216;
                      },
                      cell.region);
}

/// The largest cells that fit, however many there are in all.
class Largest {
 public:
  explicit Largest(std::size_t bytes) : bytes_(bytes) {}

  void add(const Cell& cell) {
    const Key key{-volume_of(cell), order_++};
    if (taken_ + bytes_of(cell) > bytes_ && !kept_.empty() && kept_.top().first < key) return;
    taken_ += bytes_of(cell);
    kept_.push({key, cell});
    for (; taken_ > bytes_ && kept_.size() > 1; kept_.pop()) taken_ -= bytes_of(kept_.top().second);
  }

  /// Shallow ones first, those of a depth as the structure shows them.
  std::vector<Cell> cells() {
    std::vector<Entry> entries;
    for (; !kept_.empty(); kept_.pop()) entries.push_back(kept_.top());
    std::ranges::sort(entries, {}, [](const Entry& entry) { return entry.first.second; });
    std::vector<Cell> all;
    for (Entry& entry : entries) all.push_back(std::move(entry.second));
    std::ranges::stable_sort(all, {}, &Cell::depth);
    return all;
  }

 private:
  using Key = std::pair<double, std::size_t>;
  using Entry = std::pair<Key, Cell>;
  struct Before {
    bool operator()(const Entry& a, const Entry& b) const { return a.first < b.first; }
  };
  std::size_t bytes_, taken_ = 0, order_ = 0;
  std::priority_queue<Entry, std::vector<Entry>, Before> kept_;  // the smallest cell on top
};

int readable_depth(const std::vector<DepthCount>& depths, std::size_t readable) {
  std::size_t sum = 0;
  for (std::size_t depth = 0; depth < depths.size(); ++depth) {
    sum += depths[depth].inner + depths[depth].leaves;
    if (depth > 0 && sum > readable) return static_cast<int>(depth) - 1;
  }
  return static_cast<int>(depths.size()) - 1;
}

/// The pixels at this distance along an axis.
std::vector<std::pair<int, int>> square_around(int x, int y, int ring) {
  if (ring == 0) return {{x, y}};
  std::vector<std::pair<int, int>> pixels;
  for (int i = -ring; i <= ring; ++i) pixels.insert(pixels.end(), {{x + i, y - ring}, {x + i, y + ring}});
  for (int i = 1 - ring; i < ring; ++i) pixels.insert(pixels.end(), {{x - ring, y + i}, {x + ring, y + i}});
  return pixels;
}

}  // namespace

std::size_t WebStructure::cell_count() const {
  std::size_t count = 0;
  for (const DepthCount& depth : depths) count += depth.inner + depth.leaves;
  return count;
}

WebModel web_model(const std::string& scene, std::shared_ptr<const TriangleMesh> mesh, const Camera& camera,
                   const Vec3d& focus) {
  WebModel model{scene, {}, std::move(mesh), {}, camera, focus, {}, {}};
  model.shown = thin_mesh(*model.mesh, web_triangles);
  if (model.mesh->size() > web_triangles) {
    model.shown.note = "Drawn with " + with_commas(model.shown.triangles.size()) + " of " +
                       with_commas(model.mesh->size()) +
                       " triangles, whose vertices are merged in a grid; cells, walks and counts are of them all.";
  }
  return model;
}

std::vector<std::uint32_t> work_of_picture(const Tracer& tracer, const Camera& camera) {
  Camera coarse = camera;
  coarse.width = coarse_width(tracer);
  coarse.height = std::max(1, static_cast<int>(std::lround(double(coarse.width) * camera.height / camera.width)));
  return trace_picture(tracer, coarse).work;
}

WebStructure web_structure(const Tracer& tracer, const std::string& label, const WebModel& model,
                           std::size_t cell_bytes) {
  WebStructure structure;
  structure.label = label;
  for (const AcceleratorInfo& info : accelerator_infos()) {
    if (info.name == tracer.name()) structure.description = info.description;
  }
  structure.work = work_of_picture(tracer, model.camera);
  for (const WebRay& ray : model.rays) structure.walks.push_back(record_walk(tracer, ray.ray));
  structure.bytes = tracer.structure_bytes();
  std::size_t readable = 0;
  Largest largest(cell_bytes);
  tracer.for_each_cell([&](const Cell& cell) {
    const auto depth = static_cast<std::size_t>(cell.depth);
    if (depth == 0) readable = CellFilter::readable_cells(cell);
    structure.depths.resize(std::max(structure.depths.size(), depth + 1));
    ++(cell.is_leaf ? structure.depths[depth].leaves : structure.depths[depth].inner);
    largest.add(cell);
  });
  structure.cells = largest.cells();
  structure.readable_depth = readable_depth(structure.depths, readable);
  structure.is_cut = structure.depths.size() > 1 && structure.depths[1].inner + structure.depths[1].leaves > many_parts;
  if (structure.is_cut) structure.readable_depth = static_cast<int>(structure.depths.size()) - 1;
  return structure;
}

WebRay middle_ray(const Tracer& tracer, const Camera& camera) {
  const int x = camera.width / 2, y = camera.height / 2;
  const auto chosen = [&](int px, int py) {
    return WebRay{"--pick " + std::to_string(px) + "," + std::to_string(py), camera.ray(px, py)};
  };
  for (int ring = 0; ring < std::max(camera.width, camera.height); ++ring) {
    for (const auto& [px, py] : square_around(x, y, ring)) {
      if (px < 0 || py < 0 || px >= camera.width || py >= camera.height) continue;
      const Ray<float> ray = camera.ray(px, py);
      std::uint8_t is_hit = 0;
      tracer.any_hits({&ray, 1}, {&is_hit, 1});
      if (is_hit) return chosen(px, py);
    }
  }
  return chosen(x, y);
}

}  // namespace sightline::viz
