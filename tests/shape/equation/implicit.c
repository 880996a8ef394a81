#include <batten/contours.h>

#include "support/test.h"

static const char *const variables[] = {"x", "y", "z"};

/* Curves with known lengths, points and pieces, in a box of half its size. */
typedef struct {
    const char *text[2];
    double half, tolerance;
    int curves, nodes, isolated, singular;
    double length; /* of all; 0: not known */
    int corners;
} row;

static const row rows[] = {
    {{"x^2 + y^2 = 1"}, 2, 1e-6, 1, 0, 0, 0, 6.283185307179586, 0},
    {{"x^2 + y^2 = 1"}, 1, 1e-6, 1, 0, 0, 0, 6.283185307179586, 0},
    {{"x^2/4 + y^2 = 1"}, 3, 1e-9, 1, 0, 0, 0, 9.688448220547675, 0},
    {{"x*y = 1"}, 2, 1e-6, 2, 0, 0, 0, 0, 0},
    {{"x = 0.5"}, 1, 1e-6, 1, 0, 0, 0, 2, 0},
    {{"x + y = 3"}, 1, 1e-6, 0, 0, 0, 0, 0, 0},
    {{"(x^2+y^2)^2 = 2*(x^2-y^2)"}, 2, 1e-8, 1, 1, 0, 0, 7.416298709205487, 0},
    {{"(x^2+y^2)^2 - 2*(x^2-y^2) = -0.1"}, 2, 1e-6, 2, 0, 0, 0, 0, 0},
    {{"(x^2+y^2)^2 - 2*(x^2-y^2) = 0.1"}, 2, 1e-6, 1, 0, 0, 0, 0, 0},
    {{"x^3 + y^3 = 3*x*y"}, 3, 1e-6, 1, 1, 0, 0, 0, 0},
    {{"y^2 = x^3"}, 2, 1e-6, 1, 0, 0, 1, 5.19990706349899, 0},
    {{"x^2 + y^2 = 0"}, 2, 1e-6, 0, 0, 1, 0, 0, 0},
    {{"(x-0.3)^2 + (y-0.2)^2 = 1e-8"}, 2, 1e-6, 1, 0, 0, 0, 0, 0},
    {{"x*y*(x-y) = 0"}, 2, 1e-6, 3, 1, 0, 0, 13.65685424949238, 0},
    {{"exp(x*y) = sin(3*x) + cos(5*y)"}, 2, 1e-6, 7, 0, 0, 0, 0, 0},
    {{"abs(x) + abs(y) = 1"}, 2, 1e-6, 1, 0, 0, 0, 0, 4},
    {{"y = abs(x)"}, 1, 1e-6, 1, 0, 0, 0, 2.8284271247461903, 1},
    {{"x^2 + 2.5*x*(y-0.5) + (y-0.5)^2 = 0"}, 1, 1e-6, 2, 1, 0, 0, 4.47213595499958, 0},
    {{"x^2 + y^2 = -1"}, 2, 1e-6, 0, 0, 0, 0, 0, 0},
    {{"x^2 + y^2 + z^2 = 4", "(x-1)^2 + y^2 = 1"}, 2, 1e-6, 1, 1, 0, 0, 15.28079129, 0},
    {{"x^2 + y^2 + z^2 = 1", "z = 0"}, 2, 1e-8, 1, 0, 0, 0, 6.283185307179586, 0},
    {{"x^2 + y^2 + z^2 = 1", "z = x*y"}, 2, 1e-6, 1, 0, 0, 0, 0, 0},
    {{"x^2 + y^2 = 1", "z = 3"}, 2, 1e-6, 0, 0, 0, 0, 0, 0},
};

typedef struct {
    batten_equation *read[2];
    int count;
    batten_equation_curves made;
} traced;

static batten_status trace(const row *r, traced *t)
{
    *t = (traced){.count = r->text[1] ? 2 : 1};
    const batten_equation_names names = {t->count + 1, 0, variables, NULL};
    const batten_box box = {{-r->half, -r->half, -r->half}, {r->half, r->half, r->half}};
    for (int i = 0; i < t->count; i++)
        CHECK_OK(batten_equation_read(r->text[i], &names, &t->read[i]));
    batten_status status = batten_curves_implicit(
        t->count, (const batten_equation *const *)t->read, &box, r->tolerance, NULL, &t->made);
    if (status == BATTEN_OUT_OF_MEMORY)
        status = batten_curves_implicit(t->count, (const batten_equation *const *)t->read, &box,
                                        r->tolerance, NULL, &t->made);
    return status;
}

static void end_trace(traced *t)
{
    batten_equation_curves_release(&t->made);
    batten_equation_free(t->read[0]);
    batten_equation_free(t->read[1]);
}

/* The length by chords; how large the equations become along them, at most. */
static double length_of(const traced *t, double *largest)
{
    enum { SAMPLES = 4000 };
    double length = 0, before[3], p[3] = {0, 0, 0}, value;
    for (int c = 0; c < t->made.count; c++) {
        const batten_interval domain = batten_curve_domain(t->made.curves[c]);
        for (int i = 0; i <= SAMPLES; i++) {
            const double u = domain.a + (domain.b - domain.a) * i / SAMPLES;
            CHECK_OK(batten_curve_evaluate(t->made.curves[c], fmin(u, domain.b), 0, p));
            for (int k = 0; k < t->count; k++) {
                CHECK_OK(batten_equation_value(t->read[k], p, &value, NULL));
                *largest = fmax(*largest, fabs(value));
            }
            double sum = 0;
            for (int k = 0; k <= t->count; k++)
                sum += (p[k] - before[k]) * (p[k] - before[k]) * (i > 0 ? 1 : 0);
            length += sqrt(sum);
            for (int k = 0; k <= t->count; k++)
                before[k] = p[k];
        }
    }
    return length;
}

static void check_row(const row *r)
{
    traced t;
    int kinds[5] = {0, 0, 0, 0, 0};
    double largest = 0;
    CHECK_OK(trace(r, &t));
    CHECK_INT(t.made.count, r->curves);
    CHECK(t.made.error <= r->tolerance);
    CHECK_INT(t.made.undecided_count, 0);
    for (int i = 0; i < t.made.point_count; i++) {
        const batten_equation_point *point = &t.made.points[i];
        kinds[point->kind]++;
        CHECK(point->parameter == 0); /* these curves have none */
        CHECK(point->kind == BATTEN_EQUATION_ISOLATED ? point->branches == 0
                                                      : point->branches >= 2);
    }
    CHECK_INT(kinds[BATTEN_EQUATION_CORNER], r->corners);
    CHECK_INT(kinds[BATTEN_EQUATION_NODE], r->nodes);
    CHECK_INT(kinds[BATTEN_EQUATION_ISOLATED], r->isolated);
    CHECK_INT(kinds[BATTEN_EQUATION_SINGULAR], r->singular);
    const double length = length_of(&t, &largest);
    /* Chords lose (length / samples)^2 of curvature; the gradients of all rows are below 100. */
    if (r->length > 0)
        CHECK_NEAR(length, r->length, 2e-5 * r->length);
    CHECK(largest <= 100 * r->tolerance);
    end_trace(&t);
}

TEST(known_curves_come_with_all_their_branches_loops_and_singular_points)
{
    for (int i = 0; i < COUNT(rows); i++)
        check_row(&rows[i]);
}

TEST(closed_branches_end_where_they_begin)
{
    traced t;
    double p[2], q[2];
    CHECK_OK(trace(&rows[0], &t));
    const batten_interval domain = batten_curve_domain(t.made.curves[0]);
    CHECK_OK(batten_curve_evaluate(t.made.curves[0], domain.a, 0, p));
    CHECK_OK(batten_curve_evaluate(t.made.curves[0], domain.b, 0, q));
    CHECK(p[0] == q[0] && p[1] == q[1]);
    end_trace(&t);
}

TEST(squares_poles_and_branches_that_touch_are_incomplete_with_their_boxes)
{
    static const row incomplete[] = {
        {{"(x-y)^2 = 0"}, 2, 1e-4, 0, 0, 0, 0, 0, 0},
        {{"y = 1/x"}, 2, 1e-4, 2, 0, 0, 0, 0, 0},
        {{"(x^2+y^2)^3 = 4*x^2*y^2"}, 2, 1e-6, 0, 0, 0, 0, 0, 0},
    };
    for (int i = 0; i < COUNT(incomplete); i++) {
        traced t;
        CHECK_STATUS(trace(&incomplete[i], &t), BATTEN_INCOMPLETE);
        CHECK(t.made.undecided_count > 0);
        CHECK_MESSAGE("boxes are undecided after");
        end_trace(&t);
    }
}

/* Of a double line each box holds a part; of a pole the line x = 0. */
TEST(undecided_boxes_hold_what_is_undecided_and_the_message_counts_them_and_says_why)
{
    static const struct {
        row of;
        const char *why;
    } rest[] = {
        {{{"(x-y)^2 = 0"}, 2, 1e-2, 0, 0, 0, 0, 0, 0},
         "where the derivatives vanish along a line (a square?) or branches touch; 0 branches"},
        {{{"y = 1/x"}, 2, 1e-2, 2, 0, 0, 0, 0, 0},
         "where there is a pole, a corner or no value; "},
    };
    for (int i = 0; i < COUNT(rest); i++) {
        traced t;
        char counts[160];
        CHECK_STATUS(trace(&rest[i].of, &t), BATTEN_INCOMPLETE);
        CHECK_MESSAGE(rest[i].why);
        const batten_box *first = t.made.undecided;
        snprintf(
            counts, sizeof counts,
            "%d boxes are undecided after %d were examined, the first at (%.6g, %.6g, 0), where",
            t.made.undecided_count, t.made.boxes, first->low.x, first->low.y);
        CHECK_MESSAGE(counts);
        CHECK_INT(t.made.count, rest[i].of.curves);
        for (int k = 0; k < t.made.undecided_count; k++) {
            const batten_box *box = &t.made.undecided[k];
            const double low = i ? box->low.x : box->low.x - box->high.y;
            const double high = i ? box->high.x : box->high.x - box->low.y;
            CHECK(low <= 0.01 && high >= -0.01);
            CHECK(box->high.x - box->low.x < 0.01 && box->high.y - box->low.y < 0.01);
            CHECK(box->low.z == 0 && box->high.z == 0);
        }
        end_trace(&t);
    }
}

TEST(curves_reach_beyond_the_box_by_less_than_half_the_tolerance)
{
    const row line = {{"y = 0.5*x"}, 1, 1e-3, 1, 0, 0, 0, 0, 0};
    traced t;
    CHECK_OK(trace(&line, &t));
    const batten_curve *curve = t.made.curves[0];
    const double *points = batten_curve_points(curve);
    const int last = batten_curve_point_count(curve) - 1;
    CHECK_INT(last, 3);
    CHECK(fabs(points[0]) > 1 && fabs(points[0]) < 1.0005);
    CHECK_NEAR(points[0], -points[2 * last], 1e-15);
    CHECK(t.made.error >= 0 && t.made.error < 1e-14);
    end_trace(&t);
}

TEST(boxes_tolerances_and_numbers_of_variables_are_checked)
{
    batten_equation *plane = NULL;
    batten_equation_curves made = {0};
    const batten_equation_names names = {2, 0, variables, NULL};
    const batten_box good = {{0, 0, 0}, {1, 1, 1}}, flat = {{0, 0.5, 0}, {1, 0.25, 1}},
                     endless = {{0, 0, 0}, {1, HUGE_VAL, 1}};
    CHECK_OK(batten_equation_read("x + y", &names, &plane));
    const batten_equation *const two[] = {plane, plane};
    CHECK_STATUS(batten_curves_implicit(2, two, &good, 1e-6, NULL, &made), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("equation 1 has 2 variables, expected 3");
    CHECK_STATUS(batten_curves_implicit(1, two, &flat, 1e-6, NULL, &made), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the box is empty along y: 0.5 to 0.25");
    CHECK_STATUS(batten_curves_implicit(1, two, &endless, 1e-6, NULL, &made),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("the box is not finite");
    CHECK_STATUS(batten_curves_implicit(1, two, &good, HUGE_VAL, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance must be above 0, not inf");
    CHECK_STATUS(batten_curves_implicit(0, two, &good, 1e-6, NULL, &made), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("0 equations; a curve has one in the plane and two in space");
    CHECK_STATUS(batten_curves_implicit(1, two, &good, -1, NULL, &made), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curves_implicit(1, two, &good, 1e-15, NULL, &made),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("a tolerance of 1e-15 is below 1e-12 of the coordinates of the box, 1");
    CHECK_STATUS(batten_curves_implicit(3, two, &good, 1e-6, NULL, &made), BATTEN_BAD_ARGUMENT);
    batten_equation_free(plane);
}

/* f(p) = 0 at p: so far is a place of the curve from the circle, and so far the circle's places
 * from the curve, at most. */
TEST(coarse_curves_are_within_the_error_that_was_proved_too)
{
    static const double tolerances[] = {0.3, 0.1, 0.03, 0.01, 1e-4, 1e-7};
    for (int i = 0; i < COUNT(tolerances); i++) {
        const row circle = {{"x^2 + y^2 = 1"}, 2, tolerances[i], 1, 0, 0, 0, 0, 0};
        traced t;
        double worst = 0, p[2];
        CHECK_OK(trace(&circle, &t));
        CHECK(t.made.error <= tolerances[i]);
        const batten_interval domain = batten_curve_domain(t.made.curves[0]);
        for (int k = 0; k <= 3000; k++) {
            const double u = fmin(domain.a + (domain.b - domain.a) * k / 3000, domain.b);
            CHECK_OK(batten_curve_evaluate(t.made.curves[0], u, 0, p));
            worst = fmax(worst, fabs(hypot(p[0], p[1]) - 1));
        }
        CHECK(worst <= t.made.error);
        end_trace(&t);
    }
}

/* Where the four leaves of a node and the three lines through a point meet. */
TEST(points_where_branches_meet_are_named_with_their_place_and_their_branches)
{
    static const struct {
        row of;
        double x, y;
        batten_equation_point_kind kind;
        int branches;
    } at[] = {
        {{{"(x-0.3)*(y-0.2) = 0"}, 1, 1e-6, 0, 0, 0, 0, 0, 0},
         0.3,
         0.2,
         BATTEN_EQUATION_NODE,
         4},
        {{{"x*y*(x-y) = 0"}, 2, 1e-6, 0, 0, 0, 0, 0, 0}, 0, 0, BATTEN_EQUATION_NODE, 6},
        {{{"(y-0.1)^2 = (x-0.2)^3"}, 1, 1e-6, 0, 0, 0, 0, 0, 0},
         0.2,
         0.1,
         BATTEN_EQUATION_SINGULAR,
         2},
        {{{"(x+0.5)^2 + (y-0.5)^2 = 0"}, 1, 1e-6, 0, 0, 0, 0, 0, 0},
         -0.5,
         0.5,
         BATTEN_EQUATION_ISOLATED,
         0},
        {{{"x^2 + x*(y-0.5) + (y-0.5)^2 = 0"}, 1, 1e-6, 0, 0, 0, 0, 0, 0},
         0,
         0.5,
         BATTEN_EQUATION_ISOLATED,
         0},
        {{{"x^2 + 2.5*x*(y-0.5) + (y-0.5)^2 = 0"}, 1, 1e-6, 0, 0, 0, 0, 0, 0},
         0,
         0.5,
         BATTEN_EQUATION_NODE,
         4},
        {{{"y = abs(x-0.25)"}, 1, 1e-6, 0, 0, 0, 0, 0, 0}, 0.25, 0, BATTEN_EQUATION_CORNER, 2},
    };
    for (int i = 0; i < COUNT(at); i++) {
        traced t;
        CHECK_OK(trace(&at[i].of, &t));
        CHECK_INT(t.made.point_count, 1);
        CHECK_INT(t.made.points[0].kind, at[i].kind);
        CHECK_INT(t.made.points[0].branches, at[i].branches);
        CHECK_NEAR(t.made.points[0].point.x, at[i].x, 1e-6);
        CHECK_NEAR(t.made.points[0].point.y, at[i].y, 1e-6);
        CHECK(t.made.points[0].point.z == 0);
        end_trace(&t);
    }
}

/* Cubics with the circle's tangents at their ends miss it by about 2/27 (angle / 4)^6; the bound
 * that is proved is of the fourth order, so a hundredth of the tolerance asks for 3.2 times as many
 * pieces, or 4 times where they are halved. */
TEST(smooth_curves_have_few_pieces_with_common_tangents_and_corners_are_kept)
{
    static const double tolerances[] = {1e-4, 1e-6, 1e-8};
    int before = 0;
    for (int i = 0; i < COUNT(tolerances); i++) {
        const row circle = {{"x^2 + y^2 = 1"}, 2, tolerances[i], 1, 0, 0, 0, 0, 0};
        traced t;
        CHECK_OK(trace(&circle, &t));
        const batten_curve *curve = t.made.curves[0];
        const int pieces = batten_curve_spans(curve, NULL) - 1;
        const double angle = 4 * pow(13.5 * tolerances[i], 1.0 / 6);
        CHECK_INT(batten_curve_degree(curve), 3);
        CHECK_INT(batten_curve_point_count(curve), 2 * pieces + 2);
        CHECK(pieces >= 6.28 / angle && pieces <= (i > 0 ? 4 * before : 32));
        before = pieces;
        end_trace(&t);
    }
    const row bent = {{"y = abs(x)"}, 1, 1e-6, 1, 0, 0, 0, 0, 0};
    traced t;
    double left[4], right[4];
    CHECK_OK(trace(&bent, &t));
    const batten_curve *curve = t.made.curves[0];
    const int pieces = batten_curve_spans(curve, NULL) - 1;
    const batten_interval domain = batten_curve_domain(curve);
    CHECK_INT(batten_curve_point_count(curve), 3 * pieces + 1);
    const double quarter = (domain.b - domain.a) / 4;
    CHECK_OK(batten_curve_evaluate(curve, domain.a + quarter, 1, left));
    CHECK_OK(batten_curve_evaluate(curve, domain.b - quarter, 1, right));
    CHECK_NEAR(fabs(left[3] / left[2]), 1, 1e-6);
    CHECK_NEAR(left[3] / left[2], -right[3] / right[2], 2e-6);
    end_trace(&t);
}
