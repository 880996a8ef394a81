/* Surfaces that fold over are noted where they are made. */
#include "design/expect.h"

static const char lines[] = "  la: {line: [[0, 0, 0], [2, 0, 0]]}\n"
                            "  lb: {line: [[2, 1, 0], [0, 1, 0]]}\n"
                            "  lc: {line: [[0, 1, 0], [2, 1, 0]]}\n"
                            "  skew: {line: [[2, 1, 0.4], [0, 1, 1.4]]}\n"
                            "  s1: {line: [[0, 0], [2, 2]]}\n"
                            "  s2: {line: [[2, 2], [2, 0]]}\n"
                            "  s3: {line: [[2, 0], [0, 2]]}\n"
                            "  s4: {line: [[0, 2], [0, 0]]}\n"
                            "  p1: {line: [[0, 0], [3, 1]]}\n"
                            "  p2: {line: [[0, 1], [3, 0]]}\n"
                            "  g1: {line: [[0, 0], [0, 1]]}\n"
                            "  g2: {line: [[3, 1], [3, 0]]}\n"
                            "  wedge: {polyline: [[0, 0, 0], [3, 0.1, 0], [0, 0.2, 0]]}\n"
                            "  wedge2: {polyline: [[0, 0, 1], [3, 0.1, 1], [0, 0.2, 1]]}\n"
                            "  ring: {circle: 1}\n";

TEST(a_surface_that_folds_over_is_noted_with_its_place)
{
    static const expect_row rows[] = {
        {"{ruled: [la, lb]}", BATTEN_OK, "notes folds over near ("},
        {"{skin: [la, lb], align: no}", BATTEN_OK, "notes folds over near ("},
        {"{coons: [s1, s2, s3, s4]}", BATTEN_OK, "notes folds over near ("},
        {"{gordon: [p1, p2], guides: [g1, g2]}", BATTEN_OK, "notes folds over near ("},
    };
    EXPECT(lines, rows);
}

TEST(what_is_bent_or_sharp_or_has_a_pole_is_no_fold)
{
    static const expect_row rows[] = {
        {"{ruled: [la, lc]}", BATTEN_OK, "silent"},
        {"{ruled: [la, skew]}", BATTEN_OK, "silent"},
        {"{ruled: [wedge, wedge2]}", BATTEN_OK, "silent"},
        {"{sphere: 1}", BATTEN_OK, "silent"},
        {"{torus: 3, minor: 1}", BATTEN_OK, "silent"},
    };
    EXPECT(lines, rows);
}

TEST(one_surface_that_folds_is_not_said_to_be_several)
{
    static const expect_row rows[] = {
        {"{ruled: [la, lb]}", BATTEN_OK,
         "notes keep their order and do not cross;lacks other surfaces fold too"},
    };
    EXPECT(lines, rows);
}
