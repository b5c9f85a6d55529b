#include "sightline/scene/animation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "sightline/scene/live_scene.h"
#include "sightline/scene/rocket.h"
#include "sightline/scene/rocket_motion.h"

namespace sightline {
namespace {

const glm::dquat none(1, 0, 0, 0), quarter(std::sqrt(0.5), 0, 0, std::sqrt(0.5)), half(0, 0, 0, 1);

Animation moving(Interpolation interpolation) {
  Channel channel;
  channel.node = 1;
  channel.translation = {{0, 1, 3}, {{0, 0, 0}, {2, 0, 0}, {2, 8, 0}}, interpolation};
  channel.scale = {{0, 4}, {{1, 1, 1}, {3, -1, 1}}, Interpolation::step};
  return {"walk", {channel}, true};
}

Transform pose_at(const Animation& animation, double time) {
  std::vector<NodePose> poses;
  AnimationController(animation).pose(time, poses);
  EXPECT_EQ(poses.size(), animation.channels.size());
  return poses.at(0).local;
}

TEST(Animation, GoesFromKeyToKey) {
  const Animation animation = moving(Interpolation::linear);
  EXPECT_EQ(animation.duration(), 4);
  EXPECT_EQ(pose_at(animation, 0.5), Transform::translation({1, 0, 0}));
  EXPECT_EQ(pose_at(animation, 1), Transform::translation({2, 0, 0}));
  EXPECT_EQ(pose_at(animation, 1.5), Transform::translation({2, 2, 0}));
  EXPECT_EQ(pose_at(animation, 3.5), Transform::translation({2, 8, 0}));
  EXPECT_EQ(pose_at(moving(Interpolation::step), 0.999), Transform());
  EXPECT_EQ(pose_at(moving(Interpolation::step), 1), Transform::translation({2, 0, 0}));
}

TEST(Animation, LoopsOrHolds) {
  Animation animation = moving(Interpolation::linear);
  EXPECT_EQ(pose_at(animation, 4 * 1000 + 0.5), pose_at(animation, 0.5));
  EXPECT_EQ(pose_at(animation, -4 + 1.5), pose_at(animation, 1.5));
  animation.is_loop = false;
  EXPECT_EQ(pose_at(animation, 100), Transform::translation({2, 8, 0}) * Transform::scaling({3, -1, 1}));
  EXPECT_EQ(pose_at(animation, -100), Transform());
}

TEST(Animation, TurnsTheShorterWay) {
  Animation animation{"turn", {Channel{}}, true};
  Track<glm::dquat>& turn = animation.channels[0].rotation;
  turn = {{0, 1}, {none, quarter}, Interpolation::linear};
  const Transform middle = pose_at(animation, 0.5);
  EXPECT_NEAR(middle.vector({1, 0, 0}).x, std::sqrt(0.5), 0x1p-50);
  EXPECT_NEAR(middle.vector({1, 0, 0}).y, std::sqrt(0.5), 0x1p-50);
  turn.values[1] = -quarter;
  EXPECT_EQ(pose_at(animation, 0.5), middle);
  turn = {{0, 1, 2, 3, 4}, {none, quarter, half, quarter * half, none}, Interpolation::linear};  // once around
  for (int i = 0; i < 32; ++i) {
    const double angle = i * std::acos(-1) / 16;
    EXPECT_NEAR(pose_at(animation, i / 8.).vector({1, 0, 0}).x, std::cos(angle), 0x1p-48);
    EXPECT_NEAR(pose_at(animation, i / 8.).vector({1, 0, 0}).y, std::sin(angle), 0x1p-48);
  }
}

TEST(Animation, RefusesWhatMakesNoSense) {
  SceneGraph graph;
  graph.add(root_node, "arm");
  check(moving(Interpolation::linear), graph);
  const auto refuses = [&](const std::string& says, const auto& spoil) {
    Animation animation = moving(Interpolation::linear);
    spoil(animation.channels[0]);
    if (says == "one channel") animation.channels.push_back(animation.channels[0]);
    try {
      check(animation, graph);
      FAIL() << "expected a refusal that says " << says;
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find(says), std::string::npos) << text;
      EXPECT_NE(text.find("walk"), std::string::npos) << text;
      EXPECT_TRUE(text.find("/arm") != std::string::npos || says == "node 9") << text;
    }
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  refuses("node 9", [](Channel& c) { c.node = 9; });
  refuses("one channel", [](Channel&) {});
  refuses("as many times", [](Channel& c) { c.translation.times.pop_back(); });
  refuses("translation, key 1: expected a time later", [](Channel& c) { c.translation.times[1] = 0; });
  refuses("translation, key 1: expected a time later", [](Channel& c) {
    c.translation.times = {-1e308, 1e308, 1.7e308};
  });
  refuses("finite time", [](Channel& c) { c.translation.times[2] = infinity; });
  refuses("finite numbers", [](Channel& c) { c.translation.values[2].y = NAN; });
  refuses("rotation, key 0", [](Channel& c) { c.rotation = {{0}, {glm::dquat(0, 0, 0, 0)}, Interpolation::step}; });
  refuses("factors other than 0", [](Channel& c) { c.scale.values[0].z = 0; });
  refuses("0 lies between", [](Channel& c) { c.scale.interpolation = Interpolation::linear; });
}

TEST(Controllers, DragKeepsWhatIsBelow) {
  LiveScene live(rocket());
  const NodeId whole = live.graph().find("/rocket"), fin = live.graph().find("/rocket/fin 2");
  live.set_local(whole, Transform::rotation(Vec3d(1, 2, 0), 50) * Transform::scaling({2, 1, -1}));
  const Vec3d before = live.world(fin).point({1, 1, 1}), by(3, 4, 5);
  const Transform parent = live.world(whole);
  live.set_local(fin, dragged(live.graph().local(fin), parent, by));
  EXPECT_LE(glm::length(live.world(fin).point({1, 1, 1}) - before - by), 0x1p-46);
}

/// The shape's file says nothing of the motion, nor the motion's of shapes: the same flight moves any node.
TEST(Controllers, TheRocketFlies) {
  LiveScene live(rocket());
  const NodeId whole = live.graph().find("/rocket"), flame = live.graph().find("/rocket/flame");
  ASSERT_NE(flame, no_node);
  const RocketFlight flight;
  const RocketMotion motion(flight, whole, flame);
  double highest = 0;
  for (double time = -1; time < flight.landing() + 1; time += 0.125) {
    std::vector<NodePose> poses;
    motion.pose(time, poses);
    live.apply(poses);
    const Vec3d place = live.world(whole).point(Vec3d(0));
    EXPECT_EQ(place, flight.place(time));
    highest = std::max(highest, double(live.bounds<Aabb>(whole).hi.y));
    // Velocity is what place changes by: the mean over a step is that of its middle, but where the engine stops.
    const Vec3d mean = (flight.place(time + 0.0625) - flight.place(time)) / 0.0625;
    if (time >= 0 && time + 0.0625 < flight.landing()) {
      EXPECT_LE(glm::length(mean - flight.velocity(time + 0.03125)), 0x1p-40);
    }
    const Vec3d velocity = flight.velocity(time), nose = live.world(whole).vector({0, 1, 0});
    if (velocity != Vec3d(0)) {
      EXPECT_GE(glm::dot(nose, glm::normalize(velocity)), 1 - 0x1p-40);
    }
  }
  EXPECT_GT(highest, 25);
  EXPECT_NEAR(flight.place(1e9).y, 0, 0x1p-40);
  EXPECT_THROW(RocketMotion({3, {0, -1, 0}, 9.81, 0}, whole), std::invalid_argument);
}

}  // namespace
}  // namespace sightline
