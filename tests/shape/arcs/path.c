/* Curves that arcs are to follow: where they rest, turn a corner and close. */
#include "shape/arcs/path.h"
#include "support/test.h"

#include <batten/standard.h>

/* What failed is ended, so that a test may try again. */
static batten_status make_path(const batten_curve *curve, double angle, bat_arcs_path *out)
{
    const batten_status status = bat_arcs_path_make(curve, angle, out);
    if (status != BATTEN_OK) {
        bat_arcs_path_end(out);
        *out = (bat_arcs_path){0};
    }
    return status;
}

static batten_curve *bezier(int degree, int pieces, const double *points, const double *breaks)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){degree, pieces, breaks}, points, NULL,
                                      &curve));
    return curve;
}

static bool has(int count, const double *places, double u, double within)
{
    for (int i = 0; i < count; i++)
        if (fabs(places[i] - u) <= within)
            return true;
    return false;
}

TEST(a_cusp_inside_a_piece_is_a_station_and_a_corner)
{
    /* (s^2, s^3) with s = u - c: it rests at c, where it turns back. */
    for (int k = 1; k < 8; k++) {
        const double c = k / 8.0 + 0.01, a = -c, b = 1 - c;
        /* Blossoms of s^2 and s^3 at (a, a, a), (a, a, b), (a, b, b), (b, b, b). */
        const double points[] = {a * a,
                                 a * a * a,
                                 (a * a + 2 * a * b) / 3,
                                 a * a * b,
                                 (2 * a * b + b * b) / 3,
                                 a * b * b,
                                 b * b,
                                 b * b * b};
        const double breaks[] = {0, 1};
        batten_curve *curve = bezier(3, 1, points, breaks);
        bat_arcs_path p;
        CHECK_OK(make_path(curve, 0.1, &p));
        CHECK(has(p.station_count, p.stations, c, 1e-6));
        CHECK_INT(p.corner_count, 3);
        CHECK_NEAR(p.corners[1], c, 1e-6);
        CHECK(p.corners[0] == 0 && p.corners[2] == 1);
        CHECK(!p.closed && !p.smooth_seam);
        for (int i = 1; i < p.station_count; i++)
            CHECK(p.stations[i] > p.stations[i - 1]);
        bat_arcs_path_end(&p);
        batten_curve_unref(curve);
    }
}

TEST(a_corner_is_a_jump_of_direction_above_the_angle_given)
{
    /* Two lines that turn by 0.3. */
    const double points[] = {0, 0, 1, 0, 1 + cos(0.3), sin(0.3)}, breaks[] = {0, 1, 3};
    batten_curve *curve = bezier(1, 2, points, breaks);
    for (int k = 0; k < 2; k++) {
        bat_arcs_path p;
        CHECK_OK(make_path(curve, k ? 0.31 : 0.29, &p));
        CHECK_INT(p.corner_count, k ? 2 : 3);
        if (!k)
            CHECK_NEAR(p.corners[1], 1, 0);
        CHECK_NEAR(p.scale, 1 + cos(0.3), 1e-15);
        CHECK_NEAR(p.speed, hypot(1 + cos(0.3), sin(0.3)) / 3, 1e-15);
        bat_arcs_path_end(&p);
    }
    batten_curve_unref(curve);
}

TEST(a_seam_is_smooth_when_a_closed_curve_has_no_corner)
{
    const double square[] = {0, 0, 1, 0, 1, 1, 0, 1, 0, 0}, breaks[] = {0, 1, 2, 3, 4};
    /* A drop with its corner at the seam, by one cubic. */
    const double drop[] = {0, 0, 2, 2, -2, 2, 0, 0};
    batten_curve *curves[3] = {NULL, bezier(1, 4, square, breaks), bezier(3, 1, drop, breaks)};
    CHECK_OK(batten_curve_circle(2, BATTEN_CIRCLE_SQUARE_9, &curves[0]));
    for (int i = 0; i < 3; i++) {
        bat_arcs_path p;
        CHECK_OK(make_path(curves[i], 1e-3, &p));
        CHECK(p.closed);
        CHECK(p.smooth_seam == (i == 0));
        CHECK_INT(p.corner_count, i == 1 ? 5 : 2);
        bat_arcs_path_end(&p);
        batten_curve_unref(curves[i]);
    }
}

TEST(samples_take_both_ends_the_stations_between_and_enough_besides)
{
    const double points[] = {0, 0, 1, 3, 2, -3, 3, 0}, breaks[] = {0, 1};
    batten_curve *curve = bezier(3, 1, points, breaks);
    bat_arcs_path p;
    CHECK_OK(make_path(curve, 0.1, &p));
    CHECK(has(p.station_count, p.stations, 0.5, 1e-9)); /* its inflection */
    for (int inner = 1; inner < 4; inner++) {
        bat_samples s = {0};
        CHECK_OK(bat_arcs_take(&p, (batten_interval){0.2, 0.9}, inner, 20, &s));
        CHECK(s.count >= 20);
        CHECK_NEAR(s.u[0], 0.2, 0);
        CHECK_NEAR(s.u[s.count - 1], 0.9, 0);
        CHECK(has(s.count, s.u, 0.5, 1e-9));
        for (int i = 0; i < s.count; i++) {
            double at[4];
            CHECK(i == 0 || s.u[i] > s.u[i - 1]);
            CHECK_OK(batten_curve_evaluate(curve, s.u[i], 1, at));
            const double *row = s.rows[i];
            CHECK_NEAR(hypot(row[0] - at[0], row[1] - at[1]), 0, 1e-14);
            /* the direction, of any length */
            CHECK(row[2] * at[2] + row[3] * at[3] > 0);
            CHECK_NEAR(row[2] * at[3] - row[3] * at[2], 0, 1e-12);
        }
        bat_samples_end(&s);
    }
    bat_arcs_path_end(&p);
    batten_curve_unref(curve);
}

TEST(points_and_endless_curves_have_no_path)
{
    const double point[] = {5, 5, 5, 5}, huge[] = {-1e308, -1e308, 1.1e308, 1.5e308};
    const double breaks[] = {0, 1};
    batten_curve *curves[2] = {bezier(1, 1, point, breaks), bezier(1, 1, huge, breaks)};
    for (int i = 0; i < 2; i++) {
        bat_arcs_path p;
        CHECK_STATUS(make_path(curves[i], 0.1, &p), i ? BATTEN_OVERFLOW : BATTEN_SINGULAR_HERE);
        bat_arcs_path_end(&p);
        batten_curve_unref(curves[i]);
    }
}

TEST(a_part_that_continues_beyond_the_seam_is_two_ranges)
{
    static const struct {
        double from, to;
        int count;
        batten_interval ranges[2];
    } rows[] = {
        {2, 3, 1, {{2, 3}}},     {2.5, 6, 1, {{2.5, 6}}},         /* up to the seam */
        {6, 7, 1, {{2, 3}}},     {5, 6.5, 2, {{5, 6}, {2, 2.5}}}, /* from it, and over it */
        {7, 9.5, 1, {{3, 5.5}}},
    };
    const bat_arcs_path p = {.domain = {2, 6}, .closed = true, .smooth_seam = true};
    for (int i = 0; i < COUNT(rows); i++) {
        const bat_arcs_part part = {.from = rows[i].from, .to = rows[i].to};
        batten_interval ranges[2];
        CHECK_INT(bat_arcs_ranges(&p, &part, ranges), rows[i].count);
        for (int k = 0; k < rows[i].count; k++) {
            CHECK_NEAR(ranges[k].a, rows[i].ranges[k].a, 0);
            CHECK_NEAR(ranges[k].b, rows[i].ranges[k].b, 0);
        }
    }
}
