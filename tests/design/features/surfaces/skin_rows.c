#include "design/agree.h"
#include "design/expect.h"

#include <batten/skin.h>

/* Surfaces through rows of points, with each option in its place. */

static const char rows_of_points[] =
    "  e: {points: [[0, 0, 0], [0, 1, 0.2], [0, 1.1, 0.3], [0, 2, 0.2], [0, 3, 0]]}\n"
    "  f: {points: [[1, 0, 0.1], [1, 0.8, 0.3], [1, 1.6, 0.3], [1, 3, 0]]}\n"
    "  g: {points: [[2, 0, 0.1], [2, 0.6, 0.3], [2, 2, 0.5], [2, 3, 0]]}\n"
    "  h: {points: [[3, 0, 0.2], [3, 0.6, 0.3], [3, 1, 0.4], [3, 2, 0.5], [3, 3, 0]]}\n"
    "  few: {points: [[1, 0, 1], [1, 3, 1]]}\n  flat: {points: [[0, 0, 1], [0, 1, 1], [0, 3, 1]]}\n"
    "  flat2: {points: [[2, 0, 1], [2, 2, 1], [2, 3, 1]]}\n  line: {line: [[0, 0], [1, 1]]}\n";
static const int counts[] = {5, 4, 4, 5};
static const double points[] = {0, 0,   0,   0,   1,   0.2, 0,   1.1, 0.3, 0,   2, 0.2, 0, 3,
                                0, 1,   0,   0.1, 1,   0.8, 0.3, 1,   1.6, 0.3, 1, 3,   0, 2,
                                0, 0.1, 2,   0.6, 0.3, 2,   2,   0.5, 2,   3,   0, 3,   0, 0.2,
                                3, 0.6, 0.3, 3,   1,   0.4, 3,   2,   0.5, 3,   3, 0};

static batten_status skin_rows(const batten_surface_skin_rows_options *options,
                               agree_surface *made)
{
    batten_surface_skin_rows_report report = {0};
    const batten_status status =
        batten_surface_skin_rows((batten_rows){3, 4, counts, points}, options, NULL,
                                 (batten_uv_out){NULL, NULL}, &report, &made->surface);
    made->error = report.error;
    return status;
}

static batten_status as_it_is(const batten_design *design, agree_surface *made)
{
    (void)design;
    const batten_surface_skin_rows_options options = batten_surface_skin_rows_defaults();
    return skin_rows(&options, made);
}

static batten_status with_options(const batten_design *design, agree_surface *made)
{
    (void)design;
    batten_surface_skin_options across = batten_surface_skin_defaults();
    batten_surface_skin_rows_options options = batten_surface_skin_rows_defaults();
    across.degree = 2;
    across.parameters = BATTEN_UNIFORM;
    options.degree = 2;
    options.parameters = BATTEN_CHORD;
    options.margin = 0.1;
    options.across = &across;
    return skin_rows(&options, made);
}

static batten_status with_ends(const batten_design *design, agree_surface *made)
{
    (void)design;
    batten_surface_skin_options across = batten_surface_skin_defaults();
    batten_surface_skin_rows_options options = batten_surface_skin_rows_defaults();
    across.start = (batten_end){BATTEN_END_CLAMPED, {1, 0, 2}};
    across.end = (batten_end){BATTEN_END_SECOND, {0, 1, 1}};
    options.across = &across;
    return skin_rows(&options, made);
}

static batten_status periodic(const batten_design *design, agree_surface *made)
{
    (void)design;
    batten_surface_skin_options across = batten_surface_skin_defaults();
    batten_surface_skin_rows_options options = batten_surface_skin_rows_defaults();
    across.closed = true;
    options.across = &across;
    return skin_rows(&options, made);
}

TEST(skins_of_rows_are_those_of_their_calls)
{
    static const agree_surface_row rows[] = {
        {"{skin-rows: [e, f, g, h]}", as_it_is},
        {"{skin-rows: [e, f, g, h], degree-u: 2, degree-v: 2, parameters: chord, across: uniform, "
         "margin: 0.1}",
         with_options},
        {"{skin-rows: [e, f, g, h], start: clamped, start-vector: [1, 0, 2], end: second, "
         "end-vector: [0, 1, 1]}",
         with_ends},
        {"{skin-rows: [e, f, g, h], periodic: yes}", periodic},
    };
    AGREE_SURFACES(rows_of_points, rows);
}

TEST(skins_of_rows_say_how_many_knots_they_share_and_refuse_what_has_no_rows)
{
    static const expect_row rows[] = {
        {"{skin-rows: [flat, few, flat2], degree-u: 1, degree-v: 1, margin: 0.4}", BATTEN_OK,
         "objects 1;named a;degree 1 1;on 0 0 1 1;area 6;notes inner knot; notes along the rows, where "
         "knots of their own would be 2;error 1e-9"},
        {"{skin-rows: [flat, flat2], degree-u: 2, degree-v: 1}", BATTEN_OK,
         "degree 2 1;on 0 0 1 1;notes 0 inner knots along the rows, where knots of their own would "
         "be 0; notes 0 rows with fewer points than control points"},
        {"{skin-rows: line}", BATTEN_BAD_ARGUMENT, "line"},
        {"{skin-rows: [flat, flat2], degree-u: 0, degree-v: 1}", BATTEN_BAD_DEGREE, ""},
    };
    EXPECT(rows_of_points, rows);
}
