#include "viz/compare/compare_data.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "viz/compare/work_statistics.h"

namespace sightline::viz {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vec3f& v) { return {v.x, v.y, v.z}; }

/// A miss is null.
Json hit_json(const Hit<float>& hit) {
  if (!hit.is_hit()) return nullptr;
  return {{"t", hit.t}, {"triangle", hit.prim_id}, {"u", hit.u}, {"v", hit.v}};
}

std::uint32_t highest_of(const CompareFindings& findings, WorkKind kind) {
  std::uint32_t highest = 0;
  for (const TracedPicture& traced : findings.traced) {
    const std::vector<std::uint32_t> work = work_of(traced, kind);
    if (!work.empty()) highest = std::max(highest, *std::ranges::max_element(work));
  }
  return highest;
}

Json walk_json(const Walk& walk) {
  const TraversalStats stats = walk.statistics();
  return {{"nodes", stats.nodes},   {"leaves", stats.leaves},  {"candidates", stats.candidates},
          {"culled", stats.culled}, {"cells", walk.all_cells}, {"hit", hit_json(walk.hit)}};
}

Json work_json(const std::vector<std::uint32_t>& work, const std::vector<std::uint32_t>& against,
               std::uint32_t highest) {
  const WorkStatistics s = statistics_of(std::span<const std::uint32_t>(work));
  const std::vector<std::int64_t> less = differences(work, against);
  const DifferenceStatistics d = statistics_of(std::span<const std::int64_t>(less));
  Json bins = Json::array();
  for (const HistogramBin& bin : histogram_of(work, highest)) bins.push_back({bin.low, bin.high, bin.rays});
  return {{"rays", s.rays},
          {"total", s.total},
          {"mean", s.mean()},
          {"median", s.median},
          {"percentile_99", s.percentile_99},
          {"highest", s.highest},
          {"idle_rays", s.idle},
          {"median_of_others", s.busy_median},
          {"difference",
           {{"mean", d.mean()},
            {"median", d.median},
            {"total", d.total},
            {"less", d.less},
            {"equal", d.equal},
            {"more", d.more}}},
          {"histogram", std::move(bins)}};
}

}  // namespace

Json comparison_json(std::span<const Compared> compared, const CompareFindings& findings, const CompareLook& look,
                     const CompareSource& source) {
  const Verdict verdict = verdict_of(compared, findings);
  Json json{{"scene", source.scene},
            {"triangles", compared.front().tracer->mesh().size()},
            {"ray", {{"origin", vector_json(look.ray.origin)}, {"direction", vector_json(look.ray.direction)}}},
            {"picture",
             {{"width", findings.camera.width},
              {"height", findings.camera.height},
              {"azimuth", look.azimuth},
              {"elevation", look.elevation},
              {"zoom", look.zoom}}},
            {"against", compared[look.against].label},
            {"same_hits", verdict.is_same},
            {"verdict", verdict.text},
            {"histogram_columns", {"from", "to", "rays"}},
            {"structures", Json::array()}};
  for (std::size_t i = 0; i < compared.size(); ++i) {
    Json pixels{{"differing_hits", differing_pixels(findings.traced[i], findings.traced.front())}};
    for (const WorkKind kind : work_kinds) {
      pixels[std::string(name_of(kind))] = work_json(
          work_of(findings.traced[i], kind), work_of(findings.traced[look.against], kind), highest_of(findings, kind));
    }
    json["structures"].push_back({{"label", compared[i].label},
                                  {"accelerator", compared[i].tracer->name()},
                                  {"walk", walk_json(findings.walks[i])},
                                  {"pixels", std::move(pixels)}});
  }
  return json;
}

std::string histogram_csv(std::span<const Compared> compared, const CompareFindings& findings) {
  std::string text = "structure,count,from,to,rays\n";
  for (std::size_t i = 0; i < compared.size(); ++i) {
    std::string label = compared[i].label;
    if (label.find(',') != std::string::npos) label = '"' + label + '"';
    for (const WorkKind kind : work_kinds) {
      for (const HistogramBin& bin : histogram_of(work_of(findings.traced[i], kind), highest_of(findings, kind))) {
        text += label + ',' + std::string(name_of(kind)) + ',' + std::to_string(bin.low) + ',' +
                std::to_string(bin.high) + ',' + std::to_string(bin.rays) + '\n';
      }
    }
  }
  return text;
}

std::string comparison_table(std::span<const Compared> compared, const CompareFindings& findings) {
  std::size_t longest = 9;
  for (const Compared& each : compared) longest = std::max(longest, each.label.size());
  const auto padded = [&](const std::string& text) { return text + std::string(longest - text.size(), ' '); };
  std::string table = padded("structure") + "    nodes   leaves  candidates   culled\n";
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const TraversalStats s = findings.walks[i].statistics();
    std::array<char, 128> line{};
    std::snprintf(line.data(), line.size(), " %8llu %8llu %11llu %8llu\n", static_cast<unsigned long long>(s.nodes),
                  static_cast<unsigned long long>(s.leaves), static_cast<unsigned long long>(s.candidates),
                  static_cast<unsigned long long>(s.culled));
    table += padded(compared[i].label) + line.data();
  }
  return table + verdict_of(compared, findings).text + '\n';
}

}  // namespace sightline::viz
