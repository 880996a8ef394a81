#include "design/agree.h"
#include "design/evaluate.h"
#include "design/expect.h"

#include <batten/polygon.h>
#include <batten/standard.h>

/* Bezier curves of polygons, and of edges with their weights. */

/* Degree 25 is the highest. */
#define TEN "[0,0],[1,0],[2,0],[3,0],[4,0],[5,0],[6,0],[7,0],[8,0],[9,0],"
#define FIVE "[10,0],[11,0],[12,0],[13,0],[14,0],"

static const char lines[] =
    "  s: {points: [[0, 0, 1], [1, 1, 0.5], [2, 0.2, 1], [3, 1.5, 3]]}\n"
    "  most: {points: [" TEN FIVE TEN "[0, 1]]}\n"
    "  more: {points: [" TEN FIVE TEN "[0, 1], [1, 1]]}\n";
static const double of_s[] = {0, 0, 1, 1, 1, 0.5, 2, 0.2, 1, 3, 1.5, 3};
static const agree_made space = {.points = {3, 4, of_s}};

static batten_status bezier(agree_made *m)
{
    return batten_curve_bezier(3, 3, of_s, NULL, &m->curve);
}

static batten_status weighted(agree_made *m)
{
    static const double weights[] = {1, 2, 3, 4};
    return batten_curve_bezier(3, 3, of_s, weights, &m->curve);
}

/* The first row is the start, and each other one is an edge of the derivative's polygon. */
static batten_status of_edges(agree_made *m)
{
    return batten_curve_from_edges(3, 3, of_s, of_s + 3, &m->curve);
}

TEST(bezier_curves_are_those_of_their_calls_and_have_no_parameters_of_their_points)
{
    static const agree_row rows[] = {
        {"{bezier: s}", bezier},
        {"{bezier: s, weights: [1, 2, 3, 4]}", weighted},
        {"{bezier: s, given: edges}", of_edges},
    };
    AGREE(lines, &space, rows);
}

TEST(a_polygon_of_26_corners_is_the_longest)
{
    static const expect_row rows[] = {
        {"{bezier: most}", BATTEN_OK, "degree 25;count 26;at 1 0 1 0"},
        {"{bezier: more}", BATTEN_BAD_DEGREE,
         "more: a polygon of 27 corners gives degree 26; the highest is 25, and 'b-spline' takes "
         "polygons of any length"},
    };
    EXPECT(lines, rows);
}

TEST(points_are_vertices_of_a_polygon_but_edges_are_not)
{
    for (int edges = 0; edges < 2; edges++) {
        char text[400];
        batten_design *design = NULL;
        snprintf(
            text, sizeof text,
            "batten: 1\nfeatures:\n  s: {points: [[0, 0], [1, 1], [2, 0]]}\n  a: {bezier: s, "
            "given: %s}\n",
            edges ? "edges" : "points");
        CHECK_OK(evaluate_design(text, "a", NULL, &design));
        const batten_object *made =
            batten_model_object(batten_design_result(design, "a")->value, 0);
        CHECK_INT(made->points_are_vertices, !edges);
        CHECK_INT(made->point_count, 3);
        CHECK(!made->parameters);
        batten_design_free(design);
    }
}
