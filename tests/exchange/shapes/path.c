#include "exchange/shapes/path.h"
#include "exchange/shapes/paths.h"

/* The point of a path half way along vertex i's move, from its bulge. */
static void middle(const bat_path *path, int i, double at[2])
{
    const bat_vertex *a = &path->vertices[i], *b = &path->vertices[(i + 1) % path->count];
    at[0] = (a->x + b->x) / 2 + a->bulge / 2 * (b->y - a->y);
    at[1] = (a->y + b->y) / 2 - a->bulge / 2 * (b->x - a->x);
}

static bat_path path_of(const batten_model *model)
{
    bool is_path = false;
    bat_path path = {0};
    CHECK_OK(bat_path_of(batten_model_object(model, 0), &is_path, &path));
    CHECK(is_path);
    return path;
}

TEST(a_closed_chain_is_a_closed_path_with_half_circles_as_bulges_of_one)
{
    batten_model *model = model_of("stadium", stadium());
    bat_path path = path_of(model);
    CHECK(path.closed);
    CHECK_INT(path.count, 4);
    const double bulges[4] = {0, 1, 0, 1};
    for (int i = 0; i < 4; i++)
        CHECK_NEAR(path.vertices[i].bulge, bulges[i], 1e-15);
    double at[2];
    middle(&path, 1, at);
    CHECK_NEAR(at[0], 100, 1e-13);
    CHECK_NEAR(at[1], 10, 1e-13);
    bat_path_release(&path);
    batten_model_unref(model);
}

TEST(arcs_beyond_a_half_circle_are_cut_and_stay_on_their_circle)
{
    batten_model *model = model_of("hook", hook());
    bat_path path = path_of(model);
    CHECK(!path.closed);
    CHECK_INT(path.count, 4); /* two arcs, the begin of the line, its end */
    for (int i = 0; i < 2; i++) {
        double at[2], cx, cy, radius;
        CHECK(path.vertices[i].bulge < 0);
        middle(&path, i, at);
        CHECK_NEAR(hypot(at[0] - 5, at[1]), 5, 1e-14);
        bat_path_centre(&path.vertices[i], path.vertices[i + 1].x, path.vertices[i + 1].y, &cx,
                        &cy, &radius);
        CHECK_NEAR(cx, 5, 1e-14);
        CHECK_NEAR(cy, 0, 1e-14);
        CHECK_NEAR(radius, 5, 1e-14);
    }
    CHECK_NEAR(path.vertices[3].x, 1, 1e-14);
    CHECK_NEAR(path.vertices[3].y, -5, 1e-14);
    bat_path_release(&path);
    batten_model_unref(model);
}

TEST(an_arc_that_is_beside_its_chord_by_rounding_has_no_bulge)
{
    const double curvatures[3] = {1e-19, 1e-17, 1e-12};
    for (int k = 0; k < 3; k++) {
        const batten_span arc = {.kind = BATTEN_SPAN_ARC,
                                 .length = 100,
                                 .start = {1000, 0},
                                 .curvature = {-curvatures[k]}};
        batten_chain *chain = NULL;
        CHECK_OK(
            batten_chain_create(&(batten_chain_parts){2, 1, &arc, NULL, false}, 0, &chain));
        batten_model *model = model_of("flat", chain);
        bat_path path = path_of(model);
        CHECK((path.vertices[0].bulge != 0) == (k == 2));
        bat_path_release(&path);
        batten_model_unref(model);
    }
}

TEST(a_polyline_in_a_level_plane_is_a_path_and_other_curves_are_none)
{
    const double points[4][3] = {{0, 0, 2}, {4, 0, 2}, {4, 3, 2}, {0, 0, 2}};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){3, 4, &points[0][0]}, &curve));
    batten_object object = {.name = "", .kind = BATTEN_OBJECT_CURVE, .curve = curve};
    bool is_path = false;
    bat_path path = {0};
    CHECK_OK(bat_path_of(&object, &is_path, &path));
    CHECK(is_path && path.closed);
    CHECK_INT(path.count, 3);
    CHECK_NEAR(path.frame.origin.z, 2, 0);
    bat_path_release(&path);
    batten_curve_unref(curve);

    CHECK_OK(batten_curve_ellipse(2, 1, 0, 1, &curve));
    object.curve = curve;
    CHECK_OK(bat_path_of(&object, &is_path, &path));
    CHECK(!is_path);
    batten_curve_unref(curve);
}

TEST(a_polyline_is_closed_from_four_points_on_and_level_or_none)
{
    static const struct {
        double points[4][3];
        int count;
        bool is_path, closed;
    } cases[] = {{{{0, 0, 1}, {4, 0, 1}, {0, 0, 1}}, 3, true, false},
                 {{{0, 0, 1}, {4, 0, 1}, {4, 3, 1}, {0, 0, 1}}, 4, true, true},
                 {{{0, 0, 1}, {4, 0, 1}, {4, 3, 1}, {0, 1, 1}}, 4, true, false},
                 {{{0, 0, 1}, {4, 0, 1}, {4, 3, 2}, {0, 0, 1}}, 4, false, false},
                 {{{0, 0, 1}, {4, 0, 1}, {4, 3, 1}, {0, 0, 2}}, 4, false, false}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_curve *curve = NULL;
        bool is_path = false;
        bat_path path = {0};
        CHECK_OK(batten_curve_polyline((batten_points){3, cases[i].count, cases[i].points[0]},
                                       &curve));
        const batten_object object = {.name = "", .kind = BATTEN_OBJECT_CURVE, .curve = curve};
        CHECK_OK(bat_path_of(&object, &is_path, &path));
        /* A polyline out of level is a path when it lies in some plane. */
        if (cases[i].is_path) {
            CHECK(is_path);
            CHECK_INT(path.closed, cases[i].closed);
            CHECK_INT(path.count, cases[i].count - cases[i].closed);
            CHECK_BITS(path.frame.origin.z, 1);
            for (int k = 0; k < path.count; k++) {
                CHECK_BITS(path.vertices[k].x, cases[i].points[k][0]);
                CHECK_BITS(path.vertices[k].y, cases[i].points[k][1]);
                CHECK_BITS(path.vertices[k].bulge, 0);
            }
        } else if (is_path) {
            CHECK(path.frame.z.x != 0 || path.frame.z.y != 0);
        }
        bat_path_release(&path);
        batten_curve_unref(curve);
    }
}

TEST(a_polyline_of_the_plane_lies_at_height_0)
{
    const double points[] = {0, 0, 4, 0, 4, 3};
    batten_curve *curve = NULL;
    bool is_path = false;
    bat_path path = {0};
    CHECK_OK(batten_curve_polyline((batten_points){2, 3, points}, &curve));
    CHECK_OK(bat_path_of(&(batten_object){.kind = BATTEN_OBJECT_CURVE, .curve = curve},
                         &is_path, &path));
    CHECK(is_path && !path.closed && path.count == 3);
    CHECK_BITS(path.frame.origin.z, 0);
    CHECK(path.vertices[2].x == 4 && path.vertices[2].y == 3);
    bat_path_release(&path);
    batten_curve_unref(curve);
}

TEST(the_sagitta_is_the_bulge_times_half_the_chord)
{
    const bat_vertex from = {1, 2, -0.5};
    CHECK_NEAR(bat_path_sagitta(&from, 7, 10), 2.5, 1e-15);
}

TEST(a_chain_of_too_many_turns_is_refused)
{
    const batten_span wheel = {.kind = BATTEN_SPAN_ARC, .length = 1e9, .curvature = {1}};
    batten_span *spans = test_array(11, sizeof *spans);
    batten_chain *chain = NULL;
    bool is_path = false;
    bat_path path = {0};
    double x = 0, y = 0, angle = 0;
    for (int i = 0; i < 11; i++) {
        spans[i] = wheel;
        spans[i].start[0] = x, spans[i].start[1] = y, spans[i].angle = angle;
        x += sin(angle + 1e9) - sin(angle);
        y -= cos(angle + 1e9) - cos(angle);
        angle += 1e9;
    }
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 11, spans, NULL, false}, 1e-3, &chain));
    CHECK_STATUS(bat_path_of(&(batten_object){.kind = BATTEN_OBJECT_CURVE, .chain = chain},
                             &is_path, &path),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("a path of 11000000 vertices");
    batten_chain_unref(chain);
}
