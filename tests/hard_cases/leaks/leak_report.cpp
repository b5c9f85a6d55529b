#include "tests/hard_cases/leaks/leak_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace sightline::hard {
namespace {

template <class... Args>
std::string formatted(const char* format, Args... args) {
  char text[160];
  std::snprintf(text, sizeof text, format, args...);
  return text;
}

double speed_of(const LeakRow& row) { return row.seconds > 0 ? static_cast<double>(row.rays()) / row.seconds : 0; }

}  // namespace

std::string text_table(const LeakReport& report) {
  std::string text =
      formatted("%zu closed meshes, %llu triangles, level %s, seed %llu, %d threads\n\n", report.meshes.size(),
                static_cast<unsigned long long>(report.triangles), std::string(info_of(report.level).name).c_str(),
                static_cast<unsigned long long>(report.seed), report.threads);
  text += formatted("%-24s %14s %10s %24s\n", "structure", "rays", "leaks", "million rays/s, a core");
  const auto row_text = [&](const std::string& name, std::uint64_t rays, std::uint64_t leaks) {
    return formatted("%-24s %14llu %10llu", name.c_str(), static_cast<unsigned long long>(rays),
                     static_cast<unsigned long long>(leaks));
  };
  for (const LeakRow& row : report.rows) {
    text += row_text(row.structure, row.rays(), row.leaks()) + formatted(" %24.2f\n", speed_of(row) / 1e6);
  }
  text += row_text("all", report.rays(), report.leaks()) + "\n";
  for (const LeakRow& row : report.rows) {
    if (row.leaks() == 0) continue;
    text += "\nfirst leak of " + row.first_leak + "\n";
    for (std::size_t i = 0; i < leak_ways.size(); ++i) {
      if (row.ways[i].leaks > 0)
        text += row_text("  " + std::string(leak_ways[i].name), row.ways[i].rays, row.ways[i].leaks) + "\n";
    }
  }
  return text;
}

nlohmann::json to_json(const LeakReport& report) {
  nlohmann::json structures = nlohmann::json::array();
  for (const LeakRow& row : report.rows) {
    nlohmann::json ways = nlohmann::json::array();
    for (std::size_t i = 0; i < leak_ways.size(); ++i) {
      ways.push_back({{"way", leak_ways[i].name}, {"rays", row.ways[i].rays}, {"leaks", row.ways[i].leaks}});
    }
    structures.push_back({{"structure", row.structure},
                          {"rays", row.rays()},
                          {"leaks", row.leaks()},
                          {"rays_per_second_and_core", speed_of(row)},
                          {"ways", std::move(ways)}});
    if (!row.first_leak.empty()) structures.back()["first_leak"] = row.first_leak;
  }
  return {{"seed", report.seed},           {"level", info_of(report.level).name}, {"meshes", report.meshes},
          {"triangles", report.triangles}, {"threads", report.threads},           {"rays", report.rays()},
          {"leaks", report.leaks()},       {"structures", std::move(structures)}};
}

}  // namespace sightline::hard
