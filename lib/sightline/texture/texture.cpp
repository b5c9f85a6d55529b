#include "sightline/texture/texture.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace sightline {
namespace {

template <class T>
struct Entry {
  using Type = T;
  std::string_view name, description;
};

/// A texture's one line of the registry.
constexpr std::tuple entries{
    Entry<Wood>{"wood", "rings around the y axis, moved by noise: the course's"},
    Entry<Marble>{"marble", "layers across an axis, stirred by turbulence"},
    Entry<Granite>{"granite", "grains of quartz, feldspar and mica"},
    Entry<Clouds>{"clouds", "a sky with noise over a threshold"},
    Entry<Checker>{"checker", "cubes of two colors in turn"},
};
static_assert(std::tuple_size_v<decltype(entries)> == std::variant_size_v<Texture::Any>);

template <class Visit>
void for_each_entry(const Visit& visit) {
  std::apply([&](const auto&... entry) { (visit(entry), ...); }, entries);
}

template <class O>
std::vector<TextureOptionInfo> options_of() {
  std::vector<TextureOptionInfo> infos;
  O defaults;
  for (const TextureField<O>& field : O::fields()) {
    const TextureSlot slot = field.slot(defaults);
    infos.push_back(
        {field.name, detail::value_text(slot), detail::allowed_text(slot, field.lowest, field.highest), field.help});
  }
  return infos;
}

}  // namespace

const std::vector<TextureInfo>& texture_infos() {
  static const std::vector<TextureInfo> infos = [] {
    std::vector<TextureInfo> list;
    for_each_entry([&]<class T>(const Entry<T>& entry) {
      list.push_back({entry.name, entry.description, options_of<typename T::Options>()});
    });
    return list;
  }();
  return infos;
}

Texture make_texture(const std::string& spec) {
  const std::string name = spec.substr(0, spec.find(':'));
  std::vector<Texture> made;
  std::string known;
  for_each_entry([&]<class T>(const Entry<T>& entry) {
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
    if (entry.name != name) return;
    typename T::Options options;
    for (std::size_t first = name.size() + 1; first <= spec.size();) {
      const std::size_t end = std::min(spec.find(',', first), spec.size());
      const std::string item = spec.substr(first, end - first);
      first = end + 1;
      const std::size_t equals = item.find('=');
      if (equals == std::string::npos || equals == 0) {
        throw std::invalid_argument(spec + ": expected NAME[:OPTION=VALUE,...], found '" + item + "'");
      }
      set_texture_option(name, options, item.substr(0, equals), item.substr(equals + 1));
    }
    made.emplace_back(T(options));
  });
  if (made.empty()) throw std::invalid_argument("no texture '" + name + "'; expected one of " + known);
  return made.front();
}

}  // namespace sightline
