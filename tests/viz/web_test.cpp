/// What a page is told, against the walks and structures that it is of.

#include "viz/web/web_data.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "sightline/query/workloads.h"
#include "sightline/scene/scenes.h"
#include "tests/viz/structure_names.h"
#include "viz/web/web_camera.h"
#include "viz/web/web_page.h"

namespace sightline::viz {
namespace {

using nlohmann::json;

template <class T>
std::vector<T> decoded(const json& text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.get<std::string>()) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
  }
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

WebModel model_of(const std::string& scene, const std::vector<std::string>& names, std::size_t bytes = 1'000'000) {
  const auto mesh = load_scene(scene, SIGHTLINE_SOURCE_DIR "/data");
  View view;
  view.width = 400, view.height = 300;
  const auto [camera, focus] = web_camera(mesh->bounds(), view);
  WebModel model = web_model(scene, mesh, camera, focus);
  for (const std::string& name : names) {
    const auto tracer = make_tracer(name, mesh);
    if (model.rays.empty()) {
      model.rays = {middle_ray(*tracer, camera), {"--ray", {mesh->bounds().hi + Vec3f(1), Vec3f(1)}}};
      for (const Ray<float>& ray : random_rays(mesh->bounds(), 20, 1)) model.rays.push_back({"--ray", ray});
    }
    model.structures.push_back(web_structure(*tracer, name, model, bytes));
  }
  return model;
}

/// Every step as the walk has it, and the stack after it.
void expect_same(const Walk& walk, const json& data) {
  const auto kind = decoded<std::uint8_t>(data["steps"]["kind_u8"]),
             flags = decoded<std::uint8_t>(data["steps"]["flags_u8"]);
  const auto t = decoded<float>(data["steps"]["t_f32"]), far = decoded<float>(data["steps"]["far_f32"]);
  const auto cell = decoded<std::uint32_t>(data["steps"]["cell_u32"]),
             node = decoded<std::uint32_t>(data["cells"]["node_u32"]);
  const auto triangle = decoded<std::uint32_t>(data["steps"]["triangle_u32"]),
             id = decoded<std::uint32_t>(data["steps"]["id_u32"]);
  const auto since = decoded<std::uint32_t>(data["since_u32"]), until = decoded<std::uint32_t>(data["until_u32"]);
  ASSERT_EQ(kind.size(), walk.steps.size());
  ASSERT_EQ(node.size(), walk.cells.size());
  for (std::size_t i = 0; i < kind.size(); ++i) {
    const WalkStep& step = walk.steps[i];
    EXPECT_EQ(kind[i], static_cast<int>(step.kind));
    EXPECT_EQ(t[i], static_cast<float>(step.t));
    EXPECT_EQ(far[i], static_cast<float>(step.far));
    EXPECT_EQ(cell[i], walk.cell_of(step.node));
    EXPECT_EQ(flags[i] & 3, step.is_crossed + 2 * step.is_hit);
    if (step.kind == WalkStep::Kind::candidate) {
      EXPECT_EQ(id[triangle[i]], step.triangle);
    }
    std::vector<std::size_t> stack;
    for (std::size_t c = 0; c < since.size(); ++c) {
      if (since[c] <= i && i < until[c]) stack.push_back(c);
    }
    std::ranges::sort(stack, {}, [&](std::size_t c) { return until[c]; });
    EXPECT_EQ(stack, walk.pending(i));
  }
}

TEST(WebData, HasEveryWalkOfEveryStructure) {
  const WebModel model = model_of("soup:300", structure_names());
  const json data = json::parse(web_data(model).dump());
  ASSERT_EQ(data["structures"].size(), structure_names().size());
  std::size_t steps = 0;
  for (std::size_t s = 0; s < model.structures.size(); ++s) {
    for (std::size_t w = 0; w < model.rays.size(); ++w) {
      const Walk& walk = model.structures[s].walks[w];
      expect_same(walk, data["structures"][s]["walks"][w]);
      steps += walk.steps.size();
      EXPECT_EQ(walk.hit, model.structures[0].walks[w].hit);
    }
  }
  EXPECT_GT(steps, 10'000u);
}

TEST(WebData, CountsCellsAndWork) {
  const WebModel model = model_of("teapot", {"kd-tree", "bsp-tree", "sphere-tree", "cylinder-tree", "grid"}, 4'000'000);
  const json data = web_data(model);
  for (std::size_t s = 0; s < model.structures.size(); ++s) {
    const WebStructure& structure = model.structures[s];
    const json& told = data["structures"][s];
    std::size_t sum = 0, work = 0;
    for (const json& depth : told["depths"]) sum += depth[0].get<std::size_t>() + depth[1].get<std::size_t>();
    EXPECT_EQ(sum, structure.cells.size()) << structure.label << ": all fit";
    EXPECT_EQ(told["cell_count"], sum);
    for (const json& count : told["work"]) work += count.get<std::size_t>();
    EXPECT_EQ(work, 200u * 150u);
    const auto depth = decoded<std::uint16_t>(told["cells"]["depth_u16"]);
    ASSERT_EQ(depth.size(), sum);
    EXPECT_TRUE(std::ranges::is_sorted(depth));
    for (std::size_t i = 0; i < sum; ++i) EXPECT_EQ(depth[i], structure.cells[i].depth);
    EXPECT_EQ(structure.is_cut, structure.label == "grid");
  }
  const auto shape = decoded<float>(data["structures"][0]["cells"]["shape_f32"]);
  const Aabb& root = model.mesh->bounds();
  ASSERT_GE(shape.size(), 6u);
  EXPECT_LE(shape[0], root.lo.x);
  EXPECT_GE(shape[5], root.hi.z);
}

TEST(WebData, KeepsTheLargestCellsThatFit) {
  const WebModel all = model_of("teapot:4", {"kd-tree"}), few = model_of("teapot:4", {"kd-tree"}, 3500);
  ASSERT_EQ(few.structures[0].cells.size(), 100u);  // of 35 bytes each
  double least = 1e300;
  for (const Cell& cell : few.structures[0].cells) least = std::min(least, volume_of(cell));
  const auto larger =
      std::ranges::count_if(all.structures[0].cells, [&](const Cell& c) { return volume_of(c) > least; });
  EXPECT_LE(larger, 100);
  EXPECT_EQ(few.structures[0].cell_count(), all.structures[0].cells.size());
}

TEST(WebData, LeavesOutTrianglesOfLongWalksAndCountsThem) {
  const WebModel model = model_of("soup:25000", {"brute-force"});
  const json steps = web_data(model)["structures"][0]["walks"][0]["steps"];
  const auto kind = decoded<std::uint8_t>(steps["kind_u8"]);
  const auto skipped = decoded<std::uint32_t>(steps["skipped_u32"]);
  EXPECT_LT(kind.size(), 20'000u);
  const auto shown = std::ranges::count(kind, 2);
  EXPECT_EQ(std::accumulate(skipped.begin(), skipped.end(), static_cast<std::uint64_t>(shown)), 25'000u);
}

TEST(WebData, ThinsLargeMeshesOnly) {
  const auto mesh = load_scene("soup:500", "");
  EXPECT_EQ(thin_mesh(*mesh, 500).triangles.size(), 500u);
  const auto teapot = load_scene("teapot:16", SIGHTLINE_SOURCE_DIR "/data");
  const ThinMesh thin = thin_mesh(*teapot, 3000);
  EXPECT_LE(thin.triangles.size(), 3000u);
  EXPECT_GT(thin.triangles.size(), 1500u);
  for (const auto& triangle : thin.triangles) {
    for (const std::uint32_t corner : triangle) ASSERT_LT(corner, thin.positions.size());
  }
}

TEST(WebPage, IsOneFileThatEndsNoScriptEarly) {
  WebModel model = model_of("soup:50", {"box-tree"});
  model.scene = "</script><b>\"&";
  if (!has_web_library()) {
    EXPECT_THROW(web_page(model), std::runtime_error);
    return;
  }
  const std::string page = web_page(model);
  EXPECT_EQ(page, web_page(model));
  const std::string begin = "id=data>";
  const std::size_t from = page.find(begin) + begin.size(), to = page.find("</script>", from);
  EXPECT_EQ(json::parse(page.substr(from, to - from))["scene"], model.scene);
  EXPECT_NE(page.find("Permission is hereby granted"), std::string::npos);
  for (const char* outside : {"<script src", "<link rel=stylesheet", "@import", "url("}) {
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  }
}

}  // namespace
}  // namespace sightline::viz
