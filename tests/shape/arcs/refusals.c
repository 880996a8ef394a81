#include "support/test.h"

#include <batten/arcs.h>
#include <batten/standard.h>
#include <math.h>

/* What methods of arcs refuse by name; what was there stays. */

static char place; /* any address */
static const double points[] = {0, 0, 0, 1, 1, 0, 2, 0, 1, 3, 1, 0};

TEST(arcs_refuse_points_that_are_not_of_the_plane)
{
    static const char words[] = "the points have 3 coordinates, 2 are expected";
    const batten_points space = {3, 4, points};
    const batten_arcs_options options = batten_arcs_defaults();
    batten_chain *chain = (void *)&place, *const left = chain;
    batten_curve *curve = (void *)&place, *const kept = curve;
    CHECK_STATUS(batten_chain_biarcs(space, NULL, NULL, NULL, &chain), BATTEN_UNSUPPORTED);
    CHECK_TEXT(batten_message(), words);
    CHECK_STATUS(batten_chain_sequential_arcs(space, 0, NULL, NULL, NULL, &chain),
                 BATTEN_UNSUPPORTED);
    CHECK_TEXT(batten_message(), words);
    CHECK_STATUS(batten_arcs_from_points(space, &options, NULL, NULL, &chain),
                 BATTEN_UNSUPPORTED);
    CHECK_TEXT(batten_message(), words);
    CHECK_STATUS(batten_curve_conics(space, NULL, NULL, NULL, &curve), BATTEN_UNSUPPORTED);
    CHECK_TEXT(batten_message(), words);
    CHECK_STATUS(batten_curve_biarcs((batten_points){1, 4, points}, NULL, NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK_TEXT(batten_message(), "biarcs of 1 dimensions; there are 2 and 3");
    CHECK(chain == left && curve == kept);
}

TEST(merging_needs_a_tolerance_and_arcs_of_the_plane)
{
    static const double bad[] = {-1, NAN, INFINITY};
    const batten_points plane = {2, 6, points};
    batten_chain *chain = NULL, *merged = NULL;
    CHECK_OK(batten_chain_biarcs(plane, NULL, NULL, NULL, &chain));
    for (int i = 0; i < 3; i++) {
        CHECK_STATUS(batten_chain_merge_arcs(chain, bad[i], &merged), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("the tolerance is ");
        CHECK(merged == NULL);
    }
    CHECK_OK(batten_chain_merge_arcs(chain, 0, &merged));
    batten_chain_unref(merged);
    batten_chain_unref(chain);
}

/* A function is no chain of arcs, whatever its graph. */
TEST(a_curve_of_one_dimension_is_no_exact_chain)
{
    const double heights[] = {1, 2}, knots[] = {0, 0, 1, 1};
    batten_curve *line = NULL;
    batten_chain *chain = (void *)&place;
    CHECK_OK(batten_curve_create((batten_points){1, 2, heights}, 1, NULL, knots, &line));
    CHECK_OK(batten_arcs_from_curve_exact(line, &chain));
    CHECK(chain == NULL);
    batten_curve_unref(line);
}

/* No span needs arcs, none falls back: there is no first one. */
TEST(conics_without_arcs_have_no_first_arc)
{
    const double row[] = {0, 0, 1, 0.5, 2, 1.5, 3, 3};
    batten_curve_conics_report report;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_conics((batten_points){2, 4, row}, NULL, NULL, &report, &curve));
    CHECK_INT(report.first_arcs, -1);
    CHECK_INT(report.first_fallen_back, -1);
    batten_curve_unref(curve);
}
