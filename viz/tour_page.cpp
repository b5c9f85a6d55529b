#include "viz/tour_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "viz/partition_picture.h"
#include "viz/tour_style.h"

namespace sightline::viz {
namespace {

using nlohmann::json;

/// The value at a path of keys; null where any of them is missing.
template <class... Keys>
json at(const json& value, const Keys&... keys) {
  json found = value;
  ((found = found.is_object() && found.contains(keys) ? json(found.at(keys)) : json()), ...);
  return found;
}

std::optional<double> number(const json& value) {
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

/// Three significant digits, as 12.3 or 0.0456; whole numbers from 1,000.
std::string digits(double value) {
  if (!(value > 0)) return "0";
  if (value >= 1000) return with_commas(static_cast<std::size_t>(std::fmin(value + 0.5, 1e15)));
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(value))), 0, 9);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return digits(seconds * 1e6) + " µs";
  return seconds < 1 ? digits(seconds * 1e3) + " ms" : digits(seconds) + " s";
}

std::string cell(const std::string& text, const char* kind = "") {
  return std::string("<td") + kind + ">" + (text.empty() ? "–" : text) + "</td>";
}

std::string plain_cell(const std::optional<double>& value) { return cell(value ? digits(*value) : ""); }

/// Rays per second with the ratio to Embree as text and as a bar.
std::string rate_cell(const json& workload) {
  const auto rate = number(at(workload, "mrays_per_second")), ratio = number(at(workload, "ratio_to_embree"));
  if (!rate) return cell("");
  std::string text = digits(*rate);
  if (!ratio) return cell(text);
  std::array<char, 64> bar{};
  std::snprintf(bar.data(), bar.size(), " class=rate style=\"--share:%.1f%%\"", 100 * std::fmin(1, *ratio));
  return cell(text + "<small>" + digits(*ratio) + "×</small>", bar.data());
}

std::string table_row(const json& contender) {
  const json primary = at(contender, "workloads", "primary");
  const bool is_peer = at(contender, "kind") == "peer";
  const json name = at(contender, "name");
  std::string row = std::string("<tr") + (is_peer ? " class=peer" : "") + "><th scope=row>" +
                    escaped(name.is_string() ? name.get<std::string>() : "?") + "</th>";
  const auto build = number(at(contender, "build_seconds", "median"));
  row += cell(build ? duration(*build) : "") + plain_cell(number(at(contender, "bytes_per_primitive")));
  for (const char* workload : {"primary", "bounce", "shadow"}) row += rate_cell(at(contender, "workloads", workload));
  return row + plain_cell(number(at(primary, "nodes_per_ray"))) +
         plain_cell(number(at(primary, "candidates_per_ray"))) + "</tr>\n";
}

std::string table(const json& bench, const std::string& scene) {
  const json scenes = at(bench, "scenes");
  for (const json& measured : scenes.is_array() ? scenes : json::array()) {
    if (at(measured, "name") != scene) continue;
    std::string text =
        "<div class=scroll><table><thead><tr><th>structure</th><th>build</th><th>bytes per<br>triangle</th>"
        "<th>primary rays<br>M/s</th><th>bounce rays<br>M/s</th><th>shadow rays<br>M/s</th><th>nodes<br>per ray</th>"
        "<th>candidates<br>per ray</th></tr></thead><tbody>\n";
    for (const json& contender : at(measured, "contenders")) text += table_row(contender);
    return text +
           "</tbody></table></div>\n<p class=note>M/s: million rays a second, on one core. The bar and the small "
           "number "
           "are the ratio to Embree in the same run. Nodes and candidates are those of primary rays; Embree does not "
           "tell its own. All times are of this machine, from a quick run: <code>./sightline bench</code> measures "
           "longer and gives intervals.</p>\n";
  }
  return "<p class=note>No measurements of this scene.</p>\n";
}

std::string figure(const std::string& file, const std::string& alternative, const std::string& caption) {
  return "<figure><a href=\"" + file + "\"><img src=\"" + file + "\" loading=lazy alt=\"" + escaped(alternative) +
         "\"></a><figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

/// The page in which the scene can be turned, and a ray followed.
std::string walk_link(const SceneTour& scene) {
  if (scene.page.empty()) return "";
  return "<p class=walk><a href=\"" + scene.page +
         "\">Walk in it</a>: turn the scene, go down the levels, and follow a ray step by step through "
         "every structure, in this browser.</p>\n";
}

std::string structure_section(const StructureTour& structure, const std::string& scene, const std::string& page) {
  const std::string walk = page.empty() ? "" : " <a href=\"" + page + "#accel=" + structure.name + "\">Walk in it</a>";
  return "<section class=structure id=\"" + escaped(structure.anchor) + "\"><h3>" + escaped(structure.name) +
         "</h3><p>" + escaped(structure.description) + walk + "</p>\n<div class=pair>" +
         figure(structure.partition, structure.name + ": cells", structure.partition_caption) +
         figure(structure.heat_map, structure.name + ": work per pixel",
                "Work: " + digits(structure.work_per_pixel) + " nodes, leaves and triangles a pixel on average") +
         "</div>\n<pre>./sightline view partitions --accel " + escaped(structure.name) + " --scene " + escaped(scene) +
         "</pre></section>\n";
}

std::string scene_section(const SceneTour& scene, const json& bench) {
  std::string text = "<section class=scene><h2>" + escaped(scene.name) + " <small>" + with_commas(scene.triangles) +
                     " triangles</small></h2>\n" +
                     figure(scene.picture, "The scene " + scene.name + ", traced", scene.verdict) + walk_link(scene) +
                     "<h3>What each structure costs and gives</h3>\n" + table(bench, scene.name) +
                     "<h3>How each structure divides the scene, and what a ray meets in it</h3>\n<p>Left, the first "
                     "cells of the structure. Right, the work of every pixel: nodes visited and triangles tried until "
                     "the nearest hit is certain, in one scale for all. Edges are dear: a ray that grazes the surface "
                     "enters many cells and hits nothing in them.</p>\n<nav>";
  for (const StructureTour& structure : scene.structures) {
    text += "<a href=\"#" + escaped(structure.anchor) + "\">" + escaped(structure.name) + "</a> ";
  }
  text += "</nav>\n";
  for (const StructureTour& structure : scene.structures) {
    text += structure_section(structure, scene.name, scene.page);
  }
  return text + "</section>\n";
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string tour_page(const std::vector<SceneTour>& scenes, const json& bench) {
  std::string page =
      "<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport "
      "content=\"width=device-width, initial-scale=1\"><title>Sightline: a tour</title>\n<style>" +
      std::string(tour_style) +
      "</style></head>\n<body><header><h1>Sightline</h1><p>A ray has to find the first of many triangles that it "
      "meets. Asking every triangle is slow; so space, or the set of triangles, is divided, and a ray asks only where "
      "it passes. Below, one scene goes through every such structure of this library. All give the same hits, bit for "
      "bit; they differ in what they cost.</p></header>\n<main>\n";
  for (const SceneTour& scene : scenes) page += scene_section(scene, bench);
  const std::string scene = scenes.empty() ? "teapot" : escaped(scenes.front().name);
  return page +
         "<section><h2>How to go on</h2>\n<dl>"
         "<dt><code>./sightline view list</code></dt><dd>every structure with its options, every scene</dd>"
         "<dt><code>./sightline view partitions --accel kd-tree --scene " +
         scene +
         "</code></dt>"
         "<dd>a window to turn and to dive into, level by level</dd>"
         "<dt><code>./sightline view partitions --accel bsp-tree --scene " +
         scene +
         " --slice z=0.5 --out cut.png</code>"
         "</dt><dd>a section through cells and mesh</dd>"
         "<dt><code>./sightline bench --scene " +
         scene +
         "</code></dt><dd>measured properly, with intervals</dd>"
         "<dt><code>./sightline test</code></dt><dd>the laws that every structure keeps</dd>"
         "<dt><code>lib/sightline/accel/kd_tree.h</code></dt><dd>read one structure: its invariants, then its "
         "traversal, then its construction</dd></dl></section>\n</main></body></html>\n";
}

}  // namespace sightline::viz
