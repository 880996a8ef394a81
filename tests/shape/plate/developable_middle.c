/* The surface between the cones, through rulings that are known. */
#include "shape/plate/developable_parts.h"

#include "shape/plate/plates.h"

enum { PAIRS = 17 };

/* Coaxial arcs with different parameters, and the rulings between equal angles. */
typedef struct {
    bat_plate plate;
    bat_pair pairs[PAIRS];
    batten_curve *curves[2];
} bench;

static void begin_bench(bench *b, bool rough)
{
    *b = (bench){.plate = {.size = 3, .rough = rough, .count = PAIRS}};
    b->curves[0] = arc(1, 0, 1.5, 0);
    b->curves[1] = reparametrised(arc(2, 0, 1.5, 1));
    for (int e = 0; e < 2; e++)
        CHECK_OK(bat_plate_edge_make(b->curves[e], e ? "second" : "first", &b->plate.edge[e]));
    for (int i = 0; i < PAIRS; i++)
        b->pairs[i] = (bat_pair){i / (PAIRS - 1.0), i / (PAIRS - 1.0)};
    b->plate.pairs = b->pairs;
}

static batten_status make(const bench *b, double tolerance, bat_middle *m)
{
    batten_surface_developable_options options = batten_surface_developable_defaults();
    options.tolerance = tolerance;
    *m = (bat_middle){0};
    const batten_status status = bat_middle_make(&b->plate, &options, m);
    if (status != BATTEN_OK) {
        bat_middle_release(m);
        *m = (bat_middle){0};
    }
    return status;
}

/* Fitted edges are off by most about midway between rulings. */
TEST(the_error_of_fitted_edges_is_their_distance_midway_between_rulings)
{
    static const double tolerances[] = {1e-3, 1e-7};
    for (int i = 0; i < 2 * COUNT(tolerances); i++) {
        bench b;
        bat_middle m;
        double worst = 0;
        begin_bench(&b, i % 2);
        CHECK_OK(make(&b, tolerances[i / 2], &m));
        for (int e = 0; e < 2; e++)
            for (int k = 0; k + 1 < m.count; k++) {
                double p[3];
                CHECK_OK(batten_curve_evaluate(m.edge[e], (m.tau[k] + m.tau[k + 1]) / 2, 0, p));
                worst = fmax(worst, fabs(hypot(p[0], p[1]) - (e + 1)));
            }
        CHECK_NEAR(m.error, worst, 1e-6 * worst + 1e-14);
        CHECK(m.error <= tolerances[i / 2] && m.error > 0);
        bat_middle_release(&m);
        drop(b.curves[0], b.curves[1]);
    }
}

TEST(rulings_of_the_middle_have_their_points_parameters_and_chords)
{
    bench b;
    bat_middle m;
    begin_bench(&b, false);
    CHECK_OK(make(&b, 1e-3, &m));
    for (int i = 0; i < m.count; i++) {
        for (int e = 0; e < 2; e++) {
            double p[3];
            CHECK_OK(batten_curve_evaluate(b.curves[e], m.u[e][i], 0, p));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(m.points[e][3 * i + c], p[c], 1e-12);
        }
        /* Equal angles on both edges; chords of both circles add. */
        const double *p = m.points[0] + 3 * i, *q = m.points[1] + 3 * i;
        CHECK_NEAR(atan2(p[1], p[0]), atan2(q[1], q[0]), 1e-7);
        const double chord = i ? hypot(p[0] - p[-3], p[1] - p[-2]) : 0;
        CHECK_NEAR(m.tau[i], i ? m.tau[i - 1] + 3 * chord : 0, 1e-6);
    }
    bat_middle_release(&m);
    drop(b.curves[0], b.curves[1]);
}
