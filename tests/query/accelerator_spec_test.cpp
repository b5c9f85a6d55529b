#include "sightline/query/accelerator_spec.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sightline {
namespace {

/// "accelerator name=value name=value", in the order in which the options apply.
std::string shown(const AcceleratorSpec& spec) {
  std::string text = spec.accelerator;
  for (const TracerSettings::Option& option : spec.settings.options) text += ' ' + option.name + '=' + option.value;
  return text;
}

std::string shown(const std::vector<AcceleratorSpec>& specs) {
  std::string text;
  for (const AcceleratorSpec& spec : specs) text += (text.empty() ? "" : " | ") + shown(spec);
  return text;
}

std::string labels(const std::vector<AcceleratorSpec>& specs) {
  std::string text;
  for (const AcceleratorSpec& spec : specs) text += (text.empty() ? "" : " | ") + spec.label;
  return text;
}

std::string refusal(const auto& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(AcceleratorSpec, NamesAStructureWithItsOptions) {
  EXPECT_EQ(shown(parse_accelerators("kd-tree")), "kd-tree");
  EXPECT_EQ(shown(parse_accelerators("kd-tree:a=1")), "kd-tree a=1");
  EXPECT_EQ(shown(parse_accelerators("kd-tree:a=1,b=0.5,c=")), "kd-tree a=1 b=0.5 c=");
}

TEST(AcceleratorSpec, ListsSeveral) {
  const auto specs = parse_accelerators("grid,kd-tree:a=1,b=2,bih,kd-tree:c=3");
  EXPECT_EQ(shown(specs), "grid | kd-tree a=1 b=2 | bih | kd-tree c=3");
  EXPECT_EQ(labels(specs), "grid | kd-tree:a=1,b=2 | bih | kd-tree:c=3");
}

TEST(AcceleratorSpec, RefusesOtherForms) {
  for (const char* text : {"", ",", "kd-tree,", ",kd-tree", ":a=1", "a=1", "kd-tree,a=1", "kd-tree:", "kd-tree:a",
                           "kd-tree:=1", "kd-tree:a=1,=2", "kd-tree:a=1,,bih"}) {
    const std::string message = refusal([&] { parse_accelerators(text); });
    EXPECT_NE(message.find("expected NAME[:OPTION=VALUE,...]"), std::string::npos) << text << ": " << message;
  }
}

TEST(AcceleratorSpec, SettingsComeBeforeWhatTheEntrySaysAndTheLastOneWins) {
  auto specs = parse_accelerators("kd-tree,bih,kd-tree:a=1");
  apply_settings(specs, std::vector<std::string>{"kd-tree.a=2", "kd-tree.a=3.5"});
  EXPECT_EQ(shown(specs), "kd-tree a=2 a=3.5 | bih | kd-tree a=2 a=3.5 a=1");
  EXPECT_EQ(labels(specs), "kd-tree | bih | kd-tree:a=1");
}

TEST(AcceleratorSpec, RefusesSettingsOfOtherForms) {
  for (const char* text : {"", "a=1", "a=1.5", ".a=1", "kd-tree.a", "kd-tree.=1", "kd-tree", "bih.a=1"}) {
    auto specs = parse_accelerators("kd-tree");
    const std::string message = refusal([&] { apply_settings(specs, std::vector<std::string>{text}); });
    EXPECT_EQ(message.find("--set " + std::string(text) + ": "), 0u) << text << ": " << message;
    EXPECT_EQ(shown(specs), "kd-tree") << text;
  }
}

TEST(AcceleratorSpec, ChecksNamesAndValues) {
  for (const AcceleratorInfo& info : accelerator_infos()) {
    AcceleratorSpec spec = parse_accelerators(std::string(info.name)).front();
    for (const auto& option : info.options) {
      spec.settings.options.push_back({std::string(option.name), option.default_value});
    }
    EXPECT_NO_THROW(check_accelerator(spec)) << info.name;
  }
  for (const char* text : {"no-such-tree", "kd-tree:no_such_option=1", "kd-tree:max_leaf_size=none"}) {
    EXPECT_NE(refusal([&] { check_accelerator(parse_accelerators(text).front()); }), "") << text;
  }
}

}  // namespace
}  // namespace sightline
