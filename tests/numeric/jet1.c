/* Jets of order 1 against those of order 3, which are tested by themselves. */
#include "numeric/jet1.h"
#include "numeric/jet3.h"
#include "support/test.h"

#include <float.h>

static bat_jet1 random_jet(test_random *random, bat_jet *same)
{
    const bat_jet1 made = {test_random_in(random, 1, 3), test_random_in(random, -2, 2),
                           test_random_in(random, -2, 2)};
    *same = (bat_jet){{made.f, made.u, made.v}};
    return made;
}

static bat_jet1_vector random_vector(test_random *random, bat_jet3 *same)
{
    bat_jet1_vector made;
    made.x = random_jet(random, &same->x);
    made.y = random_jet(random, &same->y);
    made.z = random_jet(random, &same->z);
    return made;
}

static void check_same(bat_jet1 a, bat_jet b)
{
    CHECK_NEAR(a.f, b.d[0], 64 * DBL_EPSILON);
    CHECK_NEAR(a.u, b.d[1], 512 * DBL_EPSILON);
    CHECK_NEAR(a.v, b.d[2], 512 * DBL_EPSILON);
}

TEST(jets_of_order_1_are_the_beginning_of_jets_of_order_3)
{
    test_random random = test_random_begin("jets of order 1");
    for (int i = test_cases(50); i > 0; i--) {
        bat_jet p, q;
        const bat_jet1 a = random_jet(&random, &p), b = random_jet(&random, &q);
        const double g[4] = {exp(a.f) / 10, exp(a.f) / 10, exp(a.f) / 10, exp(a.f) / 10};
        check_same(bat_jet1_add(a, b), bat_jet_add(p, q));
        check_same(bat_jet1_subtract(a, b), bat_jet_subtract(p, q));
        check_same(bat_jet1_scale(-3, a), bat_jet_scale(-3, p));
        check_same(bat_jet1_multiply(a, b), bat_jet_multiply(p, q));
        check_same(bat_jet1_divide(a, b), bat_jet_divide(p, q));
        check_same(bat_jet1_square_root(a), bat_jet_square_root(p));
        check_same(bat_jet1_compose(g[0], g[1], a), bat_jet_compose(g, p));
        check_same(bat_jet1_minor(a, b, b, a),
                   bat_jet_subtract(bat_jet_multiply(p, p), bat_jet_multiply(q, q)));
    }
}

TEST(vectors_of_jets_of_order_1_likewise)
{
    test_random random = test_random_begin("vectors of jets of order 1");
    for (int i = test_cases(50); i > 0; i--) {
        bat_jet3 p, q;
        bat_jet r;
        const bat_jet1_vector a = random_vector(&random, &p), b = random_vector(&random, &q);
        const bat_jet1 s = random_jet(&random, &r);
        const batten_vec3 fixed = {1, -2, 5};
        check_same(bat_jet1_dot(a, b), bat_jet3_dot(p, q));
        const bat_jet1_vector made[] = {bat_jet1_cross(a, b), bat_jet1_between(a, b),
                                        bat_jet1_times(s, a), bat_jet1_fixed(fixed)};
        const bat_jet3 same[] = {bat_jet3_cross(p, q), bat_jet3_subtract(p, q),
                                 bat_jet3_multiply(r, p), bat_jet3_constant(fixed)};
        for (int k = 0; k < 4; k++) {
            check_same(made[k].x, same[k].x);
            check_same(made[k].y, same[k].y);
            check_same(made[k].z, same[k].z);
        }
        check_same(bat_jet1_reciprocal_length(a),
                   bat_jet_divide(bat_jet_constant(1), bat_jet3_norm(p)));
    }
}
