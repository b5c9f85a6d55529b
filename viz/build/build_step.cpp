#include "viz/build/build_step.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sightline/io/output_file.h"
#include "viz/command_text.h"
#include "viz/partition_picture.h"
#include "viz/structure.h"

namespace sightline::viz {
namespace {

std::string exact(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string counted(std::size_t count, const std::string& name) {
  return with_commas(count) + ' ' + name + (count == 1 ? "" : "s");
}

std::string axis_name(const BuildCandidate& candidate) {
  return candidate.axis < 0 ? "" : std::string(1, "xyz"[candidate.axis]);
}

nlohmann::ordered_json json_of(const Vec3d& p) { return {p.x, p.y, p.z}; }

nlohmann::ordered_json json_of(const Cell& cell) {
  nlohmann::ordered_json json;
  if (const auto* box = std::get_if<Aabb>(&cell.region)) {
    json["box"] = {{"lo", json_of(Vec3d(box->lo))}, {"hi", json_of(Vec3d(box->hi))}};
  } else if (const auto* sphere = std::get_if<Sphere>(&cell.region)) {
    json["sphere"] = {{"center", json_of(Vec3d(sphere->center))}, {"radius", sphere->radius}};
  } else if (const auto* cylinder = std::get_if<Cylinder>(&cell.region)) {
    json["cylinder"] = {{"center", json_of(Vec3d(cylinder->center))},
                        {"axis", json_of(Vec3d(cylinder->axis))},
                        {"radius", cylinder->radius},
                        {"half_length", cylinder->half_length}};
  } else {
    json["vertices"] = nlohmann::ordered_json::array();
    for (const Vec3d& p : std::get<Polyhedron>(cell.region).vertices) json["vertices"].push_back(json_of(p));
  }
  return json;
}

nlohmann::ordered_json json_of(const BuildCandidate& candidate) {
  nlohmann::ordered_json json;
  if (candidate.axis >= 0) {
    json["axis"] = axis_name(candidate);
    json["position"] = candidate.position;
  } else if (candidate.plane.normal != Vec3d(0)) {
    const Vec3d& n = candidate.plane.normal;
    json["plane"] = {{"normal", {n.x, n.y, n.z}}, {"offset", candidate.plane.offset}};
  } else {
    json["position"] = candidate.position;
  }
  json["cost"] = candidate.cost;
  json["below"] = candidate.below;
  json["above"] = candidate.above;
  json["straddling"] = candidate.straddling;
  if (!candidate.label.empty()) json["label"] = candidate.label;
  return json;
}

}  // namespace

BuildStory::BuildStory(std::shared_ptr<const TriangleMesh> mesh, const AcceleratorSpec& structure, std::string scene,
                       std::string flags)
    : mesh_(std::move(mesh)),
      structure_(structure),
      scene_(std::move(scene)),
      flags_(std::move(flags)),
      primitives_(*mesh_),
      tracer_(make_tracer(structure.accelerator, mesh_, structure.settings)),
      tree_((wake_lazy_cells(*tracer_), *tracer_)),
      replay_(make_replay(structure.accelerator, primitives_, structure.settings)) {}

BuildStep BuildStory::step_at(std::size_t node) const {
  BuildStep step;
  step.node = node;
  step.step = tree_.step_of(node);
  step.decision = replay_->decide(tree_.way_to(node));
  if (step.decision.is_divided && tree_[node].children.empty() && tracer_->is_lazy()) {
    step.decision.reason =
        "is postponed: no ray of a first look has come here; the first one that does " + step.decision.reason;
  }
  const Cell& cell = tree_[node].cell;
  step.title = structure_.accelerator + " on " + scene_ + ": " +
               (step.step ? "step " + with_commas(*step.step) + " of " + with_commas(tree_.steps().size()) : "a leaf") +
               ", node " + std::to_string(cell.node) + " at depth " + std::to_string(cell.depth);
  step.command = "sightline-view build --accel " + quoted(structure_.label) + " --scene " + quoted(scene_) +
                 (step.step ? " --step " + std::to_string(*step.step) : " --node " + std::to_string(cell.node)) +
                 flags_;
  return step;
}

std::vector<std::string> facts_of(const BuildStory& story, const BuildStep& step) {
  const BuildTree& tree = story.tree();
  const Decision& decision = step.decision;
  std::vector<std::string> lines{"weighed: " + decision.how};
  std::string found =
      counted(decision.candidates.size(), "candidate") + " for " + counted(decision.primitives.size(), "triangle");
  if (decision.chosen) {
    const BuildCandidate& chosen = decision.candidates[*decision.chosen];
    if (chosen.axis >= 0 || chosen.plane.normal != Vec3d(0)) {
      found += "; of these " + with_commas(chosen.below) + " go below, " + with_commas(chosen.above) + " above, " +
               with_commas(chosen.straddling) + " straddle";
    }
  }
  lines.push_back(found);
  const BuildTree::Below below = tree.below(step.node);
  lines.push_back("in the finished tree: " + with_commas(below.leaves) + (below.leaves == 1 ? " leaf" : " leaves") +
                  " below, the deepest " + counted(static_cast<std::size_t>(below.depth), "level") + " down");
  return lines;
}

void write_step_json(const std::filesystem::path& path, const BuildStory& story, const BuildStep& step) {
  const Cell& cell = story.tree()[step.node].cell;
  const Decision& decision = step.decision;
  nlohmann::ordered_json json{{"structure", story.structure().accelerator},
                              {"scene", story.scene()},
                              {"node", cell.node},
                              {"depth", cell.depth},
                              {"steps", story.tree().steps().size()}};
  if (step.step) json["step"] = *step.step;
  json["cell"] = json_of(cell);
  json["children"] = nlohmann::ordered_json::array();
  for (const std::size_t child : story.tree()[step.node].children) {
    json["children"].push_back(json_of(story.tree()[child].cell));
  }
  json["primitives"] = decision.primitives.size();
  json["divided"] = decision.is_divided;
  json["reason"] = decision.reason;
  json["weighed"] = decision.how;
  json["cost_unit"] = decision.cost_unit;
  json["leaf_cost"] = decision.leaf_cost;
  json["chosen"] = decision.chosen ? nlohmann::ordered_json(*decision.chosen) : nlohmann::ordered_json();
  json["candidates"] = nlohmann::ordered_json::array();
  for (const BuildCandidate& candidate : decision.candidates) json["candidates"].push_back(json_of(candidate));
  write_text(path, json.dump(1) + '\n');
}

void write_step_csv(const std::filesystem::path& path, const BuildStep& step) {
  std::string text = "axis,position,normal_x,normal_y,normal_z,offset,cost,below,above,straddling,chosen,label\n";
  const Decision& decision = step.decision;
  for (std::size_t i = 0; i < decision.candidates.size(); ++i) {
    const BuildCandidate& c = decision.candidates[i];
    const bool is_general = c.axis < 0 && c.plane.normal != Vec3d(0);
    text += axis_name(c) + ',' + (is_general ? "" : exact(c.position)) + ',';
    for (int axis = 0; axis < 3; ++axis) text += (is_general ? exact(c.plane.normal[axis]) : "") + ',';
    text += (is_general ? exact(c.plane.offset) : "") + ',' + exact(c.cost) + ',' + std::to_string(c.below) + ',' +
            std::to_string(c.above) + ',' + std::to_string(c.straddling) + ',' + (decision.chosen == i ? '1' : '0') +
            ",\"" + c.label + "\"\n";
  }
  write_text(path, text);
}

}  // namespace sightline::viz
