#include "viz/pages/page_words.h"

#include <algorithm>

#include "viz/command_text.h"

namespace sightline::viz {
namespace {

void remove(std::vector<std::string>& words, const std::string& option) {
  for (auto at = words.begin(); at != words.end();) {
    if (*at == option) {
      at = words.erase(at, at + std::min<std::ptrdiff_t>(2, words.end() - at));
    } else if (at->starts_with(option + '=')) {
      at = words.erase(at);
    } else {
      ++at;
    }
  }
}

/// In one word, since values may begin with a sign.
void set(std::vector<std::string>& words, const std::string& option, const std::string& value) {
  remove(words, option);
  words.push_back(option + '=' + value);
}

/// Of one structure; those of others would be refused.
std::vector<std::string> settings_of(const PageState& state) {
  std::vector<std::string> settings;
  const std::string name = state.accelerator.substr(0, state.accelerator.find(':'));
  for (const std::string& setting : state.settings) {
    if (setting.starts_with(name + '.')) settings.push_back(setting);
  }
  return settings;
}

}  // namespace

std::optional<std::size_t> page_named(std::string_view name) {
  const auto page = std::ranges::find(page_infos, name, &PageInfo::name);
  return page == page_infos.end() ? std::nullopt : std::optional<std::size_t>(page - page_infos.begin());
}

std::optional<std::string> value_in(const std::vector<std::string>& words, const std::string& option) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].starts_with(option + '=')) return words[i].substr(option.size() + 1);
    if (words[i] == option && i + 1 < words.size()) return words[i + 1];
  }
  return std::nullopt;
}

std::vector<std::string> page_words(const PageInfo& page, const PageState& state, const std::string& size,
                                    const std::vector<std::string>& former) {
  std::vector<std::string> words{std::string(page.name)};
  const bool has_ray = page.has_ray && state.ray;
  const bool is_same = !former.empty() && (!page.has_structure || value_in(former, "--accel") == state.accelerator) &&
                       (!page.has_scene || value_in(former, "--scene") == state.scene) &&
                       (!has_ray || value_in(former, "--ray") == state.ray);
  if (is_same) {
    words = former;
  } else {
    if (page.has_structure) set(words, "--accel", state.accelerator);
    if (page.has_scene) set(words, "--scene", state.scene);
    if (page.has_structure) {
      for (const std::string& setting : settings_of(state)) words.push_back("--set=" + setting);
    }
    for (const char* kept : {"--show", "--count"}) {
      if (const auto value = value_in(former, kept)) set(words, kept, *value);
    }
  }
  if (page.has_scene && state.threads != 0) set(words, "--threads", std::to_string(state.threads));
  if (has_ray) set(words, "--ray", *state.ray);
  if (page.has_ray && state.pick) set(words, "--pick", *state.pick);
  const auto set_number = [&](bool has, const char* option, const std::optional<double>& number) {
    if (has && number) set(words, option, shortest(*number));
  };
  set_number(page.has_camera, "--azimuth", state.azimuth);
  set_number(page.has_camera, "--elevation", state.elevation);
  set_number(page.has_zoom, "--zoom", state.zoom);
  if (!size.empty()) set(words, "--size", size);
  return words;
}

}  // namespace sightline::viz
