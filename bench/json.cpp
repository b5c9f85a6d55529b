#include "bench/json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/prices.h"
#include "bench/summary.h"

namespace sightline::bench {
namespace {

using Json = nlohmann::ordered_json;

Json median_of(const std::optional<Estimate>& value) { return value ? Json(value->median) : Json(nullptr); }
Json interval_of(const std::optional<Estimate>& value) {
  return value ? Json::array({value->low, value->high}) : Json(nullptr);
}

Json json_of(const Plan& plan) {
  Json workloads = Json::array();
  for (const Workload w : plan.workloads) workloads.push_back(workload_infos[index_of(w)].name);
  Json levels = Json::array();
  for (const Level level : plan.levels) levels.push_back(name_of(level));
  return {{"levels", levels},       {"stream", plan.is_stream},         {"rays", plan.rays},
          {"rounds", plan.rounds},  {"build_threads", plan.threads},    {"peers", plan.peers},
          {"workloads", workloads}, {"slot_seconds", plan.slot_seconds}};
}

Json traced_json(const ContenderReport& contender, const Measurement& own) {
  const auto rate = own.mrays_per_second();
  Json json{{"rays", own.rays},
            {"hit_share", own.hit_share},
            {"mrays_per_second", median_of(rate)},
            {"mrays_per_second_interval", interval_of(rate)},
            {"ratio_to_embree", median_of(own.ratio)},
            {"ratio_to_embree_interval", interval_of(own.ratio)},
            {"confidence", own.seconds ? Json(own.seconds->confidence) : Json(nullptr)}};
  const auto per_ray = [&](std::uint64_t TraversalStats::*member) {
    if (!own.stats || own.rays == 0) return Json(nullptr);
    return Json(static_cast<double>((*own.stats).*member) / static_cast<double>(own.rays));
  };
  json["nodes_per_ray"] = per_ray(&TraversalStats::nodes);
  json["leaves_per_ray"] = per_ray(&TraversalStats::leaves);
  json["candidates_per_ray"] = per_ray(&TraversalStats::candidates);
  json["culled_per_ray"] = per_ray(&TraversalStats::culled);
  if (contender.kind == Contender::Kind::peer) json["disagreeing_rays"] = own.disagreeing_rays;
  json["first_pass_seconds"] = own.first_pass_seconds;
  json["next_pass_seconds"] = own.next_pass_seconds;
  json["iterations"] = own.iterations;
  json["round_seconds"] = json_of_rounds(own.round_seconds);
  return json;
}

Json json_of(const ContenderReport& contender, std::size_t triangles) {
  const bool is_peer = contender.kind == Contender::Kind::peer;
  Json json{{"name", contender.name}, {"kind", is_peer ? "peer" : "ours"}};
  json["accelerator"] = is_peer ? Json(nullptr) : Json(contender.accelerator);
  json["level"] = is_peer ? Json(nullptr) : Json(name_of(contender.level));
  json["stream"] = contender.asking ? Json(contender.asking->is_stream) : Json(nullptr);
  json["options"] = Json::object();
  for (const auto& [name, value] : contender.options) json["options"][name] = value;
  json["lazy"] = contender.is_lazy();
  json["bytes"] = {{"structure", contender.bytes.structure},
                   {"leaves", contender.bytes.leaves ? Json(*contender.bytes.leaves) : Json(nullptr)},
                   {"total", contender.bytes.total()},
                   {"total_when_built", contender.bytes_when_built}};
  json["bytes_per_primitive"] =
      triangles == 0 ? Json(nullptr)
                     : Json(static_cast<double>(contender.bytes.total()) / static_cast<double>(triangles));
  const auto& build = contender.at[index_of(Workload::build)];
  json["build_seconds"] = build ? json_of(build->seconds) : Json(nullptr);
  if (build && build->seconds) {
    json["build_seconds"]["ratio_to_embree"] = median_of(build->ratio);
    json["build_seconds"]["iterations"] = build->iterations;
    json["build_seconds"]["round_seconds"] = json_of_rounds(build->round_seconds);
  }
  json["workloads"] = Json::object();
  for (const WorkloadInfo& info : workload_infos) {
    const auto& own = contender.at[index_of(info.workload)];
    if (own && info.workload != Workload::build)
      json["workloads"][std::string(info.name)] = traced_json(contender, *own);
  }
  return json;
}

Json prices_json(std::span<const SceneReport> scenes) {
  Json json = Json::array();
  for (const Price& price : prices_of(scenes)) {
    Json entry{{"name", price.name}, {"over", price.over}, {"time_ratio", Json::object()}};
    for (const WorkloadInfo& info : workload_infos) {
      const auto& ratio = price.ratio[index_of(info.workload)];
      if (ratio) entry["time_ratio"][std::string(info.name)] = json_of(ratio);
    }
    json.push_back(std::move(entry));
  }
  return json;
}

Json summary_json(std::span<const SceneReport> scenes) {
  Json json = Json::array();
  for (const SummaryLine& line : summary_of(scenes)) {
    Json entry{{"name", line.name},
               {"bytes_per_primitive", line.bytes_per_triangle ? Json(*line.bytes_per_triangle) : Json(nullptr)}};
    entry["ratio_to_embree"] = Json::object();
    for (const WorkloadInfo& info : workload_infos) {
      const auto& ratio = line.ratio[index_of(info.workload)];
      if (ratio) entry["ratio_to_embree"][std::string(info.name)] = json_of(ratio);
    }
    json.push_back(std::move(entry));
  }
  return json;
}

Json growth_json(const Plan& plan, std::span<const GrowthLine> lines) {
  Json json{{"family", plan.growth}, {"limit", plan.growth_limit}, {"contenders", Json::array()}};
  for (const GrowthLine& line : lines) {
    Json entry{{"name", line.name},
               {"left_out_from", line.left_out_from == 0 ? Json(nullptr) : Json(line.left_out_from)}};
    entry["fits"] = Json::object();
    for (const WorkloadInfo& info : workload_infos) {
      const auto& fit = line.fit[index_of(info.workload)];
      if (!fit) continue;
      entry["fits"][std::string(info.name)] = {
          {"exponent", fit->exponent},
          {"standard_error", fit->standard_error ? Json(*fit->standard_error) : Json(nullptr)},
          {"seconds_of_one_triangle", fit->factor}};
    }
    json["contenders"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace

std::string json_text(const Report& report, std::span<const GrowthLine> growth) {
  Json json{{"schema", "sightline-bench 2"}, {"date", report.machine.date}};
  json["machine"] = json_of(report.machine);
  json["plan"] = json_of(report.plan);
  json["scenes"] = Json::array();
  for (const SceneReport& scene : report.scenes) {
    Json entry{
        {"name", scene.name}, {"triangles", scene.triangles}, {"rays_verified_by_brute_force", scene.sampled_rays}};
    entry["contenders"] = Json::array();
    for (const ContenderReport& contender : scene.contenders) {
      entry["contenders"].push_back(json_of(contender, scene.triangles));
    }
    entry["prices"] = prices_json(std::span(&scene, 1));
    json["scenes"].push_back(entry);
  }
  json["summary"] = growth.empty() && report.scenes.size() > 1 ? summary_json(report.scenes) : Json(nullptr);
  json["prices"] = growth.empty() && report.scenes.size() > 1 ? prices_json(report.scenes) : Json(nullptr);
  json["growth"] = growth.empty() ? Json(nullptr) : growth_json(report.plan, growth);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Json json_of(const Machine& machine) {
  return {{"processor", machine.processor},
          {"hardware_threads", machine.hardware_threads},
          {"load", machine.load < 0 ? Json(nullptr) : Json(machine.load)},
          {"system", machine.system},
          {"compiler", machine.compiler},
          {"flags", machine.flags},
          {"build_type", machine.build_type},
          {"assertions", machine.has_assertions},
          {"versions",
           {{"sightline", machine.sightline_version},
            {"embree", machine.embree_version},
            {"cgal", machine.cgal_version.empty() ? Json(nullptr) : Json(machine.cgal_version)},
            {"vtk", machine.vtk_version.empty() ? Json(nullptr) : Json(machine.vtk_version)},
            {"google_benchmark", machine.google_benchmark_version},
            {"tbb", machine.tbb_version}}}};
}

Json json_of(const std::optional<Estimate>& value) {
  if (!value) return nullptr;
  return {{"median", value->median}, {"low", value->low}, {"high", value->high}, {"confidence", value->confidence}};
}

Json json_of_rounds(std::span<const double> seconds) {
  Json list = Json::array();
  for (const double s : seconds) list.push_back(std::isnan(s) ? Json(nullptr) : Json(s));
  return list;
}

}  // namespace sightline::bench
