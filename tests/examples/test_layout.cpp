// The judge of layouts finds what it should.
#include <doctest/doctest.h>

#include "layout.hpp"

using namespace kreda::tests;

TEST_CASE("layout: a text that leaves its picture or lies over another one or is too small is found") {
    const PlacedText good{"a", 640, 360, 10, 10, 60, 30, 16, "good"};
    PlacedText outside = good, over = good, small = good, elsewhere = good, beside = good;
    outside.right = 641;
    over.left = 59;
    over.right = 90;
    small.size = 11.9f;
    elsewhere.picture = "b";
    beside.left = 60;
    beside.right = 90;
    CHECK(layout_faults({good}).empty());
    CHECK(layout_faults({good, elsewhere}).empty());
    CHECK(layout_faults({good, beside}).empty());
    CHECK(layout_faults({outside}).size() == 1);
    CHECK(layout_faults({good, over}).size() == 1);
    CHECK(layout_faults({small}).size() == 1);
}
