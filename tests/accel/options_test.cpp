#include "sightline/accel/options.h"

#include <gtest/gtest.h>

#include <limits>

namespace sightline {
namespace {

struct SampleOptions {
  int leaf_size = 4;
  float cost = 1.5f;
  bool lazy = false;
  Quality quality = Quality::balanced;

  static constexpr std::array<OptionField<SampleOptions>, 4> fields() {
    return {{{"leaf_size", &SampleOptions::leaf_size, 1, 64, "size"},
             {"cost", &SampleOptions::cost, 0, 100, "cost"},
             {"lazy", &SampleOptions::lazy, 0, 1, "lazy"},
             {"quality", &SampleOptions::quality, 0, 2, "quality"}}};
  }
};

std::string message_of(std::string_view name, std::string_view value) {
  SampleOptions options;
  try {
    set_option("sample", options, name, value);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Options, AreSetFromText) {
  SampleOptions options;
  set_option("sample", options, "leaf_size", "8");
  set_option("sample", options, "cost", "0.25");
  set_option("sample", options, "lazy", "true");
  set_option("sample", options, "quality", "best");
  EXPECT_EQ(options.leaf_size, 8);
  EXPECT_EQ(options.quality, Quality::best);
  EXPECT_EQ(options.cost, 0.25f);
  EXPECT_TRUE(options.lazy);
}

TEST(Options, AreRefusedWithStructureFieldValueAndLimits) {
  EXPECT_EQ(message_of("leaf_size", "0"), "sample: leaf_size = 0 is not allowed; expected a whole number from 1 to 64");
  EXPECT_EQ(message_of("leaf_size", "4x"),
            "sample: leaf_size = 4x is not allowed; expected a whole number from 1 to 64");
  EXPECT_EQ(message_of("leaf_size", ""), "sample: leaf_size =  is not allowed; expected a whole number from 1 to 64");
  EXPECT_EQ(message_of("leaf_size", "99999999999"),
            "sample: leaf_size = 99999999999 is not allowed; expected a whole number from 1 to 64");
  EXPECT_EQ(message_of("cost", "nan"), "sample: cost = nan is not allowed; expected a number from 0 to 100");
  EXPECT_EQ(message_of("lazy", "yes"), "sample: lazy = yes is not allowed; expected true or false");
  EXPECT_EQ(message_of("size", "1"), "sample: no option 'size'; expected one of leaf_size, cost, lazy, quality");
  EXPECT_EQ(message_of("quality", "good"), "sample: quality = good is not allowed; expected fast, balanced or best");
  EXPECT_EQ(message_of("quality", "1"), "sample: quality = 1 is not allowed; expected fast, balanced or best");
}

TEST(Options, LeaveTheStructAloneWhenRefused) {
  SampleOptions options;
  EXPECT_THROW(set_option("sample", options, "cost", "1e9"), std::invalid_argument);
  EXPECT_EQ(options.cost, 1.5f);
}

}  // namespace
}  // namespace sightline
