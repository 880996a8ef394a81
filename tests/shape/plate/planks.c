/* The planks of a dory, between the lines of its table of offsets. */
#include <batten/interpolate.h>
#include <batten/plate.h>

#include "support/test.h"

#include <stdio.h>
#include <stdlib.h>

enum { STATIONS = 8, LINES = 6 };

/* Numbers of one row behind its two labels; NaN where there is none. */
static void read_row(char *text, double *out)
{
    char *at = strchr(text, ',');
    at = at ? strchr(at + 1, ',') : NULL;
    for (int i = 0; i < STATIONS; i++) {
        char *end = at ? at + 1 : NULL;
        out[i] = at ? strtod(at + 1, &end) : 0;
        if (!at || end == at + 1)
            out[i] = (double)NAN;
        at = at ? strchr(at + 1, ',') : NULL;
    }
}

/* Stations, then heights and widths of the lines from the sheer down, in feet. */
static void read_table(double *x, double heights[LINES][STATIONS],
                       double widths[LINES][STATIONS])
{
    FILE *file = fopen(test_data("hull_offsets/SportDory.csv"), "r");
    char text[1000];
    CHECK(file != NULL);
    for (int row = 0; row < 2 + 2 * LINES && fgets(text, sizeof text, file); row++) {
        if (row == 1)
            read_row(text, x);
        else if (row > 1)
            read_row(text, row < 2 + LINES ? heights[row - 2] : widths[row - 2 - LINES]);
    }
    fclose(file);
}

/* Stations 1 to 5, where x is known: transom and stem are raked. */
static batten_curve *edge(const double *x, const double *heights, const double *widths)
{
    double points[5][3];
    batten_curve *curve = NULL;
    for (int i = 0; i < 5; i++) {
        points[i][0] = x[i + 1];
        points[i][1] = widths[i + 1];
        points[i][2] = heights[i + 1];
    }
    CHECK_OK(
        batten_curve_interpolate((batten_points){3, 5, &points[0][0]}, NULL, NULL, &curve));
    return curve;
}

TEST(planks_of_a_dory_unroll_with_the_strain_that_their_warp_asks_for)
{
    double x[STATIONS], heights[LINES][STATIONS], widths[LINES][STATIONS];
    read_table(x, heights, widths);
    /* The three upper planks are developable between these lines, the lower two are not. */
    for (int k = 0; k + 1 < LINES; k++) {
        batten_curve *low = edge(x, heights[k + 1], widths[k + 1]);
        batten_curve *high = edge(x, heights[k], widths[k]);
        batten_developable found = {0}, given = {0};
        batten_unrolled flat = {0};
        batten_surface_developable_options options = batten_surface_developable_defaults();
        options.tolerance = 1e-3;
        CHECK_OK(batten_surface_developable(low, high, &options, &found));
        options.keep_matching = true;
        CHECK_OK(batten_surface_developable(low, high, &options, &given));
        CHECK(found.error <= 1e-3 && found.warp <= given.warp * (1 + 1e-6));
        batten_surface_unroll_options lay = batten_surface_unroll_defaults();
        lay.tolerance = 1e-3;
        CHECK_OK(batten_surface_unroll(found.surface, &lay, &flat));
        CHECK(flat.error <= 1e-3);
        CHECK_INT(found.is_developable, k < 3);
        /* Half of the warp on each side of the middle; creases are not in it. */
        CHECK(flat.strain <= 1 - cos(found.warp) + 1e-12);
        CHECK(flat.area[1] <= flat.area[0] * (1 + 1e-12));
        batten_unrolled_release(&flat);
        batten_developable_release(&found);
        batten_developable_release(&given);
        batten_curve_unref(low);
        batten_curve_unref(high);
    }
}
