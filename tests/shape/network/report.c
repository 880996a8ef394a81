/* What the report of a network says, in networks of lines where it is known. */
#include <batten/gordon.h>

#include "support/test.h"

/* Lines: from x, y, z to X, Y, Z. */
typedef struct {
    double end[6];
} line;

enum { MOST = 4 };

typedef struct {
    int count[2];
    batten_curve *curves[2][MOST];
} lines;

static void begin_lines(lines *n, int profiles, const line *first, int guides,
                        const line *second)
{
    static const double knots[] = {0, 0, 1, 1};
    *n = (lines){{profiles, guides}, {{NULL}, {NULL}}};
    for (int f = 0; f < 2; f++)
        for (int k = 0; k < n->count[f]; k++)
            CHECK_OK(
                batten_curve_create((batten_points){3, 2, f ? second[k].end : first[k].end}, 1,
                                    NULL, knots, &n->curves[f][k]));
}

static void end_lines(lines *n)
{
    for (int f = 0; f < 2; f++)
        for (int k = 0; k < n->count[f]; k++)
            batten_curve_unref(n->curves[f][k]);
}

static batten_status make(const lines *n, const batten_surface_gordon_options *options,
                          batten_surface_gordon_report *report, batten_surface **out)
{
    return batten_surface_gordon(
        (batten_curve_row){n->count[0], (const batten_curve *const *)n->curves[0]},
        (batten_curve_row){n->count[1], (const batten_curve *const *)n->curves[1]}, options,
        NULL, report, out);
}

/* A plane grid: y = 0, 10, 30 and x = 0, 20, 25. */
static const line across[] = {
    {{0, 0, 0, 25, 0, 0}}, {{0, 10, 0, 25, 10, 0}}, {{0, 30, 0, 25, 30, 0}}};
static const line along[] = {
    {{0, 0, 0, 0, 30, 0}}, {{20, 0, 0, 20, 30, 0}}, {{25, 0, 0, 25, 30, 0}}};

TEST(a_plane_grid_of_lines_is_met_exactly)
{
    lines n;
    batten_surface *surface = NULL;
    batten_surface_gordon_report r;
    batten_surface_gordon_options options = batten_surface_gordon_defaults();
    options.tolerance = 1e-3;
    begin_lines(&n, 3, across, 3, along);
    CHECK_OK(make(&n, &options, &r, &surface));
    CHECK(r.gap == 0 && r.cut == 0 && r.cut_count == 0 && r.reversed_count == 0);
    CHECK(r.repeated_count == 0 && r.seam == 0 && r.pole_count == 0);
    CHECK(!r.closed_u && !r.closed_v && !r.smooth_u && !r.smooth_v && r.exact_u && r.exact_v);
    CHECK(r.error < 1e-13 && r.node_error < 1e-13 && r.guide_error < 1e-12 && r.spread < 1e-15);
    CHECK_NEAR(r.size, sqrt(25 * 25 + 30 * 30), 1e-12);
    CHECK_NEAR(r.nearest, 5, 1e-13);
    CHECK(r.nearest_is_guide && r.nearest_curves[0] == 1 && r.nearest_curves[1] == 2);
    CHECK_INT(r.points_u, batten_surface_point_count(surface, BATTEN_U));
    CHECK_INT(r.points_v, batten_surface_point_count(surface, BATTEN_V));
    CHECK(r.exact_knots_u == 0 && r.exact_knots_v == 0);
    for (int i = 0; i <= 10; i++) {
        double p[3], q[3];
        CHECK_OK(batten_surface_evaluate(surface, i / 10.0, 0, 0, p));
        CHECK_OK(batten_surface_evaluate(surface, 1, i / 10.0, 0, q));
        CHECK(p[0] == 2.5 * i || fabs(p[0] - 2.5 * i) < 1e-13);
        CHECK(fabs(p[1]) < 1e-13 && fabs(q[0] - 25) < 1e-13 && fabs(q[1] - 3 * i) < 1e-13);
    }
    batten_surface_unref(surface);
    end_lines(&n);
}

/* Profiles given from the last on, the middle one reversed, and guides in another order: the nearest
 * neighbours are profiles 3 and 2 now. */
TEST(neighbours_and_reversed_curves_are_those_of_the_callers_list)
{
    static const line mixed[] = {
        {{0, 30, 0, 25, 30, 0}}, {{25, 3, 0, 0, 3, 0}}, {{0, 0, 0, 25, 0, 0}}};
    static const line turned[] = {{{25, 30, 0, 25, 0, 0}}, {{0, 0, 0, 0, 30, 0}}};
    lines n;
    batten_surface *surface = NULL;
    batten_surface_gordon_report r;
    batten_surface_gordon_options options = batten_surface_gordon_defaults();
    double p[3];
    options.tolerance = 1e-3;
    begin_lines(&n, 3, mixed, 2, turned);
    CHECK_OK(make(&n, &options, &r, &surface));
    CHECK_INT(r.reversed_count, 2);
    CHECK_NEAR(r.nearest, 3, 1e-13);
    CHECK(!r.nearest_is_guide && r.nearest_curves[0] + r.nearest_curves[1] == 3);
    CHECK_OK(batten_surface_evaluate(surface, 0, 0, 0, p)); /* u as profile 1, v as guide 1 */
    CHECK(fabs(p[0]) < 1e-13 && fabs(p[1] - 30) < 1e-13);
    CHECK_OK(batten_surface_evaluate(surface, 1, 1, 0, p));
    CHECK(fabs(p[0] - 25) < 1e-13 && fabs(p[1]) < 1e-13);
    batten_surface_unref(surface);
    end_lines(&n);
}

/* Profile 2 rises to 0.02 at guide 3; the node is 0.01 above. */
TEST(gaps_are_reported_with_their_curves_and_met_halfway)
{
    lines n;
    batten_surface *surface = NULL;
    batten_surface_gordon_report r;
    batten_surface_gordon_options options = batten_surface_gordon_defaults();
    line risen[3];
    double p[3];
    memcpy(risen, across, sizeof risen);
    risen[1].end[5] = 0.02;
    options.tolerance = 1e-3;
    begin_lines(&n, 3, risen, 3, along);
    CHECK_STATUS(make(&n, &options, NULL, &surface), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE(
        "profile 2 misses guide 3 by 0.02 near (25, 10, 0.02); profile 2 misses guide 2 by 0.016 near "
        "(20, 10, 0.016): more than the gap allowed, 0.001; of 9 pairs 2 are apart; a gap of 0.02 would join them");
    options.gap = 0.03;
    CHECK_OK(make(&n, &options, &r, &surface));
    CHECK_NEAR(r.gap, 0.02, 1e-7);
    CHECK(r.gap_profile == 1 && r.gap_guide == 2);
    /* Guide 3 is missed by the parabola that is 0, 0.01 and 0 at v = 0, 1/3 and 1, most so of ninths at 4/9. */
    CHECK_NEAR(r.error, 0.1 / 9, 1e-8);
    CHECK(r.worst_is_guide && r.worst == 2);
    CHECK(r.node_error < 1e-12);
    CHECK_OK(batten_surface_evaluate(surface, 1, 1.0 / 3, 0, p));
    CHECK_NEAR(p[2], 0.01, 1e-6);
    batten_surface_unref(surface);
    end_lines(&n);
}

TEST(the_longest_cut_and_its_curves_are_counted)
{
    static const line longer[] = {
        {{0, 0, 0, 25, 0, 0}}, {{-4, 10, 0, 27, 10, 0}}, {{0, 30, 0, 25, 30, 0}}};
    static const line higher[] = {{{0, -1, 0, 0, 33, 0}}, {{25, 0, 0, 25, 30, 0}}};
    lines n;
    batten_surface *surface = NULL;
    batten_surface_gordon_report r;
    batten_surface_gordon_options options = batten_surface_gordon_defaults();
    options.tolerance = 1e-3;
    begin_lines(&n, 3, longer, 2, higher);
    CHECK_OK(make(&n, &options, &r, &surface));
    CHECK_INT(r.cut_count, 2);
    CHECK_NEAR(r.cut, 4, 1e-6);
    batten_surface_unref(surface);
    surface = NULL;
    options.cut = false;
    CHECK_STATUS(make(&n, &options, &r, &surface), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("profile 2 extends 4 beyond the network");
    end_lines(&n);
}

/* What no network is, with all that is said. */
static const struct {
    int profiles, guides;
    line first[3], second[3];
    batten_status status;
    const char *says;
} refused[] = {
    {2,
     2,
     {{{0, 0, 0, 25, 0, 0}}, {{0, 9, 5, 25, 9, 5}}},
     {{{0, 0, 0, 0, 9, 0}}, {{25, 0, 0, 25, 9, 4}}},
     BATTEN_NOT_COMPATIBLE,
     "profile 2 misses guide 1 by 5 near (0, 9, 5); profile 2 misses guide 2 by 1 near (25, 9, 5): more than the gap allowed, "
     "0.001; of 4 pairs 2 are apart"},
    {2,
     3,
     {{{0, 0, 0, 9, 0, 0}}, {{0, 9, 0, 9, 9, 0}}},
     {{{0, 0, 0, 0, 9, 0}}, {{9, 0, 0, 5, 9, 0}}, {{4, 0, 0, 9, 9, 0}}},
     BATTEN_NOT_COMPATIBLE,
     "profile 2 meets guide 3 and guide 2 in another order than profile 1 does"},
    {2,
     1,
     {{{0, 0, 0, 9, 0, 0}}, {{0, 9, 0, 9, 9, 0}}},
     {{{0, 0, 0, 0, 9, 0}}},
     BATTEN_TOO_FEW_POINTS,
     "there is 1 guide; a network whose profiles are open needs 2"},
    {2,
     3,
     {{{0, 0, 0, 9, 0, 0}}, {{0, 9, 0, 9, 9, 0}}},
     {{{0, 0, 0, 0, 9, 0}}, {{9, 0, 0, 9, 9, 0}}, {{9, 0, 0, 5, 9, 0}}},
     BATTEN_COINCIDENT,
     "guide 2 and guide 3 meet profile 1 in the same point, (9, 0, 0): they are 0 apart there, and miss it by 0 and 0; elsewhere "
     "they are up to 4 apart"},
};

TEST(networks_that_are_none_are_refused_with_names_places_and_numbers)
{
    for (int i = 0; i < COUNT(refused); i++) {
        lines n;
        batten_surface *surface = NULL;
        batten_surface_gordon_options options = batten_surface_gordon_defaults();
        options.tolerance = 1e-3;
        begin_lines(&n, refused[i].profiles, refused[i].first, refused[i].guides,
                    refused[i].second);
        CHECK_STATUS(make(&n, &options, NULL, &surface), refused[i].status);
        CHECK_MESSAGE(refused[i].says);
        CHECK(!surface);
        end_lines(&n);
    }
}

/* Two lines meet in one point in which all guides end. */
TEST(a_point_in_which_all_guides_end_is_a_pole)
{
    static const line base[] = {{{0, 0, 0, 8, 0, 0}}, {{2, 6, 0, 6, 6, 0}}};
    static const line rays[] = {
        {{0, 0, 0, 4, 12, 0}}, {{4, 0, 0, 4, 12, 0}}, {{8, 0, 0, 4, 12, 0}}};
    lines n;
    batten_surface *surface = NULL;
    batten_surface_gordon_report r;
    batten_surface_gordon_options options = batten_surface_gordon_defaults();
    double p[3];
    options.tolerance = 1e-3;
    begin_lines(&n, 2, base, 3, rays);
    CHECK_OK(make(&n, &options, &r, &surface));
    CHECK_INT(r.pole_count, 1);
    CHECK_NEAR(r.nearest, 2, 1e-12);
    CHECK(r.nearest_is_guide);
    for (int i = 0; i <= 4; i++) {
        CHECK_OK(batten_surface_evaluate(surface, i / 4.0, 1, 0, p));
        CHECK(fabs(p[0] - 4) < 1e-12 && fabs(p[1] - 12) < 1e-12);
    }
    batten_surface_unref(surface);
    end_lines(&n);
}
