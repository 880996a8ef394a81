#include <batten/invariants.h>
#include <batten/standard.h>

#include "inspect/shapes.h"
#include "support/test.h"

static void random_points(test_random *random, int degree, bool whole, double *points)
{
    for (int i = 0; i < 2 * (degree + 1); i++)
        points[i] = whole ? test_random_int(random, -20, 20) : test_random_in(random, -1, 1);
}

/* Bezier points of x(t), y(t) given by whole powers of t in [0, 1], after t -> c t + f with
 * small dyadic numbers: all exact. */
static void from_powers(int degree, const double *x, const double *y, double c, double f,
                        double *points)
{
    const double *const both[2] = {x, y};
    for (int k = 0; k < 2; k++) {
        double a[BATTEN_MAX_DEGREE + 1], binomial = 1;
        memcpy(a, both[k], ((size_t)degree + 1) * sizeof *a);
        for (int r = 0; r < degree; r++) /* at t + f */
            for (int i = degree - 1; i >= r; i--)
                a[i] += f * a[i + 1];
        double power = 1;
        for (int i = 0; i <= degree; i++, power *= c) {
            a[i] *= power;
            a[i] *= 2520 / binomial; /* whole: 2520 is a multiple of all C(n, i), n <= 6 */
            binomial = binomial * (degree - i) / (i + 1);
        }
        for (int r = 1; r <= degree; r++)
            for (int i = degree; i >= r; i--)
                a[i] += a[i - 1];
        for (int i = 0; i <= degree; i++)
            points[2 * i + k] = a[i];
    }
}

#define WHOLE(c, kind) (c).whole[BATTEN_SPECIAL_##kind]
#define SEGMENT(c, kind) (c).segment[BATTEN_SPECIAL_##kind]

/* Release it; what is listed stands by kind, then by t, and is what is counted. */
static void end_census(batten_census *c)
{
    int whole[BATTEN_SPECIAL_COUNT] = {0}, segment[BATTEN_SPECIAL_COUNT] = {0};
    for (int i = 0; i < c->count; i++) {
        const batten_special *at = &c->specials[i], *before = i > 0 ? at - 1 : at;
        CHECK(before->kind < at->kind || (before->kind == at->kind && before->t <= at->t));
        whole[at->kind]++;
        segment[at->kind] += at->inside;
    }
    for (int kind = 0; kind < BATTEN_SPECIAL_COUNT; kind++) {
        CHECK_INT(whole[kind], c->whole[kind]);
        CHECK_INT(segment[kind], c->segment[kind]);
    }
    batten_census_release(c);
}

static int double_point_sum(const batten_census *c)
{
    int sum = c->complex_count + c->infinite_count;
    for (int i = 0; i < c->count; i++)
        if (c->specials[i].kind == BATTEN_SPECIAL_CROSSING ||
            c->specials[i].kind == BATTEN_SPECIAL_ISOLATED)
            sum += c->specials[i].multiplicity;
    return sum;
}

/* ---- quintics with (t^2, t^5 + a t^4 + b t^3 + g t) ---- */

static void census_of_quintic(double a, double b, double g, batten_census *out)
{
    const double x[6] = {0, 0, 1, 0, 0, 0}, y[6] = {0, g, 0, b, a, 1};
    double points[12];
    from_powers(5, x, y, 4, -2, points);
    CHECK_OK(batten_census_take(2, 5, points, 0, out));
}

TEST(spec_5_the_quintics_of_the_table_have_its_counts)
{
    static const struct {
        double a, b, g;
        int crossings, isolated, cusps, inflections, complex, inside;
    } rows[] = {
        {1, -3, 1, 2, 0, 0, 2, 0, 2}, {1, 3, 1, 0, 2, 0, 2, 0, 0},
        {1, 0, 1, 0, 0, 0, 2, 2, 0},  {1, 1, -1, 1, 1, 0, 0, 0, 1},
        {1, 2, 0, 0, 1, 1, 0, 0, 0},  {1, -2, 0, 1, 0, 1, 2, 0, 1},
        {1, -2, 1, 1, 0, 0, 2, 0, 1}, {1, 2, 1, 0, 1, 0, 2, 0, 0},
        {1, 0, 0, 0, 0, 1, 1, 0, 0},  {0, -5, -1, 1, 1, 0, 4, 0, 0},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_census c;
        census_of_quintic(rows[i].a, rows[i].b, rows[i].g, &c);
        CHECK(c.is_complete && !c.is_repeated);
        CHECK_INT(c.degree, 5);
        CHECK_INT(WHOLE(c, CROSSING), rows[i].crossings);
        CHECK_INT(WHOLE(c, ISOLATED), rows[i].isolated);
        CHECK_INT(WHOLE(c, CUSP), rows[i].cusps);
        CHECK_INT(WHOLE(c, INFLECTION), rows[i].inflections);
        CHECK_INT(c.complex_count, rows[i].complex);
        CHECK_INT(c.infinite_count, 4);
        CHECK_INT(SEGMENT(c, CROSSING), rows[i].inside);
        end_census(&c);
    }
}

TEST(parameters_and_points_of_a_quintic_are_its_own)
{
    /* u^2 - 3 u + 1 = 0, t = +- sqrt(u); the segment runs from -2 to 2 */
    batten_census c;
    census_of_quintic(1, -3, 1, &c);
    int seen = 0;
    for (int i = 0; i < c.count; i++) {
        const batten_special *s = &c.specials[i];
        if (s->kind != BATTEN_SPECIAL_CROSSING)
            continue;
        const double u = (3 + (seen++ ? -1 : 1) * sqrt(5)) / 2;
        CHECK_NEAR(s->t, (2 - sqrt(u)) / 4, 4 * DBL_EPSILON);
        CHECK_NEAR(s->s, (2 + sqrt(u)) / 4, 4 * DBL_EPSILON);
        CHECK_NEAR(s->point.x, 2520 * u, 1e-10 * 2520);
        CHECK_NEAR(s->point.y, 2520 * u * u, 1e-10 * 2520);
    }
    CHECK_INT(seen, 2);
    end_census(&c);
    census_of_quintic(1, 3, 1, &c); /* u = (-3 +- sqrt 5) / 2 */
    for (int i = 0; i < c.count; i++)
        if (c.specials[i].kind == BATTEN_SPECIAL_ISOLATED) {
            const double u = -16 * c.specials[i].s * c.specials[i].s;
            CHECK_NEAR(u * u + 3 * u + 1, 0, 1e-14 * 20);
            CHECK_NEAR(c.specials[i].t, 0.5, DBL_EPSILON);
            CHECK_NEAR(c.specials[i].point.y, 2520 * u * u, 1e-10 * 2520);
        }
    end_census(&c);
}

TEST(a_touching_pair_of_branches_counts_twice)
{
    batten_census c;
    census_of_quintic(1, -2, 1, &c); /* b = -2 sqrt g: a tacnode */
    for (int i = 0; i < c.count; i++)
        if (c.specials[i].kind == BATTEN_SPECIAL_CROSSING)
            CHECK_INT(c.specials[i].multiplicity, 2);
    CHECK_INT(double_point_sum(&c), 6);
    end_census(&c);
}

/* ---- against what else is known ---- */

static int cubic_inflections(batten_cubic_class kind)
{
    return kind == BATTEN_CUBIC_TWO_INFLECTIONS                                   ? 2
           : kind == BATTEN_CUBIC_ONE_INFLECTION || kind == BATTEN_CUBIC_EXPLICIT ? 1
                                                                                  : 0;
}

TEST(cubics_have_what_their_class_says)
{
    test_random random = test_random_begin("cubics");
    for (int n = test_cases(4000); n > 0; n--) {
        double points[8];
        batten_cubic cubic;
        batten_census c;
        random_points(&random, 3, n % 2, points);
        CHECK_OK(batten_cubic_classify(2, points, 0, &cubic));
        CHECK_OK(batten_census_take(2, 3, points, 0, &c));
        if (c.flat_dimension == 2) {
            CHECK_INT(WHOLE(c, INFLECTION), cubic_inflections(cubic.whole));
            CHECK_INT(SEGMENT(c, INFLECTION), cubic_inflections(cubic.segment));
            CHECK_INT(WHOLE(c, CUSP), cubic.whole == BATTEN_CUBIC_CUSP);
            CHECK_INT(SEGMENT(c, CUSP), cubic.segment == BATTEN_CUBIC_CUSP);
            CHECK_INT(WHOLE(c, CROSSING), cubic.whole == BATTEN_CUBIC_LOOP);
            CHECK_INT(SEGMENT(c, CROSSING), cubic.segment == BATTEN_CUBIC_LOOP);
            /* two inflections come with an isolated point */
            CHECK_INT(WHOLE(c, ISOLATED), cubic.whole == BATTEN_CUBIC_TWO_INFLECTIONS);
            if (WHOLE(c, CROSSING)) {
                const batten_special *last = &c.specials[c.count - 1];
                CHECK_NEAR(last->t, cubic.crossing[0], 1e-9 * (1 + fabs(last->t)));
                CHECK_NEAR(last->s, cubic.crossing[1], 1e-9 * (1 + fabs(last->s)));
            }
        }
        end_census(&c);
    }
}

static void at(int degree, const double *points, double t, double *point, double *bend)
{
    double b[2 * (BATTEN_MAX_DEGREE + 1)], d[3][2] = {{0}};
    memcpy(b, points, 2 * ((size_t)degree + 1) * sizeof *b);
    for (int r = degree; r > 0; r--) {
        for (int k = 0; k < 2 && r == 2; k++)
            d[2][k] = b[k] - 2 * b[2 + k] + b[4 + k];
        for (int k = 0; k < 2 && r == 1; k++)
            d[1][k] = b[2 + k] - b[k];
        for (int i = 0; i < 2 * r; i++)
            b[i] += t * (b[i + 2] - b[i]);
    }
    memcpy(point, b, 2 * sizeof *point);
    *bend = d[1][0] * d[2][1] - d[1][1] * d[2][0];
}

static double side(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* The counts on the segment by walking along it in steps, four times as many for the
 * inflections. */
enum { FEW = 96, MANY = 1600 };

static int searched_inflections(int degree, const double *points)
{
    double bend, before = 0, point[2];
    int count = 0;
    for (int i = 0; i <= 4 * FEW; i++) {
        at(degree, points, i / (4.0 * FEW), point, &bend);
        count += before * bend < 0;
        before = bend != 0 ? bend : before;
    }
    return count;
}

static int searched_crossings(int degree, const double *points, int steps)
{
    double x[MANY + 1][2], bend;
    int count = 0;
    for (int i = 0; i <= steps; i++)
        at(degree, points, (double)i / steps, x[i], &bend);
    for (int i = 0; i < steps; i++)
        for (int j = i + 2; j < steps; j++)
            count += side(x[i], x[i + 1], x[j]) * side(x[i], x[i + 1], x[j + 1]) < 0 &&
                     side(x[j], x[j + 1], x[i]) * side(x[j], x[j + 1], x[i + 1]) < 0;
    return count;
}

/* Are all crossings wide enough that a polygon shows them? */
static bool is_plain_to_see(int degree, const double *points, const batten_census *c)
{
    for (int i = 0; i < c->count; i++) {
        const batten_special *s = &c->specials[i];
        double a[2], b[2], p[2], q[2], bend;
        if (s->kind != BATTEN_SPECIAL_CROSSING || s->t < -0.1 || s->s > 1.1)
            continue;
        at(degree, points, s->t, p, &bend);
        at(degree, points, s->t + 1e-5, a, &bend);
        at(degree, points, s->s, q, &bend);
        at(degree, points, s->s + 1e-5, b, &bend);
        const double va[2] = {a[0] - p[0], a[1] - p[1]}, vb[2] = {b[0] - q[0], b[1] - q[1]};
        const double sine =
            (va[0] * vb[1] - va[1] * vb[0]) / (hypot(va[0], va[1]) * hypot(vb[0], vb[1]));
        if (fabs(sine) < 0.3 || s->s - s->t < 0.1)
            return false;
    }
    return c->margin > 0.03;
}

TEST(a_search_counts_the_same)
{
    test_random random = test_random_begin("search");
    int compared = 0, crossed = 0, turned = 0;
    const int cases = test_cases(7000);
    for (int n = 0; n < cases; n++) {
        const int degree = 3 + n % 4;
        double points[14];
        batten_census c;
        random_points(&random, degree, n % 3 != 0, points);
        CHECK_OK(batten_census_take(2, degree, points, 0, &c));
        if (c.flat_dimension == 2) {
            CHECK(c.is_complete);
            CHECK_INT(double_point_sum(&c) + WHOLE(c, CUSP),
                      (c.degree - 1) * (c.degree - 2) / 2);
        }
        if (c.flat_dimension == 2 && is_plain_to_see(degree, points, &c)) {
            int crossings = searched_crossings(degree, points, FEW);
            if (crossings != SEGMENT(c, CROSSING)) /* legs may cross where arcs do not */
                crossings = searched_crossings(degree, points, MANY);
            compared++;
            turned += SEGMENT(c, INFLECTION) > 0;
            crossed += crossings > 0;
            CHECK_INT(SEGMENT(c, INFLECTION), searched_inflections(degree, points));
            CHECK_INT(SEGMENT(c, CROSSING), crossings);
        }
        end_census(&c);
    }
    CHECK(cases < 1000 || (compared > cases / 4 && crossed > 50 && turned > 50));
}

TEST(both_parameters_of_a_crossing_lead_to_one_point)
{
    test_random random = test_random_begin("closing");
    int seen = 0;
    const int cases = test_cases(60);
    for (int n = 0; n < cases; n++) {
        const int degree = 4 + n % 5;
        double points[18], bend;
        batten_census c;
        random_points(&random, degree, false, points);
        CHECK_OK(batten_census_take(2, degree, points, 0, &c));
        for (int i = 0; i < c.count; i++) {
            double p[2], q[2];
            if (c.specials[i].kind != BATTEN_SPECIAL_CROSSING || !c.specials[i].inside)
                continue;
            at(degree, points, c.specials[i].t, p, &bend);
            at(degree, points, c.specials[i].s, q, &bend);
            CHECK_NEAR(hypot(p[0] - q[0], p[1] - q[1]), 0, 1e-13);
            CHECK_NEAR(c.specials[i].point.x, p[0], 1e-13);
            seen++;
        }
        end_census(&c);
    }
    CHECK(cases < 60 || seen > 20);
}

/* X(t + s i), both parts of each coordinate. */
static void at_complex(int degree, const double *points, double t, double s, double (*out)[2])
{
    for (int k = 0; k < 2; k++) {
        double a[BATTEN_MAX_DEGREE + 1], b[BATTEN_MAX_DEGREE + 1] = {0};
        for (int i = 0; i <= degree; i++)
            a[i] = points[2 * i + k];
        for (int r = degree; r > 0; r--)
            for (int i = 0; i < r; i++) {
                const double da = a[i + 1] - a[i], db = b[i + 1] - b[i];
                a[i] += t * da - s * db;
                b[i] += t * db + s * da;
            }
        out[k][0] = a[0];
        out[k][1] = b[0];
    }
}

TEST(isolated_points_are_real_at_complex_parameters)
{
    test_random random = test_random_begin("isolated");
    int seen = 0;
    const int cases = test_cases(100);
    for (int n = 0; n < cases; n++) {
        const int degree = 3 + n % 5;
        double points[16];
        batten_census c;
        random_points(&random, degree, false, points);
        CHECK_OK(batten_census_take(2, degree, points, 0, &c));
        for (int i = 0; i < c.count; i++) {
            const batten_special *s = &c.specials[i];
            double value[2][2];
            /* far from the span the powers of t magnify rounding */
            if (s->kind != BATTEN_SPECIAL_ISOLATED || hypot(s->t - 0.5, s->s) > 1)
                continue;
            at_complex(degree, points, s->t, s->s, value);
            CHECK_NEAR(value[0][1], 0, 1e-11);
            CHECK_NEAR(value[1][1], 0, 1e-11);
            CHECK_NEAR(value[0][0], s->point.x, 1e-11);
            CHECK(s->s > 0 && !s->inside);
            seen++;
        }
        end_census(&c);
    }
    CHECK(cases < 100 || seen > 50);
}

/* ---- laws ---- */

TEST(counts_stay_under_affine_maps_and_changes_of_parameter)
{
    test_random random = test_random_begin("invariant");
    const int cases = test_cases(400);
    for (int n = 0; n < cases; n++) {
        const int degree = 3 + n % 4;
        double x[7], y[7], u[7], v[7], points[14], m[4];
        batten_census old, new;
        for (int i = 0; i <= degree; i++) { /* small numbers: special cases are common */
            x[i] = test_random_int(&random, -2, 2);
            y[i] = test_random_int(&random, -2, 2);
        }
        for (int i = 0; i < 4; i++)
            m[i] = test_random_int(&random, -5, 5);
        if (m[0] * m[3] == m[1] * m[2])
            continue;
        for (int i = 0; i <= degree; i++) {
            u[i] = m[0] * x[i] + m[1] * y[i];
            v[i] = m[2] * x[i] + m[3] * y[i];
        }
        from_powers(degree, x, y, 1, 0, points);
        CHECK_OK(batten_census_take(2, degree, points, 0, &old));
        from_powers(degree, u, v, n % 2 ? -0.5 : 4, test_random_int(&random, -3, 3), points);
        CHECK_OK(batten_census_take(2, degree, points, 0, &new));
        CHECK_INT(new.degree, old.degree);
        CHECK_INT(new.flat_dimension, old.flat_dimension);
        CHECK_INT(new.is_repeated, old.is_repeated);
        CHECK_INT(new.is_complete, old.is_complete);
        for (int k = 0; k < BATTEN_SPECIAL_COUNT && old.is_complete; k++)
            CHECK_INT(new.whole[k], old.whole[k]);
        CHECK_INT(new.complex_count, old.complex_count);
        CHECK_INT(new.infinite_count, old.infinite_count);
        end_census(&old);
        end_census(&new);
    }
}

TEST(a_curve_run_backwards_has_the_same_census)
{
    test_random random = test_random_begin("backwards");
    for (int n = test_cases(200); n > 0; n--) {
        double there[14], back[14];
        batten_census a, b;
        const int degree = 3 + n % 4;
        random_points(&random, degree, true, there);
        for (int i = 0; i <= degree; i++)
            memcpy(back + 2 * i, there + 2 * (degree - i), 2 * sizeof *back);
        CHECK_OK(batten_census_take(2, degree, there, 0, &a));
        CHECK_OK(batten_census_take(2, degree, back, 0, &b));
        CHECK_NEAR(a.margin, b.margin, 1e-9);
        for (int k = 0; k < BATTEN_SPECIAL_COUNT; k++) {
            CHECK_INT(a.whole[k], b.whole[k]);
            CHECK_INT(a.segment[k], b.segment[k]);
        }
        end_census(&a);
        end_census(&b);
    }
}

/* ---- special spans ---- */

/* The census of powers x, y from t = -2 to 2. */
static void census_of(int degree, const double *x, const double *y, batten_census *out)
{
    double points[14];
    from_powers(degree, x, y, 4, -2, points);
    CHECK_OK(batten_census_take(2, degree, points, 0, out));
}

TEST(stops_are_cusps_or_pauses)
{
    const double square[5] = {0, 0, 1, 0, 0}, cube[5] = {0, 0, 0, 1, 0},
                 fourth[5] = {0, 0, 0, 0, 1};
    batten_census c;
    census_of(4, square, cube, &c);
    CHECK(SEGMENT(c, CUSP) == 1 && WHOLE(c, INFLECTION) == 0 && c.degree == 3 && c.margin == 0);
    CHECK_NEAR(c.specials[0].t, 0.5, 0);
    end_census(&c);
    census_of(4, cube, fourth, &c);
    CHECK(SEGMENT(c, PAUSE) == 1 && WHOLE(c, CUSP) == 0 && WHOLE(c, INFLECTION) == 0);
    CHECK(c.is_complete);
    end_census(&c);
}

TEST(a_flat_place_without_a_change_of_side_is_an_undulation)
{
    const double x[5] = {0, 1, 0, 0, 0}, y[5] = {0, 0, 0, 0, 1};
    batten_census c;
    census_of(4, x, y, &c);
    CHECK(SEGMENT(c, UNDULATION) == 1 && WHOLE(c, INFLECTION) == 0 && c.is_complete);
    CHECK_INT(c.specials[0].multiplicity, 2);
    CHECK_INT(c.infinite_count, 3);
    end_census(&c);
}

TEST(a_curve_that_is_passed_twice_says_so)
{
    const double x[5] = {0, 0, 1, 0, 0}, y[5] = {0, 0, 0, 0, 1};
    batten_census c;
    census_of(4, x, y, &c);
    CHECK(c.is_repeated && !c.is_complete);
    CHECK_INT(SEGMENT(c, CUSP), 1); /* where it turns back on itself */
    CHECK_INT(WHOLE(c, CROSSING), 0);
    end_census(&c);
}

TEST(lines_and_points_are_told_from_curves)
{
    const double turning[4] = {0, -3, 0, 1}, still[4] = {5, 0, 0, 0};
    batten_census c;
    census_of(3, turning, turning, &c);
    CHECK_INT(c.flat_dimension, 1);
    CHECK_INT(SEGMENT(c, CUSP), 2);
    end_census(&c);
    census_of(3, still, still, &c);
    CHECK(c.flat_dimension == 0 && c.degree == 0 && c.count == 0);
    end_census(&c);
    CHECK_OK(batten_census_take(2, 1, (const double[]){0, 0, 3, 1}, 0, &c));
    CHECK(c.flat_dimension == 1 && c.count == 0 && c.degree == 1);
    end_census(&c);
    CHECK_OK(batten_census_take(2, 2, (const double[]){0, 0, 1, 1, 2, 0}, 0, &c));
    CHECK(c.flat_dimension == 2 && c.count == 0 && c.is_complete && c.margin == 1);
    end_census(&c);
}

TEST(lines_that_rounding_hides_from_a_small_tolerance_are_lines)
{
    test_random random = test_random_begin("lines");
    for (int n = test_cases(100); n > 0; n--) {
        double points[12];
        batten_census c;
        for (int i = 0; i < 6; i++) { /* y = 3 x exactly, with all bits in use */
            points[2 * i] = (double)(test_random_bits(&random) >> 13) * 0x1p-51;
            points[2 * i + 1] = 3 * points[2 * i];
        }
        CHECK_OK(batten_census_take(2, 5, points, 1e-300, &c));
        CHECK_INT(c.flat_dimension, 1);
        CHECK_INT(WHOLE(c, INFLECTION), 0);
        end_census(&c);
    }
}

TEST(a_plane_of_space_has_the_census_of_the_plane)
{
    test_random random = test_random_begin("space");
    for (int n = test_cases(100); n > 0; n--) {
        double flat[12], tilted[18];
        batten_census a, b;
        random_points(&random, 5, true, flat);
        for (int i = 0; i < 6; i++) {
            tilted[3 * i] = flat[2 * i];
            tilted[3 * i + 1] = flat[2 * i] - 3 * flat[2 * i + 1];
            tilted[3 * i + 2] = flat[2 * i + 1] + 7;
        }
        CHECK_OK(batten_census_take(2, 5, flat, 0, &a));
        CHECK_OK(batten_census_take(3, 5, tilted, n % 2 ? 0 : 1e-12, &b));
        CHECK_INT(b.flat_dimension, a.flat_dimension);
        for (int k = 0; k < BATTEN_SPECIAL_COUNT; k++)
            CHECK_INT(b.segment[k], a.segment[k]);
        end_census(&b);
        tilted[4] += 1e-3;
        CHECK_OK(batten_census_take(3, 5, tilted, n % 2 ? 0 : 1e-12, &b));
        CHECK(b.flat_dimension == 3 || a.flat_dimension < 2);
        end_census(&a);
        end_census(&b);
    }
}

TEST(what_elimination_cannot_reach_is_searched_and_called_incomplete)
{
    test_random random = test_random_begin("high");
    double points[2 * (BATTEN_MAX_DEGREE + 1)];
    batten_census c;
    for (int i = 0; i < COUNT(points); i++)
        points[i] = test_random_in(&random, -1, 1);
    CHECK_OK(batten_census_take(2, BATTEN_MAX_DEGREE, points, 0, &c));
    CHECK(!c.is_complete && !c.is_repeated);
    CHECK_INT(SEGMENT(c, INFLECTION), searched_inflections(BATTEN_MAX_DEGREE, points));
    CHECK_INT(SEGMENT(c, CROSSING), searched_crossings(BATTEN_MAX_DEGREE, points, MANY));
    end_census(&c);
}

TEST(spans_of_a_curve_have_its_parameters)
{
    const double points[14] = {0, 0, 1, 2, 3, -2, 4, 1, 5, 3, 7, -2, 8, 0};
    const double knots[12] = {2, 2, 2, 2, 2, 3, 6, 7, 7, 7, 7, 7};
    batten_curve *curve = NULL;
    batten_censuses spans = {0, NULL};
    batten_parameters at_turns = {0, NULL};
    int seen = 0;
    CHECK_OK(batten_curve_create((batten_points){2, 7, points}, 4, NULL, knots, &curve));
    CHECK_OK(batten_curve_census(curve, 1e-9, &spans));
    CHECK_OK(batten_curve_inflections(curve, &at_turns));
    CHECK_INT(spans.count, 3);
    for (int i = 0; i < spans.count; i++)
        for (int k = 0; k < spans.at[i].count; k++) {
            const batten_special *s = &spans.at[i].specials[k];
            if (s->kind != BATTEN_SPECIAL_INFLECTION || !s->inside)
                continue;
            CHECK(s->t > spans.at[i].from && s->t < spans.at[i].to && seen < at_turns.count);
            CHECK_NEAR(s->t, at_turns.at[seen++], 1e-10);
        }
    CHECK_INT(seen, at_turns.count);
    batten_release(at_turns.at);
    batten_censuses_release(&spans);
    batten_curve_unref(curve);
}

/* ---- bad input ---- */

TEST(n1_spans_that_are_not_finite_are_refused)
{
    batten_census c;
    CHECK_STATUS(batten_census_take(2, 2, (const double[]){0, 0, 1, NAN, 2, 0}, 0, &c),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 2");
}

TEST(n2_spans_of_any_size_are_counted_and_of_too_many_sizes_refused)
{
    const double points[12] = {0, 0, 3, 1, -2, 5, 1, 7, 4, 4, 2, 0};
    const double sizes[] = {1e-300, 1, 1e300};
    batten_census first, c;
    CHECK_OK(batten_census_take(2, 5, points, 0, &first));
    for (int i = 0; i < COUNT(sizes); i++) {
        double scaled[12];
        for (int k = 0; k < 12; k++)
            scaled[k] = points[k] * sizes[i];
        CHECK_OK(batten_census_take(2, 5, scaled, 1e-12, &c));
        CHECK_INT(WHOLE(c, CROSSING), WHOLE(first, CROSSING));
        CHECK_INT(WHOLE(c, INFLECTION), WHOLE(first, INFLECTION));
        end_census(&c);
    }
    end_census(&first);
    CHECK_STATUS(batten_census_take(2, 2, (const double[]){0, 0, 1e-200, 1, 1, 0}, 0, &c),
                 BATTEN_INCOMPLETE);
    CHECK_MESSAGE("coordinates 1 have ");
}

TEST(n2_the_smallest_numbers_of_a_high_degree_take_no_longer)
{
    double points[2 * 19];
    batten_census c;
    for (int i = 0; i < COUNT(points); i++)
        points[i] = ldexp((i * 7) % 11 + 1, -1074);
    CHECK_OK(batten_census_take(2, 18, points, 1e-9, &c));
    CHECK(!c.is_complete && SEGMENT(c, INFLECTION) > 0);
    end_census(&c);
}

TEST(n6_arguments_outside_their_range_are_refused)
{
    const double points[8] = {0, 0, 1, 1, 0, 1, 1, 0};
    batten_census c;
    CHECK_STATUS(batten_census_take(1, 3, points, 0, &c), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_census_take(2, 3, points, -1, &c), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_census_take(2, 3, points, NAN, &c), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_census_take(2, 0, points, 0, &c), BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_census_take(2, 26, points, 0, &c), BATTEN_BAD_DEGREE);
}

TEST(rational_curves_are_refused)
{
    batten_curve *arc = NULL;
    batten_censuses spans = {0, NULL};
    CHECK_OK(batten_curve_arc(1, 1, &arc));
    CHECK_STATUS(batten_curve_census(arc, 0, &spans), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("rational");
    batten_curve_unref(arc);
}

TEST(special_points_have_names_for_one_and_for_many)
{
    static const char *const names[][2] = {{"inflection", "inflections"},
                                           {"undulation", "undulations"},
                                           {"cusp", "cusps"},
                                           {"pause", "pauses"},
                                           {"crossing", "crossings"},
                                           {"isolated point", "isolated points"},
                                           {"unknown", "unknown"}};
    for (int kind = 0; kind <= BATTEN_SPECIAL_COUNT; kind++)
        for (int plural = 0; plural < 2; plural++)
            CHECK_TEXT(batten_special_name((batten_special_kind)kind, plural),
                       names[kind][plural]);
}
