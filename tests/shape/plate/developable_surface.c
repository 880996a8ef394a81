/* The rulings that a developable surface reports. */
#include "shape/plate/plates.h"

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
