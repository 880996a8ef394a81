/* Faces of bodies across their common edges: boxes, cylinders and rounded edges, in closed form. */
#include "body/builder.h"
#include "support/bodies.h"
#include "support/test.h"

#include <batten/continuity.h>
#include <batten/standard.h>

static batten_joins joins_of(const batten_body *body)
{
    batten_joins joins = {0, NULL, false};
    CHECK_OK(batten_body_joins(body, NULL, NULL, &joins));
    return joins;
}

TEST(faces_of_a_box_meet_at_right_angles_along_all_twelve_edges)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3});
    batten_joins joins = joins_of(box);
    CHECK_INT(joins.count, 12);
    for (int i = 0; i < joins.count; i++) {
        const batten_join *join = &joins.at[i];
        CHECK_INT(join->edge, i);
        CHECK(join->shape[0] != join->shape[1]);
        CHECK(join->side[0] == -1 && join->side[1] == -1 && join->part == -1);
        CHECK_NEAR(join->gap.value, 0, 1e-14);
        CHECK_NEAR(join->angle.value, acos(-1) / 2, 1e-12);
        CHECK_INT(join->geometric, 0);
        CHECK_NEAR(join->curvature_difference, 0, 1e-10);
    }
    batten_joins_release(&joins);
    batten_body_unref(box);
}

/* The seam of a sphere is smooth in all orders; its poles have no curve and do not join. */
TEST(the_seam_of_a_sphere_joins_it_with_itself)
{
    const batten_frame world = batten_frame_world();
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_sphere(&world, 2, &surface));
    CHECK_OK(batten_body_from_surface("ball", surface, 1e-6, &body));
    batten_joins joins = joins_of(body);
    CHECK_INT(joins.count, 1);
    CHECK_INT(joins.at[0].shape[0], 0);
    CHECK_INT(joins.at[0].shape[1], 0);
    CHECK_INT(joins.at[0].geometric, 3);
    CHECK_NEAR(joins.at[0].gap.value, 0, 1e-12);
    CHECK_NEAR(joins.at[0].angle.value, 0, 1e-7);
    batten_joins_release(&joins);
    batten_body_unref(body);
    batten_surface_unref(surface);
}

TEST(bounds_below_zero_are_refused)
{
    batten_curve_continuity_options bounds = batten_curve_continuity_defaults();
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 1, 1});
    batten_joins joins = {0, NULL, false};
    bounds.gap = -1;
    CHECK_STATUS(batten_body_joins(box, &bounds, NULL, &joins), BATTEN_BAD_ARGUMENT);
    batten_body_unref(box);
}

TEST(worst_places_lie_on_their_edges)
{
    batten_body *box = test_box((batten_vec3){5, 6, 7}, (batten_vec3){6, 8, 10});
    batten_joins joins = joins_of(box);
    const batten_body_parts *p = batten_body_view(box);
    for (int i = 0; i < joins.count; i++) {
        const double *a = p->vertices + 3 * (size_t)p->edges[i].vertices[0],
                     *b = p->vertices + 3 * (size_t)p->edges[i].vertices[1];
        const batten_vec3 at = joins.at[i].angle.at;
        const double x[3] = {at.x, at.y, at.z};
        for (int k = 0; k < 3; k++) {
            CHECK(x[k] >= fmin(a[k], b[k]) - 1e-12);
            CHECK(x[k] <= fmax(a[k], b[k]) + 1e-12);
        }
    }
    batten_joins_release(&joins);
    batten_body_unref(box);
}

/* Two square plates from (0, 0) to (1, 1) and to (-1, 1), the second turned up about x = 0 by an angle; the third
 * one hangs down. All border the edge between (0, 0) and (0, 1). */
static batten_body *folded_plates(double angle, int plates)
{
    const double c = cos(angle), s = sin(angle);
    const double vertices[] = {0,  0, 0, 0,  1, 0, 1, 0, 0,  1, 1, 0,
                               -c, 0, s, -c, 1, s, 0, 0, -1, 0, 1, -1};
    static const int ends[10][2] = {{0, 1}, {0, 2}, {2, 3}, {3, 1}, {0, 4},
                                    {4, 5}, {5, 1}, {0, 6}, {6, 7}, {7, 1}};
    batten_body_edge edges[10];
    batten_body_use uses[12];
    batten_body_loop loops[3];
    batten_body_face faces[3];
    static const double knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_body *made = NULL;
    batten_curve *lines[10];
    batten_surface *sheets[3];
    for (int e = 0; e < 3 * plates + 1; e++) {
        batten_curve *line = NULL;
        CHECK_OK(
            batten_curve_line(3, vertices + 3 * ends[e][0], vertices + 3 * ends[e][1], &line));
        lines[e] = line;
        edges[e] = (batten_body_edge){.curve = line, .vertices = {ends[e][0], ends[e][1]}};
    }
    for (int f = 0; f < plates; f++) {
        const bool back = f == 1; /* the edge in the middle runs once each way */
        double net[12];
        batten_surface *surface = NULL;
        memcpy(net, vertices, 6 * sizeof *net);
        memcpy(net + 6, vertices + 6 * (f + 1), 6 * sizeof *net);
        CHECK_OK(batten_surface_create(3, &axis, &axis, net, NULL, &surface));
        sheets[f] = surface;
        for (int i = 0; i < 4; i++) {
            const int edge = i == 3 ? 0 : 3 * f + 1 + i;
            const bool reversed = i == 3;
            uses[4 * f + (back ? 3 - i : i)] = (batten_body_use){edge, reversed != back, NULL};
        }
        loops[f] = (batten_body_loop){4 * f, 4};
        faces[f] = (batten_body_face){
            .name = "plate", .surface = surface, .first = f, .count = 1, .reversed = back};
    }
    const batten_body_shell shell = {0, plates, false};
    CHECK_OK(batten_body_create(&(batten_body_parts){.vertex_count = 2 + 2 * plates,
                                                     .vertices = vertices,
                                                     .edge_count = 3 * plates + 1,
                                                     .edges = edges,
                                                     .use_count = 4 * plates,
                                                     .uses = uses,
                                                     .loop_count = plates,
                                                     .loops = loops,
                                                     .face_count = plates,
                                                     .faces = faces,
                                                     .shell_count = 1,
                                                     .shells = &shell,
                                                     .tolerance = 1e-6},
                                &made));
    for (int e = 0; e < 3 * plates + 1; e++)
        batten_curve_unref(lines[e]);
    for (int f = 0; f < plates; f++)
        batten_surface_unref(sheets[f]);
    return made;
}

TEST(plates_join_along_their_common_edge_alone_by_the_angle_of_their_fold)
{
    static const double angles[] = {0, 0.25, 1, 2.5};
    for (int i = 0; i < COUNT(angles); i++) {
        batten_body *body = folded_plates(angles[i], 2);
        batten_joins joins = joins_of(body);
        CHECK_INT(joins.count, 1);
        CHECK_INT(joins.at[0].edge, 0);
        CHECK_INT(joins.at[0].shape[0], 0);
        CHECK_INT(joins.at[0].shape[1], 1);
        CHECK_NEAR(joins.at[0].angle.value, angles[i], 1e-12);
        CHECK_NEAR(joins.at[0].gap.value, 0, 1e-15);
        CHECK_INT(joins.at[0].geometric, i ? 0 : 3);
        batten_joins_release(&joins);
        batten_body_unref(body);
    }
}

TEST(an_edge_of_one_face_or_of_three_joins_nothing)
{
    for (int plates = 1; plates <= 3; plates += 2) {
        batten_body *body = folded_plates(1, plates);
        batten_joins joins = joins_of(body);
        CHECK_INT(joins.count, 0);
        batten_joins_release(&joins);
        batten_body_unref(body);
    }
}

TEST(without_a_bound_gaps_are_those_of_the_body_and_joins_are_left_alone_on_failure)
{
    batten_curve_continuity_options bounds = batten_curve_continuity_defaults();
    batten_body *body = folded_plates(0.25, 2);
    batten_joins joins = {7, NULL, true};
    bounds.gap = 0.5;
    bounds.angle = 0.3;
    CHECK_OK(batten_body_joins(body, &bounds, NULL, &joins));
    CHECK_INT(joins.count, 1);
    CHECK_INT(joins.at[0].geometric, 3);
    batten_joins_release(&joins);
    joins = (batten_joins){7, NULL, true};
    bounds.angle = -1;
    CHECK_STATUS(batten_body_joins(body, &bounds, NULL, &joins), BATTEN_BAD_ARGUMENT);
    CHECK(joins.count == 7 && !joins.at && joins.left_out);
    batten_body_unref(body);
}

static batten_curve *line_over(int dimension, const double *a, const double *b, double begin)
{
    const double knots[] = {begin, begin, begin + 4, begin + 4};
    double points[6];
    batten_curve *out = NULL;
    for (int k = 0; k < dimension; k++) {
        points[k] = a[k];
        points[dimension + k] = b[k];
    }
    CHECK_OK(batten_curve_create((batten_points){dimension, 2, points}, 1, NULL, knots, &out));
    return out;
}

/* A patch over its corners at (u, v) = (0, 0), (0, 1), (1, 1) and (1, 0), with that loop, or against it; where two
 * corners are one, no edge lies between them. Curves have domains far from 0. */
typedef struct {
    const batten_surface *surface;
    int corner[4];
    bool back, traced;
} patch;

static void add_patch(bat_builder *b, const patch *p, int *common)
{
    static const double uv[4][2] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    CHECK_OK(bat_builder_face(
        b, &(batten_body_face){.name = "", .surface = p->surface, .reversed = p->back}));
    CHECK_OK(bat_builder_loop(b));
    for (int n = 0; n < 4; n++) {
        const int i = p->back ? (4 - n) % 4 : n, from = p->corner[i],
                  to = p->corner[(i + 1) % 4];
        int edge = i == 0 ? *common : -1;
        batten_curve *flat = p->traced ? line_over(2, uv[i], uv[(i + 1) % 4], 7) : NULL;
        if (from == to)
            continue;
        if (edge < 0) {
            batten_curve *curve =
                line_over(3, b->parts.vertices + 3 * from, b->parts.vertices + 3 * to, 2);
            CHECK_OK(bat_builder_edge(b, curve, from, to, &edge));
            batten_curve_unref(curve);
        }
        CHECK_OK(bat_builder_use(b, edge, p->back, flat));
        batten_curve_unref(flat);
        if (i == 0)
            *common = edge;
    }
}

/* Of two patches whose corners 0 and 1 are (0, 0, 0) and (0, 1, 0); the second is turned over. */
static batten_body *two_patches(batten_surface *const surfaces[2], const double (*vertices)[3],
                                const int corners[2][4], bool traced)
{
    bat_builder b;
    batten_body *body = NULL;
    int common = -1, v = 0;
    bat_builder_begin(&b, 1e-6);
    for (int i = 0; i < 6; i++)
        CHECK_OK(bat_builder_vertex(&b, vertices[i], &v));
    CHECK_OK(bat_builder_shell(&b, false));
    for (int k = 0; k < 2; k++) {
        const patch p = {surfaces[k],
                         {corners[k][0], corners[k][1], corners[k][2], corners[k][3]},
                         k == 1,
                         traced};
        add_patch(&b, &p, &common);
    }
    b.parts.is_traced = traced;
    CHECK_OK(batten_body_create(&b.parts, &body));
    bat_builder_end(&b);
    return body;
}

static batten_surface *patch_of(int degree, const double *points)
{
    static const double knots[3][8] = {
        {0, 0, 1, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}};
    const batten_axis u = {1, 2, knots[0], false},
                      v = {degree, degree + 1, knots[degree - 1], false};
    batten_surface *out = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &out));
    return out;
}

/* z = x b(y) with b = 27/4 y^2 (1 - y) beside a plane: the fold is sharpest, atan(1), at y = 2/3. */
TEST(the_sharpest_place_of_a_fold_is_found_on_curves_with_any_domain)
{
    static const double flat[] = {0, 0, 0, 0, 1, 0, -1, 0, 0, -1, 1, 0};
    static const double lifted[] = {0, 0, 0, 0, 1 / 3., 0, 0, 2 / 3., 0,    0, 1, 0,
                                    1, 0, 0, 1, 1 / 3., 0, 1, 2 / 3., 2.25, 1, 1, 0};
    static const double vertices[][3] = {{0, 0, 0},  {0, 1, 0}, {-1, 1, 0},
                                         {-1, 0, 0}, {1, 1, 0}, {1, 0, 0}};
    static const int corners[2][4] = {{0, 1, 2, 3}, {0, 1, 4, 5}};
    for (int traced = 0; traced < 2; traced++) {
        batten_surface *pair[2] = {patch_of(1, flat), patch_of(3, lifted)};
        batten_body *body = two_patches(pair, vertices, corners, traced);
        batten_joins joins = joins_of(body);
        CHECK_INT(joins.count, 1);
        CHECK_INT(joins.at[0].edge, 0);
        CHECK_NEAR(joins.at[0].gap.value, 0, 1e-14);
        CHECK_NEAR(joins.at[0].angle.value, acos(-1) / 4, 1e-8);
        CHECK_NEAR(joins.at[0].angle.at.y, 2 / 3., 1e-3);
        CHECK_INT(joins.at[0].geometric, 0);
        batten_joins_release(&joins);
        batten_body_unref(body);
        for (int k = 0; k < 2; k++)
            batten_surface_unref(pair[k]);
    }
}

/* Both lie on z = x y, whose tangent plane turns along x = 0; one shrinks to a point of it, where it has none. */
TEST(where_a_face_has_no_tangent_plane_only_the_gap_counts)
{
    static const double square[] = {0, 0, 0, 0, 1, 0, -1, 0, 0, -1, 1, -1};
    static const double to_a_point[] = {0, 0, 0, 0,   0.5, 0,   0, 1, 0,
                                        1, 0, 0, 0.5, 0.5, 0.5, 0, 1, 0};
    static const double vertices[][3] = {{0, 0, 0},  {0, 1, 0}, {-1, 1, -1},
                                         {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    static const int corners[2][4] = {{0, 1, 2, 3}, {0, 1, 1, 4}};
    for (int swap = 0; swap < 2; swap++) {
        const int order[2][4] = {{0, 1, corners[swap][2], corners[swap][3]},
                                 {0, 1, corners[!swap][2], corners[!swap][3]}};
        batten_surface *pair[2] = {NULL, NULL};
        pair[swap] = patch_of(1, square);
        pair[!swap] = patch_of(2, to_a_point);
        batten_body *body = two_patches(pair, vertices, order, false);
        batten_joins joins = joins_of(body);
        CHECK_INT(joins.count, 1);
        CHECK_NEAR(joins.at[0].angle.value, 0, 1e-9);
        CHECK_NEAR(joins.at[0].curvature_difference, 0, 1e-7);
        CHECK_INT(joins.at[0].geometric, 3);
        batten_joins_release(&joins);
        batten_body_unref(body);
        for (int k = 0; k < 2; k++)
            batten_surface_unref(pair[k]);
    }
}

TEST(joins_of_a_body_take_a_step_for_each_edge)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 1, 1});
    batten_job job = BATTEN_JOB;
    for (int less = 0; less < 2; less++) {
        const batten_status due = less ? BATTEN_INCOMPLETE : BATTEN_OK;
        batten_joins joins = {0, NULL, false};
        job.work_limit = 12 - (unsigned)less;
        const batten_status status = batten_body_joins(box, NULL, &job, &joins);
        if (!test_memory_failed(status, due))
            CHECK_STATUS(status, due);
        CHECK_INT(joins.count, status == BATTEN_OK ? 12 : 0);
        batten_joins_release(&joins);
    }
    batten_body_unref(box);
}
