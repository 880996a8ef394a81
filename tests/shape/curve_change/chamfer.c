/* Corners cut off by straight lines. */
#include "support/test.h"
#include <batten/blend.h>
#include <batten/measure.h>
#include <batten/standard.h>

/* A corner with legs of 3 and 4: its report, which stays as it was where the cut is too long. */
TEST(a_chamfer_reports_its_corners_where_it_is_made_and_only_there)
{
    static const double points[6] = {0, 0, 3, 0, 3, 4};
    static const struct {
        double lengths[2];
        batten_status status;
        const char *words;
    } cuts[] = {
        {{1, 2}, BATTEN_OK, ""},
        {{3, 4}, BATTEN_OK, ""},
        {{3.5, 1}, BATTEN_NOT_FOUND, "3.5 cannot be cut off the first curve, which is 3 long"},
        {{1, 4.5}, BATTEN_NOT_FOUND, "4.5 cannot be cut off the second curve, which is 4 long"},
        {{0, 1}, BATTEN_BAD_ARGUMENT, "a length of 0 is cut off, not above 0"},
        {{1, -2}, BATTEN_BAD_ARGUMENT, "a length of -2 is cut off, not above 0"},
    };
    batten_curve *bent = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){2, 3, points}, &bent));
    for (int i = 0; i < COUNT(cuts); i++) {
        batten_corners_report report = {.corners = 77, .cut = 78};
        batten_curve *made = NULL;
        CHECK_STATUS(batten_curve_chamfer(bent, cuts[i].lengths, 1e-9, &report, &made),
                     cuts[i].status);
        if (cuts[i].status == BATTEN_OK) {
            double length;
            CHECK_OK(batten_curve_length(made, 1e-9, NULL, &length));
            CHECK_NEAR(length,
                       7 - cuts[i].lengths[0] - cuts[i].lengths[1] +
                           hypot(cuts[i].lengths[0], cuts[i].lengths[1]),
                       1e-8);
            CHECK(report.corners == 1 && report.cut == 1 && report.complete);
        } else {
            CHECK_MESSAGE(cuts[i].words);
            CHECK(report.corners == 77 && report.cut == 78 && !made);
        }
        batten_curve_unref(made);
    }
    batten_curve_unref(bent);
}
