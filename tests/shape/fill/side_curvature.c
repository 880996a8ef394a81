/* Curvature taken over by the quads of a plane fill. */
#include "shape/fill/fill.h"

#include "shape/fill/loops.h"
#include "support/faults.h"

/* t^3 (1 - t)^3 times 20 across a side, flat at its corners. */
static const double bump[7][3] = {{0}, {0}, {0}, {0, 0, 1}, {0}, {0}, {0}};

/* A square of sides 2 about the origin, flat; the ribbon of its first side bends across it by the bump. */
static void add_square(hole *h, batten_curve **bend)
{
    static const double corners[4][3] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    static const double in[4][3] = {{0, 2, 0}, {-2, 0, 0}, {0, -2, 0}, {2, 0, 0}};
    static const double ends[2] = {0, 1};
    memset(h, 0, sizeof *h);
    for (int i = 0; i < 4; i++) {
        double side[2][3], slope[2][3];
        memcpy(side[0], corners[i], sizeof side[0]);
        memcpy(side[1], corners[(i + 1) % 4], sizeof side[1]);
        memcpy(slope[0], in[i], sizeof slope[0]);
        memcpy(slope[1], in[i], sizeof slope[1]);
        hole_add(h, 1, side[0], 1, slope[0]);
    }
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){6, 1, ends}, bump[0], NULL, bend));
    h->ribbons[0].curvature = *bend;
}

/* Quad i, which has u along the first half of side i: bilinear, with the degree of the ribbon. */
static batten_surface *quad_of_square(int i)
{
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double *a = corner[i], *next = corner[(i + 1) % 4], *before = corner[(i + 3) % 4];
    const double points[12] = {a[0],
                               a[1],
                               0,
                               (a[0] + before[0]) / 2,
                               (a[1] + before[1]) / 2,
                               0,
                               (a[0] + next[0]) / 2,
                               (a[1] + next[1]) / 2,
                               0,
                               0,
                               0,
                               0};
    const double knots[4] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL, *raised[2] = {NULL, NULL};
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    CHECK_OK(batten_surface_elevate(surface, BATTEN_U, 5, &raised[0]));
    CHECK_OK(batten_surface_elevate(raised[0], BATTEN_V, 5, &raised[1]));
    batten_surface_unref(surface);
    batten_surface_unref(raised[0]);
    return raised[1];
}

/* The quads stay: a failure may leave some of the others bent. */
static batten_status bend_quads(const bat_fill_loop *loop, batten_surface *const *quads,
                                batten_surface **made)
{
    for (int i = 0; i < 4; i++)
        made[i] = batten_surface_ref(quads[i]);
    const batten_status status = bat_fill_bend(loop, made);
    for (int i = 0; i < 4 && status != BATTEN_OK; i++)
        batten_surface_unref(made[i]);
    return status;
}

/* S_vv of a quad along its first half of side 1, at u: what its ribbon has, in the quad's v. */
TEST(a_plane_fill_takes_the_second_derivative_of_a_ribbon_over_along_its_side_alone)
{
    hole h;
    batten_curve *bend = NULL;
    bat_fill_loop loop = {0};
    batten_surface_fill_report report = {0};
    batten_surface *quads[4], *made[4];
    add_square(&h, &bend);
    CHECK_OK(bat_fill_loop_make(4, h.ribbons, 1e-9, &report, &loop));
    for (int i = 0; i < 4; i++)
        quads[i] = quad_of_square(i);
    CHECK_OK(bend_quads(&loop, quads, made));
    for (int k = 0; k <= 10; k++) {
        const double u = k / 10.0, t = u / 2;
        double d[6][3];
        /* a whole slope is 2 long over the side, and v is half as long */
        const double wanted = 20 * pow(t * (1 - t), 3) / 4;
        CHECK_OK(batten_surface_evaluate(made[0], u, 0, 2, d[0]));
        CHECK_NEAR(d[0][2], 0, 1e-15);
        CHECK_NEAR(d[2][2], 0, 1e-15);
        CHECK_NEAR(d[5][2], wanted, 1e-12);
        CHECK_OK(batten_surface_evaluate(made[1], 0, u, 2, d[0]));
        CHECK_NEAR(d[1][2], 0, 1e-15);
        CHECK_NEAR(d[3][2], wanted, 1e-12);
        /* The spoke moves by v^2 (1 - v)^3 / 2 times what is added in the middle. */
        CHECK_OK(batten_surface_evaluate(made[0], 1, u, 0, d[0]));
        CHECK_NEAR(d[0][2], u * u * pow(1 - u, 3) / 2 * 20 / 64 / 4, 1e-13);
        for (int i = 2; i < 4; i++) {
            CHECK_OK(batten_surface_evaluate(made[i], u, 0.3, 0, d[0]));
            CHECK_NEAR(d[0][2], 0, 0);
        }
    }
    for (int i = 0; i < 4; i++) {
        batten_surface_unref(quads[i]);
        batten_surface_unref(made[i]);
    }
    bat_fill_loop_free(&loop);
    batten_curve_unref(bend);
    hole_free(&h);
}

/* The first of those that are made bends in the middle of the side. */
static batten_status bend_once(const bat_fill_loop *loop, batten_surface *const *quads)
{
    batten_surface *made[4];
    const batten_status status = bend_quads(loop, quads, made);
    double d[6][3];
    if (status != BATTEN_OK)
        return status;
    CHECK_OK(batten_surface_evaluate(made[0], 1, 0, 2, d[0]));
    CHECK_NEAR(d[5][2], 20.0 / 64 / 4, 1e-12);
    for (int i = 0; i < 4; i++)
        batten_surface_unref(made[i]);
    return BATTEN_OK;
}

TEST(taking_curvature_over_reports_every_lack_of_memory)
{
    hole h;
    batten_curve *bend = NULL;
    bat_fill_loop loop = {0};
    batten_surface_fill_report report = {0};
    batten_surface *quads[4];
    add_square(&h, &bend);
    CHECK_OK(bat_fill_loop_make(4, h.ribbons, 1e-9, &report, &loop));
    for (int i = 0; i < 4; i++)
        quads[i] = quad_of_square(i);
    CHECK_ALL_ALLOCATIONS(bend_once(&loop, quads));
    for (int i = 0; i < 4; i++)
        batten_surface_unref(quads[i]);
    bat_fill_loop_free(&loop);
    batten_curve_unref(bend);
    hole_free(&h);
}
