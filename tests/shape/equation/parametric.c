#include <batten/standard.h>

#include "support/test.h"

static const char *const variable[] = {"t"};
static const batten_equation_names names = {1, 0, variable, NULL};

typedef struct {
    const char *text[3];
    double a, b, tolerance;
    batten_status status;
    int corners, halts;
    const char *says;
} row;

static const row rows[] = {
    {{"5*cos(t)", "5*sin(t)", "t/5"}, 0, 30, 1e-6, BATTEN_OK, 0, 0, NULL},
    {{"4*t^3+10*t^2-30*t+2", "-30*t^2-10*t+10"}, -5, 5, 1e-9, BATTEN_OK, 0, 0, NULL},
    {{"t*sin(t/2)", "t", "3+t*cos(t/2)"}, -6, 6, 1e-8, BATTEN_OK, 0, 0, NULL},
    {{"t", "sqrt(1-t^2)"}, -1, 1, 1e-6, BATTEN_OK, 2, 0, NULL},
    {{"t", "abs(t)"}, -1, 1, 1e-9, BATTEN_OK, 1, 0, NULL},
    {{"t", "max(t, 0.3) + exp(t)"}, -1, 1.3, 1e-7, BATTEN_OK, 1, 0, NULL},
    {{"t - sin(t)", "1 - cos(t)"}, 1, 20, 1e-6, BATTEN_OK, 0, 3, NULL},
    {{"t^2", "t^3"}, -1, 1.5, 1e-9, BATTEN_OK, 0, 1, NULL},
    {{"t", "tanh(5*t)*asin(t/2)+atan(3*t)"}, -1, 1, 1e-10, BATTEN_OK, 0, 0, NULL},
    {{"t", "1/t"}, -1, 1.3, 1e-6, BATTEN_OUT_OF_DOMAIN, 0, 0, "no finite value"},
    {{"t", "1/(t^2-2)"},
     1,
     2,
     1e-6,
     BATTEN_OUT_OF_DOMAIN,
     0,
     0,
     "no finite value, or a jump, at 1.414"},
    {{"t", "1/t"},
     0,
     1,
     1e-6,
     BATTEN_OUT_OF_DOMAIN,
     0,
     0,
     "there is no finite value at 0; take ranges that end before it"},
    {{"t", "ln(t)"},
     -2,
     -1,
     1e-6,
     BATTEN_OUT_OF_DOMAIN,
     0,
     0,
     "there is no value between -2 and -1; take a range without it"},
    {{"t", "1e9*cos(t)"},
     0,
     9,
     1e-9,
     BATTEN_TOLERANCE_NOT_MET,
     0,
     0,
     "more than the tolerance"},
    {{"t", "t"}, 1, 1, 1e-9, BATTEN_BAD_ARGUMENT, 0, 0, "the range from 1 to 1 is empty"},
    {{"t", "t"}, 0, 1, 0, BATTEN_BAD_ARGUMENT, 0, 0, "the tolerance must be above 0"},
    {{"t", "t"}, 0, INFINITY, 1, BATTEN_NOT_FINITE, 0, 0, "not finite"},
};

static int count_kind(const batten_equation_curves *made, batten_equation_point_kind kind)
{
    int count = 0;
    for (int i = 0; i < made->point_count; i++)
        count += made->points[i].kind == kind;
    return count;
}

/* The largest distance at equal parameters, of many. */
static double measured(const row *r, int dimension, batten_equation *const *read,
                       const batten_curve *curve)
{
    enum { SAMPLES = 20000 };
    double worst = 0, p[3], value;
    for (int i = 0; i <= SAMPLES; i++) {
        const double t = i == SAMPLES ? r->b : r->a + (r->b - r->a) * i / SAMPLES;
        double sum = 0;
        CHECK_OK(batten_curve_evaluate(curve, t, 0, p));
        for (int k = 0; k < dimension; k++) {
            CHECK_OK(batten_equation_value(read[k], &t, &value, NULL));
            sum += (p[k] - value) * (p[k] - value);
        }
        worst = fmax(worst, sqrt(sum));
    }
    return worst;
}

static void check_row(const row *r)
{
    batten_equation *read[3] = {NULL, NULL, NULL};
    batten_equation_curves made = {0};
    int dimension = 0;
    for (; dimension < 3 && r->text[dimension]; dimension++)
        CHECK_OK(batten_equation_read(r->text[dimension], &names, &read[dimension]));
    CHECK_STATUS(batten_curve_parametric(dimension, (const batten_equation *const *)read,
                                         (batten_interval){r->a, r->b}, r->tolerance, NULL,
                                         &made),
                 r->status);
    if (r->status == BATTEN_OK) {
        CHECK_INT(made.count, 1);
        CHECK(made.error <= r->tolerance);
        CHECK(measured(r, dimension, read, made.curves[0]) <= made.error);
        CHECK_INT(count_kind(&made, BATTEN_EQUATION_CORNER), r->corners);
        CHECK_INT(count_kind(&made, BATTEN_EQUATION_HALT), r->halts);
    } else {
        CHECK_MESSAGE(r->says);
    }
    batten_equation_curves_release(&made);
    for (int k = 0; k < 3; k++)
        batten_equation_free(read[k]);
}

TEST(curves_are_within_the_error_that_was_proved_or_refused_with_the_place)
{
    for (int i = 0; i < COUNT(rows); i++)
        check_row(&rows[i]);
}

TEST(polynomials_of_degree_5_are_one_piece)
{
    batten_equation *read[2] = {NULL, NULL};
    batten_equation_curves made = {0};
    CHECK_OK(batten_equation_read("t", &names, &read[0]));
    CHECK_OK(batten_equation_read("t^5 - 3*t^2 + 1/4", &names, &read[1]));
    CHECK_OK(batten_curve_parametric(2, (const batten_equation *const *)read,
                                     (batten_interval){-1, 2}, 1e-12, NULL, &made));
    CHECK_INT(batten_curve_point_count(made.curves[0]), 6);
    CHECK(made.error < 1e-12);
    batten_equation_curves_release(&made);
    batten_equation_free(read[0]);
    batten_equation_free(read[1]);
}

TEST(quintics_join_with_two_derivatives)
{
    batten_equation *read[2] = {NULL, NULL};
    batten_equation_curves made = {0};
    CHECK_OK(batten_equation_read("cos(3*t)", &names, &read[0]));
    CHECK_OK(batten_equation_read("exp(-t)", &names, &read[1]));
    CHECK_OK(batten_curve_parametric(2, (const batten_equation *const *)read,
                                     (batten_interval){0, 4}, 1e-8, NULL, &made));
    const int count = batten_curve_point_count(made.curves[0]);
    const double *knots = batten_curve_knots(made.curves[0]);
    for (int i = 6; i + 3 < count; i++)
        CHECK(knots[i] < knots[i + 3]);
    batten_equation_curves_release(&made);
    batten_equation_free(read[0]);
    batten_equation_free(read[1]);
}

/* t^6 less its quintic is (t - a)^3 (t - b)^3, at most half the length to the sixth; a chord over a corner
 * is as far off as its box is wide, at most. */
static const struct {
    const char *text[3];
    batten_interval range;
    double tolerance, error;
} bounds[] = {
    {{"t^6"}, {0, 1}, 0.02, 1.0 / 64},
    {{"t^6", "t"}, {-1, 1}, 1.01, 1},
    {{"t^6", "2*t^6", "t"}, {0, 1}, 0.04, 0.03493856214843422},
    {{"t", "abs(t)"}, {-1, 1}, 3, 2.23606797749979},
    {{"3*t", "abs(t)", "4*t"}, {-1, 1}, 11, 10.04987562112089},
};

TEST(the_error_of_a_piece_is_what_its_sixth_derivative_leaves_or_the_box_of_a_chord)
{
    for (int i = 0; i < COUNT(bounds); i++) {
        batten_equation *read[3] = {NULL, NULL, NULL};
        batten_equation_curves made = {0};
        int count = 0;
        for (; count < 3 && bounds[i].text[count]; count++)
            CHECK_OK(batten_equation_read(bounds[i].text[count], &names, &read[count]));
        CHECK_OK(batten_curve_parametric(count, (const batten_equation *const *)read,
                                         bounds[i].range, bounds[i].tolerance, NULL, &made));
        CHECK_INT(batten_curve_point_count(made.curves[0]), 6);
        CHECK_NEAR(made.error, bounds[i].error, 1e-13);
        CHECK_INT(made.boxes, 1);
        batten_equation_curves_release(&made);
        for (int k = 0; k < 3; k++)
            batten_equation_free(read[k]);
    }
}

/* What is special, and where. */
static const struct {
    const char *text[2];
    batten_interval range;
    double tolerance;
    int count;
    struct {
        batten_equation_point_kind kind;
        double at, x, y;
    } point[3];
} specials[] = {
    {{"t", "abs(t - 0.3)"}, {-1, 1}, 1e-6, 1, {{BATTEN_EQUATION_CORNER, 0.3, 0.3, 0}}},
    {{"t", "abs(t - 0.3)"}, {-1, 1}, 9, 1, {{BATTEN_EQUATION_CORNER, 0.3, 0.3, 0}}},
    {{"t", "max(t, 0)"}, {-1, 1}, 1e-6, 1, {{BATTEN_EQUATION_CORNER, 0, 0, 0}}},
    {{"t", "sqrt(1 - t^2)"},
     {-1, 1},
     1e-6,
     2,
     {{BATTEN_EQUATION_CORNER, -1, -1, 0}, {BATTEN_EQUATION_CORNER, 1, 1, 0}}},
    {{"t^2", "t^3"}, {-1, 1.5}, 1e-6, 1, {{BATTEN_EQUATION_HALT, 0, 0, 0}}},
    {{"t - sin(t)", "1 - cos(t)"},
     {1, 20},
     1e-6,
     3,
     {{BATTEN_EQUATION_HALT, 6.283185307179586, 6.283185307179586, 0},
      {BATTEN_EQUATION_HALT, 12.566370614359172, 12.566370614359172, 0},
      {BATTEN_EQUATION_HALT, 18.84955592153876, 18.84955592153876, 0}}},
    {{"t^2", "1"}, {0, 1}, 1e-6, 1, {{BATTEN_EQUATION_HALT, 0, 0, 1}}},
    {{"t^2 - 2*t", "1"}, {0, 1}, 1e-6, 1, {{BATTEN_EQUATION_HALT, 1, -1, 1}}},
};

TEST(corners_and_halts_have_their_parameters_and_places)
{
    for (int i = 0; i < COUNT(specials); i++) {
        batten_equation *read[2] = {NULL, NULL};
        batten_equation_curves made = {0};
        for (int k = 0; k < 2; k++)
            CHECK_OK(batten_equation_read(specials[i].text[k], &names, &read[k]));
        CHECK_OK(batten_curve_parametric(2, (const batten_equation *const *)read,
                                         specials[i].range, specials[i].tolerance, NULL,
                                         &made));
        CHECK_INT(made.point_count, specials[i].count);
        for (int k = 0; k < made.point_count; k++) {
            CHECK_INT(made.points[k].kind, specials[i].point[k].kind);
            CHECK_NEAR(made.points[k].parameter, specials[i].point[k].at, 2e-6);
            CHECK_NEAR(made.points[k].point.x, specials[i].point[k].x, 2e-6);
            CHECK_NEAR(made.points[k].point.y, specials[i].point[k].y, 2e-3);
            CHECK(made.points[k].point.z == 0 && made.points[k].branches == 0);
        }
        batten_equation_curves_release(&made);
        batten_equation_free(read[0]);
        batten_equation_free(read[1]);
    }
}

/* The largest fraction so far; falls and what is beyond 1 are counted. */
typedef struct {
    double last;
    int calls, wrong;
} seen;

static void see(void *user, double fraction, const char *what)
{
    seen *s = user;
    s->calls++;
    s->wrong +=
        !(fraction >= s->last && fraction <= 1) || strcmp(what, "curve of equations") != 0;
    s->last = fraction;
}

TEST(progress_rises_to_1_and_a_limit_of_work_or_pieces_ends_the_curve)
{
    batten_equation *read = NULL;
    batten_equation_curves made = {0};
    batten_job job = BATTEN_JOB;
    seen s = {0, 0, 0};
    job.progress = see;
    job.user = &s;
    CHECK_OK(batten_equation_read("sin(t)", &names, &read));
    const batten_equation *const one[] = {read};
    CHECK_OK(batten_curve_parametric(1, one, (batten_interval){3, 13}, 1e-9, &job, &made));
    CHECK(s.wrong == 0 && s.last == 1 && s.calls == made.boxes);
    batten_equation_curves_release(&made);
    job.work_limit = 2;
    CHECK_STATUS(batten_curve_parametric(1, one, (batten_interval){3, 13}, 1e-9, &job, &made),
                 BATTEN_INCOMPLETE);
    CHECK(made.count == 0 && !made.curves);
    CHECK_STATUS(batten_curve_parametric(1, one, (batten_interval){0, 1e6}, 1e-3, NULL, &made),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("more than 20000 pieces; 0.001 is too fine, or the curve winds too often");
    batten_equation_free(read);
}

TEST(coordinates_ranges_and_tolerances_are_checked_with_their_numbers)
{
    static const char *const two[] = {"t", "s"};
    const batten_equation_names plane = {2, 0, two, NULL};
    batten_equation *one = NULL, *both = NULL;
    batten_equation_curves made = {0};
    CHECK_OK(batten_equation_read("t", &names, &one));
    CHECK_OK(batten_equation_read("t*s", &plane, &both));
    const batten_equation *const mixed[] = {one, both, one, one};
    const struct {
        int dimension;
        batten_interval range;
        double tolerance;
        batten_status status;
        const char *says;
    } refused[] = {
        {0, {0, 1}, 1, BATTEN_BAD_ARGUMENT, "0 coordinates; a curve has 1 to 3"},
        {4, {0, 1}, 1, BATTEN_BAD_ARGUMENT, "4 coordinates; a curve has 1 to 3"},
        {2, {0, 1}, 1, BATTEN_BAD_ARGUMENT, "coordinate 2 has 2 variables, expected 1"},
        {1, {NAN, 1}, 1, BATTEN_NOT_FINITE, "the range or the tolerance is not finite"},
        {1, {0, 1}, INFINITY, BATTEN_NOT_FINITE, "the range or the tolerance is not finite"},
        {1, {2, 1}, 1, BATTEN_BAD_ARGUMENT, "the range from 2 to 1 is empty"},
        {1, {0, 1}, -1, BATTEN_BAD_ARGUMENT, "the tolerance must be above 0, not -1"},
    };
    for (int i = 0; i < COUNT(refused); i++) {
        CHECK_STATUS(batten_curve_parametric(refused[i].dimension, mixed, refused[i].range,
                                             refused[i].tolerance, NULL, &made),
                     refused[i].status);
        CHECK_MESSAGE(refused[i].says);
    }
    batten_equation_free(one);
    batten_equation_free(both);
}
