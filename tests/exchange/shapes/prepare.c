#include "exchange/shapes/prepare.h"

#include "exchange/shapes.h"
#include "numeric/jet.h"
#include "shape/formula/formula.h"
#include "support/bodies.h"

#include <batten/standard.h>

TEST(clamped_shapes_keep_their_bits)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(20); i++) {
        batten_surface *surface = random_surface(&random), *prepared = NULL;
        batten_curve *curve = random_curve(&random), *ready = NULL;
        CHECK_OK(bat_prepare_surface(&(batten_object){.name = "", .surface = surface}, 1e-6,
                                     NULL, &prepared));
        CHECK_OK(bat_prepare_curve(&(batten_object){.name = "", .curve = curve}, &ready));
        check_same_surface(surface, prepared);
        check_same_curve(curve, ready);
        batten_surface_unref(surface);
        batten_surface_unref(prepared);
        batten_curve_unref(curve);
        batten_curve_unref(ready);
    }
}

TEST(a_periodic_surface_is_clamped)
{
    const double points[] = {0, 0, 0, 0, 0, 4, 2, 0, 0, 2, 0, 4,
                             2, 2, 0, 2, 2, 4, 0, 2, 0, 0, 2, 4};
    const double u[] = {0, 1, 2, 3, 4}, v[] = {0, 0, 1, 1};
    const batten_axis around = {2, 4, u, true}, up = {1, 2, v, false};
    batten_surface *surface = NULL, *prepared = NULL;
    CHECK_OK(batten_surface_create(3, &around, &up, points, NULL, &surface));
    CHECK_OK(bat_prepare_surface(&(batten_object){.name = "", .surface = surface}, 1e-6, NULL,
                                 &prepared));
    const double *knots = batten_surface_knots(prepared, BATTEN_U);
    CHECK(knots[0] == knots[2] && !batten_surface_is_periodic(prepared, BATTEN_U));
    for (int i = 0; i <= 40; i++) {
        double p[3], q[3];
        CHECK_OK(batten_surface_evaluate(surface, i / 10.0, 0.25, 0, p));
        CHECK_OK(batten_surface_evaluate(prepared, i / 10.0, 0.25, 0, q));
        CHECK_NEAR(hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]), 0, 1e-14);
    }
    batten_surface_unref(prepared);
    batten_surface_unref(surface);
}

TEST(a_surface_in_the_plane_is_refused)
{
    const double points[] = {0, 0, 1, 0, 0, 1, 1, 1}, knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL, *prepared = NULL;
    CHECK_OK(batten_surface_create(2, &axis, &axis, points, NULL, &surface));
    CHECK_STATUS(bat_prepare_surface(&(batten_object){.name = "flat", .surface = surface}, 1e-6,
                                     NULL, &prepared),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("surface 'flat' has 2 dimensions");
    batten_surface_unref(surface);
}

TEST(points_are_counted_over_curves_surfaces_and_the_faces_of_bodies)
{
    test_random random = test_random_begin(__func__);
    batten_model *model = NULL;
    batten_curve *curve = random_curve(&random);
    batten_surface *surface = random_surface(&random);
    batten_body *body = NULL;
    const long long of_curve = batten_curve_point_count(curve);
    const long long of_surface = (long long)batten_surface_point_count(surface, BATTEN_U) *
                                 batten_surface_point_count(surface, BATTEN_V);
    CHECK_OK(batten_model_create(1, &model));
    CHECK_INT((long long)bat_count_points(model), 0);
    add_curve(model, "c", curve);
    CHECK_INT((long long)bat_count_points(model), of_curve);
    add_surface(model, "s", surface);
    CHECK_INT((long long)bat_count_points(model), of_curve + of_surface);
    const batten_status status = batten_body_from_surface("b", surface, 1e-6, &body);
    if (status == BATTEN_OK) {
        CHECK_OK(batten_model_add(
            model, &(batten_object){.name = "b", .kind = BATTEN_OBJECT_BODY, .body = body}));
        CHECK_INT((long long)bat_count_points(model), of_curve + 2 * of_surface);
    }
    batten_body_unref(body);
    batten_surface_unref(surface);
    batten_curve_unref(curve);
    batten_model_unref(model);
}

TEST(each_direction_is_clamped_where_an_end_is_not)
{
    const double points[] = {0, 0, 0, 0, 0, 4, 2, 0, 0, 2, 0, 4,
                             4, 2, 0, 4, 2, 4, 6, 3, 0, 6, 3, 4};
    const double line[] = {0, 0, 1, 1};
    /* Clamped nowhere, at the start, at the end. */
    static const double knots[][7] = {
        {0, 1, 2, 3, 4, 5, 6}, {2, 2, 2, 3, 4, 5, 6}, {0, 1, 2, 3, 4, 4, 4}};
    for (int n = 0; n < COUNT(knots); n++)
        for (int across = 0; across < 2; across++) {
            const batten_axis along = {2, 4, knots[n], false}, up = {1, 2, line, false};
            double turned[24];
            for (int i = 0; i < 4; i++)
                for (int j = 0; j < 2; j++)
                    memcpy(turned + 3 * (4 * j + i), points + 3 * (2 * i + j),
                           3 * sizeof(double));
            batten_surface *surface = NULL, *prepared = NULL;
            CHECK_OK(batten_surface_create(3, across ? &up : &along, across ? &along : &up,
                                           across ? turned : points, NULL, &surface));
            CHECK_OK(bat_prepare_surface(&(batten_object){.name = "", .surface = surface}, 1e-6,
                                         NULL, &prepared));
            const double *made = batten_surface_knots(prepared, across ? BATTEN_V : BATTEN_U);
            const int count = batten_surface_knot_count(prepared, across ? BATTEN_V : BATTEN_U);
            CHECK(made[0] == 2 && made[2] == 2 && made[count - 1] == 4 && made[count - 3] == 4);
            for (int i = 0; i <= 10; i++) {
                const double t = 2 + i / 5.0;
                double p[3], q[3];
                CHECK_OK(batten_surface_evaluate(surface, across ? 0.25 : t, across ? t : 0.25,
                                                 0, p));
                CHECK_OK(batten_surface_evaluate(prepared, across ? 0.25 : t, across ? t : 0.25,
                                                 0, q));
                for (int k = 0; k < 3; k++)
                    CHECK_NEAR(q[k], p[k], 1e-14);
            }
            batten_surface_unref(prepared);
            batten_surface_unref(surface);
        }
}

/* ---- bodies ---- */

static batten_object object_of(const char *name, batten_body *body)
{
    return (batten_object){.name = name, .kind = BATTEN_OBJECT_BODY, .body = body};
}

TEST(a_body_gets_curves_in_its_parameters_once)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3}), *traced = NULL,
                *again = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    const batten_object object = object_of("box", box);
    CHECK(!batten_body_view(box)->is_traced);
    CHECK_OK(bat_prepare_body(&object, 1e-6, 1, notes, &traced));
    const batten_body_parts *p = batten_body_view(traced);
    CHECK(p->is_traced && p->face_count == 6 && p->is_solid);
    for (int i = 0; i < p->use_count; i++)
        CHECK(p->uses[i].parameters != NULL);
    const batten_object ready = object_of("box", traced);
    CHECK_OK(bat_prepare_body(&ready, 1e-6, 1, notes, &again));
    CHECK(again == traced);
    CHECK_INT(batten_notes_count(notes), 0);
    batten_body_unref(again);
    batten_body_unref(traced);
    batten_body_unref(box);
    batten_notes_free(notes);
}

/* A triangle whose edges lie 1 above the plane of its face: they have no place on it. */
static batten_body *floating(void)
{
    static const double flat[] = {0, 0, 0, 0, 4, 0, 4, 0, 0, 4, 4, 0}, knots[] = {0, 0, 1, 1};
    static const double corners[9] = {1, 1, 1, 3, 1, 1, 1, 3, 1};
    static const batten_body_use uses[3] = {
        {0, false, NULL}, {1, false, NULL}, {2, false, NULL}};
    static const batten_body_loop loop = {0, 3};
    static const batten_body_shell shell = {.first = 0, .count = 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_body_edge edges[3];
    batten_curve *curves[3] = {NULL};
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, flat, NULL, &surface));
    for (int i = 0; i < 3; i++) {
        CHECK_OK(batten_curve_line(3, corners + 3 * i, corners + (3 * i + 3) % 9, &curves[i]));
        edges[i] = (batten_body_edge){curves[i], {i, (i + 1) % 3}};
    }
    const batten_body_face face = {.name = "lid", .surface = surface, .first = 0, .count = 1};
    const batten_body_parts parts = {.tolerance = 1e-3,
                                     .vertex_count = 3,
                                     .vertices = corners,
                                     .edge_count = 3,
                                     .edges = edges,
                                     .use_count = 3,
                                     .uses = uses,
                                     .loop_count = 1,
                                     .loops = &loop,
                                     .face_count = 1,
                                     .faces = &face,
                                     .shell_count = 1,
                                     .shells = &shell};
    CHECK_OK(batten_body_create(&parts, &body));
    for (int i = 0; i < 3; i++)
        batten_curve_unref(curves[i]);
    batten_surface_unref(surface);
    return body;
}

TEST(a_body_that_cannot_have_them_stays_as_it_is_with_a_note)
{
    batten_body *body = floating(), *out = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    const batten_object object = object_of("roof", body);
    CHECK_OK(bat_prepare_body(&object, 1e-6, 1, notes, &out));
    CHECK(out == body);
    if (batten_notes_dropped(notes) == 0) {
        const int last = batten_notes_count(notes) - 1;
        CHECK(last >= 0);
        CHECK_TEXT(batten_notes_at(notes, last)->text,
                   "not all faces have curves in their parameters; written as they are");
        for (int i = 0; i <= last; i++)
            CHECK(strncmp(batten_notes_at(notes, i)->entity, "roof", 4) == 0);
    }
    batten_body_unref(out);
    batten_body_unref(body);
    batten_notes_free(notes);
}

TEST(a_surface_becomes_a_body_of_one_face)
{
    test_random random = test_random_begin(__func__);
    batten_surface *surface = random_surface(&random);
    batten_body *body = NULL;
    const batten_object object = {
        .name = "deck", .kind = BATTEN_OBJECT_SURFACE, .surface = surface};
    CHECK_OK(bat_prepare_body(&object, 1e-6, 1, NULL, &body));
    const batten_body_parts *p = batten_body_view(body);
    CHECK_INT(p->face_count, 1);
    CHECK_TEXT(p->faces[0].name, "deck");
    check_same_surface(surface, p->faces[0].surface);
    CHECK_NEAR(p->tolerance, 1e-6, 0);
    batten_body_unref(body);
    batten_surface_unref(surface);
}

/* z = sin(u), which no spline is. */
static batten_status arch(const void *data, const bat_surface_place *at, int order, double *out)
{
    (void)data;
    const double s = sin(at->u), c = cos(at->u);
    const bat_jet u = bat_jet_u(at->u), v = bat_jet_v(at->v);
    const bat_jet xyz[3] = {u, v, bat_jet_compose((const double[4]){s, c, -s, -c}, u)};
    for (int i = 0; i < BATTEN_SURFACE_DERIVATIVES(order); i++)
        for (int k = 0; k < 3; k++)
            out[3 * i + k] = xyz[k].d[i];
    return BATTEN_OK;
}

static void keep(void *data)
{
    (void)data;
}

TEST(a_surface_that_is_approximated_keeps_its_tolerance_and_says_so)
{
    static const bat_formula formula = {"arch", arch, NULL, keep};
    static const double ends[2] = {0, 1}, tolerances[] = {1e-3, 1e-6};
    const bat_formula_axis axis = {2, ends, 2};
    for (int k = 0; k < COUNT(tolerances); k++) {
        batten_surface *surface = NULL, *made = NULL;
        batten_notes *notes = NULL;
        double error = 0;
        CHECK_OK(batten_notes_create(5, &notes));
        CHECK_OK(bat_formula_create(&formula, NULL, 3, &axis, &axis, 2, &surface));
        CHECK_OK(bat_prepare_surface(&(batten_object){.name = "s", .surface = surface},
                                     tolerances[k], notes, &made));
        if (batten_notes_dropped(notes) == 0) {
            const batten_note *note = batten_notes_at(notes, 0);
            CHECK_INT(sscanf(note->text, "approximated within %lf", &error), 1);
            CHECK_TEXT(note->entity, "s");
            CHECK(error > 0 && error <= tolerances[k]);
        }
        for (int i = 0; i <= 20; i++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(made, i / 20.0, (7 * i % 21) / 20.0, 0, p));
            CHECK_NEAR(p[2], sin(p[0]), 1.5 * tolerances[k]);
        }
        batten_notes_free(notes);
        batten_surface_unref(made);
        batten_surface_unref(surface);
    }
}
