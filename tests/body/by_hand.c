#include "body/by_hand.h"
#include "body/trace/traced.h"
#include "support/test.h"
#include <batten/standard.h>
#include <stdlib.h>

const batten_frame hand_world = {.x = {1, 0, 0}, .z = {0, 0, 1}};

hand hand_begin(void)
{
    hand m = {.turn = 0};
    bat_builder_begin(&m.builder, 1e-6);
    CHECK_OK(bat_builder_shell(&m.builder, false));
    return m;
}

hand hand_turned(int turn)
{
    hand m = hand_begin();
    m.turn = turn;
    return m;
}

void hand_every_turn(void (*of)(int turn))
{
    for (int turn = 0; turn < 8; turn++)
        of(turn);
}

static int vertex_at(hand *m, const double p[3])
{
    const batten_body_parts *parts = &m->builder.parts;
    int index = 0;
    for (int i = 0; i < parts->vertex_count; i++) {
        const double *q = parts->vertices + 3 * i;
        if (hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]) < 1e-9)
            return i;
    }
    CHECK_OK(bat_builder_vertex(&m->builder, p, &index));
    return index;
}

/* Takes the curve over. */
int hand_edge(hand *m, batten_curve *curve)
{
    const batten_interval on = batten_curve_domain(curve);
    double a[3], b[3];
    int index = 0;
    CHECK_OK(batten_curve_evaluate(curve, on.a, 0, a));
    CHECK_OK(batten_curve_evaluate(curve, on.b, 0, b));
    const int start = vertex_at(m, a), end = vertex_at(m, b);
    CHECK_OK(bat_builder_edge(&m->builder, curve, start, end, &index));
    batten_curve_unref(curve);
    return index;
}

int hand_line(hand *m, double x0, double y0, double z0, double x1, double y1, double z1)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_line(3, (double[]){x0, y0, z0}, (double[]){x1, y1, z1}, &curve));
    return hand_edge(m, curve);
}

/* About the z-axis at this height, angles in degrees. */
int hand_arc(hand *m, double radius, double z, double start, double angle)
{
    batten_frame frame = hand_world;
    batten_curve *curve = NULL;
    frame.origin.z = z;
    CHECK_OK(batten_curve_arc_in(&frame, radius, start * acos(-1) / 180, angle * acos(-1) / 180,
                                 &curve));
    return hand_edge(m, curve);
}

/* The same with u for v. */
static batten_surface *transposed(const batten_surface *surface)
{
    const int nu = batten_surface_point_count(surface, BATTEN_U),
              nv = batten_surface_point_count(surface, BATTEN_V);
    const double *from = batten_surface_points(surface),
                 *weights = batten_surface_weights(surface);
    double *points = test_array((size_t)nu * nv, 3 * sizeof *points),
           *other = test_array((size_t)nu * nv, sizeof *other);
    batten_axis axes[2];
    batten_surface *made = NULL;
    for (int k = 0; k < 2; k++) {
        const batten_direction d = k ? BATTEN_V : BATTEN_U;
        axes[k] = (batten_axis){batten_surface_degree(surface, d), k ? nv : nu,
                                batten_surface_knots(surface, d),
                                batten_surface_is_periodic(surface, d)};
    }
    for (int i = 0; i < nu; i++)
        for (int j = 0; j < nv; j++) {
            memcpy(points + 3 * (j * nu + i), from + 3 * (i * nv + j), 3 * sizeof *points);
            other[j * nu + i] = weights ? weights[i * nv + j] : 1;
        }
    CHECK_OK(
        batten_surface_create(3, &axes[1], &axes[0], points, weights ? other : NULL, &made));
    return made;
}

static void take_over(batten_surface **surface, batten_surface *by)
{
    batten_surface_unref(*surface);
    *surface = by;
}

/* Takes the surface over. */
void hand_face(hand *m, batten_surface *surface, bool reversed)
{
    batten_surface *turned = NULL;
    if (m->turn & 1)
        take_over(&surface, transposed(surface));
    for (int k = 0; k < 2; k++)
        if (m->turn & (k ? 4 : 2)) {
            CHECK_OK(batten_surface_reverse(surface, k ? BATTEN_V : BATTEN_U, &turned));
            take_over(&surface, turned);
        }
    const int turns = (m->turn & 1) + (m->turn >> 1 & 1) + (m->turn >> 2);
    CHECK_OK(bat_builder_face(
        &m->builder,
        &(batten_body_face){.surface = surface, .reversed = reversed != (turns % 2 == 1)}));
    batten_surface_unref(surface);
}

/* Edges from 1; a minus runs against the edge. */
void hand_loop(hand *m, int count, const int *edges)
{
    CHECK_OK(bat_builder_loop(&m->builder));
    for (int i = 0; i < count; i++)
        CHECK_OK(bat_builder_use(&m->builder, abs(edges[i]) - 1, edges[i] < 0, NULL));
}

batten_surface *hand_cylinder(double radius, double height)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_cylinder(&hand_world, radius, height, &surface));
    return surface;
}

/* Trace it, look at what holds for all, and that it is the same the second time. */
batten_body *hand_trace(hand *m, double tolerance, batten_body_trace_report *report)
{
    batten_body *body = NULL, *traced = NULL, *again = NULL;
    CHECK_OK(batten_body_create(&m->builder.parts, &body));
    bat_builder_end(&m->builder);
    CHECK_OK(batten_body_trace(body, tolerance, NULL, NULL, report, &traced));
    check_traced(traced, tolerance);
    CHECK(report->error <= tolerance);
    CHECK_OK(batten_body_trace(traced, tolerance, NULL, NULL, NULL, &again));
    check_traced(again, tolerance);
    CHECK_INT(batten_body_view(again)->edge_count, batten_body_view(traced)->edge_count);
    CHECK_INT(batten_body_view(again)->use_count, batten_body_view(traced)->use_count);
    batten_body_unref(again);
    batten_body_unref(body);
    return traced;
}

/* How many edges have exactly two uses, one each way. */
int hand_shared(const batten_body *body)
{
    const batten_body_parts *p = batten_body_view(body);
    int count = 0;
    for (int e = 0; e < p->edge_count; e++) {
        int uses[2] = {0, 0};
        for (int i = 0; i < p->use_count; i++)
            if (p->uses[i].edge == e)
                uses[p->uses[i].reversed]++;
        count += uses[0] == 1 && uses[1] == 1;
    }
    return count;
}

double hand_area(const batten_body *body)
{
    batten_body_measures measures;
    CHECK_OK(batten_body_measure(body, 1e-8, NULL, &measures));
    return measures.area;
}

double hand_volume(const batten_body *body)
{
    batten_body_measures measures;
    CHECK_OK(batten_body_measure(body, 1e-8, NULL, &measures));
    CHECK(measures.is_closed);
    return measures.volume;
}

void hand_plate(hand *m, double x0, double y0, double x1, double y1, double z)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){x0, y0, z}, (batten_vec3){x1, y0, z},
                                     (batten_vec3){x0, y1, z}, (batten_vec3){x1, y1, z},
                                     &surface));
    hand_face(m, surface, false);
}

batten_surface *hand_torus(void)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_torus(&hand_world, 3, 1, &surface));
    return surface;
}
