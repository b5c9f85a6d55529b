#include "sightline/query/structure_plugin.h"

#include <dlfcn.h>

#include <map>
#include <stdexcept>

namespace sightline {
namespace {

struct Loaded {
  std::map<std::filesystem::path, std::string> names;
  std::map<std::string, const StructurePlugin*, std::less<>> plugins;
};

Loaded& loaded() {
  static Loaded all;
  return all;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& expected, const std::string& found) {
  throw std::runtime_error(file.string() + ": expected " + expected + ", found " + found);
}

/// What the loader says of a failure is "FILE: why".
std::string reason(const std::filesystem::path& file) {
  const char* const said = ::dlerror();
  const std::string text = said == nullptr ? "" : said, begin = file.string() + ": ";
  return text.starts_with(begin) ? text.substr(begin.size()) : text;
}

}  // namespace

std::string load_structure(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) refuse(file, "a structure that was compiled apart", "no such file");
  const auto path = std::filesystem::canonical(file);
  if (const auto found = loaded().names.find(path); found != loaded().names.end()) return found->second;
  void* const object = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);  // never closed: names refer into it
  if (object == nullptr) refuse(file, "a structure that was compiled apart", reason(path));
  const void* const symbol = ::dlsym(object, "sightline_structure");
  if (symbol == nullptr) refuse(file, "the symbol sightline_structure", "none");
  const auto& plugin = *static_cast<const StructurePlugin*>(symbol);
  if (plugin.build() != plugin_build()) refuse(file, "made by " + plugin_build(), plugin.build());
  const AcceleratorInfo info = plugin.info();
  for (const AcceleratorInfo& known : accelerator_infos()) {
    if (known.name == info.name) {
      throw std::invalid_argument(file.string() + ": the name '" + std::string(info.name) +
                                  "' is taken; choose another for your structure");
    }
  }
  detail::add_info(info);
  loaded().plugins.emplace(info.name, &plugin);
  return loaded().names.emplace(path, info.name).first->second;
}

const StructurePlugin* detail::loaded_structure(std::string_view name) {
  const auto found = loaded().plugins.find(name);
  return found == loaded().plugins.end() ? nullptr : found->second;
}

}  // namespace sightline
