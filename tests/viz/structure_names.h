#pragma once
/// All structures as parameters of tests.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sightline/query/tracer.h"

namespace sightline::viz {

inline std::vector<std::string> structure_names() {
  std::vector<std::string> all;
  for (const AcceleratorInfo& info : accelerator_infos()) all.emplace_back(info.name);
  return all;
}

inline std::string test_name_of(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
}

}  // namespace sightline::viz
