/* Combs: knots that many curves share, and what makes them. */
#include "shape/skin/common_knots_parts.h"
#include "support/test.h"

#include <string.h>

/* Anew: what a failing allocation left is given back. */
static batten_status begin_comb(int capacity, bat_comb *c)
{
    bat_comb_free(c);
    *c = (bat_comb){0};
    return bat_comb_make(capacity, c);
}

static bat_comb comb(int capacity)
{
    bat_comb c = {0};
    CHECK_OK(begin_comb(capacity, &c));
    CHECK_INT(c.capacity, capacity);
    return c;
}

static void check_comb(const bat_comb *c, int count, const double *knots, const char *held)
{
    CHECK_INT(c->inner, count);
    for (int i = 0; i < count; i++) {
        CHECK_BITS(c->knots[i], knots[i]);
        CHECK_INT(c->held[i], held[i] == 'h');
    }
}

TEST(knots_are_put_into_a_comb_in_rising_order_with_what_holds_them)
{
    bat_comb c = comb(6), other = comb(6);
    double U[11];
    bat_comb_insert(&c, 0.5, true);
    bat_comb_insert(&c, 0.25, false);
    bat_comb_insert(&c, 0.75, true);
    bat_comb_insert(&c, 0.5, false); /* after its equal */
    check_comb(&c, 4, (double[]){0.25, 0.5, 0.5, 0.75}, "fhfh");
    bat_comb_copy(&c, &other);
    bat_comb_remove(&c, 1);
    check_comb(&c, 3, (double[]){0.25, 0.5, 0.75}, "ffh");
    bat_comb_remove(&c, 0);
    bat_comb_remove(&c, 1);
    check_comb(&c, 1, (double[]){0.5}, "f");
    check_comb(&other, 4, (double[]){0.25, 0.5, 0.5, 0.75}, "fhfh");
    bat_comb_write(&c, 3, U);
    for (int i = 0; i < 9; i++)
        CHECK_BITS(U[i], i < 4 ? 0 : i == 4 ? 0.5 : 1);
    bat_comb_free(&other);
    bat_comb_free(&c);
}

TEST(a_comb_begins_with_the_held_knots_and_three_for_a_seam)
{
    static const double held[] = {0.21, 0.8};
    const struct {
        int held, limit;
        bool seam, fits;
        int count;
        double knots[4];
        const char *kinds;
    } rows[] = {
        {0, 9, false, true, 0, {0}, ""},
        {2, 9, false, true, 2, {0.21, 0.8}, "hh"},
        {2, 5, false, true, 2, {0.21, 0.8}, "hh"},
        {2, 4, false, false, 0, {0}, ""},
        /* As few may be wanted as there are, where nothing must stand. */
        {0, 2, false, true, 0, {0}, ""},
        {0, 2, true, false, 0, {0}, ""},
        {0, 3, true, true, 3, {0.25, 0.5, 0.75}, "hhh"},
        /* A quarter is nearer than 0.05 to what is held; one half makes three. */
        {2, 9, true, true, 3, {0.21, 0.5, 0.8}, "hhh"},
        {1, 9, true, true, 3, {0.21, 0.5, 0.75}, "hhh"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        bat_comb c = comb(9);
        const bat_common_request request = {
            .held_count = rows[i].held, .held = held, .seam = rows[i].seam};
        const bat_fitting f = {.request = &request, .limit = rows[i].limit};
        CHECK_INT(bat_comb_hold(&f, &c), rows[i].fits);
        check_comb(&c, rows[i].count, rows[i].knots, rows[i].kinds);
        bat_comb_free(&c);
    }
}

/* Two straight legs, of degree 2 with a full knot at `at`: from (0, 0) by (1, 0) a span of the
 * domain to the middle point, and on by (1, slope). */
static bat_spline legs(double at, double slope)
{
    bat_spline s = {0};
    CHECK_OK(bat_spline_make(2, 5, 2, &s));
    const double knots[] = {0, 0, 0, at, at, 1, 1, 1};
    const double after = 1 - at;
    const double values[] = {
        0, 0, at / 2, 0, at, 0, at + after / 2, slope * after / 2, 1, slope * after};
    memcpy(s.knots, knots, sizeof knots);
    memcpy(s.values, values, sizeof values);
    return s;
}

/* The derivative bends by (0, slope) at `at`: that moves the curve by slope h / 32, h the shorter
 * span, and is a corner above a quarter of the tolerance. */
TEST(a_corner_that_a_quarter_of_the_tolerance_shows_gets_as_many_knots_as_its_degree)
{
    const struct {
        double at, slope;
        bool corner;
    } rows[] = {
        {0.25, 1.01, true}, {0.25, 0.99, false}, {0.75, 1.01, true}, {0.75, 0.99, false},
        {0.5, 0.51, true},  {0.5, 0.49, false},  {0.5, -0.51, true},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        bat_comb c = comb(4);
        bat_spline given[] = {legs(rows[i].at, rows[i].slope)};
        const bat_fitting f = {.count = 1,
                               .degree = 2,
                               .dimension = 2,
                               .width = 2,
                               .tolerance = 4 * 0.25 / 32,
                               .given = given,
                               .limit = 4};
        CHECK(bat_comb_corners(&f, &c));
        check_comb(&c, rows[i].corner ? 2 : 0, (double[]){rows[i].at, rows[i].at}, "hh");
        bat_comb_free(&c);
        bat_spline_free(&given[0]);
    }
}

TEST(corners_of_several_curves_are_shared_where_they_are_one_and_limited_in_number)
{
    bat_spline given[] = {legs(0.25, 3), legs(0.25 * (1 + 8 * 0x1p-52), 3), legs(0.75, -3)};
    bat_fitting f = {.count = 3,
                     .degree = 2,
                     .dimension = 2,
                     .width = 2,
                     .tolerance = 1e-3,
                     .given = given,
                     .limit = 4};
    bat_comb c = comb(4);
    CHECK(bat_comb_corners(&f, &c));
    check_comb(&c, 4, (double[]){0.25, 0.25, 0.75, 0.75}, "hhhh");
    f.limit = 3;
    c.inner = 0;
    CHECK(!bat_comb_corners(&f, &c));
    /* What stands there already is filled up, at the place where it stands. */
    f.limit = 4;
    c.inner = 0;
    bat_comb_insert(&c, 0.25 * (1 - 8 * 0x1p-52), false);
    CHECK(bat_comb_corners(&f, &c));
    CHECK_INT(c.inner, 4);
    CHECK_BITS(c.knots[1], c.knots[0]);
    CHECK_BITS(c.knots[2], 0.75);
    CHECK(!c.held[0] && c.held[1] && c.held[2] && c.held[3]);
    bat_comb_free(&c);
    for (int k = 0; k < 3; k++)
        bat_spline_free(&given[k]);
}

static bat_spline spline_of(int degree, int count, const double *knots)
{
    bat_spline s = {0};
    CHECK_OK(bat_spline_make(degree, count, 1, &s));
    memcpy(s.knots, knots, (size_t)(count + degree + 1) * sizeof *knots);
    return s;
}

/* The quantiles of 0, 0.2, 0.4, 1 and of 0, 0.6, 1 at thirds: 0.2 and 0.4; 0.4 and 0.6 + 0.4 / 3. */
TEST(averaged_knots_are_the_means_of_the_quantiles)
{
    const double first[] = {0, 0, 0.2, 0.4, 1, 1}, second[] = {0, 0, 0.6, 1, 1};
    bat_spline given[] = {spline_of(1, 4, first), spline_of(1, 3, second)};
    bat_fitting f = {.count = 2, .given = given, .limit = 9};
    bat_comb c = comb(9);
    bat_comb_average(&f, 2, &c);
    CHECK_INT(c.inner, 2);
    CHECK_NEAR(c.knots[0], 0.3, 1e-15);
    CHECK_NEAR(c.knots[1], (0.4 + 0.6 + 0.4 / 3) / 2, 1e-15);
    CHECK(!c.held[0] && !c.held[1]);
    /* Not beside a held knot, within a twentieth of the distance of its neighbours. */
    c.inner = 0;
    bat_comb_insert(&c, 0.3 + 0.99 * 0.05 / 3, true);
    bat_comb_average(&f, 2, &c);
    CHECK_INT(c.inner, 2);
    c.inner = 0;
    bat_comb_insert(&c, 0.3 + 1.01 * 0.05 / 3, true);
    bat_comb_average(&f, 2, &c);
    CHECK_INT(c.inner, 3);
    /* And no more than the limit. */
    f.limit = 1;
    c.inner = 0;
    bat_comb_average(&f, 2, &c);
    CHECK_INT(c.inner, 1);
    c.inner = 0;
    bat_comb_average(&f, 0, &c);
    CHECK_INT(c.inner, 0);
    bat_comb_free(&c);
    for (int k = 0; k < 2; k++)
        bat_spline_free(&given[k]);
}

/* Rational, in the plane: homogeneous rows of points and weights of degree 2 with knots at `a` and
 * `b`. The points turn about (3, .), so that the left legs are those on the right. */
static bat_spline mirrored(double a, double b, double weight, double x, double y)
{
    const double knots[] = {0, 0, 0, a, b, 1, 1, 1};
    const double points[5][3] = {{0, 0, 1}, {1, 2, 2}, {3, 3, 3}, {5, 2, 2}, {x, y, weight}};
    bat_spline s = {0};
    CHECK_OK(bat_spline_make(2, 5, 3, &s));
    memcpy(s.knots, knots, sizeof knots);
    for (int i = 0; i < 5; i++)
        for (int c = 0; c < 3; c++)
            s.values[3 * i + c] = points[i][c] * (c < 2 ? points[i][2] : 1);
    return s;
}

TEST(sections_are_symmetric_when_knots_weights_and_legs_are)
{
    const struct {
        double a, b, weight, x, y;
        bool symmetric;
    } rows[] = {
        {0.25, 0.75, 1, 6, 0, true},
        {0.25, 0.74, 1, 6, 0, false},
        {0.25, 0.75, 1.001, 6, 0, false},
        {0.25, 0.75, 1, 6, 0.01, false},
        /* As far from its neighbour as its image, on the other side: farther from those behind it. */
        {0.25, 0.75, 1, 4, 0, false},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        bat_spline given[] = {
            mirrored(0.25, 0.75, 1, 6, 0),
            mirrored(rows[i].a, rows[i].b, rows[i].weight, rows[i].x, rows[i].y)};
        const bat_fitting f = {.count = 2,
                               .degree = 2,
                               .dimension = 2,
                               .width = 3,
                               .rational = true,
                               .given = given};
        CHECK_INT(bat_common_symmetry(&f), rows[i].symmetric);
        for (int k = 0; k < 2; k++)
            bat_spline_free(&given[k]);
    }
}

/* The same, of polynomials in space: the last coordinate counts. */
TEST(polynomial_sections_are_symmetric_in_space)
{
    for (int lifted = 0; lifted < 2; lifted++) {
        const double knots[] = {0, 0, 0.5, 1, 1}, values[] = {0, 0, lifted, 1, 1, 0, 2, 0, 0};
        bat_spline s = {0};
        CHECK_OK(bat_spline_make(1, 3, 3, &s));
        memcpy(s.knots, knots, sizeof knots);
        memcpy(s.values, values, sizeof values);
        const bat_fitting f = {
            .count = 1, .degree = 1, .dimension = 3, .width = 3, .given = &s};
        CHECK_INT(bat_common_symmetry(&f), !lifted);
        bat_spline_free(&s);
    }
}

TEST(mirrored_knots_are_symmetric_to_the_bit_but_where_they_are_held)
{
    bat_comb c = comb(5);
    const double nearly[] = {0.1, 0.3, 0.51, 0.71, 0.91};
    for (int i = 0; i < 5; i++)
        bat_comb_insert(&c, nearly[i], false);
    bat_comb_mirror(&c);
    check_comb(&c, 5, (double[]){0.1, 0.3, 0.5, 1 - 0.3, 1 - 0.1}, "fffff");
    c.inner = 0;
    for (int i = 0; i < 5; i++)
        bat_comb_insert(&c, nearly[i], i == 0 || i == 3);
    bat_comb_mirror(&c);
    check_comb(&c, 5, (double[]){0.1, 0.3, 0.5, 0.71, 0.91}, "hffhf");
    c.inner = 0;
    bat_comb_insert(&c, 0.4, false);
    bat_comb_insert(&c, 0.7, false);
    bat_comb_mirror(&c);
    check_comb(&c, 2, (double[]){0.4, 1 - 0.4}, "ff");
    bat_comb_free(&c);
}
