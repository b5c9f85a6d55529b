#include "viz/csg_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "sightline/csg/span_list.h"

namespace sightline::viz {
namespace {

using Json = nlohmann::ordered_json;

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

std::string text_of(const Vec3d& v) { return exact_text(v.x) + " " + exact_text(v.y) + " " + exact_text(v.z); }

std::string intervals_of(const LadderRow& row) {
  std::string text;
  for_each_span(row.boundaries, row.begins_inside, [&](double lo, double hi, const Boundary*, const Boundary*) {
    text += (text.empty() ? "[" : " [") + exact_text(lo) + ", " + exact_text(hi) + "]";
  });
  return text.empty() ? "empty" : text;
}

/// "sphere red (0)": its number tells equal ones apart.
std::string primitive_text(const LadderSolid& solid, std::uint32_t primitive) {
  const std::string& material = solid.material(primitive);
  return shape_name(solid.plain().primitives()[primitive].shape) + (material.empty() ? "" : " " + material) + " (" +
         std::to_string(primitive) + ")";
}

std::string boundary_text(const LadderSolid& solid, const Boundary& boundary) {
  return primitive_text(solid, boundary.primitive) + ", " +
         face_name(solid.plain().primitives()[boundary.primitive].shape, boundary.face) +
         (boundary.is_flipped ? ", flipped" : "");
}

std::string label_of(const Ladder& ladder, const LadderSolid& solid, std::size_t i) {
  const LadderRow& row = ladder.rows[i];
  std::string text(static_cast<std::size_t>(2 * row.depth), ' ');
  if (row.role != ' ') text += std::string(1, row.role) + " ";
  if (row.kind == SolidTree::Kind::primitive) return text + primitive_text(solid, row.primitive);
  return text + name_of(row, solid.plain()) + (row.is_fold ? " (folded)" : "");
}

Json number(double value) {
  if (std::isfinite(value)) return value;
  return exact_text(value);
}

Json json_of(const Vec3d& v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const LadderSolid& solid, const Boundary& boundary) {
  return {{"t", boundary.t},
          {"primitive", boundary.primitive},
          {"face", face_name(solid.plain().primitives()[boundary.primitive].shape, boundary.face)},
          {"material", solid.material(boundary.primitive)},
          {"flipped", boundary.is_flipped}};
}

Json json_of(const LadderSolid& solid, const LadderRow& row) {
  Json json{{"name", name_of(row, solid.plain())}, {"depth", row.depth}, {"parent", row.parent}};
  if (row.role != ' ') json["role"] = std::string(1, row.role);
  if (row.is_fold) json["fold"] = true;
  if (row.kind == SolidTree::Kind::primitive) {
    json["primitive"] = row.primitive;
    json["material"] = solid.material(row.primitive);
  }
  json["intervals"] = Json::array();
  for_each_span(row.boundaries, row.begins_inside, [&](double lo, double hi, const Boundary*, const Boundary*) {
    json["intervals"].push_back(Json::array({number(lo), number(hi)}));
  });
  if (row.kind != SolidTree::Kind::operation) return json;
  json["transitions"] = Json::array();
  for (const LadderStep& step : row.steps) {
    Json entry = json_of(solid, step.boundary);
    entry["wasInA"] = step.change.was_in_a, entry["isInA"] = step.change.is_in_a;
    entry["wasInB"] = step.change.was_in_b, entry["isInB"] = step.change.is_in_b;
    entry["kept"] = step.is_kept;
    json["transitions"].push_back(entry);
  }
  return json;
}

}  // namespace

std::string exact_text(double number) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number + 0.0);
  return {text.data(), end};
}

std::string ladder_table(const Ladder& ladder, const LadderSolid& solid, const std::string& name) {
  std::string text = "solid      " + name + "\nray        origin " + text_of(ladder.ray.origin) + "  direction " +
                     text_of(ladder.ray.direction) + "\nprecision  " + std::string(info_of(ladder.level).name) +
                     "\n\nINTERVALS of t, node by node\n";
  std::size_t width = 0;
  for (std::size_t i = 0; i < ladder.rows.size(); ++i) width = std::max(width, label_of(ladder, solid, i).size());
  for (std::size_t i = 0; i < ladder.rows.size(); ++i) {
    text += padded(std::to_string(i), 5) + padded(label_of(ladder, solid, i), width + 2) +
            intervals_of(ladder.rows[i]) + "\n";
  }
  for (std::size_t i = 0; i < ladder.rows.size(); ++i) {
    const LadderRow& row = ladder.rows[i];
    if (row.steps.empty()) continue;
    const auto sign = operation_infos[static_cast<std::size_t>(row.operation)].sign;
    text += "\nTRANSITIONS of node " + std::to_string(i) + ", " + name_of(row, solid.plain()) + ": " +
            std::string(sign) + "\nt                       wasInA isInA wasInB isInB  result     boundary\n";
    for (const LadderStep& step : row.steps) {
      const auto bit = [](bool b, std::size_t w) { return padded(b ? "1" : "0", w); };
      text += padded(exact_text(step.t), 24) + bit(step.change.was_in_a, 7) + bit(step.change.is_in_a, 6) +
              bit(step.change.was_in_b, 7) + bit(step.change.is_in_b, 7) +
              padded(step.is_kept ? "kept" : "discarded", 11) + boundary_text(solid, step.boundary) + "\n";
    }
  }
  text += "\nHIT, the first boundary of node 0 with t >= 0\n";
  if (!ladder.hit) return text + "none\n";
  const LadderHit& hit = *ladder.hit;
  const std::string& material = solid.material(hit.boundary.primitive);
  return text + "t          " + exact_text(hit.boundary.t) + "\npoint      " + text_of(hit.point) + "\nnormal     " +
         text_of(hit.normal) + "\nmaterial   " + (material.empty() ? "none" : material) + "\nboundary   " +
         boundary_text(solid, hit.boundary) + "\n";
}

nlohmann::ordered_json ladder_json(const Ladder& ladder, const LadderSolid& solid, const std::string& name) {
  Json json{{"solid", name},
            {"ray", {{"o", json_of(ladder.ray.origin)}, {"d", json_of(ladder.ray.direction)}}},
            {"precision", info_of(ladder.level).name},
            {"nodes", Json::array()}};
  for (const LadderRow& row : ladder.rows) json["nodes"].push_back(json_of(solid, row));
  json["hit"] = nullptr;
  if (ladder.hit) {
    Json hit = json_of(solid, ladder.hit->boundary);
    hit["point"] = json_of(ladder.hit->point);
    hit["normal"] = json_of(ladder.hit->normal);
    json["hit"] = hit;
  }
  return json;
}

}  // namespace sightline::viz
