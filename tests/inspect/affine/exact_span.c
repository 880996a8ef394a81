/* Spans in exact numbers: their powers, their limits, and the dimension that they span. */
#include "inspect/affine/exact_span.h"
#include "support/test.h"

/* ---- reading ---- */

static void only_once(void)
{
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
}

typedef struct {
    bat_effort effort;
    bat_wholes pool;
    bat_exact_span span;
} reading;

static batten_status read_span(reading *r, int dimension, int degree, const double *points)
{
    r->effort = (bat_effort){BATTEN_OK, 1 << 20};
    r->pool = (bat_wholes){&r->effort, NULL, NULL, 0};
    const batten_status status =
        bat_exact_span_read(&r->pool, dimension, degree, points, &r->span);
    if (status != BATTEN_OK)
        bat_wholes_release(&r->pool);
    return status;
}

static double value_of(bat_whole a, int shift)
{
    int exponent = 0;
    const double part = bat_whole_frexp(a, &exponent);
    return ldexp(part, exponent - shift);
}

/* One coordinate of a cubic, its powers of t, and how many binary places they need. */
static const struct {
    double points[4], powers[4];
    int degree, shift;
} cubics[] = {
    {{0.25, 0.75, 1.5, 1.75}, {0.25, 1.5, 0.75, -0.75}, 3, 2},
    {{0, 0, 0, 1}, {0, 0, 0, 1}, 3, 0},
    {{0, 0, 1, 3}, {0, 0, 3}, 2, 0},
    {{-2, -4, -6, -8}, {-2, -6}, 1, -1},
    {{12, 12, 12, 12}, {12}, 0, -2},
    {{0, 0, 0, 0}, {0}, -1, 0},
    {{0x1p-10, 0x1p10, 0, 0},
     {0x1p-10, 3 * (0x1p10 - 0x1p-10), 3 * (0x1p-10 - 0x1p11), 3 * 0x1p10 - 0x1p-10},
     3,
     10},
};

TEST(a_span_is_read_as_whole_powers_of_t)
{
    only_once();
    for (int i = 0; i < COUNT(cubics); i++)
        for (int axis = 0; axis < 3; axis++) {
            double points[12] = {0};
            reading r;
            for (int k = 0; k < 4; k++)
                points[3 * k + axis] = cubics[i].points[k];
            CHECK_OK(read_span(&r, 3, 3, points));
            CHECK_INT(r.span.dimension, 3);
            CHECK_INT(r.span.degree, cubics[i].degree > 0 ? cubics[i].degree : 0);
            CHECK_INT(r.span.shift[axis], cubics[i].shift);
            CHECK_INT(r.span.at[axis].degree, cubics[i].degree);
            for (int k = 0; k <= cubics[i].degree; k++)
                CHECK_BITS(value_of(r.span.at[axis].c[k], cubics[i].shift),
                           cubics[i].powers[k]);
            CHECK_INT(r.span.at[(axis + 1) % 3].degree, -1);
            bat_wholes_release(&r.pool);
        }
}

/* From the first bit of the largest number to the last of all: 353 places are counted with. Those of another
 * coordinate do not matter. */
TEST(numbers_of_too_many_binary_places_are_refused_with_their_count)
{
    only_once();
    static const char words[] =
        "coordinates 2 have 354 binary places, which is more than the 353 that are counted with";
    for (int swap = 0; swap < 2; swap++)
        for (int more = 0; more < 2; more++) {
            double points[6] = {0x1p-700, 1, 0, 0, 0x1p600, 0};
            points[swap ? 1 : 5] = ldexp(1, -352 - more);
            points[swap ? 5 : 1] = 1;
            points[0] = points[4] = 0x1p-700;
            reading r;
            const batten_status status = read_span(&r, 2, 2, points);
            CHECK_STATUS(status, more ? BATTEN_INCOMPLETE : BATTEN_OK);
            if (more)
                CHECK_TEXT(batten_message(), words);
            else
                bat_wholes_release(&r.pool);
        }
}

TEST(an_effort_that_is_used_up_is_said)
{
    only_once();
    const double points[4] = {0.1, 0.2, 0.3, 0.7};
    bat_effort effort = {BATTEN_OK, 1};
    bat_wholes pool = {&effort, NULL, NULL, 0};
    bat_exact_span span;
    const batten_status status = bat_exact_span_read(&pool, 1, 3, points, &span);
    CHECK(status == BATTEN_INCOMPLETE || status == BATTEN_OUT_OF_MEMORY);
    bat_wholes_release(&pool);
}

/* With t = (1 + u) / 2: t^2 = ... + u / 2 + u^2 / 4; 3 t = ... + 3 u / 2. Constants do not count. */
TEST(powers_about_the_middle_are_in_proportion_and_the_largest_is_near_1)
{
    only_once();
    static const double points[9] = {7, 0, 5, 7, 1.5, 5, 8, 3, 5};
    static const double due[3][3] = {{0, 0.5, 0.25}, {0, 1.5, 0}, {0, 0, 0}};
    for (int size = -30; size <= 30; size += 15) {
        double scaled[9], powers[3 * 5];
        reading r;
        for (int i = 0; i < 9; i++)
            scaled[i] = ldexp(points[i], size);
        CHECK_OK(read_span(&r, 3, 2, scaled));
        bat_exact_span_centred(&r.pool, &r.span, 5, powers);
        CHECK(powers[5 + 1] >= 0.5 && powers[5 + 1] < 1);
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 3; i++)
                CHECK_BITS(powers[5 * k + i], due[k][i] * (powers[5 + 1] / 1.5));
        bat_wholes_release(&r.pool);
    }
}

/* ---- dimension ---- */

/* Powers of t, and how many dimensions they span; `depends` on these coordinates. */
static const struct {
    double powers[4][3]; /* of t, t^2, t^3, t^4 */
    int dimension, depends;
} spans[] = {
    {{{0}}, 0, 0},
    {{{1, 0, 0}}, 1, 1},
    {{{0, 2, 0}}, 1, 2},
    {{{0}, {0}, {0, 0, 5}}, 1, 4},
    {{{1, 0, 0}, {3, 0, 0}, {-2, 0, 0}}, 1, 1},
    {{{1, 2, 3}, {-2, -4, -6}}, 1, 7},
    {{{1, 0, 0}, {0, 1, 0}}, 2, 3},
    {{{1, 0, 0}, {0, 0, 0}, {2, 0, 3}}, 2, 5},
    {{{0}, {0, 1, 0}, {0, 0, 1}}, 2, 6},
    {{{0}, {0, 0, 1}, {0, 0, 2}, {0, 1, 1}}, 2, 6},
    {{{1, 1, 0}, {2, 2, 0}, {1, 1, 4}}, 2, 7},
    {{{1, 0, 1}, {0, 1, 0}, {3, 7, 3}, {1, 0, 1}}, 2, 7},
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 3, 7},
    {{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, 3, 7},
    {{{1, 2, 3}, {2, 4, 6}, {0, 1, 0}, {1, 2, 4}}, 3, 7},
    {{{1, 1, 1}, {1, -1, 0}, {0, 0, 0}, {1, 1, -2}}, 3, 7},
};

/* Bezier points of a quartic: p_i = sum over k of C(i, k) / C(4, k) c_k. */
static void points_of(const double (*powers)[3], double *points)
{
    static const double choose[5][5] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
    for (int i = 0; i <= 4; i++)
        for (int axis = 0; axis < 3; axis++) {
            points[3 * i + axis] = 12 * (axis + 5);
            for (int k = 1; k <= i; k++)
                points[3 * i + axis] += 12 * choose[i][k] / choose[4][k] * powers[k - 1][axis];
        }
}

TEST(the_dimension_of_a_span_is_exact_and_its_coordinates_tell_points_apart)
{
    only_once();
    for (int i = 0; i < COUNT(spans); i++) {
        double points[15];
        reading r;
        points_of(spans[i].powers, points);
        CHECK_OK(read_span(&r, 3, 4, points));
        const bat_flatness exact = bat_exact_span_flatness(&r.pool, &r.span, points, 4, 0),
                           near = bat_exact_span_flatness(&r.pool, &r.span, points, 4, 1e-9);
        CHECK_INT(exact.dimension, spans[i].dimension);
        CHECK_INT(near.dimension, spans[i].dimension);
        for (int k = 0; k < 2 * spans[i].dimension && spans[i].dimension < 3; k++) {
            const bat_flatness *flat = k % 2 ? &near : &exact;
            CHECK(spans[i].depends >> flat->axes[k / 2] & 1);
        }
        if (spans[i].dimension == 2) {
            CHECK(exact.axes[0] < exact.axes[1] && near.axes[0] < near.axes[1]);
            for (int k = 0; k < 2; k++) { /* one of its minors is not 0 */
                const int *axes = k ? near.axes : exact.axes;
                double most = 0;
                for (int a = 0; a < 4; a++)
                    for (int b = 0; b < a; b++)
                        most = fmax(
                            most,
                            fabs(spans[i].powers[a][axes[0]] * spans[i].powers[b][axes[1]] -
                                 spans[i].powers[a][axes[1]] * spans[i].powers[b][axes[0]]));
                CHECK(most > 0);
            }
        }
        bat_wholes_release(&r.pool);
    }
}

/* A last bit out of line counts exactly, and not by a tolerance. */
TEST(one_bit_is_a_dimension_where_nothing_is_tolerated)
{
    only_once();
    static const double line[] = {0, 0, 1, 1, 2, 2 + 0x1p-51},
                        plane[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0x1p-60};
    for (int k = 0; k < 4; k++) {
        const double *points = k % 2 ? plane : line;
        const int d = k % 2 ? 3 : 2;
        reading r;
        CHECK_OK(read_span(&r, d, d, points));
        const bat_flatness flat =
            bat_exact_span_flatness(&r.pool, &r.span, points, d, k < 2 ? 0 : 1e-14);
        CHECK_INT(flat.dimension, k < 2 ? d : d - 1);
        bat_wholes_release(&r.pool);
    }
}

/* ---- by a tolerance ---- */

/* Base 4 long, `width` of it across, `height` of it out of the plane; in any order of the axes, of any size. */
TEST(flatness_is_what_is_missing_to_the_dimension_below_by_the_size)
{
    only_once();
    static const double width = 0.25, height = 0.0625,
                        sizes[] = {1, 0x1p300, 0x1p-300, 0x1p1020};
    for (int turn = 0; turn < 3; turn++)
        for (int i = 0; i < COUNT(sizes); i++) {
            const double base[4][3] = {
                {0, 0, 0}, {1, 4 * width, 0}, {4, 0, 0}, {2, 0, 4 * height}};
            double points[12];
            for (int k = 0; k < 12; k++)
                points[k / 3 * 3 + (k + turn) % 3] = sizes[i] * base[k / 3][k % 3] / 2;
            const double below = 1 - 1e-12, above = 1 + 1e-12;
            bat_flatness flat = bat_flatness_of_points(3, 4, points, height * below);
            CHECK_INT(flat.dimension, 3);
            CHECK_BITS(flat.flatness, height);
            flat = bat_flatness_of_points(3, 4, points, height * above);
            CHECK_INT(flat.dimension, 2);
            CHECK_BITS(flat.flatness, width);
            CHECK_INT(flat.axes[0], turn == 2 ? 0 : turn == 1 ? 1 : 0);
            CHECK_INT(flat.axes[1], turn == 2 ? 2 : turn == 1 ? 2 : 1);
            flat = bat_flatness_of_points(3, 4, points, width * above);
            CHECK_INT(flat.dimension, 1);
            CHECK_BITS(flat.flatness, 0);
            CHECK_INT(flat.axes[0], turn);
        }
}

TEST(points_in_the_plane_have_no_third_dimension)
{
    only_once();
    static const double points[] = {1, 1, 1, 5, 2, 1}, one[] = {3, 4, 3, 4};
    bat_flatness flat = bat_flatness_of_points(2, 3, points, 0.2499);
    CHECK_INT(flat.dimension, 2);
    CHECK_BITS(flat.flatness, 0.25);
    CHECK(flat.axes[0] == 0 && flat.axes[1] == 1);
    flat = bat_flatness_of_points(2, 3, points, 0.25);
    CHECK_INT(flat.dimension, 1);
    CHECK_INT(flat.axes[0], 1);
    flat = bat_flatness_of_points(2, 2, one, 1e-9);
    CHECK_INT(flat.dimension, 0);
    CHECK_BITS(flat.flatness, 0);
}
