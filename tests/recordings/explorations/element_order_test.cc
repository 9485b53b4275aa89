#include "recordings/explorations/element_order.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace somato {
namespace {

using Names = std::vector<std::string>;
using Values = std::vector<double>;

// The values of a frame with these names, in the order of the elements; empty if it is left out.
Result<Values> placed(ElementOrder& order, const Names& names, Values values) {
  std::string key;
  for (const std::string& name : names) key += name + '\0';
  if (!order.is_known(key)) {
    const Result<void> learnt = order.learn(key, names);
    if (!learnt) return fail(learnt.error());
  }
  EXPECT_TRUE(order.is_known(key));
  const bool has_all = order.place(values);
  EXPECT_EQ(has_all, !values.empty());
  return values;
}

TEST(ElementOrder, APermutationIsPutIntoTheOrderOfTheFirstFrame) {
  ElementOrder order;
  EXPECT_EQ(placed(order, {"a", "b", "c"}, {1, 2, 3}).value(), (Values{1, 2, 3}));
  EXPECT_EQ(placed(order, {"c", "a", "b"}, {3, 1, 2}).value(), (Values{1, 2, 3}));
  EXPECT_EQ(placed(order, {"a", "b", "c"}, {4, 5, 6}).value(), (Values{4, 5, 6}));
  EXPECT_EQ(order.names(), (Names{"a", "b", "c"}));
}

TEST(ElementOrder, OtherNamesAreRefusedWithBothLists) {
  for (const Names& names :
       {Names{"a", "b"}, Names{"a", "b", "d"}, Names{"a", "b", "c", "d"}, Names{}}) {
    ElementOrder order;
    (void)placed(order, {"a", "b", "c"}, {1, 2, 3});
    const auto refused = placed(order, names, Values(names.size()));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().what.find("those of the first frame are 'a', 'b', 'c'"),
              std::string::npos)
        << refused.error().what;
  }
}

TEST(ElementOrder, LongListsAreCutAndTheirDifferenceIsNamed) {
  Names first;
  for (int i = 0; i < 20; ++i) first.push_back("joint_" + std::to_string(i));
  Names other = first;
  other[17] = "gripper";
  ElementOrder order;
  (void)placed(order, first, Values(20));
  const std::string what = placed(order, other, Values(20)).error().what;
  EXPECT_NE(what.find("and 12 others"), std::string::npos) << what;
  EXPECT_NE(what.find("it has also 'gripper'; it lacks 'joint_17'"), std::string::npos) << what;
}

TEST(ElementOrder, SelectedElementsAreKeptAndFramesWithoutThemLeftOut) {
  ElementOrder order({"c", "a"});
  EXPECT_EQ(placed(order, {"x"}, {9}).value(), Values{});
  EXPECT_EQ(placed(order, {"a", "b", "c"}, {1, 2, 3}).value(), (Values{3, 1}));
  EXPECT_EQ(placed(order, {"a", "b"}, {1, 2}).value(), Values{});
  EXPECT_EQ(placed(order, {"c", "a"}, {3, 1}).value(), (Values{3, 1}));
  EXPECT_EQ(order.names(), (Names{"c", "a"}));
}

TEST(ElementOrder, ANameThatIsNotUniqueIdentifiesNoElement) {
  ElementOrder selected({"a"});
  EXPECT_FALSE(placed(selected, {"a", "a"}, {1, 2}));
  ElementOrder order;
  EXPECT_EQ(placed(order, {"a", "a"}, {1, 2}).value(), (Values{1, 2}));
  EXPECT_EQ(placed(order, {"a", "a"}, {3, 4}).value(), (Values{3, 4}));
  EXPECT_FALSE(placed(order, {"a", "b"}, {1, 2}));
}

}  // namespace
}  // namespace somato
