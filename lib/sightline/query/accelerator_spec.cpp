#include "sightline/query/accelerator_spec.h"

#include <algorithm>
#include <stdexcept>

#include "sightline/query/structure_plugin.h"

namespace sightline {
namespace {

TracerSettings::Option parse_option(const std::string& text, const std::string& whole, const std::string& expected) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw std::invalid_argument(whole + ": expected " + expected + ", found '" + text + "'");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace

std::vector<AcceleratorSpec> parse_accelerators(const std::string& text) {
  const std::string whole = "--accel " + text, expected = "NAME[:OPTION=VALUE,...]";
  std::vector<AcceleratorSpec> specs;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t end = std::min(text.find(',', first), text.size());
    const std::string item = text.substr(first, end - first);
    first = end + 1;
    const std::size_t colon = item.find(':');
    if (item.find('=') < colon) {
      if (specs.empty() || specs.back().settings.options.empty()) {
        throw std::invalid_argument(whole + ": expected " + expected + ", found '" + item + "'");
      }
      specs.back().settings.options.push_back(parse_option(item, whole, expected));
      specs.back().label += ',' + item;
      continue;
    }
    AcceleratorSpec spec{item, item.substr(0, colon), {}};
    if (spec.accelerator.empty()) {
      throw std::invalid_argument(whole + ": expected " + expected + ", found '" + item + "'");
    }
    if (spec.accelerator.ends_with(".so")) {
      spec.accelerator = load_structure(spec.accelerator);
      spec.label = spec.accelerator + (colon == std::string::npos ? "" : item.substr(colon));
    }
    if (colon != std::string::npos) {
      spec.settings.options.push_back(parse_option(item.substr(colon + 1), whole, expected));
    }
    specs.push_back(std::move(spec));
  }
  return specs;
}

void apply_settings(std::span<AcceleratorSpec> specs, std::span<const std::string> texts) {
  std::vector<std::vector<TracerSettings::Option>> common(specs.size());
  for (const std::string& text : texts) {
    const std::string whole = "--set " + text, expected = "ACCEL.OPTION=VALUE";
    const auto dot = text.substr(0, text.find('=')).find('.');  // a value may have a point
    if (dot == std::string::npos || dot == 0) {
      throw std::invalid_argument(whole + ": expected " + expected + ", as in kd-tree.max_leaf_size=8");
    }
    const std::string accelerator = text.substr(0, dot);
    const TracerSettings::Option option = parse_option(text.substr(dot + 1), whole, expected);
    bool is_used = false;
    for (std::size_t i = 0; i < specs.size(); ++i) {
      if (specs[i].accelerator != accelerator) continue;
      common[i].push_back(option);
      is_used = true;
    }
    if (!is_used) throw std::invalid_argument(whole + ": no accelerator '" + accelerator + "' in this run");
  }
  for (std::size_t i = 0; i < specs.size(); ++i) {
    std::vector<TracerSettings::Option>& options = specs[i].settings.options;
    options.insert(options.begin(), common[i].begin(), common[i].end());  // what comes later wins
  }
}

void check_accelerator(const AcceleratorSpec& spec) {
  const auto triangle = std::make_shared<const TriangleMesh>(std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                                             std::vector<TriangleMesh::Corners>{{0, 1, 2}});
  make_tracer(spec.accelerator, triangle, spec.settings);
}

}  // namespace sightline
