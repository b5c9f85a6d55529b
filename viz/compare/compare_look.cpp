#include "viz/compare/compare_look.h"

#include "viz/command_text.h"

namespace sightline::viz {
std::string_view name_of(CompareKind kind) {
  constexpr std::string_view names[] = {"walk", "work", "difference", "histogram"};
  return names[static_cast<std::size_t>(kind)];
}

bool operator==(const CompareLook& a, const CompareLook& b) {
  return a.kind == b.kind && a.work == b.work && a.against == b.against && a.alone == b.alone &&
         a.azimuth == b.azimuth && a.elevation == b.elevation && a.zoom == b.zoom && a.ray.origin == b.ray.origin &&
         a.ray.direction == b.ray.direction;
}

std::string command_line(const CompareSource& source, const CompareLook& look, int width, int height) {
  const CompareLook usual;
  std::string text = "sightline-view " + source.name;
  const auto add = [&](const std::string& option, const std::string& value) { text += option_text(option, value); };
  for (const std::string& word : source.common) text += ' ' + quoted(word);
  add("--accel", source.accelerators);
  for (const std::string& setting : source.settings) add("--set", setting);
  add("--scene", source.scene);
  if (source.name == CompareSource{}.name) add("--show", std::string(name_of(look.kind)));
  if (look.work != usual.work) add("--count", std::string(name_of(look.work)));
  if (look.against != usual.against) add("--against", source.labels[look.against]);
  if (look.alone) add("--alone", std::to_string(*look.alone + 1));
  add("--ray", text_of(look.ray));
  return text + camera_text(look.azimuth, look.elevation, look.zoom) + size_text(width, height);
}

}  // namespace sightline::viz
