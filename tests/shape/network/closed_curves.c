/* Which curves of a network close, and which are slit. */
#include <batten/gordon.h>

#include "support/faults.h"
#include "support/test.h"

enum { GUIDES = 4 };

typedef struct {
    int guides;
    batten_curve *profiles[2], *along[GUIDES];
} tower;

/* Two squares of side 4, at z = 0 and z = 10, whose ends are apart by `slit`; guides straight up from their
 * first corners, and where there is a fourth one from their other end. */
static void begin_tower(tower *t, double slit, int guides)
{
    static const double corners[] = {0, 0, 0.25, 0.5, 0.75, 1, 1}, ends[] = {0, 0, 1, 1};
    *t = (tower){.guides = guides};
    for (int k = 0; k < 2; k++) {
        const double z = 10 * k;
        const double points[] = {0, 0, z, 4, 0, z, 4, 4, z, 0, 4, z, 0, slit, z};
        CHECK_OK(batten_curve_create((batten_points){3, 5, points}, 1, NULL, corners,
                                     &t->profiles[k]));
    }
    for (int i = 0; i < guides; i++) {
        const double x = i == 1 || i == 2 ? 4 : 0, y = i == 2 ? 4 : i == 3 ? slit : 0;
        const double points[] = {x, y, 0, x, y, 10};
        CHECK_OK(
            batten_curve_create((batten_points){3, 2, points}, 1, NULL, ends, &t->along[i]));
    }
}

static void end_tower(tower *t)
{
    for (int k = 0; k < 2; k++)
        batten_curve_unref(t->profiles[k]);
    for (int i = 0; i < t->guides; i++)
        batten_curve_unref(t->along[i]);
}

static batten_status make(const tower *t, double gap, batten_surface_gordon_report *report,
                          batten_surface **out)
{
    batten_surface_gordon_options options = batten_surface_gordon_defaults();
    options.tolerance = 1e-3;
    options.gap = gap;
    return batten_surface_gordon(
        (batten_curve_row){2, (const batten_curve *const *)t->profiles},
        (batten_curve_row){t->guides, (const batten_curve *const *)t->along}, &options, NULL,
        report, out);
}

static const struct {
    double slit, gap;
    int guides, repeated;
    bool closed;
    double seam;
} rows[] = {
    {0, 0, 3, 0, true, 0},          /* closed */
    {0, 0, 4, 1, true, 0},          /* and the guide at the seam given twice */
    {0.01, 0.05, 3, 0, true, 0.01}, /* closed within the gap */
    {0.04, 0.05, 4, 0, false, 0},   /* a guide at each end: a slit */
};

TEST(curves_close_within_the_gap_unless_two_others_begin_at_their_ends)
{
    for (int i = 0; i < COUNT(rows); i++) {
        tower t;
        batten_surface *surface = NULL;
        batten_surface_gordon_report report;
        begin_tower(&t, rows[i].slit, rows[i].guides);
        CHECK_OK(make(&t, rows[i].gap, &report, &surface));
        CHECK(report.closed_u == rows[i].closed && !report.closed_v && !report.smooth_u);
        CHECK_NEAR(report.seam, rows[i].seam, 1e-12);
        CHECK(!report.seam_is_guide);
        CHECK_INT(report.repeated_count, rows[i].repeated);
        if (rows[i].repeated) {
            CHECK(report.repeated[0].is_guide && report.repeated[0].used == 0);
            CHECK(report.repeated[0].left == 3 && report.repeated[0].apart < 1e-12);
        }
        CHECK_NEAR(report.nearest, rows[i].closed ? 4 : rows[i].slit, 1e-9);
        batten_surface_unref(surface);
        end_tower(&t);
    }
}

/* The lower square is open by 0.01, the upper one by 0.02; as profiles and as guides. */
TEST(the_widest_seam_is_reported_with_its_curve_in_either_family)
{
    tower narrow, wide;
    batten_surface_gordon_options options = batten_surface_gordon_defaults();
    options.tolerance = 1e-3;
    options.gap = 0.05;
    begin_tower(&narrow, 0.01, 3);
    begin_tower(&wide, 0.02, 3);
    const batten_curve *const squares[2] = {narrow.profiles[0], wide.profiles[1]};
    const batten_curve_row rings = {2, squares},
                           posts = {3, (const batten_curve *const *)narrow.along};
    for (int guides = 0; guides < 2; guides++) {
        batten_surface *surface = NULL;
        batten_surface_gordon_report report;
        CHECK_OK(batten_surface_gordon(guides ? posts : rings, guides ? rings : posts, &options,
                                       NULL, &report, &surface));
        CHECK(report.closed_u == !guides && report.closed_v == guides);
        CHECK_NEAR(report.seam, 0.02, 1e-12);
        CHECK_INT(report.seam_is_guide, guides);
        CHECK_INT(report.seam_curve, 1);
        batten_surface_unref(surface);
    }
    end_tower(&narrow);
    end_tower(&wide);
}

TEST(networks_that_close_report_every_lack_of_memory)
{
    tower t;
    batten_surface *surface = NULL;
    begin_tower(&t, 0.04, 4);
    CHECK_EACH_ALLOCATION(make(&t, 0.05, NULL, &surface));
    batten_surface_unref(surface);
    end_tower(&t);
}
