/* Integrals over a face within polygons, by triangles of the polygon and Gauss in each. */
#include "body/measure/face_integral.h"
#include "body/builder.h"
#include "numeric/quadrature.h"
#include "support/test.h"

/* z = (a u^2 + b v^2) / 2 + c u v over [-2, 2]^2. */
typedef struct {
    double a, b, c;
} graph;

/* The control point between p and q: the polar form. */
static double height(const graph *g, const double *p, const double *q)
{
    return (g->a * p[0] * q[0] + g->b * p[1] * q[1] + g->c * (p[0] * q[1] + p[1] * q[0])) / 2;
}

static batten_surface *make_graph(const graph *g, int knots)
{
    static const double ends[] = {-2, -2, -2, 2, 2, 2}, more[] = {-0.7, 0.3, 1.1};
    static const double corners[3][2] = {{-2, -2}, {-2, 2}, {2, 2}}; /* of the polar forms */
    const batten_axis axis = {2, 3, ends, false};
    batten_surface *plain = NULL, *along = NULL, *made = NULL;
    double points[9][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double u = 2 * (i - 1), v = 2 * (j - 1);
            const double uu = corners[i][0] * corners[i][1], vv = corners[j][0] * corners[j][1];
            points[3 * i + j][0] = u;
            points[3 * i + j][1] = v;
            points[3 * i + j][2] = (g->a * uu + g->b * vv) / 2 + g->c * u * v;
        }
    CHECK_OK(batten_surface_create(3, &axis, &axis, points[0], NULL, &plain));
    CHECK_OK(batten_surface_refine(plain, BATTEN_U, knots, more, &along));
    CHECK_OK(batten_surface_refine(along, BATTEN_V, knots, more, &made));
    batten_surface_unref(along);
    batten_surface_unref(plain);
    return made;
}

/* A loop along a polygon; its edges are this far above the surface. */
static void add_loop(bat_builder *b, const graph *g, int count, const double (*corners)[2],
                     double lift)
{
    static const double straight[] = {0, 0, 1, 1}, bent[] = {0, 0, 0, 1, 1, 1};
    const int first = b->parts.vertex_count;
    CHECK_OK(bat_builder_loop(b));
    for (int i = 0, vertex; i < count; i++) {
        const double *p = corners[i];
        CHECK_OK(
            bat_builder_vertex(b, (double[]){p[0], p[1], height(g, p, p) + lift}, &vertex));
    }
    for (int i = 0; i < count; i++) {
        const double *p = corners[i], *q = corners[(i + 1) % count];
        const double flat[2][2] = {{p[0], p[1]}, {q[0], q[1]}};
        const double lifted[3][3] = {
            {p[0], p[1], height(g, p, p) + lift},
            {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, height(g, p, q) + lift},
            {q[0], q[1], height(g, q, q) + lift}};
        batten_curve *curve = NULL, *parameters = NULL;
        int edge;
        CHECK_OK(batten_curve_create((batten_points){3, 3, lifted[0]}, 2, NULL, bent, &curve));
        CHECK_OK(batten_curve_create((batten_points){2, 2, flat[0]}, 1, NULL, straight,
                                     &parameters));
        CHECK_OK(bat_builder_edge(b, curve, first + i, first + (i + 1) % count, &edge));
        CHECK_OK(bat_builder_use(b, edge, false, parameters));
        batten_curve_unref(parameters);
        batten_curve_unref(curve);
    }
}

/* What the integrals are made of, at a place. */
static void integrands(const graph *g, const bat_face_rules *rules, double u, double v,
                       double out[BAT_FACE_INTEGRALS])
{
    const double at[2] = {u, v}, n[3] = {-(g->a * u + g->c * v), -(g->b * v + g->c * u), 1};
    const double norm = sqrt(n[0] * n[0] + n[1] * n[1] + 1), s = rules->size;
    const double x[3] = {(u - rules->centre.x) / s, (v - rules->centre.y) / s,
                         (height(g, at, at) - rules->centre.z) / s};
    out[BAT_AREA] = norm / (s * s);
    for (int k = 0; k < 3; k++) {
        out[BAT_AREA_MOMENT + k] = x[k] * norm / (s * s);
        out[BAT_VOLUME + k] = x[k] * n[k] / (s * s);
        out[BAT_VOLUME_MOMENT + k] = x[k] * x[k] / 2 * n[k] / (s * s);
    }
}

/* The triangles from the origin to each side, with their signs. */
static void add_polygon(const graph *g, const bat_face_rules *rules, int count,
                        const double (*corners)[2], double sums[BAT_FACE_INTEGRALS])
{
    enum { EACH = 24 };
    double nodes[EACH], weights[EACH], here[BAT_FACE_INTEGRALS];
    bat_gauss(EACH, nodes, weights);
    for (int side = 0; side < count; side++) {
        const double *p = corners[side], *q = corners[(side + 1) % count];
        const double twice = p[0] * q[1] - p[1] * q[0];
        for (int i = 0; i < EACH; i++)
            for (int j = 0; j < EACH; j++) {
                const double s = (1 + nodes[i]) / 2, t = (1 + nodes[j]) / 2;
                const double weight = weights[i] * weights[j] / 4 * s * twice;
                integrands(g, rules, s * (p[0] + t * (q[0] - p[0])),
                           s * (p[1] + t * (q[1] - p[1])), here);
                for (int k = 0; k < BAT_FACE_INTEGRALS; k++)
                    sums[k] += weight * here[k];
            }
    }
}

static const double outer[6][2] = {{-1.5, -1}, {1.7, -1.3}, {1.2, 0.4},
                                   {1.6, 1.5}, {-0.3, 0.9}, {-1.8, 1.4}};
static const double hole[4][2] = {{-0.4, -0.5}, {-0.2, 0.5}, {0.6, 0.2}, {0.5, -0.6}};
static const bat_face_rules rules = {.centre = {0.3, -0.2, 0.5},
                                     .size = 4,
                                     .area_precision = 1e-9,
                                     .volume_precision = 1e-9,
                                     .most = 1u << 20};

/* A loop the other way around leaves out what it holds. */
static void integrate(const graph *g, int knots, bool reversed, double lift, bat_face_sums *out)
{
    batten_surface *surface = make_graph(g, knots);
    bat_builder b;
    bat_builder_begin(&b, 1e-9);
    CHECK_OK(bat_builder_shell(&b, false));
    CHECK_OK(
        bat_builder_face(&b, &(batten_body_face){.surface = surface, .reversed = reversed}));
    batten_surface_unref(surface);
    double turned[6][2];
    for (int i = 0; i < 6; i++)
        memcpy(turned[i], outer[reversed ? 5 - i : i], sizeof turned[i]);
    add_loop(&b, g, 6, (const double(*)[2])turned, lift);
    for (int i = 0; i < 4; i++)
        memcpy(turned[i], hole[reversed ? 3 - i : i], sizeof turned[i]);
    add_loop(&b, g, 4, (const double(*)[2])turned, lift);
    b.parts.is_traced = true;
    CHECK_OK(bat_face_integrate(&b.parts, 0, &rules, out));
    bat_builder_end(&b);
}

TEST(the_integrals_over_a_face_are_those_over_its_polygons)
{
    static const graph graphs[] = {{0, 0, 0}, {1, 0.5, 0}, {0, 0, 1}, {-0.7, 1.2, 0.4}};
    for (int i = 0; i < COUNT(graphs); i++)
        for (int knots = 0; knots <= 3; knots += 3)
            for (int reversed = 0; reversed < 2; reversed++) {
                double exact[BAT_FACE_INTEGRALS] = {0};
                bat_face_sums sums;
                add_polygon(&graphs[i], &rules, 6, outer, exact);
                add_polygon(&graphs[i], &rules, 4, hole, exact);
                integrate(&graphs[i], knots, reversed, 0, &sums);
                CHECK(sums.is_met);
                CHECK_NEAR(sums.slack, 0, 1e-14);
                CHECK(sums.area_error <= 1e-9 * exact[BAT_AREA]);
                CHECK(sums.volume_error <= 1e-9 * exact[BAT_AREA]);
                for (int k = 0; k < BAT_FACE_INTEGRALS; k++)
                    CHECK_NEAR(sums.values[k],
                               reversed && k >= BAT_VOLUME ? -exact[k] : exact[k],
                               1e-9 * exact[BAT_AREA]);
            }
}

/* Of a plane face the edges are as long as the polygon. */
TEST(edges_above_their_face_leave_a_ribbon_between_them)
{
    static const graph plane = {0, 0, 0};
    const double lift = 1e-3;
    double length = 0;
    bat_face_sums sums;
    for (int i = 0; i < 6; i++)
        length +=
            hypot(outer[i][0] - outer[(i + 1) % 6][0], outer[i][1] - outer[(i + 1) % 6][1]);
    for (int i = 0; i < 4; i++)
        length += hypot(hole[i][0] - hole[(i + 1) % 4][0], hole[i][1] - hole[(i + 1) % 4][1]);
    integrate(&plane, 3, false, lift, &sums);
    CHECK_NEAR(sums.slack, lift * length / (rules.size * rules.size), 1e-12);
}

TEST(the_sums_of_faces_add_up_and_their_volume_is_the_mean_of_three)
{
    bat_face_sums all = {.slack = 0.25, .area_error = 1, .volume_error = 2};
    bat_face_sums one = {.slack = 0.5, .area_error = 3, .volume_error = 5};
    for (int k = 0; k < BAT_FACE_INTEGRALS; k++)
        one.values[k] = k + 1;
    bat_face_add(&all, &one);
    bat_face_add(&all, &one);
    CHECK_NEAR(all.slack, 1.25, 0);
    CHECK_NEAR(all.area_error, 7, 0);
    CHECK_NEAR(all.volume_error, 12, 0);
    for (int k = 0; k < BAT_FACE_INTEGRALS; k++)
        CHECK_NEAR(all.values[k], 2 * (k + 1), 0);
    CHECK_NEAR(bat_face_volume(&all), (10 + 12 + 14) / 3.0, 1e-15);
    CHECK_NEAR(bat_face_volume_error(&all), 12 + 2, 1e-15); /* the spread is 2 */
    all.slack = 9;
    CHECK_NEAR(bat_face_volume_error(&all), 12 + 3, 1e-15); /* a third of the slack is more */
}
