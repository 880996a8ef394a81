/* Chords of a curve: where they begin, how far the curve leaves them, and the tree of their boxes. */
#include "inspect/nearest/meetings.h"
#include "support/test.h"

#include <batten/standard.h>

/* y = x^2 over 0 .. 4: halfway it is a quarter of 4^2 off its chord, and its polygon is 2 + sqrt(4 + 256) long, so
 * that five chords leave it by less than a hundredth of their lengths. A line is one chord. */
TEST(a_parabola_has_five_chords_and_a_line_one)
{
    static const double parabola[9] = {0, 0, 1, 2, 0, 1, 4, 16, 1},
                        knots[] = {0, 0, 0, 1, 1, 1};
    static const double from[3] = {1, 2, 3}, to[3] = {-1, 5, 3};
    batten_curve *curves[2] = {NULL, NULL};
    CHECK_OK(batten_curve_create((batten_points){3, 3, parabola}, 2, NULL, knots, &curves[0]));
    CHECK_OK(batten_curve_line(3, from, to, &curves[1]));
    for (int k = 0; k < 2; k++) {
        const int count = k ? 1 : 5;
        bat_trace trace;
        CHECK_OK(bat_trace_make(curves[k], &trace));
        CHECK(trace.curve == curves[k]);
        CHECK_INT(trace.count, count);
        CHECK_INT(trace.width, k ? 1 : 8);
        for (int i = 0; i <= count; i++) {
            double p[3];
            CHECK_NEAR(trace.at[i], (double)i / count, 1e-15);
            CHECK_OK(batten_curve_evaluate(curves[k], trace.at[i], 0, p));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(trace.points[3 * i + c], p[c], 1e-14);
        }
        for (int i = 0; i < count; i++) {
            const double sag = k ? 0 : 4.0 / 25, *box = trace.boxes + 6 * (trace.width + i);
            CHECK_NEAR(trace.sag[i], sag, 1e-14);
            for (int c = 0; c < 3; c++) {
                const double a = trace.points[3 * i + c], b = trace.points[3 * i + 3 + c];
                CHECK_NEAR(box[c], fmin(a, b) - sag, 1e-14);
                CHECK_NEAR(box[3 + c], fmax(a, b) + sag, 1e-14);
            }
        }
        for (int i = trace.width - 1; i > 0; i--) /* a box holds those of its two nodes */
            for (int c = 0; c < 3; c++) {
                const double *own = trace.boxes + 6 * i, *low = trace.boxes + 12 * i,
                             *high = low + 6;
                CHECK_BITS(own[c], fmin(low[c], high[c]));
                CHECK_BITS(own[3 + c], fmax(low[3 + c], high[3 + c]));
            }
        bat_trace_free(&trace);
        batten_curve_unref(curves[k]);
    }
}
