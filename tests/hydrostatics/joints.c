/* Edges of surfaces that run along edges of others, from end to end. */
#include "hydrostatics/hulls.h"
#include "support/test.h"

static const double bottom[][2] = {{0, 0}, {1, 0}}, side[][2] = {{1, 0}, {1, 2}};

/* A box whose side begins and ends off the ends of its bottom. */
static batten_status make_box(double from, double to, int *lids)
{
    batten_surface *parts[2] = {half_prism(0, 4, 2, bottom), half_prism(from, to, 2, side)};
    batten_hull *hull = NULL;
    const batten_status status =
        batten_hull_create(2, (const batten_surface *const *)parts, NULL, &hull);
    if (status == BATTEN_OK)
        batten_hull_lids(hull, lids);
    batten_hull_free(hull);
    for (int k = 0; k < 2; k++)
        batten_surface_unref(parts[k]);
    return status;
}

/* Of a size of 4 a millionth is 4e-6. The bottom's edge is no joint when one of its ends is farther from
 * the side, but the side's is: what is left of the two does not close. */
TEST(an_edge_is_a_joint_when_both_of_its_ends_are_on_others)
{
    static const struct {
        double from, to;
        bool joint;
    } rows[] = {{0, 4, true},        {3e-6, 4, true},      {2e-5, 4, false},
                {0, 4 - 3e-6, true}, {0, 4 - 2e-5, false}, {-3e-6, 4 + 3e-6, true}};
    for (int i = 0; i < COUNT(rows); i++) {
        int lids = 0;
        CHECK_STATUS(make_box(rows[i].from, rows[i].to, &lids),
                     rows[i].joint ? BATTEN_OK : BATTEN_NOT_COMPATIBLE);
        CHECK_INT(lids, rows[i].joint ? 5 : 0); /* two ends each, and the deck */
    }
}
