#include <stdexcept>

#include "sightline/scene/scene_members.h"
#include "sightline/scene/scene_reader.h"
#include "sightline/scene/solid_frame.h"

namespace sightline {
namespace {

/// {"axis": [3], "degrees": angle}, or a quaternion [x, y, z, w].
glm::dquat turn_of(const JsonValue& json) {
  if (json.is_array()) {
    if (json.size() != 4) json.fail("4 numbers", std::to_string(json.size()));
    const auto at = [&](std::size_t i) { return json[i].real(); };
    return {at(3), at(0), at(1), at(2)};
  }
  check_members(json, "rotation");
  const Vec3d axis = vector_of(json["axis"]);
  const double size = max_norm(axis);
  if (!(size > 0)) json["axis"].fail("an axis other than 0");
  return glm::angleAxis(glm::radians(json["degrees"].real()), glm::normalize(axis / size));
}

Vec3d scale_of(const JsonValue& json) { return json.is_array() ? vector_of(json) : Vec3d(json.real()); }

template <class T>
void read_track(Track<T>& track, const JsonValue& channel, const char* name, T (*of)(const JsonValue&)) {
  const auto json = channel.find(name);
  if (!json) return;
  check_members(*json, name + std::string("_track"));
  if (const auto kind = json->find("interpolation")) {
    if (kind->text() != "linear" && kind->text() != "step") kind->fail("linear or step");
    track.interpolation = kind->text() == "step" ? Interpolation::step : Interpolation::linear;
  }
  const JsonValue times = (*json)["times"], values = (*json)["values"];
  if (times.size() == 0) times.fail("at least one key");
  if (times.size() != values.size())
    values.fail(std::to_string(times.size()) + " values", std::to_string(values.size()));
  for (std::size_t i = 0; i < times.size(); ++i) {
    track.times.push_back(times[i].real());
    if (i > 0 && !(track.times[i] > track.times[i - 1])) times[i].fail("a time after the one before");
    track.values.push_back(of(values[i]));
  }
}

}  // namespace

Channel SceneReader::channel_of(const JsonValue& json) const {
  check_members(json, "channel");
  Channel channel;
  channel.node = node_of(json["node"]);
  read_track(channel.translation, json, "translation", vector_of);
  read_track(channel.rotation, json, "rotation", turn_of);
  read_track(channel.scale, json, "scale", scale_of);
  return channel;
}

Animation SceneReader::animation_of(const JsonValue& json) const {
  check_members(json, "animation");
  Animation animation;
  if (const auto name = json.find("name")) animation.name = name->text();
  if (const auto loop = json.find("loop")) animation.is_loop = loop->truth();
  const JsonValue channels = json["channels"];
  for (std::size_t i = 0; i < channels.size(); ++i) animation.channels.push_back(channel_of(channels[i]));
  try {
    check(animation, scene_.graph);
  } catch (const std::invalid_argument& error) {
    json.fail("an animation that can be played", error.what());
  }
  return animation;
}

}  // namespace sightline
