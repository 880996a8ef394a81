#include "design/agree.h"
#include "design/evaluate.h"
#include "design/expect.h"

#include <batten/polygon.h>

/* Uniform B-splines of polygons, with each kind of end. */

static const char lines[] =
    "  s: {points: [[0, 0, 1], [1, 1, 0.5], [2, 0.2, 1], [3, 1.5, 3], [4, "
    "1, 2], [5.5, 0, 0]]}\n"
    "  square: {points: [[0, 0], [6, 0], [6, 6], [0, 6]]}\n"
    "  pair: {points: [[0, 0], [3, 4]]}\n  lone: {points: [[1, 1]]}\n";
static const double of_s[] = {0, 0, 1, 1, 1, 0.5, 2, 0.2, 1, 3, 1.5, 3, 4, 1, 2, 5.5, 0, 0};
static const agree_made space = {.points = {3, 6, of_s}};

#define UNIFORM(name, degree, ends)                                                 \
    static batten_status name(agree_made *m)                                        \
    {                                                                               \
        return batten_curve_uniform(m->points, degree, NULL, BATTEN_POLYGON_##ends, \
                                    &m->curve);                                     \
    }
UNIFORM(clamped, 3, CLAMPED)
UNIFORM(quintic, 5, CLAMPED)
UNIFORM(free_ends, 3, FREE)
UNIFORM(phantom, 3, PHANTOM)
UNIFORM(repeated, 3, REPEATED)
UNIFORM(closed, 2, CLOSED)

TEST(uniform_b_splines_are_those_of_their_calls)
{
    static const agree_row rows[] = {
        {"{b-spline: s}", clamped},
        {"{b-spline: s, degree: 5}", quintic},
        {"{b-spline: s, ends: free}", free_ends},
        {"{b-spline: s, ends: phantom}", phantom},
        {"{b-spline: s, ends: repeated}", repeated},
        {"{b-spline: s, ends: closed, degree: 2}", closed},
    };
    AGREE(lines, &space, rows);
}

TEST(b_splines_of_polygons_end_where_their_ends_say)
{
    static const expect_row rows[] = {
        {"{b-spline: square, ends: closed}", BATTEN_OK, "closed 1;degree 3"},
        {"{b-spline: square, ends: repeated}", BATTEN_OK, "at 0 0 0 0;at 1 0 6 0"},
        {"{b-spline: pair, degree: 1}", BATTEN_OK, "length 5;named a;exact;silent"},
        {"{b-spline: lone}", BATTEN_TOO_FEW_POINTS, "no row has 2 points"},
        {"{b-spline: square, degree: 26}", BATTEN_BAD_DEGREE, "square: "},
    };
    EXPECT(lines, rows);
}

TEST(its_points_are_vertices_of_a_polygon)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate_design("batten: 1\nfeatures:\n  s: {points: [[0, 0], [1, 1], [2, 0], [3, "
                             "0]]}\n  a: {b-spline: s}\n",
                             "a", NULL, &design));
    const batten_object *made =
        batten_model_object(batten_design_result(design, "a")->value, 0);
    CHECK(made->points_are_vertices && !made->parameters);
    CHECK_INT(made->point_count, 4);
    batten_design_free(design);
}
