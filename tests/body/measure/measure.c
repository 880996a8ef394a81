#include "body/builder.h"
#include "body/measure/face_integral.h"
#include "support/bodies.h"
#include "support/surfaces.h"
#include "support/test.h"

#include <batten/measure.h>
#include <batten/standard.h>

/* ---- bodies with curves in the parameters, by hand ---- */

static void add_use(bat_builder *builder, int edge, bool reversed, batten_curve *parameters)
{
    CHECK_OK(bat_builder_use(builder, edge, reversed, parameters));
    batten_curve_unref(parameters);
}

static void add_face(bat_builder *builder, batten_surface *surface, bool reversed)
{
    const batten_body_face face = {.name = "", .surface = surface, .reversed = reversed};
    CHECK_OK(bat_builder_face(builder, &face));
    CHECK_OK(bat_builder_loop(builder));
    batten_surface_unref(surface);
}

static batten_curve *flat_line(double u0, double v0, double u1, double v1)
{
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(2, (double[]){u0, v0}, (double[]){u1, v1}, &line));
    return line;
}

static int add_edge(bat_builder *builder, batten_curve *curve, int start, int end)
{
    int index = -1;
    CHECK_OK(bat_builder_edge(builder, curve, start, end, &index));
    batten_curve_unref(curve);
    return index;
}

static int add_vertex(bat_builder *builder, double x, double y, double z)
{
    int index = -1;
    CHECK_OK(bat_builder_vertex(builder, (double[]){x, y, z}, &index));
    return index;
}

static batten_body *finish(bat_builder *builder, bool is_solid)
{
    batten_body *body = NULL;
    builder->parts.is_traced = true;
    builder->parts.is_solid = is_solid;
    CHECK_OK(batten_body_create(&builder->parts, &body));
    bat_builder_end(builder);
    return body;
}

static batten_body_measures measured(batten_body *body, double precision)
{
    batten_body_measures m = {.area = -1};
    CHECK_OK(batten_body_measure(body, precision, NULL, &m));
    CHECK(m.area_error <= 4 * precision * m.area);
    batten_body_unref(body);
    return m;
}

static batten_body *whole(batten_surface *surface)
{
    batten_body *body = NULL;
    CHECK_OK(batten_body_from_surface("", surface, 1e-9, &body));
    batten_surface_unref(surface);
    return body;
}

/* ---- whole surfaces ---- */

static const batten_frame place = {
    {3, -2, 5}, {2. / 3, -1. / 3, 2. / 3}, {1. / 3, -2. / 3, -2. / 3}};

TEST(a_ball_has_its_area_and_volume)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_sphere(&place, 2, &surface));
    const batten_body_measures m = measured(whole(surface), 1e-10);
    CHECK(m.is_closed);
    CHECK_NEAR(m.area / (16 * BAT_PI), 1, 1e-11);
    CHECK_NEAR(m.volume / (32 * BAT_PI / 3), 1, 1e-11);
    CHECK_NEAR(m.centroid[0], 3, 1e-10);
    CHECK_NEAR(m.centroid[1], -2, 1e-10);
    CHECK_NEAR(m.centroid[2], 5, 1e-10);
    CHECK_NEAR(m.edge_length, 2 * BAT_PI, 1e-8); /* the seam */
}

TEST(a_torus_has_its_area_and_volume)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_torus(&place, 5, 2, &surface));
    const batten_body_measures m = measured(whole(surface), 1e-10);
    CHECK(m.is_closed);
    CHECK_NEAR(m.area / (4 * BAT_PI * BAT_PI * 10), 1, 1e-11);
    CHECK_NEAR(m.volume / (2 * BAT_PI * BAT_PI * 20), 1, 1e-11);
    CHECK_NEAR(m.centroid[1], -2, 1e-9);
}

TEST(an_open_cylinder_has_no_volume)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_cylinder(&place, 2, 7, &surface));
    const batten_body_measures m = measured(whole(surface), 1e-10);
    CHECK(!m.is_closed);
    CHECK_BITS(m.volume, 0);
    CHECK_NEAR(m.area / (28 * BAT_PI), 1, 1e-12);
    CHECK_NEAR(m.centroid[0], 3 + 3.5 / 3, 1e-10);
    CHECK_NEAR(m.centroid[1], -2 - 7. / 3, 1e-10);
    CHECK_NEAR(m.edge_length, 8 * BAT_PI + 7, 1e-7);
}

TEST(N2_measures_hold_at_any_size)
{
    static const double sizes[] = {1e-80, 1e-3, 1e80};
    for (int i = 0; i < COUNT(sizes); i++) {
        batten_surface *surface = NULL;
        const batten_frame world = batten_frame_world();
        const double r = sizes[i];
        CHECK_OK(batten_surface_sphere(&world, r, &surface));
        const batten_body_measures m = measured(whole(surface), 1e-9);
        CHECK_NEAR(m.area / r / r / (4 * BAT_PI), 1, 1e-10);
        CHECK_NEAR(m.volume / r / r / r / (4 * BAT_PI / 3), 1, 1e-10);
    }
}

/* By powers of two nothing else is rounded. */
TEST(measures_and_their_errors_grow_with_the_body)
{
    const batten_frame at = {{1, 2, 3}, {2. / 3, -1. / 3, 2. / 3}, {1. / 3, -2. / 3, -2. / 3}};
    batten_surface *unit = NULL;
    CHECK_OK(batten_surface_sphere(&at, 1.5, &unit));
    const batten_body_measures one = measured(whole(batten_surface_ref(unit)), 1e-6);
    CHECK(one.area_error > 0 && one.volume_error > 0);
    for (int k = 0; k < 2; k++) {
        const double f = k ? 0x1p10 : 0x1p-10;
        const batten_affine map = batten_affine_scaling(f, f, f);
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_transform(unit, &map, &surface));
        const batten_body_measures m = measured(whole(surface), 1e-6);
        CHECK_NEAR(m.area / f / f, one.area, 1e-12);
        CHECK_NEAR(m.volume / f / f / f, one.volume, 1e-12);
        CHECK_NEAR(m.area_error / f / f / one.area_error, 1, 1e-3);
        CHECK_NEAR(m.volume_error / f / f / f / one.volume_error, 1, 1e-3);
        CHECK_NEAR(m.edge_length / f, one.edge_length, 1e-12);
        CHECK_NEAR(m.box_error / f, one.box_error, 1e-9);
        CHECK_NEAR(m.box.high.x / f, one.box.high.x, 1e-9);
        CHECK_NEAR(m.box.low.z / f, one.box.low.z, 1e-9);
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(m.centroid[c] / f, one.centroid[c], 1e-12);
    }
    batten_surface_unref(unit);
}

TEST(a_box_is_traced_and_measured)
{
    const batten_body_measures m =
        measured(test_box((batten_vec3){1, 2, 3}, (batten_vec3){2, 4, 6}), 1e-12);
    CHECK(m.is_closed);
    CHECK_NEAR(m.area, 22, 1e-12);
    CHECK_NEAR(m.volume, 6, 1e-12);
    CHECK_NEAR(m.centroid[0], 1.5, 1e-12);
    CHECK_NEAR(m.centroid[1], 3, 1e-12);
    CHECK_NEAR(m.centroid[2], 4.5, 1e-12);
    CHECK_NEAR(m.edge_length, 24, 1e-12);
}

/* A ball of radius 1 within a ball of radius 2, as faces without loops. */
TEST(a_void_is_not_of_the_volume)
{
    const batten_frame world = batten_frame_world();
    batten_surface *outer = NULL, *inner = NULL;
    bat_builder b;
    bat_builder_begin(&b, 1e-6);
    CHECK_OK(batten_surface_sphere(&world, 2, &outer));
    CHECK_OK(batten_surface_sphere(&world, 1, &inner));
    CHECK_OK(bat_builder_shell(&b, true));
    const batten_body_face faces[2] = {{.name = "", .surface = outer},
                                       {.name = "", .surface = inner, .reversed = true}};
    CHECK_OK(bat_builder_face(&b, &faces[0]));
    CHECK_OK(bat_builder_shell(&b, true));
    CHECK_OK(bat_builder_face(&b, &faces[1]));
    batten_surface_unref(outer);
    batten_surface_unref(inner);
    const batten_body_measures m = measured(finish(&b, true), 1e-9);
    CHECK(m.is_closed);
    CHECK_NEAR(m.area / (20 * BAT_PI), 1, 1e-10);
    CHECK_NEAR(m.volume / (4 * BAT_PI / 3 * 7), 1, 1e-10);
}

/* A ball cut by a plane across its poles: x >= 1/2 of radius 1, by its edge alone. */
TEST(a_cut_ball_is_traced_and_measured)
{
    const double h = 0.5, r = sqrt(1 - h * h);
    const batten_frame world = batten_frame_world(), across = {{h, 0, 0}, {0, 1, 0}, {1, 0, 0}};
    batten_surface *ball = NULL, *lid = NULL;
    batten_curve *circle = NULL;
    bat_builder b;
    bat_builder_begin(&b, 1e-9);
    CHECK_OK(batten_surface_sphere(&world, 1, &ball));
    CHECK_OK(batten_curve_arc_in(&across, r, 0, 2 * BAT_PI, &circle));
    CHECK_OK(batten_surface_bilinear((batten_vec3){h, -2, -2}, (batten_vec3){h, -2, 2},
                                     (batten_vec3){h, 2, -2}, (batten_vec3){h, 2, 2}, &lid));
    const int v = add_vertex(&b, h, r, 0), e = add_edge(&b, circle, v, v);
    CHECK_OK(bat_builder_shell(&b, true));
    add_face(&b, ball, false);
    CHECK_OK(bat_builder_use(&b, e, false, NULL));
    add_face(&b, lid, false);
    CHECK_OK(bat_builder_use(&b, e, true, NULL));
    batten_body *body = NULL;
    b.parts.is_solid = true;
    CHECK_OK(batten_body_create(&b.parts, &body));
    bat_builder_end(&b);
    batten_body_measures m = {.area = -1};
    CHECK_OK(batten_body_measure(body, 1e-8, NULL, &m));
    CHECK(m.is_closed);
    CHECK_NEAR(m.area, 2 * BAT_PI * (1 - h) + BAT_PI * r * r, 1e-8);
    CHECK_NEAR(m.volume, BAT_PI * (1 - h) * (1 - h) * (2 + h) / 3, 1e-8);
    CHECK_NEAR(m.edge_length, 2 * BAT_PI * r, 1e-7);
    batten_body_unref(body);
}

/* ---- trimmed faces ---- */

static batten_surface *square(double half, double z, bool down)
{
    batten_surface *surface = NULL;
    const double s = down ? -half : half;
    CHECK_OK(batten_surface_bilinear((batten_vec3){-half, -s, z}, (batten_vec3){half, -s, z},
                                     (batten_vec3){-half, s, z}, (batten_vec3){half, s, z},
                                     &surface));
    return surface;
}

static batten_curve *circle_at(double x, double y, double z, double r)
{
    const batten_frame frame = {{x, y, z}, {1, 0, 0}, {0, 0, 1}};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_arc_in(&frame, r, 0, 2 * BAT_PI, &curve));
    return curve;
}

/* A circle of a square(half, ..) in its parameters: u = 1/2 + x / 2 half. */
static batten_curve *flat_circle(double x, double y, double r, double half, bool down)
{
    batten_curve *circle = NULL, *moved = NULL;
    const double s = down ? -1 : 1;
    batten_affine map = batten_affine_scaling(r / half / 2, s * r / half / 2, 1);
    map.t[0] = 0.5 + x / half / 2;
    map.t[1] = 0.5 + s * y / half / 2;
    CHECK_OK(batten_curve_arc(1, 2 * BAT_PI, &circle));
    CHECK_OK(batten_curve_transform(circle, &map, &moved));
    batten_curve_unref(circle);
    return moved;
}

/* A square of side 4 with a round hole. */
TEST(a_plate_with_a_hole_lacks_the_hole)
{
    bat_builder b;
    bat_builder_begin(&b, 1e-6);
    static const double x[4] = {-2, 2, 2, -2}, y[4] = {-2, -2, 2, 2};
    int v[5], e[5];
    for (int i = 0; i < 4; i++)
        v[i] = add_vertex(&b, x[i], y[i], 1);
    v[4] = add_vertex(&b, 1.5, 0.25, 1);
    for (int i = 0; i < 4; i++) {
        batten_curve *line = NULL;
        const int k = (i + 1) % 4;
        CHECK_OK(
            batten_curve_line(3, (double[]){x[i], y[i], 1}, (double[]){x[k], y[k], 1}, &line));
        e[i] = add_edge(&b, line, v[i], v[k]);
    }
    e[4] = add_edge(&b, circle_at(0.5, 0.25, 1, 1), v[4], v[4]);
    CHECK_OK(bat_builder_shell(&b, false));
    add_face(&b, square(2, 1, false), false);
    for (int i = 0; i < 4; i++) {
        const int k = (i + 1) % 4;
        add_use(&b, e[i], false,
                flat_line((x[i] + 2) / 4, (y[i] + 2) / 4, (x[k] + 2) / 4, (y[k] + 2) / 4));
    }
    CHECK_OK(bat_builder_loop(&b));
    add_use(&b, e[4], true, flat_circle(0.5, 0.25, 1, 2, false));
    const batten_body_measures m = measured(finish(&b, false), 1e-12);
    CHECK_NEAR(m.area, 16 - BAT_PI, 1e-12);
    CHECK_NEAR(m.centroid[0], -0.5 * BAT_PI / (16 - BAT_PI), 1e-12);
    CHECK_NEAR(m.centroid[1], -0.25 * BAT_PI / (16 - BAT_PI), 1e-12);
    CHECK_NEAR(m.centroid[2], 1, 1e-12);
    CHECK_NEAR(m.edge_length, 16 + 2 * BAT_PI, 1e-9);
    CHECK(!m.is_closed);
}

/* A cap, counter-clockwise from outside: above, or below where the face is turned. */
static void add_cap(bat_builder *b, int edge, double r, double z, bool down, bool reversed)
{
    add_face(b, square(2 * r, z, down != reversed), reversed);
    add_use(b, edge, down, flat_circle(0, 0, r, 2 * r, down != reversed));
}

TEST(a_solid_cylinder_closes_whichever_way_its_faces_are_turned)
{
    const double r = 1.5, h = 4;
    for (int turned = 0; turned < 2; turned++) {
        bat_builder b;
        bat_builder_begin(&b, 1e-6);
        const batten_frame world = batten_frame_world();
        const int low = add_vertex(&b, r, 0, 0), high = add_vertex(&b, r, 0, h);
        batten_curve *line = NULL;
        CHECK_OK(batten_curve_line(3, (double[]){r, 0, 0}, (double[]){r, 0, h}, &line));
        const int bottom = add_edge(&b, circle_at(0, 0, 0, r), low, low),
                  top = add_edge(&b, circle_at(0, 0, h, r), high, high),
                  seam = add_edge(&b, line, low, high);
        CHECK_OK(bat_builder_shell(&b, true));
        batten_surface *side = NULL;
        CHECK_OK(batten_surface_cylinder(&world, r, h, &side));
        add_face(&b, side, false);
        add_use(&b, bottom, false, flat_line(0, 0, 1, 0));
        add_use(&b, seam, false, flat_line(1, 0, 1, 1));
        add_use(&b, top, true, flat_line(0, 1, 1, 1));
        add_use(&b, seam, true, flat_line(0, 0, 0, 1));
        add_cap(&b, bottom, r, 0, true, turned);
        add_cap(&b, top, r, h, false, turned);
        const batten_body_measures m = measured(finish(&b, true), 1e-11);
        CHECK(m.is_closed);
        CHECK_NEAR(m.volume / (BAT_PI * r * r * h), 1, 1e-12);
        CHECK(m.volume_error < 1e-9);
        CHECK_NEAR(m.area / (2 * BAT_PI * r * (r + h)), 1, 1e-12);
        CHECK_NEAR(m.centroid[2], h / 2, 1e-11);
        CHECK_NEAR(m.edge_length, 4 * BAT_PI * r + h, 1e-7);
    }
}

/* ---- Wigley's hull ---- */

static const double L = 10, B = 1, T = 0.625;

static batten_surface *wigley_side(double sign)
{
    static const double knots[6] = {0, 0, 0, 1, 1, 1};
    static const double x[3] = {-0.5, 0, 0.5}, z[3] = {-1, -0.5, 0}, yx[3] = {0, 2, 0},
                        yz[3] = {0, 1, 1};
    double points[27];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            points[9 * i + 3 * j] = L * x[i];
            points[9 * i + 3 * j + 1] = sign * B / 2 * yx[i] * yz[j];
            points[9 * i + 3 * j + 2] = T * z[j];
        }
    const batten_axis axis = {2, 3, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

static batten_curve *border(batten_surface *surface, batten_direction fixed, double at)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_surface_isocurve(surface, fixed, at, &curve));
    return curve;
}

/* The waterline in the parameters of the deck, u along x and v along y. */
static batten_curve *deck_line(double sign)
{
    static const double knots[6] = {0, 0, 0, 1, 1, 1};
    const double points[6] = {0, 0.5, 0.5, 0.5 + sign, 1, 0.5};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 3, points}, 2, NULL, knots, &curve));
    return curve;
}

TEST(wigley_s_hull_has_its_displacement)
{
    bat_builder b;
    bat_builder_begin(&b, 1e-6);
    batten_surface *port = wigley_side(-1), *starboard = wigley_side(1), *deck = NULL;
    const int a0 = add_vertex(&b, -L / 2, 0, -T), a1 = add_vertex(&b, L / 2, 0, -T),
              c0 = add_vertex(&b, -L / 2, 0, 0), c1 = add_vertex(&b, L / 2, 0, 0);
    const int keel = add_edge(&b, border(port, BATTEN_V, 0), a0, a1),
              stern = add_edge(&b, border(port, BATTEN_U, 0), a0, c0),
              stem = add_edge(&b, border(port, BATTEN_U, 1), a1, c1);
    const int rail[2] = {add_edge(&b, border(port, BATTEN_V, 1), c0, c1),
                         add_edge(&b, border(starboard, BATTEN_V, 1), c0, c1)};
    CHECK_OK(bat_builder_shell(&b, true));
    for (int s = 0; s < 2; s++) { /* y > 0 has its normal inward */
        add_face(&b, s ? starboard : port, s);
        const int edges[4] = {keel, s ? stern : stem, rail[s], s ? stem : stern};
        static const bool against[2][4] = {{0, 0, 1, 1}, {1, 0, 0, 1}};
        for (int k = 0; k < 4; k++) {
            const int e = edges[k];
            batten_curve *line = e == keel      ? flat_line(0, 0, 1, 0)
                                 : e == rail[s] ? flat_line(0, 1, 1, 1)
                                 : e == stem    ? flat_line(1, 0, 1, 1)
                                                : flat_line(0, 0, 0, 1);
            add_use(&b, e, against[s][k], line);
        }
    }
    CHECK_OK(batten_surface_bilinear(
        (batten_vec3){-L / 2, -B / 2, 0}, (batten_vec3){L / 2, -B / 2, 0},
        (batten_vec3){-L / 2, B / 2, 0}, (batten_vec3){L / 2, B / 2, 0}, &deck));
    add_face(&b, deck, false);
    add_use(&b, rail[0], false, deck_line(-1));
    add_use(&b, rail[1], true, deck_line(1));
    const batten_body_measures m = measured(finish(&b, true), 1e-10);
    CHECK(m.is_closed);
    CHECK_NEAR(m.volume, 4. / 9 * L * B * T, 1e-12);
    CHECK_NEAR(m.area, 14.87906 + 2. / 3 * L * B, 5e-6);
    CHECK_NEAR(m.centroid[0], 0, 1e-12);
    CHECK_NEAR(m.centroid[1], 0, 1e-12);
    CHECK_NEAR(m.centroid[2], 5. / 8 * T - T, 1e-12);
}

/* ---- any curve on any surface ---- */

static batten_surface *hilly(test_random *random)
{
    enum { N = 9, DEGREE = 3 };
    double points[N * N * 3], knots[N + DEGREE + 1];
    for (int i = 0; i < N + DEGREE + 1; i++)
        knots[i] = bat_min(bat_max(i - DEGREE, 0), N - DEGREE);
    for (int i = 0; i < N * N; i++) {
        points[3 * i] = i / N;
        points[3 * i + 1] = i % N;
        points[3 * i + 2] = test_random_in(random, -1, 1);
    }
    const batten_axis axis = {DEGREE, N, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

/* A closed wavy curve about the middle of the domain [0, 6]^2. */
static batten_curve *wavy(test_random *random)
{
    double points[20], knots[11];
    for (int i = 0; i < 10; i++) {
        const double r = test_random_in(random, 1, 2.8);
        points[2 * i] = 3 + r * cos(BAT_PI * i / 5);
        points[2 * i + 1] = 3 + r * sin(BAT_PI * i / 5);
    }
    for (int i = 0; i <= 10; i++)
        knots[i] = i;
    batten_curve *periodic = NULL, *curve = NULL;
    CHECK_OK(batten_curve_create_periodic((batten_points){2, 10, points}, 3, NULL, knots,
                                          &periodic));
    CHECK_OK(batten_curve_clamp(periodic, &curve));
    batten_curve_unref(periodic);
    return curve;
}

/* One loop in the parameters; the edge, which no integral needs, is a line there. */
static double area_in(batten_surface *surface, batten_curve *loop, bool hole)
{
    batten_body *body = NULL;
    if (hole)
        CHECK_OK(batten_body_from_surface("", surface, 1e-9, &body));
    const batten_body_parts *border_parts = body ? batten_body_view(body) : NULL;
    bat_builder b;
    bat_builder_begin(&b, 1e-6);
    CHECK_OK(bat_builder_shell(&b, false));
    const int v = add_vertex(&b, 0, 0, 0);
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_to_dimension(loop, 3, &curve));
    const int e = add_edge(&b, curve, v, v);
    add_face(&b, batten_surface_ref(surface), false);
    if (hole) {
        for (int i = 0; i < border_parts->use_count; i++) {
            const batten_body_use *use = &border_parts->uses[i];
            const int edge =
                add_edge(&b, batten_curve_ref(border_parts->edges[use->edge].curve), v, v);
            add_use(&b, edge, use->reversed, batten_curve_ref(use->parameters));
        }
        CHECK_OK(bat_builder_loop(&b));
    }
    add_use(&b, e, hole, batten_curve_ref(loop));
    batten_body *trimmed = finish(&b, false);
    batten_body_measures m = {.area = -1};
    CHECK_OK(batten_body_measure(trimmed, 1e-10, NULL, &m));
    batten_body_unref(trimmed);
    batten_body_unref(body);
    return m.area;
}

TEST(what_a_loop_holds_and_what_is_left_are_the_whole)
{
    test_random random = test_random_begin("loop");
    for (int i = 0; i < test_cases(3); i++) {
        batten_surface *surface = hilly(&random);
        batten_curve *loop = wavy(&random);
        double area = 0, error;
        CHECK_OK(test_surface_area(surface, 1e-11, &area, &error));
        const double inside = area_in(surface, loop, false),
                     outside = area_in(surface, loop, true);
        CHECK(inside > 3 && inside < area);
        CHECK_NEAR((inside + outside) / area, 1, 1e-9);
        batten_curve_unref(loop);
        batten_surface_unref(surface);
    }
}

TEST(S5_the_work_for_a_face_is_bounded)
{
    batten_surface *surface = NULL;
    const batten_frame world = batten_frame_world();
    CHECK_OK(batten_surface_sphere(&world, 2, &surface));
    batten_body *body = whole(surface);
    const bat_face_rules rules = {
        .size = 1, .area_precision = 1e-12, .volume_precision = 1e-12, .most = 10000};
    bat_face_sums sums = {.is_met = true};
    CHECK_OK(bat_face_integrate(batten_body_view(body), 0, &rules, &sums));
    CHECK(!sums.is_met);
    CHECK_NEAR(sums.values[BAT_AREA], 16 * BAT_PI, sums.area_error);
    CHECK(sums.area_error > 1e-12);
    batten_body_unref(body);
}

TEST(N6_what_cannot_be_measured_is_refused)
{
    batten_surface *surface = NULL;
    batten_body_measures m = {.area = -1};
    CHECK_OK(batten_surface_sphere(&place, 2, &surface));
    batten_body *body = whole(surface);
    CHECK_STATUS(batten_body_measure(body, 0, NULL, &m), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_body_measure(body, NAN, NULL, &m), BATTEN_BAD_ARGUMENT);
    CHECK_BITS(m.area, -1);
    /* Rounding is as far as any precision goes. */
    CHECK_OK(batten_body_measure(body, 1e-300, NULL, &m));
    CHECK_NEAR(m.area / (16 * BAT_PI), 1, 1e-12);
    batten_body_unref(body);
}
