/* The rulings that a developable surface reports. */
#include <batten/plate.h>
#include <batten/standard.h>

#include "support/test.h"

/* An arc about the z-axis at the height z. */
static batten_curve *arc(double radius, double from, double to, double z)
{
    batten_frame frame = batten_frame_world();
    batten_curve *curve = NULL;
    frame.origin.z = z;
    CHECK_OK(batten_curve_arc_in(&frame, radius, from, to - from, &curve));
    return curve;
}

/* The same shape with another parameter. */
static batten_curve *reparametrised(batten_curve *curve)
{
    batten_curve *changed = NULL;
    CHECK_OK(batten_curve_moebius(curve, 2, 0, 1, 1, &changed));
    batten_curve_unref(curve);
    return changed;
}

static batten_curve *space_cubic(double x, double y, double z)
{
    const double points[12] = {x,     y,       z,       x + 1, y + 0.8, z + 0.1,
                               x + 2, y - 0.3, z + 0.4, x + 3, y + 0.5, z + 0.2};
    const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 4, points}, 3, NULL, knots, &curve));
    return curve;
}

static batten_status develop(const batten_curve *a, const batten_curve *b, double tolerance,
                             batten_developable *out)
{
    batten_surface_developable_options options = batten_surface_developable_defaults();
    options.tolerance = tolerance;
    return batten_surface_developable(a, b, &options, out);
}

static void drop(batten_curve *a, batten_curve *b)
{
    batten_curve_unref(a);
    batten_curve_unref(b);
}

/* Rulings that were found, not only matched: from edge to edge in order, each on the surface. */
TEST(the_rulings_that_are_reported_lie_on_the_surface_from_its_start_to_its_end)
{
    batten_curve *edges[2][2] = {
        {space_cubic(0, 0, 0), reparametrised(space_cubic(0.2, 0.3, 1))},
        {arc(1, 0, 2, 0), arc(1, 0.3, 1.8, 1)}};
    for (int k = 0; k < 2; k++) {
        batten_developable made = {0};
        CHECK_OK(develop(edges[k][0], edges[k][1], 1e-7, &made));
        CHECK(made.count >= 17);
        const batten_ruling *first = made.rulings, *last = first + made.count - 1;
        CHECK(first->u == 0 && last->u == 1);
        for (int e = 0; e < 2; e++) {
            const batten_interval domain = batten_curve_domain(edges[k][e]);
            CHECK_NEAR(e ? first->t : first->s, domain.a, 1e-12);
            CHECK_NEAR(e ? last->t : last->s, domain.b, 1e-12);
        }
        for (int i = 0; i < made.count; i++) {
            const batten_ruling *ruling = &made.rulings[i];
            CHECK(i == 0 || (ruling->u >= ruling[-1].u && ruling->s >= ruling[-1].s &&
                             ruling->t >= ruling[-1].t));
            for (int e = 0; e < 2; e++) {
                double given[3], found[3];
                CHECK_OK(
                    batten_curve_evaluate(edges[k][e], e ? ruling->t : ruling->s, 0, given));
                CHECK_OK(batten_surface_evaluate(made.surface, ruling->u, e, 0, found));
                for (int c = 0; c < 3; c++)
                    CHECK_NEAR(found[c], given[c], k == 0 ? 1e-6 : 1e-2);
            }
        }
        batten_developable_release(&made);
        drop(edges[k][0], edges[k][1]);
    }
}
