#include "design/outputs/checked.h"

#include <batten/scattered.h>
#include <batten/standard.h>

/* Edges, triangles and joins of a check of shapes that the test makes, and the bounds by which they are judged. */

/* ---- edges of hulls ---- */

static batten_status make_table(batten_offset_table **out)
{
    static const batten_table_line lines[] = {{"sheer", false, 0}};
    static const batten_table_point points[] = {
        {0, 0, 0, -1}, {0, 1, 1, 0}, {4, 0, 0, -1}, {4, 1, 1, 0}};
    static const batten_table_station stations[] = {{"1", 0, 2, points},
                                                    {"2", 4, 2, points + 2}};
    return batten_offset_table_create(1, 1, lines, 2, stations, out);
}

/* Half-breadths at its corners; to starboard. Along an edge they change evenly: their mean is that of its ends. */
TEST(edges_of_a_hull_are_near_the_centre_plane_within_a_twentieth_of_its_breadth)
{
    static const struct {
        double y[4]; /* at (0, 0), (1, 0), (1, 1), (0, 1) */
        double gap[4];
        bool is_near[4]; /* u low, u high, v low, v high */
    } rows[] = {
        {{0, -4, -4, 0}, {0, 4, 4, 4}, {true, false, false, false}},
        {{0, -4, -4, -0.39}, {0.39, 4, 4, 4}, {true, false, false, false}},
        {{0, 4, 4, 0.41}, {0.41, 4, 4, 4}, {false, false, false, false}},
        {{0, 0, 4, 4}, {4, 4, 0, 4}, {false, false, true, false}},
        {{0.1, 0.2, 4, -0.2}, {0.2, 4, 0.2, 4}, {true, false, true, false}},
    };
    static const char *const names[] = {"u low", "u high", "v low", "v high"};
    for (int i = 0; i < COUNT(rows); i++) {
        const double *y = rows[i].y;
        checked_design d;
        batten_offset_table *table = NULL;
        batten_surface *surface = NULL;
        checked_open("  table: {points: [[0, 0, 0]]}\n  hull: {skin: table}\n", "hull", &d);
        CHECK_OK(make_table(&table));
        checked_put(&d, "table",
                    &(batten_object){.name = "table",
                                     .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                     .offset_table = table});
        batten_offset_table_unref(table);
        CHECK_OK(batten_surface_bilinear((batten_vec3){0, y[0], 0}, (batten_vec3){4, y[1], 0},
                                         (batten_vec3){0, y[3], 1}, (batten_vec3){4, y[2], 1},
                                         &surface));
        checked_put_surface(&d, "hull", surface);
        const bat_checked *c = checked_run(&d, HUGE_VAL);
        CHECK_INT(c->edge_count, 4);
        for (int k = 0; k < 4; k++) {
            CHECK_TEXT(c->edges[k].name, names[k]);
            CHECK_NEAR(c->edges[k].gap, rows[i].gap[k], 1e-12);
            CHECK(c->edges[k].is_near == rows[i].is_near[k]);
        }
        checked_close(&d);
    }
}

/* ---- sets of triangles ---- */

static batten_status take_text(const bat_check *check, char **data)
{
    batten_text text = BATTEN_TEXT;
    size_t size;
    bat_report_text(check, &text);
    const batten_status status = batten_text_take(&text, data, &size);
    batten_text_free(&text);
    return status;
}

/* Two halves of the unit square, bent along the diagonal: the normals are (0, 0, 1) and (1, 1, 1) / sqrt 3. */
TEST(the_inner_edges_of_triangles_and_their_angle_are_reported)
{
    static const double vertices[] = {0, 0, 1, 0, 1, 1, 0, 1};
    static const int corners[] = {0, 1, 2, 0, 2, 3};
    static const double heights[] = {0, 0, 0, 2};
    checked_design d;
    batten_triangles *flat = NULL, *bent = NULL;
    checked_open("  three: {bezier-triangle: net}\n  net: {points: [[0, 0, 0]]}\n", "three",
                 &d);
    CHECK_OK(batten_triangles_linear(&(batten_triangulation){4, vertices, corners}, 2, heights,
                                     &flat));
    CHECK_OK(batten_triangles_from_function(flat, &bent));
    batten_triangles_unref(flat);
    checked_put(
        &d, "three",
        &(batten_object){.name = "three", .kind = BATTEN_OBJECT_TRIANGLES, .triangles = bent});
    batten_triangles_unref(bent);
    const bat_checked *c = checked_run(&d, HUGE_VAL);
    CHECK_INT(c->triangle_joins, 1);
    CHECK_NEAR(c->triangle_gap, 0, 0);
    CHECK_NEAR(c->triangle_angle, acos(1. / 3), 1e-12);
    char *data = NULL;
    CHECK_OK(take_text(&d.check, &data));
    CHECK_CONTAINS(
        data,
        "2 triangles of degree 1; at 1 inner edge gaps of at most 0 m, normals turn by at most 1.231 rad\n");
    batten_release(data);
    checked_close(&d);
}

/* ---- bounds of joins ---- */

/* A plane before x = 0, and behind it a sheet that rises by s x + c x^2. */
static void put_sheets(checked_design *d, double s, double c)
{
    const double u[] = {0, 0, 0, 1, 1, 1}, v[] = {0, 0, 1, 1};
    const batten_axis axes[] = {{2, 3, u, false}, {1, 2, v, false}};
    const double points[] = {0,   0, 0,     0,   1, 0, /* of s x + c x^2 */
                             0.5, 0, s / 2, 0.5, 1, s / 2, 1, 0, s + c, 1, 1, s + c};
    batten_surface *plane = NULL, *sheet = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){-1, 0, 0}, (batten_vec3){0, 0, 0},
                                     (batten_vec3){-1, 1, 0}, (batten_vec3){0, 1, 0}, &plane));
    checked_put_surface(d, "a", plane);
    CHECK_OK(batten_surface_create(3, &axes[0], &axes[1], points, NULL, &sheet));
    checked_put_surface(d, "b", sheet);
}

/* Two lines with an angle between them, or a line and an arc. */
static void put_curves(checked_design *d, double s, double c)
{
    const double knots[] = {0, 0, 0, 1, 1, 1};
    const double points[] = {0, 0, 0, 0.5, s / 2, 0, 1, s + c, 0};
    batten_curve *bow = NULL;
    checked_put_line(d, "a", (batten_vec3){-1, 0, 0}, (batten_vec3){0, 0, 0});
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, NULL, knots, &bow));
    checked_put(d, "b",
                &(batten_object){.name = "b", .kind = BATTEN_OBJECT_CURVE, .curve = bow});
    batten_curve_unref(bow);
}

static batten_status judge_within(checked_design *d, double angle, double curvature)
{
    const bat_fair_bounds bounds = {angle, curvature};
    bat_check_release(&d->check);
    return bat_check_all(&d->run, "check", HUGE_VAL, &bounds, &bounds, &d->check);
}

/* What is at its bound holds, and what is above it by a bit does not. */
TEST(joins_may_turn_and_jump_up_to_their_bounds_and_no_further)
{
    for (int i = 0; i < 4; i++) {
        const bool is_of_curves = i / 2, turns = i % 2;
        checked_design d;
        checked_open("  a: {points: [[0, 0]]}\n  b: {points: [[0, 0]]}\n", "[a, b]", &d);
        (is_of_curves ? put_curves : put_sheets)(&d, turns ? 0.5 : 0, turns ? 0 : 1);
        const bat_unfairness *u = &d.check.unfairness;
        CHECK_OK(judge_within(&d, 3, 3));
        CHECK_INT(d.check.join_count, 1);
        const batten_join join = d.check.joins[0].of;
        CHECK_NEAR(join.angle.value, turns ? atan(0.5) : 0, 1e-12);
        CHECK_NEAR(u->largest_crease, is_of_curves ? 0 : join.angle.value, 0);
        for (int above = 0; above < 2; above++) {
            const double angle = above ? nextafter(join.angle.value, 0) : join.angle.value,
                         jump =
                             above ? nextafter(join.curvature.value, 0) : join.curvature.value;
            CHECK_OK(turns ? judge_within(&d, angle, 3) : judge_within(&d, 1e-6, jump));
            CHECK_INT(u->creases, above && turns && !is_of_curves);
            CHECK_INT(u->edge_jumps, above && !turns && !is_of_curves);
            CHECK_INT(u->joint_corners, above && turns && is_of_curves);
            CHECK_INT(u->joint_jumps, above && !turns && is_of_curves);
            CHECK_NEAR(u->largest_joint, above && turns && is_of_curves ? join.angle.value : 0,
                       0);
        }
        checked_close(&d);
    }
}

/* Joins are listed by the shapes that meet, whatever their kinds: curves and surfaces in turns. */
TEST(joins_are_listed_in_the_order_of_what_meets)
{
    static const int pairs[][2] = {{0, 2}, {0, 4}, {1, 3}, {1, 5}};
    checked_design d;
    checked_open("  a: {points: [[0, 0]]}\n  b: {points: [[0, 0]]}\n  c: {points: [[0, 0]]}\n"
                 "  d: {points: [[0, 0]]}\n  e: {points: [[0, 0]]}\n  f: {points: [[0, 0]]}\n",
                 "[a, b, c, d, e, f]", &d);
    const double from[] = {0, 1, -1};
    static const char *const surfaces[] = {"a", "c", "e"}, *const lines[] = {"b", "d", "f"};
    for (int i = 0; i < 3; i++) {
        const double x = from[i];
        batten_surface *plane = NULL;
        CHECK_OK(batten_surface_bilinear((batten_vec3){x, 0, 0}, (batten_vec3){x + 1, 0, 0},
                                         (batten_vec3){x, 1, 0}, (batten_vec3){x + 1, 1, 0},
                                         &plane));
        checked_put_surface(&d, surfaces[i], plane);
        checked_put_line(&d, lines[i], (batten_vec3){x, 7, 0}, (batten_vec3){x + 1, 7, 0});
    }
    checked_run(&d, HUGE_VAL);
    CHECK_INT(d.check.join_count, 4);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++)
            CHECK_INT(d.check.joins[i].of.shape[k], pairs[i][k]);
    checked_close(&d);
}
