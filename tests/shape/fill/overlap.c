/* Fills that turn back over themselves without a crease. */
#include "shape/fill/loops.h"

/* Straight sides round the corners of an L. @param rise  of every second corner */
static batten_status fill_l(double rise, batten_surface_fill_report *report)
{
    static const double ell[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    hole h;
    memset(&h, 0, sizeof h);
    for (int i = 0; i < 6; i++) {
        double points[2][3];
        for (int k = 0; k < 2; k++) {
            const int at = (i + k) % 6;
            points[k][0] = ell[at][0];
            points[k][1] = ell[at][1];
            points[k][2] = at % 2 ? rise : 0;
        }
        hole_add(&h, 1, points[0], 0, NULL);
    }
    const batten_status status = batten_surface_fill(6, h.ribbons, NULL, report, h.patches);
    hole_free(&h);
    return status;
}

TEST(surfaces_that_curl_over_a_re_entrant_corner_are_a_fold_flat_or_not)
{
    static const double rises[] = {0, 0.001, 0.1, 0.4};
    for (int i = 0; i < COUNT(rises); i++) {
        batten_surface_fill_report report;
        CHECK_STATUS(fill_l(rises[i], &report), BATTEN_TOLERANCE_NOT_MET);
        CHECK_MESSAGE("the fill folds over near");
        CHECK(report.folded);
    }
}
