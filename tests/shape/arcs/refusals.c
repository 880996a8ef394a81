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

/* ---- data of biarcs, arcs and conics ---- */

static const double square[] = {0, 0, 1, 0, 1, 1, 0, 1};

static void refuse_biarcs(const double *at, const batten_chain_biarcs_options *options,
                          batten_status status, const char *words)
{
    batten_chain *chain = (void *)&place, *const left = chain;
    CHECK_STATUS(batten_chain_biarcs((batten_points){2, 4, at}, options, NULL, NULL, &chain),
                 status);
    CHECK_TEXT(batten_message(), words);
    CHECK(chain == left);
}

TEST(biarcs_name_the_points_and_directions_that_are_wrong)
{
    static const double far[] = {0, 0, 1, 0, -1.7e308, 0, 1.7e308, 0};
    static const double closed[] = {0, 0, 1, 0, 1, 1, 0, 0};
    static const double odd[] = {1, 0, 0, NAN, 1, 0, 1, 0}, zero[] = {1, 0, 0, 1, 0, 0, 1, 0};
    batten_chain_biarcs_options options = batten_chain_biarcs_defaults();
    refuse_biarcs(far, &options, BATTEN_OVERFLOW,
                  "points 3 and 4 are too far apart for a number");
    options.closed = true;
    refuse_biarcs(closed, &options, BATTEN_COINCIDENT, "points 4 and 1 coincide");
    options.closed = false;
    options.directions = odd;
    refuse_biarcs(square, &options, BATTEN_NOT_FINITE,
                  "direction 2 has a coordinate that is not a finite number");
    options.directions = zero;
    refuse_biarcs(square, &options, BATTEN_BAD_ARGUMENT, "direction 3 is zero");
    options.directions = NULL;
    options.joint = BATTEN_JOINT_GIVEN;
    for (options.place = 0; options.place <= 1; options.place++)
        refuse_biarcs(square, &options, BATTEN_BAD_ARGUMENT,
                      options.place == 0
                          ? "the place of the joints is 0; it must be between 0 and 1"
                          : "the place of the joints is 1; it must be between 0 and 1");
}

TEST(sequential_arcs_name_the_points_that_are_wrong)
{
    static const double far[] = {0, 0, -1.7e308, 0, 1.7e308, 0}, same[] = {0, 0, 1, 0, 1, 0};
    batten_chain *chain = NULL;
    CHECK_STATUS(
        batten_chain_sequential_arcs((batten_points){2, 3, far}, 0, NULL, NULL, NULL, &chain),
        BATTEN_OVERFLOW);
    CHECK_TEXT(batten_message(), "points 2 and 3 are too far apart");
    CHECK_STATUS(
        batten_chain_sequential_arcs((batten_points){2, 3, same}, 0, NULL, NULL, NULL, &chain),
        BATTEN_COINCIDENT);
    CHECK_TEXT(batten_message(), "points 2 and 3 coincide");
    CHECK(chain == NULL);
}

/* On the chord itself the joint divides it; beside it, by the areas that it spans with the ends. */
TEST(the_place_of_a_joint_on_the_chord_is_its_share)
{
    double found = 0;
    CHECK_OK(batten_biarc_place((batten_vec2){0, 0}, (batten_vec2){4, 0}, (batten_vec2){1, 0},
                                &found));
    CHECK_NEAR(found, 0.25, 1e-15);
    CHECK_STATUS(batten_biarc_place((batten_vec2){0, 0}, (batten_vec2){4, 0},
                                    (batten_vec2){0, 0}, &found),
                 BATTEN_NOT_FOUND);
    CHECK_MESSAGE("the point (0, 0) does not lie between the ends of the biarc");
    CHECK_NEAR(found, 0.25, 1e-15);
}

/* Each span of the row bends to one side: its conic has the weight that is given. */
TEST(single_conics_have_the_weight_that_is_given)
{
    static const double weights[] = {0.5, 1, 2};
    const double row[] = {0, 0, 1, 0.5, 2, 1.5, 3, 3};
    for (int i = 0; i < COUNT(weights); i++) {
        batten_curve_conics_options options = batten_curve_conics_defaults();
        batten_curve_conics_report report;
        batten_curve *curve = NULL;
        options.kind = BATTEN_CONICS_SINGLE;
        options.weight = weights[i];
        CHECK_OK(
            batten_curve_conics((batten_points){2, 4, row}, &options, NULL, &report, &curve));
        CHECK_NEAR(report.least_weight, weights[i], 1e-15);
        CHECK_NEAR(report.largest_weight, weights[i], 1e-15);
        CHECK_INT(report.inflections + report.arcs + report.fallen_back, 0);
        batten_curve_unref(curve);
    }
}
