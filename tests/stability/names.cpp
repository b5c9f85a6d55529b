#include "tests/stability/names.h"

#include <fnmatch.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "sightline/query/tracer.h"

namespace sightline::stability {
namespace {

std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), now(b.size() + 1);
  std::iota(before.begin(), before.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({before[j - 1] + (a[i - 1] != b[j - 1]), before[j] + 1, now[j - 1] + 1});
    }
    std::swap(before, now);
  }
  return before[b.size()];
}

[[noreturn]] void refuse(std::string_view kind, const std::string& name, std::span<const std::string_view> known) {
  std::string near;
  for (const std::string_view each : nearest(name, known)) near += (near.empty() ? "" : ", ") + std::string(each);
  throw std::invalid_argument("unknown " + std::string(kind) + " '" + name + "'; near are " + near +
                              (kind == "case" || kind == "group" ? " (--list names all)" : ""));
}

void check(std::string_view kind, const std::string& name, std::span<const std::string_view> known) {
  if (std::ranges::find(known, name) == known.end()) refuse(kind, name, known);
}

bool is_pattern(const std::string& name) { return name.find_first_of("*?[") != std::string::npos; }

}  // namespace

std::vector<std::string> split_at_commas(std::span<const std::string> lists) {
  std::vector<std::string> names;
  for (const std::string& list : lists) {
    std::size_t start = 0;
    for (std::size_t end = list.find(','); end != std::string::npos; end = list.find(',', start)) {
      names.push_back(list.substr(start, end - start));
      start = end + 1;
    }
    names.push_back(list.substr(start));
  }
  return names;
}

std::vector<std::string_view> nearest(std::string_view name, std::span<const std::string_view> known,
                                      std::size_t count) {
  std::vector<std::string_view> sorted(known.begin(), known.end());
  std::ranges::stable_sort(sorted, {}, [&](std::string_view each) {
    return !name.empty() && each.starts_with(name) ? 0 : distance(name, each);
  });
  sorted.resize(std::min(sorted.size(), count));
  return sorted;
}

std::vector<std::string_view> groups_of(std::span<const HardCase> cases) {
  std::vector<std::string_view> groups;
  for (const HardCase& one : cases) {
    if (std::ranges::find(groups, one.group) == groups.end()) groups.push_back(one.group);
  }
  return groups;
}

std::vector<const HardCase*> select(std::span<const HardCase> cases, std::span<const std::string> ids,
                                    std::span<const std::string> groups) {
  std::vector<std::string_view> known;
  for (const HardCase& one : cases) known.push_back(one.id);
  for (const std::string& group : groups) check("group", group, groups_of(cases));
  for (const std::string& id : ids) {
    const auto matches = [&](std::string_view each) { return fnmatch(id.c_str(), std::string(each).c_str(), 0) == 0; };
    if (!is_pattern(id)) {
      check("case", id, known);
    } else if (std::ranges::none_of(known, matches)) {
      refuse("case", id, known);
    }
  }
  std::vector<const HardCase*> selected;
  for (const HardCase& one : cases) {
    const bool is_asked = ids.empty() || std::ranges::any_of(ids, [&](const std::string& id) {
                            return fnmatch(id.c_str(), std::string(one.id).c_str(), 0) == 0;
                          });
    const bool is_of_group = groups.empty() || std::ranges::find(groups, one.group) != groups.end();
    if (is_asked && is_of_group) selected.push_back(&one);
  }
  return selected;
}

Level level_named(const std::string& name) {
  std::vector<std::string_view> known;
  for (const LevelInfo& info : level_infos) {
    if (info.name == name) return info.level;
    known.push_back(info.name);
  }
  refuse("level", name, known);
}

void check_structures(std::span<const std::string> names) {
  std::vector<std::string_view> known;
  for (const AcceleratorInfo& info : accelerator_infos()) known.push_back(info.name);
  for (const std::string& name : names) check("structure", name, known);
}

}  // namespace sightline::stability
