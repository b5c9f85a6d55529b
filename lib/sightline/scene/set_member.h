#pragma once
/// Members that need not be there: what they would set is then as before.

#include "sightline/io/json_value.h"
#include "sightline/scene/scene_transform.h"

namespace sightline {

inline void set_member(double& value, const JsonValue& json, const char* name, double lowest, double highest) {
  if (const auto member = json.find(name)) value = member->real_within(lowest, highest);
}

inline void set_member(Color& value, const JsonValue& json, const char* name) {
  if (const auto member = json.find(name)) value = color_of(*member);
}

inline void set_member(bool& value, const JsonValue& json, const char* name) {
  if (const auto member = json.find(name)) value = member->truth();
}

/// Whole, from `lowest` to `highest`.
inline void set_member(std::uint32_t& value, const JsonValue& json, const char* name, std::uint32_t lowest,
                       std::uint32_t highest) {
  const auto member = json.find(name);
  if (!member) return;
  if (member->whole() < lowest || member->whole() > highest) {
    member->fail("a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
  }
  value = static_cast<std::uint32_t>(member->whole());
}

}  // namespace sightline
