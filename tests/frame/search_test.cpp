// What a person means by a few words in the search box.
#include "app/frame/search.h"

#include <gtest/gtest.h>

#include "tests/frame/small_frame.h"

namespace gridscope {
namespace {

SearchTarget found(const std::string& words) {
  const SmallFrame small;
  return findTarget(small.frame, words).value_or(SearchTarget{});
}

TEST(Search, TwoNumbersAreAPixelAndThreeACell) {
  EXPECT_EQ(found("pixel 3,1").pixel, 7u);
  EXPECT_EQ(found("3, 1").pixel, 7u);
  EXPECT_EQ(found("Cell 1,1,0").cell, ivec3(1, 1, 0));
  EXPECT_EQ(found("(1, 1, 0)").cell, ivec3(1, 1, 0));
  EXPECT_FALSE(found("4,0").pixel) << "the frame is 4 wide";
  EXPECT_FALSE(found("cell 99,0,0").cell);
}

TEST(Search, AReferenceAMeshWithANumberAndANameAreFound) {
  EXPECT_EQ(found("0x00000002").reference, makeReference(0, 2));
  EXPECT_FALSE(found("0x00000003").reference) << "the floor has 3 triangles";
  EXPECT_EQ(found("post 0").reference, makeReference(1, 0));
  EXPECT_EQ(found("triangle floor 2").reference, makeReference(0, 2));
  EXPECT_EQ(found("instance the POST").instance, 1u);
  EXPECT_EQ(found("floor").instance, 0u);
  const SmallFrame small;
  EXPECT_FALSE(findTarget(small.frame, "nothing like it"));
  EXPECT_FALSE(findTarget(small.frame, "  "));
}

}  // namespace
}  // namespace gridscope
