#include "design/expect.h"
#include "design/feature.h"
#include "support/test.h"

#include <batten/design.h>
#include <string.h>

/* Every method "points to curve" on the same hard rows: a finite curve that passes what it says
 * it passes, or a message; never a wrong curve called right. Catalogue K1-K4, G1-G4, N1-N3. */

static const struct {
    const char *name, *points;
    double size;
} rows[] = {
    {"one point", "[[1, 2]]", 2},
    {"two points", "[[0, 0], [3, 4]]", 4},
    {"three points", "[[0, 0], [1, 2], [2, 0]]", 2},
    {"a point twice", "[[0, 0], [1, 1], [1, 1], [2, 0], [3, 1]]", 3},
    {"one place only", "[[1, 1], [1, 1], [1, 1], [1, 1]]", 1},
    {"points in line", "[[0, 0], [1, 0], [2, 0], [4, 0], [5, 0]]", 5},
    {"there and back", "[[0, 0], [2, 0], [1, 0], [3, 0]]", 3},
    {"a zigzag", "[[0, 0], [1, 5], [2, 0], [3, 5]]", 5},
    {"uneven steps", "[[0, 0], [1e-9, 1e-9], [1, 2], [1.0000001, 2], [1e6, 0]]", 1e6},
    {"far from the origin", "[[1e9, 1e9], [1000000001, 1000000002], [1000000003, 1e9]]", 1e9},
    {"very small numbers", "[[0, 0], [1e-80, 2e-80], [3e-80, 2e-80], [4e-80, 0]]", 4e-80},
    {"very large numbers", "[[0, 0], [1e80, 2e80], [3e80, 2e80], [4e80, 0]]", 4e80},
    {"in space", "[[0, 0, 1], [1, 1, 0], [2, 0, 3], [3, 2, 1], [4, 0, 0]]", 4},
};

static batten_status evaluate(const char *operation, const char *points, bool closed,
                              batten_design **out)
{
    char text[1000];
    batten_design_free(*out); /* of a first call that found no memory */
    *out = NULL;
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n  p: {points: %s}\n  a: {%s: p%s}\n",
             points, operation, closed ? ", closed: yes" : "");
    batten_design_options options = batten_design_defaults();
    options.file_name = "through.yaml";
    batten_status status = batten_design_parse(text, strlen(text), &options, NULL, out);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(*out, "a", NULL, NULL);
    return status;
}

static void check_finite(const batten_curve *curve, const char *what)
{
    enum { SAMPLES = 32 };
    const batten_interval domain = batten_curve_domain(curve);
    for (int i = 0; i <= SAMPLES; i++) {
        double p[3] = {0, 0, 0};
        CHECK_OK(batten_curve_evaluate(
            curve, domain.a + (domain.b - domain.a) * ((double)i / SAMPLES), 0, p));
        if (!(isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2])))
            printf("%s\n", what);
        CHECK(isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]));
    }
}

/* To what all constructions verify: rounding of the largest coordinate. */
static void check_passes(const batten_object *object, double size, const char *what)
{
    for (int i = 0; object->parameters && i < object->point_count; i++) {
        double p[3];
        CHECK_OK(batten_curve_evaluate(object->curve, object->parameters[i], 0, p));
        for (int k = 0; k < 3; k++) {
            if (!(fabs(p[k] - object->points[3 * i + k]) <= 1e-10 * size))
                printf("%s: point %d\n", what, i);
            CHECK_NEAR(p[k], object->points[3 * i + k], 1e-10 * size);
        }
    }
}

static void try_method(const batten_feature *method, bool exact, int row, bool closed)
{
    char what[120];
    snprintf(what, sizeof what, "%s, %s%s", method->name, rows[row].name,
             closed ? ", closed" : "");
    batten_design *design = NULL;
    const batten_status status = evaluate(method->name, rows[row].points, closed, &design);
    if (status != BATTEN_OK && status != BATTEN_PARTLY_READ) {
        if (!*batten_message())
            printf("%s\n", what);
        CHECK(*batten_message());
    } else {
        const batten_model *model = batten_design_result(design, "a")->value;
        for (int i = 0; i < batten_model_count(model); i++) {
            const batten_object *object = batten_model_object(model, i);
            if (object->kind != BATTEN_OBJECT_CURVE)
                continue;
            check_finite(object->curve, what);
            if (exact)
                check_passes(object, rows[row].size, what);
        }
    }
    batten_design_free(design);
}

static bool takes(const batten_feature *method, const char *parameter)
{
    for (int k = 1; k < method->parameter_count; k++)
        if (strcmp(method->parameters[k].name, parameter) == 0)
            return true;
    return false;
}

static bool needs_more(const batten_feature *method)
{
    for (int k = 1; k < method->parameter_count; k++)
        if (method->parameters[k].required)
            return true;
    return false;
}

static void try_all(int row)
{
    static const char through[] = "Curves through points", near[] = "Curves near points";
    const int all = batten_feature_count(), most = test_cases(all);
    int tried = 0;
    for (int k = 0; k < all && tried < most; k++) {
        const int i = (k + 4 * row) % all;
        const batten_feature *method = batten_feature_at(i);
        const bool exact = strncmp(batten_feature_group(i), through, sizeof through - 1) == 0;
        if ((!exact && strcmp(batten_feature_group(i), near) != 0) || needs_more(method))
            continue;
        try_method(method, exact, row, false);
        if (takes(method, "closed"))
            try_method(method, exact, row, true);
        tried++;
    }
    CHECK(tried > 40 || tried == most);
}

#define ROW_OF_POINTS(n, name)                 \
    TEST(every_method_takes_or_refuses_##name) \
    {                                          \
        try_all(n);                            \
    }
ROW_OF_POINTS(0, one_point)
ROW_OF_POINTS(1, two_points)
ROW_OF_POINTS(2, three_points)
ROW_OF_POINTS(3, a_point_twice)
ROW_OF_POINTS(4, one_place_only)
ROW_OF_POINTS(5, points_in_line)
ROW_OF_POINTS(6, points_there_and_back)
ROW_OF_POINTS(7, a_zigzag)
ROW_OF_POINTS(8, uneven_steps)
ROW_OF_POINTS(9, points_far_from_the_origin)
ROW_OF_POINTS(10, very_small_numbers)
ROW_OF_POINTS(11, very_large_numbers)
ROW_OF_POINTS(12, points_in_space)

TEST(points_of_no_size_that_numbers_have_are_refused)
{
    static const char *const points[] = {"[[0, 0], [1e-300, 2e-300], [3e-300, 0]]",
                                         "[[0, 0], [1e300, 2e300], [3e300, 0]]"};
    for (int i = 0; i < COUNT(points); i++) {
        batten_design *design = NULL;
        CHECK_STATUS(evaluate("tension", points[i], false, &design), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("choose another unit");
        batten_design_free(design);
    }
}

/* ---- planes and functions ---- */

static const char of_planes[] =
    "  x: {points: [[7, 0, 1], [7, 1, 3], [7, 3, 2], [7, 4, 5], [7, 6, 4]]}\n"
    "  y: {points: [[0, 7, 1], [1, 7, 3], [3, 7, 2], [4, 7, 5], [6, 7, 4]]}\n"
    "  z: {points: [[0, 1, 7], [1, 3, 7], [3, 2, 7], [4, 5, 7], [6, 4, 7]]}\n"
    "  back: {points: [[0, 1], [2, 3], [1, 2]]}\n"
    "  twice: {points: [[0, 1], [2, 3], [2, 4]]}\n"
    "  skew: {points: [[0, 0, 0], [1, 0, 1], [2, 1, 0]]}\n";

static const expect_row placed[] = {
    {"{interpolate: @, as: function}", BATTEN_OK, "domain 0 6;passes;count 5"},
    {"{tension: @, as: function, amount: 2}", BATTEN_OK, "domain 0 6;spans 4;passes"},
    {"{biarcs: @}", BATTEN_OK, "passes"},
    {"{interpolate: @, periodic: yes}", BATTEN_OK, "closed 1;passes"},
};

TEST(plane_curves_and_functions_stand_in_the_plane_of_their_points)
{
    static const char *const names[] = {"x", "y", "z"};
    expect_each(of_planes, names, COUNT(names), placed, COUNT(placed));
}

TEST(points_that_are_no_function_or_in_no_plane_are_refused_with_their_numbers)
{
    static const expect_row refused[] = {
        {"{minimax: back}", BATTEN_NOT_INCREASING,
         "a function needs rising abscissae: point 3 is at 1, point 2 before it at 2"},
        {"{minimax: twice}", BATTEN_NOT_INCREASING,
         "a function needs rising abscissae: point 3 is at 2, point 2 before it at 2"},
        {"{minimax: skew}", BATTEN_NOT_COMPATIBLE,
         "the points must lie in a plane x, y or z = constant for 'minimax'"},
        {"{biarcs: skew}", BATTEN_NOT_COMPATIBLE,
         "the points must lie in a plane x, y or z = constant for 'biarcs'"},
    };
    EXPECT(of_planes, refused);
}

/* One number stands for all; others are one for each, and points are counted from 1. */
TEST(lists_of_numbers_and_points_fit_their_rows)
{
    static const char ducks[] =
        "  ducks: {points: [[0, 0], [1, 1], [2, -1], [3, 1], [4, 0]]}\n";
    static const expect_row lists[] = {
        {"{tension: ducks, amount: [1, 2]}", BATTEN_BAD_ARGUMENT,
         "'amount' has 2 numbers for 4 spans"},
        {"{tension: ducks, amount: 2}", BATTEN_OK, "passes"},
        {"{tension: ducks, amount: [2, 2, 2, 2]}", BATTEN_OK, "passes"},
        {"{cardinal: ducks, tension: [1, 2]}", BATTEN_BAD_ARGUMENT,
         "'tension' has 2 numbers for 5 points"},
        {"{cardinal: ducks, tension: [1]}", BATTEN_OK, "passes"},
        {"{least-squares: ducks, points: 4, weights: [1, 2]}", BATTEN_BAD_ARGUMENT,
         "'weights' has 2 numbers for 5 points"},
        {"{cornered-spline: ducks, corners: [0]}", BATTEN_BAD_ARGUMENT,
         "'corners' names point 0; points are counted from 1"},
        {"{cornered-spline: ducks, corners: [2, 0]}", BATTEN_BAD_ARGUMENT,
         "'corners' names point 0; points are counted from 1"},
        {"{cornered-spline: ducks, corners: [2, 9]}", BATTEN_BAD_ARGUMENT,
         "corner 2 is point 9; of 5 points it may be 1 to 5"},
        {"{cornered-spline: ducks, corners: [1, 3, 5]}", BATTEN_OK, "passes"},
        {"{spiro: ducks, corners: [0]}", BATTEN_BAD_ARGUMENT, "points are counted from 1"},
        {"{fit-within: ducks, within: 0.1, corners: [0]}", BATTEN_BAD_ARGUMENT,
         "points are counted from 1"},
        {"{fit-within: ducks, within: 0.1, corners: [3]}", BATTEN_OK, "notes 1 corner"},
    };
    EXPECT(ducks, lists);
}
